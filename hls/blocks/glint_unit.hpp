// glint_unit: what the kernels of all lobes share: the corrections, the divider, the result word, the top functions.
// Names and arithmetic: docs/contract.md.
#ifndef GLINT_UNIT_HPP
#define GLINT_UNIT_HPP

#include "glint_int.hpp"

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

/// quotient = floor(x 2^S / D) for 0 <= x <= D, D > 0: S + 1 restoring steps, one quotient bit each.
/// `partial` is what is left of the dividend, in units of the step's quotient bit. It enters a step with at most
/// 2 D - 1 (the first with x <= D), so `remainder`, with or without D taken off, is at most D - 1 and fits the width of
/// D; doubled for the next step it is at most 2 D - 2: one bit more.
template <int S, int D_W>
uint<S + 1> divide(uint<D_W> x, uint<D_W> D) {
    uint<D_W + 1> partial = x;
    uint<S + 1> quotient = 0;
    GLINT_UNROLL
    for (int step = 0; step <= S; ++step) {
        GLINT_UNROLL_VITIS
        const bool fits = partial >= D;
        const uint<D_W> reduced = to_uint<D_W>(partial - D);
        const uint<D_W> remainder = fits ? reduced : to_uint<D_W>(partial);
        quotient = to_uint<S + 1>((quotient << 1) | to_uint<S + 1>(fits));
        partial = to_uint<D_W + 1>(to_uint<D_W + 1>(remainder) << 1);
    }
    return quotient;
}

/// n (2^F - C), at most 1023 2^F.
template <int F>
uint<F + 10> scaled_distance(const Corrected<F>& in) {
    return product_u<F + 10>(in.n, in.distance);
}

/// Schlick's fraction at S bits: floor(C 2^S / D), D = n 2^F - (n-1) C = C + n (2^F - C). D is at most n 2^F, since it
/// falls when C grows: F + 10 bits; and never 0 (at least C, and at least n 2^F when C = 0). 0 .. 2^S, since C <= D.
template <int F, int S>
uint<S + 1> ratio(const Corrected<F>& in) {
    const uint<F + 10> D = to_uint<F + 10>(in.C + scaled_distance<F>(in));
    return divide<S, F + 10>(in.C, D);
}

/// rnd(x^2, 2 S - R): the square of a fraction 0 .. 2^S, at R bits, 0 .. 2^R. Its product and half fit 2 S + 1 bits.
template <int S, int R>
uint<R + 1> square(uint<S + 1> x) {
    const uint<2 * S + 1> product = product_u<2 * S + 1>(x, x);
    return to_uint<R + 1>(rnd<2 * S - R>(product));
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
    const uint<2 * S + 1> exact = product_u<2 * S + 1>(left, right);
    return to_uint<O + 1>(rnd<2 * S - O>(exact));
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
