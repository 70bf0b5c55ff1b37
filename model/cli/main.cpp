#include "commands.hpp"
#include "common.hpp"
#include "results.hpp"

int main(int argc, char** argv) {
    CLI::App app{"Specular highlights in fixed point: evaluate, measure, and hand to hardware.", "glint"};
    app.require_subcommand(1);
    glint::cli::Chosen chosen;
    chosen.command = glint::cli::command_line(argc, argv);
    glint::cli::add_eval(app, chosen);
    glint::cli::add_sweep(app, chosen);
    glint::cli::add_vectors(app, chosen);
    glint::cli::add_emit(app, chosen);
    add_fit(app, chosen);
    glint::cli::add_cases(app, chosen);
    glint::cli::add_cost(app, chosen);
    glint::cli::add_report(app, chosen);
    glint::cli::add_render(app, chosen);
    return glint::cli::run(app, argc, argv, [&] { return chosen.run(); });
}
