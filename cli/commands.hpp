// The subcommands of `glint`: each adds itself to the command line and leaves what to run.
#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

namespace glint::cli {

/// What the chosen subcommand runs; `command` is the command line as typed.
struct Chosen {
    std::function<int()> run;
    std::string command;
};

inline constexpr const char* purpose = "Specular highlights in fixed point: evaluate, measure, and hand to hardware.";

/// All of them. The arguments are read later, by io::run.
void add_all(CLI::App& app, Chosen& chosen, int argc, char** argv);

void add_eval(CLI::App& app, Chosen& chosen);
void add_sweep(CLI::App& app, Chosen& chosen);
void add_merge(CLI::App& app, Chosen& chosen);
void add_vectors(CLI::App& app, Chosen& chosen);
void add_emit(CLI::App& app, Chosen& chosen);
void add_fit(CLI::App& app, Chosen& chosen);
void add_cases(CLI::App& app, Chosen& chosen);
void add_study(CLI::App& app, Chosen& chosen);
void add_report(CLI::App& app, Chosen& chosen);
void add_cost(CLI::App& app, Chosen& chosen);
void add_choose(CLI::App& app, Chosen& chosen);
void add_render(CLI::App& app, Chosen& chosen);

}  // namespace glint::cli
