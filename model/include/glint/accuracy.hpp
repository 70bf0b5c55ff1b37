// How far fixed-point results are from the real functions. Definitions: docs/contract.md, section "Errors".
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glint/golden.hpp"

namespace glint {

/// The largest value seen and the input where it was seen; of equal ones the least n, then the least code.
struct Worst {
    double value = -1.0;  ///< -1: nothing seen
    int n = 0;
    std::int32_t cos_code = 0;

    bool seen() const { return value >= 0.0; }
    void merge(const Worst& other);
};

/// A sum that does not depend on the order of its terms, so that parts of a run add up to the run: a multiple of 2^-128
/// below 2^128, the low word first. Terms are cut to 0 .. 2^80, and what one has below 2^-128 is dropped.
struct ExactSum {
    std::array<std::uint64_t, 4> words{};

    ExactSum& operator+=(double term);
    ExactSum& operator+=(const ExactSum& other);
    double value() const;

    /// The words as 32-bit halves, the low one first: what files hold.
    using Halves = std::array<std::uint32_t, 8>;
    Halves halves() const;
    static ExactSum of(const Halves& halves);
};

/// Errors over a set of inputs.
struct Accuracy {
    std::uint64_t inputs = 0;
    Worst rounding;                  ///< |y - 2^O f(c, n)|, f the lobe's own real function, in ulps of the output
    ExactSum rounding_squares;       ///< sum of their squares
    Worst approximation;             ///< |y / 2^O - c^n| at the rounded cosine
    ExactSum approximation_squares;  ///< sum of their squares
    Worst approximation_exact;       ///< the same at the worse end of [code - 1/2, code + 1/2] / 2^F cut to [0, 1]
    Worst epicentre;                 ///< |y / 2^O - c^n| / c^n at the rounded cosine, in the epicentre zone, n >= 2

    double rounding_rms() const;
    double approximation_rms() const;
    void merge(const Accuracy& other);
};

/// Measures results for one list of cosine codes at one n after the other.
///
/// c^n comes from std::pow at the first n and at every jump of more than 16; between them from at most 1022
/// multiplications by c, each off by 2^-53 at most, relatively: an error below 2e-13, and values below 1e-200 count as
/// 0.
class AccuracyMeter {
public:
    /// Legal: codes in 0..2^F. The model has to outlive the meter.
    AccuracyMeter(const GoldenModel& model, std::span<const std::int32_t> cos_codes);

    /// Adds the results at `n` (1..1023), one for each code, packed as by eval_port_batch.
    void add(int n, std::span<const std::uint32_t> packed, Accuracy& into);

private:
    void move_to(int n);

    /// c^n for one value of c per code.
    struct Powers {
        std::vector<double> c, value;
        void move(int from, int to);
    };

    const GoldenModel& model_;
    std::vector<std::int32_t> codes_;
    int n_ = 0;
    Powers at_, below_, above_;  // at the code, and at the two ends of what rounds to it
    std::vector<double> exact_;  // the lobe's real function
    std::vector<double> rounding_error_, error_, exact_error_;
};

}  // namespace glint
