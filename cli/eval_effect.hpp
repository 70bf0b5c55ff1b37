// `glint eval --effect`: one input of an effect with every intermediate value, or a stream of inputs.
#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace glint::cli {

/// The values of an effect's input ports as given: --<port> x or --<port>-code c.
struct PortValues {
    std::map<std::string, std::string> reals, codes;
};

/// Options for every port that any effect has, but n, which `glint eval` has anyway. They are not listed in the help,
/// for they would not fit a screen.
void add_port_options(CLI::App& command, PortValues& values);

struct EffectEval {
    std::string effect, lobe, profile, json, command;
    bool port = false;  ///< correct what is out of range instead of refusing it
    bool from_stdin = false;
};

/// Returns the exit status. Throws Error.
int eval_effect(const EffectEval& options, const PortValues& values);

}  // namespace glint::cli
