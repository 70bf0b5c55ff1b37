#include "glint/fixed_point.hpp"

#include <cmath>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {

std::int64_t quantize_constant(double value, int fraction_bits) {
    if (!(std::abs(value) < 64.0)) throw Error(fmt::format("constant {} is not legal: |constant| < 64", value));
    if (fraction_bits < 0 || fraction_bits > 48) {
        throw Error(fmt::format("constant at {} fraction bits is not legal: 0 to 48", fraction_bits));
    }
    return std::llround(std::ldexp(value, fraction_bits));  // llround: halves away from zero
}

std::int32_t quantize_cosine(double value, int fraction_bits) {
    if (!(std::abs(value) < 2.0)) throw Error(fmt::format("cosine {} is not legal: |cosine| < 2", value));
    if (fraction_bits < 0 || fraction_bits > 30) {
        throw Error(fmt::format("cosine at {} fraction bits is not legal: 0 to 30", fraction_bits));
    }
    // A value just below 2 may round up to 2.0, which the port cannot carry.
    const std::int64_t top = (std::int64_t{2} << fraction_bits) - 1;
    const std::int64_t code = std::llround(std::ldexp(value, fraction_bits));
    return static_cast<std::int32_t>(code > top ? top : code);
}

}  // namespace glint
