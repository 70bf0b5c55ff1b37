// glint_polynomial: the HLS kernel of the lobe `polynomial`. The arithmetic is docs/lobes/polynomial.md.
#ifndef GLINT_POLYNOMIAL_HPP
#define GLINT_POLYNOMIAL_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// t at S bits: floor((2^F + C) 2^S / D), D = 2^F + C + 2 n (2^F - C). D falls when C grows, from (2 n + 1) 2^F: F + 11
/// bits, never 0, and at least 2^F + C, so 0 .. 2^S.
template <int F, int S>
uint<S + 1> ratio_symmetric(const Corrected<F>& in) {
    const uint<F + 11> numerator =
        to_uint<F + 11>(static_cast<uint<F + 11>>(to_uint<F + 11>(1) << F) + to_uint<F + 11>(in.C));
    const uint<F + 11> twice = to_uint<F + 11>(to_uint<F + 11>(scaled_distance<F>(in)) << 1);
    return divide_below<S, F + 11>(twice, to_uint<F + 11>(numerator + twice));
}

/// The variable by its number: 0 s, 1 t.
template <int Variable, int F, int S>
std::enable_if_t<Variable == 0, uint<S + 1>> variable(const Corrected<F>& in) {
    return ratio<F, S>(in);
}
template <int Variable, int F, int S>
std::enable_if_t<Variable == 1, uint<S + 1>> variable(const Corrected<F>& in) {
    return ratio_symmetric<F, S>(in);
}

/// k<i> at K bits. No array: at -O0 a compiler may fill one by a call of memset.
template <class Constants>
constexpr std::int64_t coefficient(int i) {
    return i == 0   ? Constants::k0
           : i == 1 ? Constants::k1
           : i == 2 ? Constants::k2
           : i == 3 ? Constants::k3
           : i == 4 ? Constants::k4
           : i == 5 ? Constants::k5
                    : Constants::k6;
}

/// Constants: a generated header, generated/glint_polynomial_<profile>_constants.hpp.
template <class Constants>
std::uint32_t polynomial(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int S = Constants::S;
    constexpr int K = Constants::K;
    constexpr int O = Constants::O;
    constexpr int I = Constants::I;
    constexpr int DEGREE = Constants::DEGREE;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(S >= O && S <= 30, "S: O to 30");
    static_assert(K >= O && K <= 30, "K: O to 30");
    static_assert(I >= 1 && I + K + S <= 62, "I: 1 to 62 - K - S");
    static_assert(DEGREE >= 2 && DEGREE <= 6, "DEGREE: 2 to 6");

    const Corrected<F> in = correct<F>(n, cos_code);
    const uint<S + 1> quotient = variable<Constants::VARIABLE, F, S>(in);

    // Horner steps. I is such that each h, and the last sum with the half that rounds it, is below 2^I in magnitude as
    // a real number: the model shows it for these coefficients. With 0 <= q <= 1 the products are too: K + I + 1 bits
    // with the sign, S more for a product.
    constexpr int H_W = K + I + 1;
    constexpr int SUM_W = H_W + S;
    sint<H_W> h = to_sint<H_W>(coefficient<Constants>(DEGREE));
    GLINT_UNROLL
    for (int i = DEGREE - 1; i > 0; --i) {
        GLINT_UNROLL_VITIS
        h = to_sint<H_W>(to_sint<H_W>(coefficient<Constants>(i)) + to_sint<H_W>(rnd<S>(product<SUM_W>(h, quotient))));
    }
    const sint<SUM_W> k0 = to_sint<SUM_W>(Constants::k0 * (std::int64_t{1} << S));
    const sint<SUM_W> sum = to_sint<SUM_W>(product<SUM_W>(h, quotient) + k0);
    const sint<I + O + 1> r = to_sint<I + O + 1>(rnd<S + K - O>(sum));
    const sint<I + O + 1> one = to_sint<I + O + 1>(std::int64_t{1} << O);

    return word<F, O>(in, r < 0 ? to_uint<O + 1>(0) : to_uint<O + 1>(r > one ? one : r));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
