// glint_gauss: the HLS kernel of the lobe `gauss`. The arithmetic is docs/lobes/gauss.md.
#ifndef GLINT_GAUSS_HPP
#define GLINT_GAUSS_HPP

#include "../blocks/glint_exp_log.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants>
std::uint32_t gauss(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int T = Constants::T;
    constexpr int L = Constants::L;
    constexpr int S = Constants::S;
    constexpr int R = F - T;
    constexpr int C1_W = L - T + 3;
    constexpr int C2_W = L - 2 * T + 1;

    // d = 2^F, which is c = 0, is the end of the last piece.
    const Corrected<F> in = correct<F>(n, cos_code);
    const bool end = (in.distance >> F) != 0;
    const auto index = end ? (1U << T) - 1U : static_cast<unsigned>(in.distance >> R);
    const uint<R + 1> r = end ? to_uint<R + 1>(uint<R + 1>{1} << R) : to_uint<R + 1>(to_uint<R>(in.distance));
    const uint<L + 1> v = parabola<R, 0, L + 1, C1_W, C2_W>(to_uint<L + 1>(Constants::angle_c0(index)),
                                                            to_sint<C1_W>(Constants::angle_c1(index)),
                                                            to_sint<C2_W>(Constants::angle_c2(index)), r);

    // At most 1023 * 1.78 * 2^L, also with the half that rounds it: 11 integer bits.
    const uint<L + 11> scaled = product_u<L + 11>(in.n, v);
    const uint<S + 11> t = to_uint<S + 11>(rnd<L - S>(scaled));
    return word<F, Constants::O>(in, exp2<Constants, S + 11>(t));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
