// `glint report`: measured results, and what the papers claim, as one page that needs nothing else; pictures for the
// README.
#pragma once

#include "cli/report/rooms.hpp"

#include <string>
#include <vector>

namespace glint::cli {

struct ReportOptions {
    std::vector<std::string> results;  ///< JSON files of `glint-cosim --json` and `glint sweep --json`
    std::string proofs;                ///< JSON file of proofs/gappa/run.py --json; may be empty
    std::string cpu;                   ///< JSON file of bench/run.py --json; may be empty
    std::string cpu_models;            ///< the same of lighting models; may be empty
    std::string cost;                  ///< folder of accuracy.json and fpga.json; may be empty
    std::string output;                ///< folder for index.html, the figures and the pictures
};

/// Writes output/index.html, output/figures/figure-3.csv to figure-8.csv (the figures of paper 1) and paper-2-*.csv
/// (those of paper 2), and output/overview-light.svg and -dark.svg when the results hold errors per n.
/// Returns the exit status. Throws Error: results that cannot be used, gnuplot missing or failing, files not writable.
int report(const ReportOptions& options);

}  // namespace glint::cli
