// cost/data/accuracy.json: the errors of every lobe and profile at each n, of which the error over any range of n is a
// maximum.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glint/lobes.hpp"
#include "glint/range.hpp"

namespace glint::cost {

/// Which cosine an error against c^n is taken at: docs/contract.md, "Errors".
enum class Cosine { rounded, exact };

/// A lobe at a profile, measured over every legal input.
struct AccuracyRecord {
    std::string lobe, profile;  ///< as on the command line
    int F = 0, O = 0;
    std::uint64_t inputs = 0;
    double rounding = 0.0;  ///< largest rounding error, in ulp
    /// The largest absolute error against c^n at n = 1, 2, .. 1023, in units of 2^-(O+8), rounded up.
    std::vector<std::uint32_t> rounded_cosine, exact_cosine;

    /// Over a range of n within 1 .. 1023; at most one unit above what was measured.
    double error(Range n, Cosine cosine) const;
};

/// Sweeps all inputs.
AccuracyRecord measure_accuracy(const GoldenModel& model, unsigned threads);

/// Throws Error: what is missing or not legal in which file.
std::vector<AccuracyRecord> read_accuracy_file(const std::string& path);

/// Measures the lobes at the profiles and writes them to a file, beside what that already holds of others. Returns the
/// exit status: 1 where the rounding error of a shipped profile reaches the bound of its lobe. Throws Error.
int run_cost_accuracy(const std::string& lobes, const std::string& profiles, const std::string& json, unsigned threads);

}  // namespace glint::cost
