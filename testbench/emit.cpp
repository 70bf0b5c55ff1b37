// glint-emit: the subcommand of glint alone. The build itself needs it, for units whose Verilog is not committed,
// before `glint`, which may hold such units (glint render), is there.

#include "cli/commands.hpp"
#include "io/command.hpp"
#include "io/results.hpp"

int main(int argc, char** argv) {
    CLI::App app{"`glint emit` alone, for the build", "glint-emit"};
    app.require_subcommand(1);
    glint::cli::Chosen chosen;
    chosen.command = glint::io::command_line(argc, argv);
    glint::cli::add_emit(app, chosen);
    return glint::io::run(app, argc, argv, [&] { return chosen.run(); });
}
