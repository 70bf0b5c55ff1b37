// glint_cayley: the HLS kernel of the lobe `cayley`. The arithmetic is that of docs/lobes/cayley.md.
#ifndef GLINT_CAYLEY_HPP
#define GLINT_CAYLEY_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants>
std::uint32_t cayley(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int A = Constants::A;
    constexpr int S = Constants::S;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(A == 0 || A == 2 || A == 4 || A == 8 || A == 16 || A == 32, "A: 0 or a power of two up to 32");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(S >= O && S <= 30 && F + S <= 56, "S: O to 30, F + S up to 56");
    constexpr int whole = A == 0 ? 8 : A;
    constexpr int log_power = whole == 2 ? 1 : whole == 4 ? 2 : whole == 8 ? 3 : whole == 16 ? 4 : 5;
    constexpr int X_W = F + 11;

    const Corrected<F> in = correct<F>(n, cos_code);
    const bool is_power = A == 0 && (in.n <= 6 || in.n == 8);
    const sint<11> difference = to_sint<11>(static_cast<sint<11>>(in.n) - whole);  // -31 .. 1021
    const sint<11> m = is_power ? to_sint<11>(0) : difference;
    const sint<X_W> x = to_sint<X_W>(product<X_W>(m, in.distance));  // -31 2^F .. 1021 2^F
    const sint<X_W> sixteenth = A == 0 ? floor_shift<4>(x) : to_sint<X_W>(0);

    // Before its cut to 0 num is -1021 2^F .. 2 whole 2^F. num <= den. Where num is cut the answer is 0 whatever den;
    // elsewhere x <= 2 whole C, with A = 0 a little more, 17.1 2^F, and den is below 4 whole 2^F, with A = 0 at most
    // 34.3 2^F.
    constexpr int N_W = F + log_power + 2;
    constexpr int D_W = A == 0 ? N_W + 1 : N_W;
    const sint<X_W> scaled_cosine = to_sint<X_W>(static_cast<sint<X_W>>(in.C) << (log_power + 1));
    const sint<X_W> uncut = to_sint<X_W>(scaled_cosine - x + sixteenth);
    const bool cut = uncut < 0;
    const sint<X_W + 1> whole_den = to_sint<X_W + 1>(sint<X_W + 1>{1} << (F + log_power + 1));
    const sint<X_W + 1> sum_den = to_sint<X_W + 1>(whole_den + x + sixteenth + floor_shift<4>(sixteenth));
    const uint<D_W> num = cut ? to_uint<D_W>(0) : to_uint<D_W>(uncut);
    const uint<D_W> den = cut ? to_uint<D_W>(1) : to_uint<D_W>(sum_den);

    const uint<S + 1> r = divide<S, D_W>(num, den);  // 0 .. 2^S
    const uint<3> chosen = A == 0 && in.n <= 6 ? to_uint<3>(in.n) : to_uint<3>(0);
    return word<F, O>(in, power<S, O, log_power - 1>(r, chosen));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
