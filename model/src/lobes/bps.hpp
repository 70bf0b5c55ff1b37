// What follows the quotient in `bps` (docs/lobes/bps.md): shared by the lobe and by the effect bps_vectors.
#pragma once

#include <cstdint>

#include "glint/profile.hpp"

namespace glint {

/// The polynomial's word lengths, and its constants at K fraction bits.
struct BpsPolynomial {
    int S = 0;                                  ///< fraction bits of the quotient, O..30
    int K = 0;                                  ///< fraction bits of the constants, O..30
    int O = 0;                                  ///< fraction bits of the output, 4..28
    std::int64_t a = 0, b = 0, c1 = 0, d0 = 0;  ///< at K fraction bits

    struct Steps {
        std::int64_t D = 0, quotient = 0, h1 = 0, h2 = 0, y = 0;
    };

    /// h1, h2 and y of the quotient.
    void horner(Steps& x) const;
};

/// Throws Error unless O <= S, K <= 30 and y stays within 2^O; it names `who` wants it.
BpsPolynomial bps_polynomial(std::string_view who, const Profile& profile, int S, int K);

}  // namespace glint
