#include <fmt/format.h>

#include "cli/commands.hpp"
#include "glint/hard_cases.hpp"
#include "io/command.hpp"

namespace glint::cli {

void add_cases(CLI::App& app, Chosen& chosen) {
    auto output = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("cases", "The hard cases by name, with what comes out (docs/hard-cases.md)");
    command->add_option("-o,--output", *output, "Write the page there instead of to standard output");
    command->footer("Example: glint cases -o docs/hard-cases.md");
    command->callback([=, &chosen] {
        chosen.run = [=] {
            if (output->empty()) {
                fmt::print("{}", hard_cases_page());
            } else {
                io::write_file(*output, hard_cases_page());
            }
            return io::success;
        };
    });
}

}  // namespace glint::cli
