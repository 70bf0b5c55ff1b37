// The rounding of the contract (docs/contract.md, section "Arithmetic"), on 64-bit integers.
#pragma once

#include <cmath>
#include <cstdint>

namespace glint {

/// rnd(x, k) = floor((x + 2^(k-1)) / 2^k) for k > 0 (round half up), x for k = 0.
/// Legal: 0 <= k <= 62 and x + 2^(k-1) within int64. C++20 defines >> of a negative number as the floor.
constexpr std::int64_t rnd(std::int64_t x, int k) { return k == 0 ? x : (x + (std::int64_t{1} << (k - 1))) >> k; }

/// floor(sqrt(x)), exact. Legal: 0 <= x < 2^62.
inline std::int64_t floor_sqrt(std::int64_t x) {
    auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(x)));  // off by one at most
    while (root * root > x) --root;
    while ((root + 1) * (root + 1) <= x) ++root;
    return root;
}

/// A real constant at `fraction_bits` bits: value * 2^fraction_bits to the nearest integer, halves away from zero.
/// Legal: finite, 0 <= fraction_bits <= 48, |value| < 64 (so that the scaling by a power of two is exact). Throws
/// Error.
std::int64_t quantize_constant(double value, int fraction_bits);

/// A cosine at `fraction_bits` bits, rounded the same way, as `--cos x` of the command line does.
/// Legal: finite, |value| < 2, 0 <= fraction_bits <= 30. Throws Error.
std::int32_t quantize_cosine(double value, int fraction_bits);

}  // namespace glint
