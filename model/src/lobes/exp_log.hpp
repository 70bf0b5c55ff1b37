// The blocks log2 and exp2, and tables of quadratic pieces: docs/exp-log.md. Shared by blinn_phong,
// spherical_gaussian and gauss.
#pragma once

#include <functional>

#include "lobe.hpp"

namespace glint::exp_log {

/// A real number at 100 fraction bits, |x| < 2^27: the entries of the tables are rounded from such numbers, which are
/// made by integer arithmetic alone, so that no mathematical library has a say in them.
using Wide = __int128;
inline constexpr int wide_bits = 100;
inline constexpr Wide wide_one = Wide{1} << wide_bits;

/// x / ln 2, log2(1 + x / 2^bits), 2^-(x / 2^bits), each within 2^-90. Legal: 0 <= x <= 2^bits, bits <= 12; of
/// over_ln2, 0 <= x < 4.
Wide over_ln2(Wide x);
Wide log2_1p(int x, int bits);
Wide exp2_minus(int x, int bits);

/// log2(x) for 1/2 <= x < 8 and exp(-x) for 0 <= x <= 16, each within 2^-90.
Wide log2(Wide x);
Wide exp_minus(Wide x);

/// -ln(1 - d) / d and -ln(1 - d) for d = x / 2^bits, each within 2^-90. Legal: 0 < x <= 2^8; of the first, d <= 1/2; of
/// the second, x < 2^bits, bits <= 12.
Wide log_ratio(int x, int bits);
Wide minus_log_1m(int x, int bits);

/// The integer nearest to x 2^bits. Throws Error where x is so near to a half that its last digits decide.
std::int64_t nearest(Wide x, int bits);

/// A function as quadratic pieces: index says which, r / 2^R is the place in it.
struct Pieces {
    struct Piece {
        std::int64_t c0 = 0, c1 = 0, c2 = 0;
    };
    struct Steps {
        std::int64_t h = 0, value = 0;
    };
    int R = 0;
    int G = 0;  ///< guard bits: c1, c2 and h have so many more fraction bits than c0 and the value
    std::vector<Piece> pieces;

    Steps steps(std::size_t index, std::int64_t r) const {
        const Piece& c = pieces[index];
        const std::int64_t h = c.c1 + rnd(c.c2 * r, R);
        return {h, c.c0 + rnd(h * r, R + G)};
    }

    /// As a read-only memory of values of `function`, with the fields c0, c1, c2 of these widths. Throws Error where an
    /// entry, or h, which goes from c1 to c1 + c2, does not fit.
    Table table(std::string_view function, std::string_view name, int c0_width, int c1_width, int c2_width) const;
};

/// `real`(x, bits) at x / 2^bits in [0, 1], in 2^address pieces with entries at value_bits. Throws Error.
Pieces make_pieces(const std::function<Wide(int x, int bits)>& real, int address, int R, int value_bits, int G);

/// u = -log2(C / 2^F).
struct Log2 {
    int F = 0;    ///< fraction bits of C
    int T = 0;    ///< address bits
    int L = 0;    ///< fraction bits of u
    int cut = 0;  ///< low bits of the normalised C that are dropped
    Pieces pieces;

    struct Steps {
        std::int64_t z = 0, M = 0, h = 0, l = 0, u = 0;
    };
    Steps steps(std::int64_t C) const;
    Table table(std::string_view name = "log2") const;
};

/// y = 2^-t.
struct Exp2 {
    int E = 0;  ///< address bits
    int S = 0;  ///< fraction bits of t and p
    int O = 0;  ///< fraction bits of y; where it is above S, the last bits of a y near 1 are 0
    Pieces pieces;

    struct Steps {
        std::int64_t h = 0, p = 0, y = 0;
    };
    Steps steps(std::int64_t t) const;
    Table table() const;
};

/// The word lengths of a lobe with both a table for the exponent and one for the power; custom ones as F,T,L,E,S,O.
struct WordLengths {
    int T = 0, L = 0, E = 0, S = 0;
};
WordLengths word_lengths(std::string_view lobe, const Profile& profile);

/// Lobe::numbers of such a lobe.
std::vector<int> shipped_numbers(int F, int O);

/// Throw Error unless the word lengths are legal (docs/exp-log.md).
Log2 make_log2(std::string_view lobe, int F, int T, int L, int cut = 0);
Exp2 make_exp2(std::string_view lobe, int E, int S, int O);

/// Inputs for which the last block is at its ends, at several n: the least cosine with a result, the one before it, the
/// greatest whose result is not 1.
void add_end_cases(const GoldenModel& model, std::vector<HardCase>& cases);

}  // namespace glint::exp_log
