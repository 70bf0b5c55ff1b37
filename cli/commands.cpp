#include "cli/commands.hpp"

#include "io/results.hpp"

namespace glint::cli {

void add_all(CLI::App& app, Chosen& chosen, int argc, char** argv) {
    app.require_subcommand(1);
    chosen.command = io::command_line(argc, argv);
    for (const auto add : {add_eval, add_sweep, add_merge, add_vectors, add_emit, add_fit, add_cases, add_study,
                           add_report, add_cost, add_choose, add_render}) {
        add(app, chosen);
    }
}

}  // namespace glint::cli
