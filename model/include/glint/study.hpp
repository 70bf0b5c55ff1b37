// The lobes against Blinn-Phong as real functions, as paper 1 measures them (Zavalniuk, Romanyuk, Satsiuk 2024), and
// what an evaluation costs in operations.
#pragma once

#include <string_view>
#include <vector>

#include "glint/lobes.hpp"

namespace glint {

/// The largest error at one n, and the angle (radians) where it lies.
struct Peak {
    double value = 0.0;
    double theta = 0.0;
};

struct StudyRow {
    int n = 0;
    Peak delta;     ///< relative error in the epicentre zone, theta in [0, atan(1 / sqrt(n - 1))]; n >= 2
    Peak absolute;  ///< absolute error over [0, pi/2]
};

/// Of a column of rows, over a range of n.
struct Summary {
    double largest = 0.0;
    int n = 0;  ///< where it is largest
    double median = 0.0;
};

struct Study {
    std::string_view lobe;
    std::vector<StudyRow> rows;  ///< n = 2 .. 1000

    Summary delta(int first, int last) const;
    Summary absolute(int first, int last) const;
};

/// Angles per n: 1001 over the epicentre zone, 2001 over [0, 16 times the zone], 101 over [0, pi/2].
Study study(const Lobe& lobe);

/// Operations of one evaluation.
struct Operations {
    int multiplications = 0, divisions = 0, additions = 0, increments = 0, comparisons = 0;

    /// Sum of the latencies of the operations, in cycles.
    struct Latencies {
        int multiplication, division, addition, increment, comparison;
    };
    int cycles(const Latencies& l) const;
    friend bool operator==(const Operations&, const Operations&) = default;
};

/// A formula as code, in the form that the paper counts: run with a number type that counts what is done to it.
struct Form {
    std::string_view lobe;     ///< in the registry
    std::string_view formula;  ///< as evaluated
    double (*value)(double c, double n);
    Operations (*count)();
};

/// f_s, f_8, f_kv, f_kub, f_bps, then lobes of our own. f_kub with its coefficients at hand, as from a memory.
const std::vector<Form>& forms();

}  // namespace glint
