// glint_microfacets: what the kernels of cook_torrance and cook_torrance_modified share. Names, arithmetic and ranges:
// docs/effects/cook_torrance.md, sections "Attenuation" and "Scaled power".
#ifndef GLINT_MICROFACETS_HPP
#define GLINT_MICROFACETS_HPP

#include "glint_effect.hpp"
#include "glint_exp_log.hpp"

#include "glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// The dot products: dark where nl, nv or nh is not above 0; then the numbers are without meaning.
template <int F>
struct Facet {
    uint<F + 1> nl, nv, nh, vh;
    bool dark;
    bool clamped;
};

template <int F>
Facet<F> facet(std::int32_t nl_port, std::int32_t nv_port, std::int32_t nh_port, std::int32_t vh_port) {
    const Cut<sint<F + 2>> nl = cut_dot<F>(nl_port);
    const Cut<sint<F + 2>> nv = cut_dot<F>(nv_port);
    const Cut<sint<F + 2>> nh = cut_dot<F>(nh_port);
    const Cut<sint<F + 2>> vh = cut_dot<F>(vh_port);
    Facet<F> f;
    f.dark = nl.value <= 0 || nv.value <= 0 || nh.value <= 0;
    f.nl = to_uint<F + 1>(nl.value);
    f.nv = to_uint<F + 1>(nv.value);
    f.nh = to_uint<F + 1>(nh.value);
    f.vh = vh.value < 0 ? to_uint<F + 1>(0) : to_uint<F + 1>(vh.value);
    f.clamped = nl.clamped || nv.clamped || nh.clamped || vh.clamped;
    return f;
}

/// level: -32 .. 16 at S bits.
template <int S>
Cut<sint<S + 6>> cut_level(std::int32_t port) {
    const sint<S + 6> code = to_sint<S + 6>(port);
    const sint<S + 6> most = to_sint<S + 6>(sint<S + 6>{16} << S);
    const bool above = code > most;
    const Cut<sint<S + 6>> cut = {above ? most : code, above};
    return cut;
}

/// A code of W bits, at least 2^BOTTOM.
template <int W, int BOTTOM>
Cut<uint<W>> cut_from_one(std::uint32_t port) {
    const uint<W> code = to_uint<W>(port);
    const uint<W> one = to_uint<W>(uint<W>{1} << BOTTOM);
    const bool below = code < one;
    const Cut<uint<W>> cut = {below ? one : code, below};
    return cut;
}

/// -log2(N.H) and log2(G / N.V) at L bits. Each u is at most 31 2^L, so the sums are below 64 2^L in magnitude.
template <int L>
struct Gain {
    uint<L + 5> uh;
    sint<L + 7> gain;
};

template <class Constants>
Gain<Constants::L> attenuation(const Facet<Constants::F>& f) {
    constexpr int F = Constants::F;
    constexpr int L = Constants::L;
    constexpr int CUT = F + 1 > L ? F + 1 - L : 0;
    const uint<L + 5> ul = log2<Constants, CUT>(f.nl);
    const uint<L + 5> uv = log2<Constants, CUT>(f.nv);
    const uint<L + 5> uh = log2<Constants, CUT>(f.nh);
    const uint<L + 5> uc = log2<Constants, CUT>(f.vh);
    const sint<L + 7> one = to_sint<L + 7>(sint<L + 7>{1} << L);
    const sint<L + 7> lit = to_sint<L + 7>(to_sint<L + 7>(uh) + to_sint<L + 7>(ul > uv ? ul : uv));
    const sint<L + 7> lost = to_sint<L + 7>(lit - to_sint<L + 7>(to_sint<L + 7>(uc) + one));
    const sint<L + 7> loss = lost < 0 || f.vh == 0 ? to_sint<L + 7>(0) : lost;
    const Gain<L> out = {uh, to_sint<L + 7>(to_sint<L + 7>(uv) - loss)};
    return out;
}

/// min(2^(O+8) - 1, factor 2^-z) at O bits, of a z of Z_W bits, S of them fraction, and of a factor at K bits, 0 .. 2,
/// that is 0 or at least 2^-BELOW. Between the z that saturate whatever the factor is and those that leave nothing the
/// product is shifted by j, 0 .. O + 10 + BELOW, from a place where it has one bit more than its half at j = 0.
template <class Constants, int K, int BELOW, int Z_W>
uint<Constants::O + 8> scaled_power(sint<Z_W> z, uint<K + 2> factor) {
    constexpr int S = Constants::S;
    constexpr int O = Constants::O;
    constexpr int BASE = S + K - O - 8 - BELOW;
    constexpr int DROP = BASE > 1 ? BASE - 1 : 0;
    constexpr int PAD = BASE > 1 ? 0 : 1 - BASE;
    constexpr int OPERAND_W = S + K + 2 - DROP + PAD;

    const uint<S + 1> p = exp2_fraction<Constants>(to_uint<S>(z));
    const uint<S + K + 2> product = product_u<S + K + 2>(p, factor);
    const uint<OPERAND_W> operand = to_uint<OPERAND_W>(to_uint<OPERAND_W>(product >> DROP) << PAD);
    const sint<Z_W - S + 1> j = to_sint<Z_W - S + 1>(to_sint<Z_W - S + 1>(z >> S) + 8 + BELOW);
    const bool nothing = factor == 0 || j > O + 10 + BELOW;
    const uint<OPERAND_W> cut = to_uint<OPERAND_W>(operand >> (nothing || j < 0 ? to_uint<6>(0) : to_uint<6>(j)));
    const uint<OPERAND_W> rounded = rnd<1>(cut);
    const uint<OPERAND_W> most = to_uint<OPERAND_W>((std::uint64_t{1} << (O + 8)) - 1);
    const bool full = j < 0 || rounded > most;
    return to_uint<O + 8>(nothing ? to_uint<OPERAND_W>(0) : full ? most : rounded);
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
