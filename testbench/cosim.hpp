// Cosimulation: a unit's results against the golden model, bit for bit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glint/golden.hpp"
#include "glint/parallel.hpp"
#include "glint/range.hpp"
#include "io/results.hpp"
#include "unit.hpp"

namespace glint::testbench {

enum class Test {
    stream,   ///< legal inputs: a grid of n and cos (measured for accuracy too) or a seeded random sample
    illegal,  ///< n = 0 with every cos code; every illegal cos code with n in {1, 2, 50, 1000, 1023}
    reset     ///< resets in mid-stream, at random clocks and of random lengths
};

struct Request {
    Test test = Test::stream;
    Range n{1, max_n, 1};
    Range cos_code{0, 0, 1};
    std::uint64_t count = 0;  ///< random inputs instead of a grid (stream), or resets (reset)
    double stall_probability = 0.0;
    std::uint64_t seed = 1;
    unsigned threads = 0;
    std::size_t shown = 4;   ///< mismatches to describe
    std::string trace_file;  ///< waveform of the first mismatch's neighbourhood; empty: none
};

struct CosimResult {
    io::RunResult run;
    std::string complaint;  ///< what went wrong, for people; empty when all is well
};

/// Runs one test of one unit. Throws Error when there is nothing to run.
CosimResult cosimulate(const GoldenModel& model, const UnitKind& kind, const Request& request,
                       const Progress& progress);

}  // namespace glint::testbench
