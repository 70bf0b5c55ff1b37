// The golden model of `bps`: docs/contract.md, section `bps`.
#pragma once

#include <memory>
#include <string>

#include "glint/architecture.hpp"
#include "glint/emit.hpp"
#include "glint/golden.hpp"

namespace glint {

/// The word lengths of `bps` and its constants at them.
struct BpsFormat {
    int F = 0;                                  ///< fraction bits of the cosine, 8..30
    int S = 0;                                  ///< fraction bits of the quotient, O..30
    int K = 0;                                  ///< fraction bits of the constants, O..30
    int O = 0;                                  ///< fraction bits of the output, 4..28
    std::int64_t a = 0, b = 0, c1 = 0, d0 = 0;  ///< at K fraction bits
};

/// For a shipped profile (p8: S = K = 11, p12: 15, p16: 19) or a custom one F,S,K,O. Throws Error when a number is
/// outside its range, when an intermediate would not fit 64 bits, or when a result could be above 1.
BpsFormat bps_format(const Profile& profile);

/// Throws Error as bps_format does.
std::unique_ptr<GoldenModel> make_bps(const Profile& profile);

/// The Gappa script that bounds the rounding error and the range of every intermediate (proofs/gappa/). Throws Error as
/// bps_format does.
std::string bps_gappa_script(const Profile& profile);

/// The Verilog wrappers, the HLS header and the Gappa script with the constants of a profile. Throws Error as
/// bps_format does.
std::vector<GeneratedFile> emit_bps(const Profile& profile, const Architecture& architecture);

}  // namespace glint
