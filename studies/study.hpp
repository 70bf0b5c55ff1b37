// The lobes against Blinn-Phong as real functions, as paper 1 measures them (Zavalniuk, Romanyuk, Satsiuk 2024).
#pragma once

#include <string_view>
#include <vector>

#include "glint/lobes.hpp"

namespace glint::studies {

/// The largest error at one n, and the angle (radians) where it lies.
struct Peak {
    double value = 0.0;
    double theta = 0.0;
};

struct StudyRow {
    int n = 0;
    /// Relative error in the epicentre zone, theta in [0, atan(1 / sqrt(n - 1))]. NaN at n = 1, where c^n is 0 at the
    /// edge.
    Peak delta;
    /// The same over multiples of paper_step up to the first one at or beyond the edge.
    Peak delta_stepped;
    Peak absolute;  ///< absolute error over [0, pi/2]
};

/// The step in radians of the angles in the paper's data set.
inline constexpr double paper_step = 0.001;

/// The edge of the epicentre zone, the inflection point of cos^n, in radians.
double epicentre_angle(double n);

/// Of a column of rows, over a range of n.
struct Summary {
    double largest = 0.0;
    int n = 0;  ///< where it is largest
    double median = 0.0;
};

struct Study {
    std::string_view lobe;
    std::vector<StudyRow> rows;  ///< n = 1 .. 1000

    Summary delta(int first, int last) const;
    Summary delta_stepped(int first, int last) const;
    Summary absolute(int first, int last) const;
};

/// Angles per n: 1001 over the epicentre zone, 2001 over [0, 16 times the zone], 101 over [0, pi/2], and for the
/// absolute error 202 around its largest.
Study study(const Lobe& lobe);

}  // namespace glint::studies
