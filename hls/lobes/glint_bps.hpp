// glint_bps: the HLS kernel of the lobe `bps`. The arithmetic is that of docs/lobes/bps.md; a value here
// carries the name that it has there, and the width that the comment above it derives.
#ifndef GLINT_BPS_HPP
#define GLINT_BPS_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// Constants: a generated header, generated/glint_bps_<profile>_constants.hpp.
template <class Constants>
std::uint32_t bps(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int S = Constants::S;
    constexpr int K = Constants::K;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(S >= O && S <= 30, "S: O to 30");
    static_assert(K >= O && K <= 30, "K: O to 30");
    static_assert(Constants::a < 0, "a is negative");

    const Corrected<F> in = correct<F>(n, cos_code);
    const uint<S + 1> quotient = ratio<F, S>(in);

    // Horner steps. As real numbers, from the table of ranges in the contract with K >= 4:
    //   -1.67 < a q <= 0             h1 from  1.30 to 3.03: below 4 in magnitude, K + 3 bits
    //       0 <= h1 q < 1.47         h2 from -0.41 to 1.16: below 2, K + 2 bits
    //   -0.20 < h2 q + d0 < 1.19     y before the cut at 0: below 2, O + 2 bits
    // All products and sums are below 2 at K + S fraction bits, K + S + 2 bits, and stay so with the half of rnd added.
    // y is at most 2^O, which the model shows for every legal format: no upper clamp.
    constexpr int SUM_W = K + S + 2;
    const sint<K + 2> c1 = to_sint<K + 2>(Constants::c1);
    const sint<SUM_W> d0 = to_sint<SUM_W>(Constants::d0 * (std::int64_t{1} << S));  // d0 2^S

    // a is negative, so a q = -|a| + |a| (1 - q): the same bits by a product of two numbers without a sign.
    const uint<S + 1> rest = to_uint<S + 1>(to_uint<S + 1>(uint<S + 1>{1} << S) - quotient);
    const uint<SUM_W> product_a = product_u<SUM_W>(to_uint<K + 1>(-Constants::a), rest);
    const sint<K + 3> h1 =
        to_sint<K + 3>(to_sint<K + 3>(Constants::b + Constants::a) + to_sint<K + 3>(rnd<S>(product_a)));
    const sint<K + 2> h2 = to_sint<K + 2>(c1 + rnd<S>(product_s<SUM_W, K + 3>(h1, quotient)));
    const sint<SUM_W> sum = to_sint<SUM_W>(product_s<SUM_W, K + 2>(h2, quotient) + d0);
    const sint<O + 2> rounded = to_sint<O + 2>(rnd<S + K - O>(sum));

    return word<F, O>(in, rounded < 0 ? to_uint<O + 1>(0) : to_uint<O + 1>(rounded));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
