// glint_effect_cook_torrance: the HLS kernel of the effect `cook_torrance`. The arithmetic is
// docs/effects/cook_torrance.md.
#ifndef GLINT_EFFECT_COOK_TORRANCE_HPP
#define GLINT_EFFECT_COOK_TORRANCE_HPP

#include "../blocks/glint_microfacets.hpp"
#include "../blocks/glint_sqrt.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// The constants for the logarithm of q / 8, which has R + 3 = O + 13 fraction bits.
template <class Constants>
struct LogarithmOfQ : Constants {
    static constexpr int F = Constants::O + 13;
};

/// floor(x / D) for x < D 2^S, D > 0: the upper D_W bits of x are the first remainder, and a step takes in one of the S
/// others.
template <int S, int D_W>
uint<S> divide_whole(uint<D_W + S> x, uint<D_W> D) {
    uint<D_W> remainder = to_uint<D_W>(x >> S);
    uint<S> quotient = 0;
    GLINT_UNROLL
    for (int step = 1; step <= S; ++step) {
        GLINT_UNROLL_VITIS
        const uint<1> next = to_uint<1>(x >> (S - step));
        const uint<D_W + 2> doubled = to_uint<D_W + 2>(to_uint<D_W + 2>(to_uint<D_W + 2>(remainder) << 1) | next);
        const uint<D_W + 2> left = to_uint<D_W + 2>(doubled - to_uint<D_W + 2>(D));
        const bool fits = (left >> (D_W + 1)) == 0;
        remainder = to_uint<D_W>(fits ? left : doubled);
        quotient = to_uint<S>(to_uint<S>(quotient << 1) | to_uint<S>(fits));
    }
    return quotient;
}

/// t = falloff (1 - N.H^2) / N.H^2 at S bits, below 2^7; beyond: it is not.
template <int S>
struct Tangent {
    uint<S + 7> t;
    bool beyond;
};

template <class Constants>
Tangent<Constants::S> tangent(uint<Constants::F + 1> nh, uint<Constants::O + 10> falloff) {
    constexpr int F = Constants::F;
    constexpr int O = Constants::O;
    constexpr int S = Constants::S;
    constexpr int W = O + 14;
    constexpr int PRODUCT_W = O + 10 + W;      // s is 2^W only where nh is 0, and then falloff 2^W fits, too
    constexpr int DIVIDEND_W = W + 1 + S + 7;  // where t is below 2^7
    const uint<2 * F + 1> one = to_uint<2 * F + 1>(uint<2 * F + 1>{1} << (2 * F));
    const uint<2 * F + 1> square = product_u<2 * F + 1>(nh, nh);
    const uint<W + 1> s = to_uint<W + 1>(to_uint<2 * F + 1>(one - square) >> (2 * F - W));
    const uint<W + 1> e = to_uint<W + 1>(to_uint<W + 1>(uint<W + 1>{1} << W) - s);
    const uint<PRODUCT_W> product = product_u<PRODUCT_W>(falloff, s);
    Tangent<S> out;
    out.beyond = to_uint<W + 3>(product >> (O + 7)) >= e;
    const uint<DIVIDEND_W> dividend = to_uint<DIVIDEND_W>(to_uint<DIVIDEND_W>(product) << (S - O));
    const uint<S + 7> quotient = divide_whole<S + 7, W + 1>(dividend, e);
    out.t = out.beyond ? to_uint<S + 7>(0) : quotient;
    return out;
}

template <class Constants, class Word>
void effect_cook_torrance(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t vh,
                          std::uint32_t falloff_port, std::int32_t level_port, std::uint32_t excess_port, Word* y,
                          bool* clamped) {
    constexpr int F = Constants::F;
    constexpr int L = Constants::L;
    constexpr int O = Constants::O;
    constexpr int S = Constants::S;
    constexpr int R = O + 10;

    const Facet<F> f = facet<F>(nl, nv, nh, vh);
    const Cut<uint<O + 10>> falloff = cut_from_one<O + 10, O>(falloff_port);
    const Cut<sint<S + 6>> level = cut_level<S>(level_port);
    const uint<16> asked = to_uint<16>(excess_port);
    const uint<16> greatest = to_uint<16>(15U << 12);
    const uint<16> excess = asked > greatest ? greatest : asked;
    *clamped = f.clamped || falloff.clamped || level.clamped || asked > greatest;

    const Tangent<S> t = tangent<Constants>(f.nh, falloff.value);

    // root^2 <= excess + vh^2 <= 16: 2 R + 5 bits.
    const uint<2 * R + 6> vh_square = to_uint<2 * R + 6>(product_u<2 * R + 6>(f.vh, f.vh) << (2 * R - 2 * F));
    const uint<2 * R + 6> excess_wide = to_uint<2 * R + 6>(to_uint<2 * R + 6>(excess) << (2 * R - 12));
    const uint<R + 3> root = floor_sqrt<R + 3>(to_uint<2 * R + 6>(excess_wide + vh_square));
    const uint<R + 3> q = to_uint<R + 3>(root + to_uint<R + 3>(to_uint<R + 3>(f.vh) << (R - F)));
    const uint<L + 5> uq = log2<LogarithmOfQ<Constants>, R + 4 - L>(to_uint<R + 4>(q));

    // across at most 4; the numerator's magnitude at most the denominator, which is 1 .. 4.
    const uint<F + R + 4> across_exact = product_u<F + R + 4>(f.vh, root);
    const sint<S + 4> across = to_sint<S + 4>(rnd<F + R - S>(across_exact));
    const uint<2 * F + 1> vh_exact = product_u<2 * F + 1>(f.vh, f.vh);
    const sint<S + 4> square_vh = to_sint<S + 4>(rnd<2 * F - S>(vh_exact));
    const sint<S + 4> rest = to_sint<S + 4>(square_vh - to_sint<S + 4>(sint<S + 4>{1} << S));
    const sint<S + 4> numerator = to_sint<S + 4>(across + rest);
    const uint<S + 3> magnitude = to_uint<S + 3>(numerator < 0 ? to_sint<S + 4>(-numerator) : numerator);
    const uint<S + 3> denominator = to_uint<S + 3>(to_sint<S + 4>(across - rest));
    const uint<S + 1> ratio = divide<S, S + 3>(magnitude, denominator);
    const uint<S + 2> factor =
        to_uint<S + 2>(to_uint<S + 2>(uint<S + 2>{1} << S) + to_uint<S + 2>(square<S, S>(ratio)));

    // -96 .. 295 and -283 .. 234: 10 bits before the point.
    const Gain<L> g = attenuation<Constants>(f);
    const sint<L + 10> logarithms = to_sint<L + 10>(to_sint<L + 10>(to_sint<L + 10>(g.uh) + to_sint<L + 10>(uq)) * 4);
    const sint<L + 10> sum = to_sint<L + 10>(to_sint<L + 10>(g.gain) + logarithms);
    const sint<S + 10> known = to_sint<S + 10>(to_sint<S + 10>(rnd<L - S>(sum)) + to_sint<S + 10>(level.value));
    const sint<S + 10> twelve = to_sint<S + 10>(sint<S + 10>{12} << S);
    const sint<S + 10> z = to_sint<S + 10>(to_sint<S + 10>(twelve + to_sint<S + 10>(t.t)) - known);

    const uint<O + 8> value = scaled_power<Constants, S, 0, S + 10>(z, factor);
    *y = f.dark || t.beyond || excess == 0 ? static_cast<Word>(0) : static_cast<Word>(value);
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
