// The results of sweeps and cosimulations: as JSON for machines, as a table for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "glint/golden.hpp"
#include "glint/sweep.hpp"

namespace glint::io {

/// What only a simulation of hardware has.
struct HardwareResult {
    std::uint64_t mismatches = 0;
    std::uint64_t cycles = 0;
    int latency_cycles = 0;          ///< clocks from an accepted input to its output, without stalls; measured
    double interval_cycles = 0.0;    ///< clocks between two results, without stalls; measured; 0: not measured
    double results_per_cycle = 0.0;  ///< results over the clocks from the first to the last of a burst; measured
    double stall_probability = 0.0;
    std::uint64_t seed = 0;
};

struct RunResult {
    std::string lobe;
    std::string profile;
    int F = 0;
    int O = 0;
    std::string unit;          ///< "model", "core" or "axis"
    std::string architecture;  ///< of a unit of Verilog; empty where the results do not name it
    std::string test;          ///< "sweep", "stream", "illegal" or "reset"
    bool exhaustive = false;
    std::uint64_t inputs = 0;
    double seconds = 0.0;
    std::optional<HardwareResult> hardware;
    std::optional<SweepResult> accuracy;
};

/// A run's identity, from its model.
RunResult run_result(const GoldenModel& model, std::string unit, std::string test);

nlohmann::ordered_json to_json(const std::vector<RunResult>& runs, const std::string& tool, const std::string& command);

/// One line a run. `hardware` says whether the columns of a simulation are wanted.
std::string results_table(const std::vector<RunResult>& runs, bool hardware);

/// One line per n and profile, with the column names in a heading.
std::string to_csv(const std::vector<RunResult>& runs);

/// The command line as typed, for the files that record where they came from.
std::string command_line(int argc, char** argv);

}  // namespace glint::io
