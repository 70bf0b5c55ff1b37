// A word a line, as the arguments of `glint`. What only reads its arguments is run, of the rest they are read.
#include "check.hpp"
#include "cli/commands.hpp"
#include "commands.hpp"
#include "io/command.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration arguments("arguments", [](const std::string& text) {
    const auto glint = [](int argc, char** argv) {
        CLI::App app{cli::purpose, "glint"};
        cli::Chosen chosen;
        cli::add_all(app, chosen, argc, argv);
        return io::run(app, argc, argv, [&] {
            const CLI::App& command = *app.get_subcommands().front();
            const auto without = [&](const char* name, const char* option) {
                return command.get_name() == name && command.count("--json") + command.count(option) == 0;
            };
            return without("eval", "--stdin") || without("choose", "--data") ? chosen.run() : 0;
        });
    };
    std::vector<std::string> words = split(text, '\n');
    if (words.size() > 24) words.resize(24);
    check_promise(run_command(glint, "glint", words), "glint");
});

}  // namespace glint::fuzz
