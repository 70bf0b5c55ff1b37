// glint_exp_log: the blocks log2 and exp2, and tables of quadratic pieces, for the kernels of blinn_phong,
// spherical_gaussian, gauss and ward. Names, arithmetic and ranges: docs/exp-log.md.
#ifndef GLINT_EXP_LOG_HPP
#define GLINT_EXP_LOG_HPP

#include "glint_unit.hpp"

#include "glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// c0 + rnd(h r, R + G), h = c1 + rnd(c2 r, R), for r = 0 .. 2^R. h has the width of c1; a product of a coefficient of
/// W bits with r, and the half that rounds it, fit W + R bits, since r / 2^R is at most 1.
template <int R, int G, int V_W, int C1_W, int C2_W>
uint<V_W> parabola(uint<V_W> c0, sint<C1_W> c1, sint<C2_W> c2, uint<R + 1> r) {
    const sint<C2_W + R> product2 = product<C2_W + R>(c2, r);
    const sint<C1_W> h = to_sint<C1_W>(c1 + to_sint<C1_W>(rnd<R>(product2)));
    const sint<C1_W + R> product1 = product<C1_W + R>(h, r);
    return to_uint<V_W>(to_sint<V_W + 1>(c0) + to_sint<V_W + 1>(rnd<R + G>(product1)));
}

/// u = -log2(C / 2^F) at L bits: 0 .. F 2^L, and 31 2^L for C = 0. Constants has F, T, L and the table log2; CUT low
/// bits of the normalised C are dropped.
template <class Constants, int CUT = 0>
GLINT_INLINE uint<Constants::L + 5> log2(uint<Constants::F + 1> C) {
    constexpr int F = Constants::F;
    constexpr int T = Constants::T;
    constexpr int L = Constants::L;
    constexpr int R = F - CUT - 1 - T;
    constexpr int C1_W = L - T + 2;
    constexpr int C2_W = L - 2 * T + 1;

    // Zeros before the leading one of F + 1 bits, 0 .. F, by halves: a step shifts where that loses nothing.
    uint<F + 1> normal = C;
    uint<5> z = 0;
    GLINT_UNROLL
    for (int step = 4; step >= 0; --step) {
        GLINT_UNROLL_VITIS
        const int count = 1 << step;
        if (count <= F && (normal >> (F + 1 - count)) == 0) {
            normal = to_uint<F + 1>(normal << count);
            z = to_uint<5>(z + count);
        }
    }
    const uint<F - CUT - 1> M = to_uint<F - CUT - 1>(normal >> (CUT + 1));
    const auto index = static_cast<unsigned>(M >> R);
    const uint<L> l =
        parabola<R, 0, L, C1_W, C2_W>(to_uint<L>(Constants::log2_c0(index)), to_sint<C1_W>(Constants::log2_c1(index)),
                                      to_sint<C2_W>(Constants::log2_c2(index)), to_uint<R + 1>(to_uint<R>(M)));
    const uint<L + 5> none = to_uint<L + 5>(to_uint<L + 5>(31) << L);
    return C == 0 ? none : to_uint<L + 5>(to_uint<L + 5>(to_uint<L + 5>(z) << L) - to_uint<L + 5>(l));
}

/// p = 2^-fraction at S bits, 1/2 .. 1, of a fraction at S bits. Constants has E, S and the table exp2.
template <class Constants>
uint<Constants::S + 1> exp2_fraction(uint<Constants::S> fraction) {
    constexpr int E = Constants::E;
    constexpr int S = Constants::S;
    constexpr int R = S - E;
    constexpr int C1_W = S - E + 3;
    constexpr int C2_W = S - 2 * E + 2;

    const auto index = static_cast<unsigned>(fraction >> R);
    return parabola<R, 2, S + 1, C1_W, C2_W>(
        to_uint<S + 1>(Constants::exp2_c0(index)), to_sint<C1_W>(Constants::exp2_c1(index)),
        to_sint<C2_W>(Constants::exp2_c2(index)), to_uint<R + 1>(to_uint<R>(fraction)));
}

/// y = 2^-t at O bits, of a t of T_W bits, S of them fraction. Constants has E, S, O and the table exp2.
template <class Constants, int T_W>
uint<Constants::O + 1> exp2(uint<T_W> t) {
    constexpr int S = Constants::S;
    constexpr int O = Constants::O;
    const uint<S + 1> p = exp2_fraction<Constants>(to_uint<S>(t));

    // y = rnd(p, S - O + the integer part): cut to one bit more, then rounded by that bit. Nothing is left of p from an
    // integer part of O + 2 on.
    const uint<T_W - S> integer_part = to_uint<T_W - S>(t >> S);
    constexpr int cut_off =
        S > O ? S - O - 1 : 0;  // of p, so that one bit below the last of y is left; or zeros follow
    constexpr int appended = S > O ? 0 : O + 1 - S;
    const uint<O + 2> top = to_uint<O + 2>(to_uint<O + 2>(p >> cut_off) << appended);
    const uint<O + 2> cut = integer_part > O + 1 ? to_uint<O + 2>(0) : to_uint<O + 2>(top >> to_uint<5>(integer_part));
    return to_uint<O + 1>(rnd<1>(cut));
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
