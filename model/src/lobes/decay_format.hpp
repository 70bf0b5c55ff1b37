// The word lengths of the lobe `decay`, its tables and its integers: docs/lobes/decay.md.
#pragma once

#include <algorithm>
#include <bit>

#include "exp_log.hpp"

namespace glint {

struct DecayFormat {
    static constexpr std::string_view lobe = "decay";
    /// A piece of a function: its value at the begin, and what it rises by to the end.
    struct Piece {
        std::int64_t base = 0, slope = 0;
    };

    int F = 0;  ///< fraction bits of the cosine
    int A = 0;  ///< address bits of logarithm within an octave
    int M = 0;  ///< bits of m
    int V = 0;  ///< fraction bits of w, lambda and x
    int H = 0;  ///< address bits of fall within an octave
    int G = 0;  ///< guard bits of fall
    int W = 0;  ///< address bits of the octave of fall
    int N = 0;  ///< 1: the unit's table of lambda has an entry for each n; 0: for what follows the leading one of n
    int O = 0;  ///< fraction bits of the output
    int E = 0;  ///< bits of e
    std::vector<Piece> logarithm, fall;
    std::vector<std::int64_t> exponent;

    struct Steps {
        std::int64_t octave = 0, m = 0, w = 0, x = 0, fall = 0, y = 0;
    };

    int first_octave() const { return end_octave() - (1 << W); }
    int end_octave() const { return (1 << E) + 10; }

    std::int64_t fall_at(std::int64_t x) const {
        const int Q = V - H;
        const std::int64_t octave = x >> V;
        if (octave < first_octave()) return 0;
        if (octave >= end_octave()) return (std::int64_t{1} << (O + G)) - 1;
        const Piece& b = fall[static_cast<std::size_t>((x >> Q) & ((1 << (W + H)) - 1))];
        return b.base + ((b.slope * (x & ((1 << Q) - 1))) >> Q);
    }

    /// y, where n is above 1 and c neither 0 nor 1.
    std::int64_t result(std::int64_t fall_code) const { return (std::int64_t{1} << O) - 1 - (fall_code >> G); }

    // Each value is below 2^31; products below 2^48.
    Steps steps(int n, std::int64_t C) const {
        Steps s;
        const std::int64_t one = std::int64_t{1} << F;
        if (C == one) {
            s.y = std::int64_t{1} << O;
            return s;
        }
        const std::int64_t distance = one - 1 - C;
        const int e =
            std::min(F - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(distance))), (1 << E) - 1);
        const std::int64_t shifted = ((distance + 1) << e) - 1;
        s.octave = (1 << E) - 1 - e;
        s.m = shifted >= one / 2 ? (shifted - one / 2) >> (F - 1 - M) : 0;
        const int R = M - A;
        const Piece& a = logarithm[static_cast<std::size_t>((s.octave << A) + (s.m >> R))];
        s.w = a.base + ((a.slope * (s.m & ((1 << R) - 1))) >> R);

        const int k = static_cast<int>(std::bit_width(static_cast<unsigned>(n))) - 1;
        const std::int64_t lambda = exponent[static_cast<std::size_t>((n << (9 - k)) - 512)];
        s.x = s.w + lambda + ((s.octave + k + 6) << V);

        s.fall = fall_at(s.x);
        s.y = C == 0 ? 0 : n == 1 ? C >> (F - O) : result(s.fall);
        return s;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& s) const {
        return {{"C", C, F},   {"octave", s.octave, 0}, {"m", s.m, M}, {"w", s.w, V},
                {"x", s.x, V}, {"fall", s.fall, O + G}, {"y", s.y, O}};
    }

    double real(double c, double n) const { return reference::blinn_phong(c, n); }

    int base_bits() const { return V + 2; }
    int slope_bits() const { return V - std::min(A, 4) + 2; }
    int step_bits() const { return O + G - H - 1; }
};

/// The tables, of whose word lengths they are made: F, E, A and V; W, H, O and G; V.
std::vector<DecayFormat::Piece> logarithm_pieces(const DecayFormat& f);
std::vector<DecayFormat::Piece> fall_pieces(const DecayFormat& f);
std::vector<std::int64_t> exponent_entries(const DecayFormat& f);

/// The word lengths of a custom profile, F,A,M,V,H,G,W,n,O, without the tables. Throws Error where one is not legal.
DecayFormat decay_words(const std::vector<int>& numbers);

/// The numbers of a profile, shipped or custom. Throws Error where it has not nine.
std::vector<int> decay_numbers(const Profile& profile);

/// Lobe::error_bound: docs/lobes/decay.md, "Proof".
double decay_bound(const Profile& profile);

}  // namespace glint
