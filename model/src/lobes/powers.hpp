// Powers of a fraction, which the lobes with a power at their end share; for small n they are powers of c.
#pragma once

#include <array>
#include <string>

#include <fmt/format.h>

#include "glint/fixed_point.hpp"

namespace glint {

/// The exponents whose power is taken of the cosine itself: 1 .. 6 and 8.
constexpr bool is_power(double n) { return n == 1 || n == 2 || n == 3 || n == 4 || n == 5 || n == 6 || n == 8; }

/// The powers 1, 2, 4, 8, 16 of a fraction r = 0 .. 2^S by repeated squaring, each rounded to S bits.
using Powers = std::array<std::int64_t, 5>;
inline Powers powers_by_squaring(std::int64_t r, int S) {
    Powers p{r};
    for (std::size_t i = 1; i < p.size(); ++i) p[i] = rnd(p[i - 1] * p[i - 1], S);
    return p;
}

/// A power of r at O bits, as one product of two of `p` (or of r and 1.0): `power` is 1 .. 6, 8, 16 or 32.
inline std::int64_t power_of(const Powers& p, int power, int S, int O) {
    const std::int64_t left = power <= 2 ? p[0] : power <= 4 ? p[1] : power <= 8 ? p[2] : power == 16 ? p[3] : p[4];
    const std::int64_t right = power == 1                               ? std::int64_t{1} << S
                               : power == 2 || power == 3 || power == 5 ? p[0]
                               : power == 4 || power == 6               ? p[1]
                                                                        : left;
    return rnd(left * right, 2 * S - O);
}

/// The lines of a Gappa script that define, from C_r, the powers 1 .. 6 and 8 of C and their errors in ulps.
inline std::string gappa_small_powers(int O) {
    return fmt::format(R"(C_r2 = rnd_S(C_r * C_r);
C_r4 = rnd_S(C_r2 * C_r2);
C2 = C * C;
C4 = C2 * C2;
error_1 = (rnd_O(C_r) - C) * 1b{O};
error_2 = (rnd_O(C_r * C_r) - C2) * 1b{O};
error_3 = (rnd_O(C_r2 * C_r) - C2 * C) * 1b{O};
error_4 = (rnd_O(C_r2 * C_r2) - C4) * 1b{O};
error_5 = (rnd_O(C_r4 * C_r) - C4 * C) * 1b{O};
error_6 = (rnd_O(C_r4 * C_r2) - C4 * C2) * 1b{O};
error_8 = (rnd_O(C_r4 * C_r4) - C4 * C4) * 1b{O};)",
                       fmt::arg("O", O));
}

/// What a script claims of those errors.
inline constexpr std::string_view gappa_small_power_claims =
    R"(error_1 in [-1, 1] /\ error_2 in [-1, 1] /\ error_3 in [-1, 1] /\ error_4 in [-1, 1] /\ error_5 in [-1, 1] /\
  error_6 in [-1, 1] /\ error_8 in [-1, 1] /\)";

}  // namespace glint
