// glint_bps: the HLS kernel of the lobe `bps`. The arithmetic is the section `bps` of docs/contract.md; a value here
// carries the name that it has there, and the width that the comment above it derives.
#ifndef GLINT_BPS_HPP
#define GLINT_BPS_HPP

#include "glint_int.hpp"

// The top functions of the shipped profiles, one result a clock. Inputs: n, of which the low 10 bits count, and
// cos_code, of which the low F + 2 bits count (signed, code / 2^F). Result: y (code / 2^O) from bit 0, clamped in bit
// 31, else 0, as on the AXI4-Stream port of the Verilog.
extern "C" {
std::uint32_t glint_bps_p8(std::uint16_t n, std::int32_t cos_code);
std::uint32_t glint_bps_p12(std::uint16_t n, std::int32_t cos_code);
std::uint32_t glint_bps_p16(std::uint16_t n, std::int32_t cos_code);
}

namespace glint_hls {

/// quotient = floor(C 2^S / D) for 0 <= C <= D, D > 0: S + 1 restoring steps, one quotient bit each.
/// `partial` is what is left of the dividend, in units of the step's quotient bit. It enters a step with at most
/// 2 D - 1 (the first with C <= D), so `remainder`, with or without D taken off, is at most D - 1 and fits the width of
/// D; doubled for the next step it is at most 2 D - 2: one bit more.
template <int S, int D_W>
uint<S + 1> divide(uint<D_W> C, uint<D_W> D) {
    uint<D_W + 1> partial = C;
    uint<S + 1> quotient = 0;
#ifdef GLINT_HLS_PRAGMAS
#pragma hls_unroll yes
#ifdef __BAMBU__
#pragma clang loop unroll(full)
#endif
#endif
    for (int step = 0; step <= S; ++step) {
#ifdef GLINT_HLS_PRAGMAS
#pragma HLS UNROLL
#endif
        const bool fits = partial >= D;
        const uint<D_W> reduced = to_uint<D_W>(partial - D);
        const uint<D_W> remainder = fits ? reduced : to_uint<D_W>(partial);
        quotient = to_uint<S + 1>((quotient << 1) | to_uint<S + 1>(fits));
        partial = to_uint<D_W + 1>(to_uint<D_W + 1>(remainder) << 1);
    }
    return quotient;
}

template <class Constants>
struct BpsResult {
    uint<Constants::O + 1> y;  // code / 2^O, 0 .. 2^O
    bool clamped;              // an input was out of range and was corrected
};

/// The port semantics of the contract. Constants: a generated header, generated/glint_bps_<profile>_constants.hpp.
template <class Constants>
BpsResult<Constants> bps(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int S = Constants::S;
    constexpr int K = Constants::K;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(S >= O && S <= 30, "S: O to 30");
    static_assert(K >= O && K <= 30, "K: O to 30");

    // Corrections: n = 0 counts as 1, cos > 1 as 1; cos < 0 makes the result 0. C: 0 .. 2^F.
    const sint<F + 2> one = static_cast<sint<F + 2>>(sint<F + 2>{1} << F);
    const bool none = n == 0;
    const bool below = cos_code < 0;
    const bool above = cos_code > one;
    const uint<10> exponent = none ? to_uint<10>(1) : n;
    const uint<F + 1> C = below ? to_uint<F + 1>(0) : to_uint<F + 1>(above ? one : cos_code);

    // D = n 2^F - (n-1) C = C + n (2^F - C). The product is at most 1023 2^F, and so is D, which falls when C grows:
    // F + 10 bits for both.
    constexpr int D_W = F + 10;
    const uint<F + 1> distance = to_uint<F + 1>(one - static_cast<sint<F + 2>>(C));  // 0 .. 2^F
    const uint<D_W> D = to_uint<D_W>(C + to_uint<D_W>(to_uint<D_W>(exponent) * to_uint<D_W>(distance)));

    // C <= D, and D is never 0 (at least C, and at least n 2^F when C = 0): 0 <= quotient <= 2^S.
    const uint<S + 1> quotient = divide<S, D_W>(C, D);

    // Horner steps. As real numbers, from the table of ranges in the contract with K >= 4:
    //   -1.67 < a q <= 0             h1 from  1.30 to 3.03: below 4 in magnitude, K + 3 bits
    //       0 <= h1 q < 1.47         h2 from -0.41 to 1.16: below 2, K + 2 bits
    //   -0.20 < h2 q + d0 < 1.19     y before the cut at 0: below 2, O + 2 bits
    // All products and sums are below 2 at K + S fraction bits, K + S + 2 bits, and stay so with the half of rnd added.
    // y is at most 2^O, which the model shows for every legal format: no upper clamp.
    constexpr int SUM_W = K + S + 2;
    const sint<K + 2> a = to_sint<K + 2>(Constants::a);
    const sint<K + 3> b = to_sint<K + 3>(Constants::b);
    const sint<K + 2> c1 = to_sint<K + 2>(Constants::c1);
    const sint<SUM_W> d0 = to_sint<SUM_W>(Constants::d0 * (std::int64_t{1} << S));  // d0 2^S

    const sint<K + 3> h1 = to_sint<K + 3>(b + rnd<S>(product<SUM_W>(a, quotient)));
    const sint<K + 2> h2 = to_sint<K + 2>(c1 + rnd<S>(product<SUM_W>(h1, quotient)));
    const sint<SUM_W> sum = to_sint<SUM_W>(product<SUM_W>(h2, quotient) + d0);
    const sint<O + 2> rounded = to_sint<O + 2>(rnd<S + K - O>(sum));

    BpsResult<Constants> result;
    result.y = below || rounded < 0 ? to_uint<O + 1>(0) : to_uint<O + 1>(rounded);
    result.clamped = none || below || above;
    return result;
}

/// The body of a top function.
template <class Constants>
std::uint32_t bps_word(std::uint16_t n, std::int32_t cos_code) {
    const BpsResult<Constants> result = bps<Constants>(to_uint<10>(n), to_sint<Constants::F + 2>(cos_code));
    return to_uint<32>(result.y) | to_uint<32>(to_uint<32>(result.clamped) << 31);
}

}  // namespace glint_hls

#endif
