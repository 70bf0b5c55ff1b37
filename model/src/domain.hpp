// What the real functions of all lobes share: the answers outside the domain (glint/reference.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::reference {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The answers that all lobes share, then the lobe itself for 0 <= c <= 1 and n >= 1 (possibly infinite).
double with_domain(double c, double n, auto lobe) {
    if (std::isnan(c) || std::isnan(n)) return nan;
    if (c < 0.0) return 0.0;
    return lobe(std::min(c, 1.0), std::max(n, 1.0));
}

}  // namespace glint::reference
