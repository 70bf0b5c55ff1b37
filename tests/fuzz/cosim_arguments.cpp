// A word a line, as the arguments of a glint-cosim that has no units: it comes as far as asking for one.
#include "check.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration cosim_arguments("cosim_arguments", [](const std::string& text) {
    std::vector<std::string> words = split(text, '\n');
    if (words.size() > 24) words.resize(24);
    const Said said = run_command(testbench::run_cosim, "glint-cosim", words);
    check_promise(said, "glint-cosim");
    require(said.status == 2 || said.out.empty(), "nothing ran");  // --help goes elsewhere
});

}  // namespace glint::fuzz
