// The arguments of `glint eval --stdin` as one line, and then its input.
#include <algorithm>

#include "check.hpp"
#include "cli/commands.hpp"
#include "commands.hpp"
#include "io/command.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration lines("stdin", [](const std::string& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line = text.substr(0, end), in = text.substr(std::min(end + 1, text.size()));
    // Of the unit alone: with more words this would be another target.
    std::vector<std::string> words = split(line, ' ');
    if (words.size() != 3 || (words[0] != "lobe" && words[0] != "effect")) return;
    const bool port = words[2].ends_with('+');
    if (port) words[2].pop_back();
    std::vector<std::string> arguments{"eval", "--stdin", "--" + words[0], words[1], "--profile", words[2]};
    if (port) arguments.emplace_back("--port");
    const auto glint = [](int argc, char** argv) {
        CLI::App app{cli::purpose, "glint"};
        cli::Chosen chosen;
        cli::add_all(app, chosen, argc, argv);
        return io::run(app, argc, argv, [&] { return chosen.run(); });
    };
    const Said said = run_command(glint, "glint", arguments, in);
    check_promise(said, "glint");
    const auto answers = std::count(said.out.begin(), said.out.end(), '\n');
    const auto asked = std::count(in.begin(), in.end(), '\n') + (in.empty() || in.ends_with('\n') ? 0 : 1);
    require(said.status != 0 || answers == asked, "an answer a line");
    require(answers <= asked, "no more answers than lines");
    require(said.out.find_first_not_of("-0123456789 \n") == said.out.npos, "answers are numbers");
});

}  // namespace glint::fuzz
