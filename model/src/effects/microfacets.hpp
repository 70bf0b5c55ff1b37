// What the two forms of Cook-Torrance share: the logarithm of G / N.V, and the last step, a factor times a power of two
// (docs/effects/cook_torrance.md, "Attenuation" and "Scaled power").
#pragma once

#include <algorithm>

#include "../lobes/exp_log.hpp"
#include "effect.hpp"

namespace glint::microfacets {

/// Integer bits beyond 1.0 of the result.
inline constexpr int E_out = 7;

/// Word lengths that follow from O, 8 .. 16.
struct WordLengths {
    int T = 0;  ///< address bits of log2
    int L = 0;  ///< fraction bits of logarithms
    int E = 0;  ///< address bits of exp2
    int S = 0;  ///< fraction bits of exponents
};
inline WordLengths word_lengths(int O) {
    const int quarter = (O + 3) / 4;
    return {quarter + 2, O + 9, quarter, O + 4};
}

/// The bits of a wide argument of log2 that lie below what L fraction bits of the result can show.
inline int cut(int F, int L) { return std::max(0, F + 1 - L); }

/// log2(G / N.V) for nl, nv, nh > 0 and vh >= 0.
struct Attenuation {
    exp_log::Log2 log2;

    struct Steps {
        std::int64_t ul = 0, uv = 0, uh = 0, uc = 0, loss = 0, gain = 0;
    };

    // u <= 31 2^L each, so |gain| < 64 2^L.
    Steps steps(std::int64_t nl, std::int64_t nv, std::int64_t nh, std::int64_t vh) const {
        Steps x;
        x.ul = log2.steps(nl).u;
        x.uv = log2.steps(nv).u;
        x.uh = log2.steps(nh).u;
        x.uc = log2.steps(vh).u;
        const std::int64_t lost = x.uh + std::max(x.ul, x.uv) - x.uc - (std::int64_t{1} << log2.L);
        x.loss = vh == 0 ? 0 : std::max<std::int64_t>(0, lost);
        x.gain = x.uv - x.loss;
        return x;
    }
};

inline Attenuation make_attenuation(std::string_view effect, int F, const WordLengths& w) {
    return {exp_log::make_log2(effect, F, w.T, w.L, cut(F, w.L))};
}

/// y = factor 2^-z at O fraction bits, saturating.
struct ScaledPower {
    int S = 0;  ///< fraction bits of z
    int K = 0;  ///< fraction bits of the factor, 0 .. 2
    int O = 0;
    exp_log::Exp2 exp2;

    struct Steps {
        std::int64_t p = 0, y = 0;
    };

    // p <= 2^S and factor <= 2^(K+1), so the product is at most 2^(S+K+1); from z = O + 3 on it rounds to 0. Below
    // z = -K - 8 even a factor of one unit saturates.
    Steps steps(std::int64_t z, std::int64_t factor) const {
        const std::int64_t most = (std::int64_t{1} << (O + 1 + E_out)) - 1;
        const std::int64_t i = std::clamp<std::int64_t>(z >> S, -K - 1 - E_out - 1, O + 3);
        Steps x;
        x.p = exp2.steps(z & ((std::int64_t{1} << S) - 1)).p;
        const std::int64_t product = x.p * factor;
        const auto shift = static_cast<int>(S + K - O + i);
        x.y = std::min(most, shift >= 0 ? rnd(product, shift) : product << -shift);
        return x;
    }
};

inline ScaledPower make_scaled_power(std::string_view effect, int K, int O, const WordLengths& w) {
    return {w.S, K, O, exp_log::make_exp2(effect, w.E, w.S, O)};
}

/// log2 of a term's size: -32 .. 16.
inline EffectPort level_port(const WordLengths& w) {
    return {
        "level", EffectPort::Kind::parameter, w.S + 6, true, w.S, -(std::int64_t{32} << w.S), std::int64_t{16} << w.S};
}

/// Throws Error unless the profile is legal for both forms.
inline void check_profile(std::string_view effect, const Profile& profile) {
    if (profile.O < 8) throw Error(fmt::format("O = {} is not legal for the effect {}: 8 to 16", profile.O, effect));
    check_output_bits(effect, profile, 16);
    const int least = (profile.O + 15) / 2, greatest = profile.O + 9;
    if (profile.F < least || profile.F > greatest) {
        throw Error(fmt::format("F = {} is not legal for the effect {} with O = {}: {} to {}", profile.F, effect,
                                profile.O, least, greatest));
    }
}

/// Of the Verilog and of the kernels.
inline std::vector<Constant> parameters(const Profile& profile, const WordLengths& w) {
    const auto text = [](int value) { return std::to_string(value); };
    return {{"F", text(profile.F), ""}, {"T", text(w.T), ""}, {"E", text(w.E), ""}, {"O", text(profile.O), ""}};
}
inline std::vector<Constant> constants(const Profile& profile, const WordLengths& w) {
    const auto text = [](int value) { return std::to_string(value); };
    return {{"int F", text(profile.F), "fraction bits of the dot products"},
            {"int T", text(w.T), "address bits of log2"},
            {"int L", text(w.L), "fraction bits of logarithms"},
            {"int E", text(w.E), "address bits of exp2"},
            {"int S", text(w.S), "fraction bits of exponents"},
            {"int O", text(profile.O), "fraction bits of the output"}};
}

/// The memories beside the Verilog: one per logarithm, all alike.
inline std::vector<Table> memories(const Attenuation& attenuation, const ScaledPower& power) {
    std::vector<Table> out;
    for (const std::string_view name : {"log2_nl", "log2_nv", "log2_nh", "log2_vh"}) {
        out.push_back(attenuation.log2.table(name));
    }
    out.push_back(power.exp2.table());
    return out;
}

}  // namespace glint::microfacets
