// The file of effects' prices on FPGAs, cost/data/effects.json, read back: for a table, and for the report.
#pragma once

#include <string>
#include <vector>

#include "cost/fpga/points.hpp"

namespace glint::cost {

struct EffectPrices {
    fpga::ToolVersions tools;
    std::vector<fpga::Point> points;  ///< in the order of the file
};

/// Throws Error: not there or not legal, and what writes it.
EffectPrices read_effect_prices(const std::string& path);

struct EffectTableOptions {
    std::string data = "cost/data";                   ///< the folder of the file
    std::string effect, mask, lobe, profile, device;  ///< lists; empty or "all": all
    std::string json;                                 ///< empty: not written
};

/// Prints the prices that the options name, and writes them as a file of the same format. Throws Error: none is there.
int run_effect_table(const EffectTableOptions& options);

}  // namespace glint::cost
