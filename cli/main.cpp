#include "cli/commands.hpp"
#include "io/command.hpp"

int main(int argc, char** argv) {
    CLI::App app{glint::cli::purpose, "glint"};
    glint::cli::Chosen chosen;
    glint::cli::add_all(app, chosen, argc, argv);
    return glint::io::run(app, argc, argv, [&] { return chosen.run(); });
}
