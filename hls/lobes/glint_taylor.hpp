// glint_taylor: the HLS kernel of the lobe `taylor`. The arithmetic is that of docs/lobes/taylor.md.
#ifndef GLINT_TAYLOR_HPP
#define GLINT_TAYLOR_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// C at S bits: rnd(C, F - S), or C 2^(S-F).
template <int F, int S, bool wider>
struct Resized {
    static uint<S + 1> of(uint<F + 1> C) { return to_uint<S + 1>(to_uint<S + 1>(C) << (S - F)); }
};
template <int F, int S>
struct Resized<F, S, false> {
    static uint<S + 1> of(uint<F + 1> C) { return to_uint<S + 1>(rnd<F - S>(to_uint<F + 2>(C))); }
};

template <class Constants>
std::uint32_t taylor(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int A = Constants::A;
    constexpr int E = Constants::E;
    constexpr int S = Constants::S;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 29, "F: 8 to 29");
    static_assert(A == 8 || A == 16 || A == 32, "A: 8, 16, 32");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(S >= O && S <= 30, "S: O to 30");
    static_assert(E >= F && E >= S && E <= 2 * F && E <= 50, "E: max(F, S) to min(2 F, 50)");
    constexpr int log_a = A == 8 ? 3 : A == 16 ? 4 : 5;
    constexpr int sum_w = 2 * F + 4;  // the sum is at most 13 2^(2F)

    const Corrected<F> in = correct<F>(n, cos_code);
    const uint<sum_w> square_d = square_of_fraction<F>(in.distance);
    const uint<sum_w> five_squares = to_uint<sum_w>(to_uint<sum_w>(square_d << 2) + square_d);
    const uint<sum_w> sum_e = to_uint<sum_w>(to_uint<sum_w>(to_uint<sum_w>(in.distance) << (F + 3)) + five_squares);
    const uint<E + 1> e = to_uint<E + 1>(rnd<2 * F + 3 - E>(sum_e));  // at most 1.625 2^E
    const uint<E + 11> x = product_u<E + 11>(in.n, e);                // n e
    const uint<E + 11> one = to_uint<E + 11>(uint<E + 11>{1} << (E + log_a));
    const bool cut = x >= one;

    const uint<E + 11> rest = cut ? to_uint<E + 11>(0) : to_uint<E + 11>(one - x);
    const uint<S + 1> v = to_uint<S + 1>(rnd<E + log_a - S>(rest));  // 0 .. 2^S
    const uint<S + 1> half = to_uint<S + 1>(uint<S + 1>{1} << (S - 1));
    const uint<S + 1> base = cut ? to_uint<S + 1>(0) : to_uint<S + 1>(half + square<S, S - 1>(v));

    const bool is_power = in.n <= 6 || in.n == 8;
    const uint<S + 1> r = is_power ? Resized<F, S, (S >= F)>::of(in.C) : base;
    const uint<3> chosen = in.n <= 6 ? to_uint<3>(in.n) : to_uint<3>(in.n == 8 ? 7 : 0);
    return word<F, O>(in, power<S, O, log_a - 1>(r, chosen));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
