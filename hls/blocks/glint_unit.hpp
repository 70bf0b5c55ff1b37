// glint_unit: what the kernels of all lobes share: the corrections, products of fractions, powers, the result word.
// Names and arithmetic: docs/contract.md.
#ifndef GLINT_UNIT_HPP
#define GLINT_UNIT_HPP

#include "glint_divide.hpp"

#include "glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// An input after the corrections of the contract's section "Ports".
template <int F>
struct Corrected {
    uint<10> n;            // 1 .. 1023
    uint<F + 1> C;         // the cosine, 0 .. 2^F
    uint<F + 1> distance;  // 2^F - C
    bool negative;         // cos < 0: the result is 0
    bool clamped;          // something was corrected
};

template <int F>
Corrected<F> correct(uint<10> n, sint<F + 2> cos_code) {
    const sint<F + 2> one = static_cast<sint<F + 2>>(sint<F + 2>{1} << F);
    const bool none = n == 0;
    const bool below = cos_code < 0;
    const bool above = cos_code > one;
    Corrected<F> in;
    in.n = none ? to_uint<10>(1) : n;
    in.C = below ? to_uint<F + 1>(0) : to_uint<F + 1>(above ? one : cos_code);
    in.distance = to_uint<F + 1>(one - static_cast<sint<F + 2>>(in.C));
    in.negative = below;
    in.clamped = none || below || above;
    return in;
}

/// x y for x <= 2^X and y <= 2^Y: X-by-Y bits of a multiplier. Where a factor has its top bit, its other bits are 0, so
/// at most one of the three parts is not 0. (A choice between them would let a compiler drop the cut of the factors.)
template <int X, int Y>
uint<X + Y + 1> product_of_fractions(uint<X + 1> x, uint<Y + 1> y) {
    constexpr int W = X + Y + 1;
    const uint<W> low = product_u<W>(to_uint<X>(x), to_uint<Y>(y));
    const uint<W> of_x = (x >> X) != 0 ? to_uint<W>(to_uint<W>(y) << X) : to_uint<W>(0);
    const uint<W> of_y = (y >> Y) != 0 ? to_uint<W>(to_uint<W>(to_uint<X>(x)) << Y) : to_uint<W>(0);
    return to_uint<W>(low | of_x | of_y);
}

/// n (2^F - C), at most 1023 2^F, with F bits of a multiplier as above.
template <int F>
uint<F + 10> scaled_distance(const Corrected<F>& in) {
    const uint<F + 10> low = product_u<F + 10>(in.n, to_uint<F>(in.distance));
    const uint<F + 10> all = to_uint<F + 10>(to_uint<F + 10>(in.n) << F);
    return to_uint<F + 10>(low | ((in.distance >> F) != 0 ? all : to_uint<F + 10>(0)));
}

/// Schlick's fraction at S bits: floor(C 2^S / D), D = n 2^F - (n-1) C = C + n (2^F - C). D is at most n 2^F, since it
/// falls when C grows: F + 10 bits; and never 0 (at least C, and at least n 2^F when C = 0). 0 .. 2^S, since C <= D.
template <int F, int S>
uint<S + 1> ratio(const Corrected<F>& in) {
    const uint<F + 10> below = scaled_distance<F>(in);
    return divide_below<S, F + 10>(below, to_uint<F + 10>(in.C + below));
}

/// x^2 of x <= 2^S: S-by-S bits of a multiplier, since the other bits of 2^S are 0.
template <int S>
uint<2 * S + 1> square_of_fraction(uint<S + 1> x) {
    const uint<2 * S + 1> low = product_u<2 * S + 1>(to_uint<S>(x), to_uint<S>(x));
    return to_uint<2 * S + 1>(low | to_uint<2 * S + 1>(to_uint<2 * S + 1>(x >> S) << (2 * S)));
}

/// rnd(x^2, 2 S - R): the square of a fraction 0 .. 2^S, at R bits, 0 .. 2^R. Its product and half fit 2 S + 1 bits.
template <int S, int R>
uint<R + 1> square(uint<S + 1> x) {
    return to_uint<R + 1>(rnd<2 * S - R>(square_of_fraction<S>(x)));
}

/// A power of a fraction r = 0 .. 2^S, by SQUARES squarings at S bits and one product, rounded to O bits: 1 to 6 is
/// that power, 7 the eighth (with SQUARES of 2 or more), 0 the power 2^(SQUARES + 1).
template <int S, int O, int SQUARES>
uint<O + 1> power(uint<S + 1> r, uint<3> chosen) {
    uint<S + 1> powers[SQUARES + 1];
    powers[0] = r;
    GLINT_UNROLL
    for (int i = 1; i <= SQUARES; ++i) {
        GLINT_UNROLL_VITIS
        powers[i] = square<S, S>(powers[i - 1]);
    }
    const uint<S + 1> one = to_uint<S + 1>(uint<S + 1>{1} << S);
    const uint<S + 1> last = powers[SQUARES];
    const uint<S + 1> r2 = powers[SQUARES >= 1 ? 1 : 0];
    const uint<S + 1> r4 = powers[SQUARES >= 2 ? 2 : 0];
    const bool takes_r = chosen == 2 || chosen == 3 || chosen == 5;
    const bool takes_r2 = chosen == 4 || chosen == 6;
    const uint<S + 1> left = chosen == 0 ? last : chosen <= 2 ? r : chosen <= 4 ? r2 : r4;
    const uint<S + 1> right = chosen == 0 ? last : chosen == 1 ? one : takes_r ? r : takes_r2 ? r2 : r4;
    return to_uint<O + 1>(rnd<2 * S - O>(product_of_fractions<S, S>(left, right)));
}

/// The result word: y from bit 0, 0 where cos < 0; clamped in bit 31.
template <int F, int O>
std::uint32_t word(const Corrected<F>& in, uint<O + 1> y) {
    const uint<32> value = in.negative ? to_uint<32>(0) : to_uint<32>(y);
    return static_cast<std::uint32_t>(value | to_uint<32>(to_uint<32>(in.clamped) << 31));
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
