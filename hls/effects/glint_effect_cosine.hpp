// glint_effect_cosine: the HLS kernel of the effect `cosine`. The arithmetic is docs/effects/cosine.md.
#ifndef GLINT_EFFECT_COSINE_HPP
#define GLINT_EFFECT_COSINE_HPP

#include "../blocks/glint_effect.hpp"
#include "../blocks/glint_sqrt.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// A vector of three components of W bits.
template <int W>
struct Vector {
    sint<W> x, y, z;
};

/// a.b, at most 3 2^(2W-2) in magnitude: 2 W + 1 bits.
template <int W>
sint<2 * W + 1> dot(const Vector<W>& a, const Vector<W>& b) {
    const sint<2 * W + 1> xx = product<2 * W + 1>(a.x, b.x);
    const sint<2 * W + 1> yy = product<2 * W + 1>(a.y, b.y);
    const sint<2 * W + 1> zz = product<2 * W + 1>(a.z, b.z);
    return static_cast<sint<2 * W + 1>>(xx + yy + zz);
}

template <class Constants, class Word>
void effect_cosine(std::int32_t a_x, std::int32_t a_y, std::int32_t a_z, std::int32_t b_x, std::int32_t b_y,
                   std::int32_t b_z, Word* c, bool* clamped) {
    constexpr int W = Constants::W;
    constexpr int F = Constants::F;
    constexpr int K = F + 2;
    static_assert(W >= 8 && W <= 18 && F >= W - 1 && F <= 29, "W: 8 to 18, F: W - 1 to 29");

    const Vector<W> a = {to_sint<W>(a_x), to_sint<W>(a_y), to_sint<W>(a_z)};
    const Vector<W> b = {to_sint<W>(b_x), to_sint<W>(b_y), to_sint<W>(b_z)};
    const sint<2 * W + 1> p = dot<W>(a, b);
    const uint<2 * W> aa = to_uint<2 * W>(dot<W>(a, a));
    const uint<2 * W> bb = to_uint<2 * W>(dot<W>(b, b));

    // s = aa bb, up to 72 bits: as two words of 2 W bits, of four products of halves of W bits.
    const uint<W> aa_low = to_uint<W>(aa);
    const uint<W> aa_high = to_uint<W>(aa >> W);
    const uint<W> bb_low = to_uint<W>(bb);
    const uint<W> bb_high = to_uint<W>(bb >> W);
    const uint<2 * W> outer = product_u<2 * W>(aa_low, bb_low);
    const uint<2 * W + 2> cross_1 = product_u<2 * W + 2>(aa_high, bb_low);
    const uint<2 * W + 2> cross_2 = product_u<2 * W + 2>(aa_low, bb_high);
    const uint<2 * W + 2> middle = to_uint<2 * W + 2>(cross_1 + cross_2 + to_uint<2 * W + 2>(outer >> W));
    const uint<2 * W> top = product_u<2 * W>(aa_high, bb_high);
    uint<2 * W> high = to_uint<2 * W>(top + to_uint<2 * W>(middle >> W));
    uint<2 * W> low = to_uint<2 * W>(to_uint<2 * W>(to_uint<2 * W>(to_uint<W>(middle)) << W) | to_uint<W>(outer));

    // Up by 4 bits for each of the W nibbles that is 0 from the top, p by 2: by MOST nibbles up to three times, then by
    // MOST / 2, .., 1. |p| 4^j is below 2^(2W), since p^2 <= s.
    constexpr int MOST = W >= 16 ? 8 : 4;
    sint<2 * W + 1> moved = p;
    GLINT_UNROLL
    for (int step = 0; step < 6; ++step) {
        GLINT_UNROLL_VITIS
        const int nibbles = step < 3 ? MOST : MOST >> (step - 2);
        if (nibbles == 0) continue;
        const uint<2 * W> above = to_uint<2 * W>(high >> (2 * W - 4 * nibbles));
        if (above != 0) continue;
        // Where that is all of the word, the other one takes its place.
        const uint<2 * W> in = to_uint<2 * W>(low >> (2 * W - 4 * nibbles));
        high = 4 * nibbles == 2 * W ? low : to_uint<2 * W>(to_uint<2 * W>(high << (4 * nibbles % (2 * W))) | in);
        low = 4 * nibbles == 2 * W ? to_uint<2 * W>(0) : to_uint<2 * W>(low << (4 * nibbles % (2 * W)));
        moved = to_sint<2 * W + 1>(to_uint<2 * W + 1>(moved) << (2 * nibbles));
    }

    // The top 2 K bits of the 4 W; K is above W.
    const uint<2 * K> head = to_uint<2 * K>(to_uint<2 * K>(high) << (2 * K - 2 * W));
    constexpr int CUT = 4 * W - 2 * K;
    const uint<2 * K> tail = CUT >= 0 ? to_uint<2 * K>(low >> (CUT >= 0 ? CUT : 0))
                                      : to_uint<2 * K>(to_uint<2 * K>(low) << (CUT < 0 ? -CUT : 0));
    const uint<K> r = floor_sqrt<K>(to_uint<2 * K>(head | tail));

    // |c| = floor((|p| 4^j 2^(2F+3-2W) + r) / (2 r + 1)): the divisor is odd, so nothing is half between two results,
    // and the sign may wait. The dividend is below (2^F + 1) (2 r + 1): F + 1 steps, each with a remainder below the
    // divisor.
    constexpr int N = 2 * F + 4;
    const bool negative = moved < 0;
    const uint<2 * W + 1> magnitude = to_uint<2 * W + 1>(negative ? static_cast<sint<2 * W + 1>>(-moved) : moved);
    const uint<N> dividend = to_uint<N>(to_uint<N>(to_uint<N>(magnitude) << (2 * F + 3 - 2 * W)) + to_uint<N>(r));
    const uint<K + 1> divisor = to_uint<K + 1>(to_uint<K + 1>(to_uint<K + 1>(r) << 1) | 1U);
    uint<K + 2> remainder = to_uint<K + 2>(dividend >> (F + 1));
    uint<F + 1> quotient = 0;
    GLINT_UNROLL
    for (int step = F; step >= 0; --step) {
        GLINT_UNROLL_VITIS
        const uint<1> bit = to_uint<1>(dividend >> step);
        const uint<K + 2> partial = to_uint<K + 2>(to_uint<K + 2>(remainder << 1) | bit);
        const bool fits = partial >= divisor;
        remainder = fits ? to_uint<K + 2>(partial - divisor) : partial;
        quotient = to_uint<F + 1>(to_uint<F + 1>(quotient << 1) | to_uint<F + 1>(fits));
    }
    const sint<F + 2> positive = to_sint<F + 2>(quotient);
    const bool none = aa == 0 || bb == 0;
    *c = none ? static_cast<Word>(0) : static_cast<Word>(negative ? static_cast<sint<F + 2>>(-positive) : positive);
    *clamped = none;
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
