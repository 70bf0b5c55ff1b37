// `glint study`: the two papers held against what is measured.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "studies/json.hpp"

namespace glint::cli {

/// Prices on a processor, for the claims about time; either may be empty.
struct StudyInputs {
    std::string cpu;         ///< JSON file of bench/run.py: formulas
    std::string cpu_models;  ///< the same for lighting models
};

/// Throws Error: a file that is missing or cannot be used.
studies::Findings find(const StudyInputs& inputs);

/// Adds the options --cpu and --cpu-models.
void add_options(CLI::App& command, StudyInputs& inputs);

}  // namespace glint::cli
