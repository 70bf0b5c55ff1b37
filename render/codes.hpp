// Columns of real numbers as codes of a port.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "glint/effect.hpp"

namespace glint::render {

/// out[i] = port.code(x[i]), in vector lanes. Legal: out is as long as x, the port's codes fit in int32.
inline void codes(const EffectPort& port, std::span<const double> x, std::int32_t* out) {
    const double scale = std::ldexp(1.0, port.fraction_bits);
    const auto least = static_cast<double>(port.least());
    const auto greatest = static_cast<double>(port.greatest());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double real = x[i] == x[i] ? x[i] : 0.0;  // NaN
        const double scaled = std::min(std::max(scale * real, least), greatest);
        // What the cut to an integer leaves is exact, so halves are told from what is just below them.
        const auto cut = static_cast<std::int32_t>(scaled);
        const double rest = scaled - cut;
        out[i] = cut + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
    }
}

}  // namespace glint::render
