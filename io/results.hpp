// The results of sweeps and cosimulations: as JSON for machines, as a table for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "glint/golden.hpp"
#include "glint/sweep.hpp"

namespace glint::io {

/// What is counted while there are no stalls; all 0 with stalls.
struct Timing {
    int least_latency = 0, most_latency = 0;           ///< clocks from an accepted input to its output
    std::uint64_t span = 0, span_results = 0;          ///< clocks from the first result of a burst to the last; results
    std::uint64_t intervals = 0, interval_clocks = 0;  ///< between neighbouring results, and their clocks

    void merge(const Timing& other);
    double results_per_cycle() const;
    double interval_cycles() const;  ///< 0: not measured
    /// What is wrong with it in one line; empty when all is well.
    std::string complaint() const;
};

/// What only a simulation of hardware has.
struct HardwareResult {
    std::uint64_t mismatches = 0;
    std::uint64_t cycles = 0;
    Timing timing;
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
    std::string key;        ///< what determines the run, for shards: units, inputs, seed, hash of the Verilog
    std::string complaint;  ///< what went wrong, for people; empty when all is well

    /// The number of inputs, and whether a grid of them was all of the legal ones.
    void set_inputs(std::uint64_t count);
};

/// A run's identity, from its model.
RunResult run_result(const GoldenModel& model, std::string unit, std::string test);

/// With more than one shard also what merge_shards needs.
nlohmann::ordered_json to_json(const std::vector<RunResult>& runs, const std::string& tool, const std::string& command,
                               Shard shard = {});

/// One line a run. `hardware` says whether the columns of a simulation are wanted.
std::string results_table(const std::vector<RunResult>& runs, bool hardware);

/// One line per n and profile, with the column names in a heading.
std::string to_csv(const std::vector<RunResult>& runs);

/// "12 345 678".
std::string grouped(std::uint64_t number);

/// Whether the rounding error of a shipped profile reaches the bound that its lobe promises; what commands then print.
bool bound_reached(const RunResult& run);
inline constexpr const char* bound_line =
    "FAILED: the rounding error of a shipped profile reaches the bound of its lobe\n";

/// The command line as typed, for the files that record where they came from.
std::string command_line(int argc, char** argv);

}  // namespace glint::io
