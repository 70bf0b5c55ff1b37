#include "cli/commands.hpp"
#include "io/command.hpp"
#include "io/results.hpp"

int main(int argc, char** argv) {
    CLI::App app{"Specular highlights in fixed point: evaluate, measure, and hand to hardware.", "glint"};
    app.require_subcommand(1);
    glint::cli::Chosen chosen;
    chosen.command = glint::io::command_line(argc, argv);
    glint::cli::add_eval(app, chosen);
    glint::cli::add_sweep(app, chosen);
    glint::cli::add_merge(app, chosen);
    glint::cli::add_vectors(app, chosen);
    glint::cli::add_emit(app, chosen);
    add_fit(app, chosen);
    glint::cli::add_cases(app, chosen);
    glint::cli::add_study(app, chosen);
    glint::cli::add_report(app, chosen);
    glint::cli::add_cost(app, chosen);
    glint::cli::add_choose(app, chosen);
    glint::cli::add_render(app, chosen);
    return glint::io::run(app, argc, argv, [&] { return chosen.run(); });
}
