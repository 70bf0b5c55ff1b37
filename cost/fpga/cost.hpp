// Prices of units on FPGAs: which units, and how the parts of the flow make a point.
#pragma once

#include <string>
#include <vector>

#include "cost/fpga/points.hpp"
#include "glint/parallel.hpp"

namespace glint::fpga {

struct Options {
    std::string lobe = "bps";  ///< a list; with `effect` the one that effects are made of
    std::string effect;        ///< a list, or all: effects instead of lobes
    bool shell = false;        ///< each unit, and the AXI4-Stream unit around it
    int lanes = 1;             ///< with `shell`, more than 1: also so many of that side by side
    std::string mask;          ///< a list: values of the parameter MASK of the effect shade; empty: the default ones
    std::string profile = "p12";
    std::string architecture;  ///< a list, or all; empty: the default one of each lobe
    std::string device = "hx8k";
    std::string dsp = "on";
    std::string seeds = "1,2,3";
    std::string rtl = "rtl";
    std::string cache = "build/cost-cache";
    std::string json;
    unsigned jobs = 1;
};

/// Prices every combination, merges the points into `json` unless that is empty, and prints the table. The exit status.
/// Throws Error.
int run_fpga(const Options& options);

/// Says which prices in the file `json` (empty: cost/data/fpga.json and fpga-yowasp.json) are not of the Verilog in
/// `rtl` and of what the tools are told today, by their hashes, and of which lobes or effects prices are missing. Runs
/// no tool. The exit status: check_failed when there is one of the former. Throws Error.
int run_price_check(const Options& options);

}  // namespace glint::fpga
