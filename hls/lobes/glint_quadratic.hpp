// glint_quadratic: the HLS kernel of the lobe `quadratic`. The arithmetic is docs/lobes/quadratic.md.
#ifndef GLINT_QUADRATIC_HPP
#define GLINT_QUADRATIC_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// Constants: a generated header, generated/glint_quadratic_<profile>_constants.hpp.
template <class Constants>
std::uint32_t quadratic(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int S = Constants::S;
    constexpr int K = Constants::K;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(K >= O && K <= 30 && F + K <= 52, "K: O to 30 and to 52 - F");
    static_assert(S >= O && S <= 30 && S <= F + K, "S: O to 30 and to F + K");

    const Corrected<F> in = correct<F>(n, cos_code);

    // slope < 2^K and n < 2^10: K + 10 bits; times d <= 2^F: below 2^(F+K+10).
    constexpr int P_W = F + K + 10;
    const uint<K + 10> scaled = product_u<K + 10>(to_uint<K>(Constants::slope), in.n);
    const uint<P_W> product_d = product_u<P_W>(scaled, in.distance);

    // line = max(0, 2^(F+K) - scaled d), between -2^(F+K+10) and 2^(F+K), with the half that rounds it below 2^(F+K+1):
    // one bit more for the sign. Rounded before it is cut: rnd is monotone and keeps 0.
    constexpr int CUT = F + K - S;
    constexpr std::int64_t offset = (std::int64_t{1} << (F + K)) + ((std::int64_t{1} << CUT) >> 1);
    const sint<P_W + 1> line = to_sint<P_W + 1>(to_sint<P_W + 1>(offset) - static_cast<sint<P_W + 1>>(product_d));
    const uint<S + 1> w = line < 0 ? to_uint<S + 1>(0) : to_uint<S + 1>(floor_shift<CUT>(line));  // 0 .. 2^S

    // C w <= 2^(F+S); with the half that rounds it still fits F + S + 1 bits.
    constexpr int Y_W = F + S + 1;
    const uint<Y_W> product_y = product_u<Y_W>(in.C, w);
    return word<F, O>(in, to_uint<O + 1>(rnd<F + S - O>(product_y)));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
