// glint_divide: the quotient of a fraction, in one of four forms of the same bits. At most one macro chooses:
//   none                      a subtraction and a choice a quotient bit
//   GLINT_DIVIDE_ADDING       an addition a quotient bit, whose sign is the bit
//   GLINT_DIVIDE_RADIX4       three subtractions and a choice for two quotient bits
//   GLINT_DIVIDE_RECIPROCAL   a table of reciprocals, products and a correction for up to 16 quotient bits
// What each costs: hls/README.md, "Forms of the divider".
#ifndef GLINT_DIVIDE_HPP
#define GLINT_DIVIDE_HPP

#if defined(GLINT_DIVIDE_ADDING) + defined(GLINT_DIVIDE_RADIX4) + defined(GLINT_DIVIDE_RECIPROCAL) > 1
#error "define at most one of GLINT_DIVIDE_ADDING, GLINT_DIVIDE_RADIX4, GLINT_DIVIDE_RECIPROCAL"
#endif

#include "glint_int.hpp"

#include "glint_names_begin.hpp"  // after all others

namespace glint_hls {

#if defined(GLINT_DIVIDE_ADDING)

/// quotient = floor((D - below) 2^S / D) for 0 <= below <= D, D > 0: S + 1 steps, one quotient bit each. A step is one
/// addition: it takes D off a partial remainder that is not negative and adds D to a negative one, and the sign of the
/// sum is the bit (division without restoring). The first sum, of D - below and -D, is -below. The partial remainder is
/// in -D .. D - 1, so all is modulo 2^(D_W + 1). Doubled it is even: the 1 that -D = ~D + 1 wants stands in its lowest
/// bit.
template <int S, int D_W>
uint<S + 1> divide_below(uint<D_W> below, uint<D_W> D) {
    const uint<D_W + 1> plus = D;
    const uint<D_W + 1> minus = to_uint<D_W + 1>(~plus);
    uint<D_W + 1> partial = to_uint<D_W + 1>(to_uint<D_W + 1>(0) - to_uint<D_W + 1>(below));
    uint<S + 1> quotient = to_uint<S + 1>(below == 0);
    GLINT_UNROLL
    for (int step = 1; step <= S; ++step) {
        GLINT_UNROLL_VITIS
        const bool subtract = (partial >> D_W) == 0;
        const uint<D_W + 1> doubled = to_uint<D_W + 1>(to_uint<D_W + 1>(partial << 1) | to_uint<D_W + 1>(subtract));
        partial = to_uint<D_W + 1>(doubled + (subtract ? minus : plus));
        quotient = to_uint<S + 1>(to_uint<S + 1>(quotient << 1) | to_uint<S + 1>((partial >> D_W) == 0));
    }
    return quotient;
}

#elif defined(GLINT_DIVIDE_RADIX4)

/// quotient = floor((D - below) 2^S / D) for 0 <= below <= D, D > 0: the bit of weight 1, then two bits a step, so
/// where S is odd one bit more than asked for, which is dropped. The remainder is below D; four times it has D_W + 2
/// bits, and less D, 2 D or 3 D a sign before those.
template <int S, int D_W>
uint<S + 1> divide_below(uint<D_W> below, uint<D_W> D) {
    constexpr int STEPS = (S + 1) / 2;
    constexpr int W = D_W + 3;
    const uint<W> once = to_uint<W>(D);
    const uint<W> twice = to_uint<W>(once << 1);
    const uint<W> thrice = to_uint<W>(once + twice);
    uint<D_W> remainder = to_uint<D_W>(below == 0 ? to_uint<D_W>(0) : to_uint<D_W>(D - below));
    uint<2 * STEPS + 1> quotient = to_uint<2 * STEPS + 1>(below == 0);
    GLINT_UNROLL
    for (int step = 0; step < STEPS; ++step) {
        GLINT_UNROLL_VITIS
        const uint<W> all = to_uint<W>(to_uint<W>(remainder) << 2);
        const uint<W> left1 = to_uint<W>(all - once);
        const uint<W> left2 = to_uint<W>(all - twice);
        const uint<W> left3 = to_uint<W>(all - thrice);
        const bool fits1 = (left1 >> (W - 1)) == 0;
        const bool fits2 = (left2 >> (W - 1)) == 0;
        const bool fits3 = (left3 >> (W - 1)) == 0;
        remainder = to_uint<D_W>(fits3 ? left3 : fits2 ? left2 : fits1 ? left1 : all);
        const uint<2> digit = to_uint<2>(fits3 ? 3 : fits2 ? 2 : fits1 ? 1 : 0);
        quotient = to_uint<2 * STEPS + 1>(to_uint<2 * STEPS + 1>(quotient << 2) | to_uint<2 * STEPS + 1>(digit));
    }
    return to_uint<S + 1>(quotient >> (2 * STEPS - S));
}

#elif defined(GLINT_DIVIDE_RECIPROCAL)

/// The table of glint_divider_reciprocal.v for K quotient bits a round, 2 to 16: tangents of 1 / x for x = 1 .. 2, at U
/// fraction bits, in 2^T intervals; slopes at V fraction bits. middle = m 2^(T+1), with m the middle of an interval;
/// slope = ceil(2^V / m^2); offset = floor(2^U (1 / m + 2^-(T+1) / m^2)) - ceil(slope / 2^DROP) - 1.
template <int K>
struct Reciprocals {
    static_assert(K >= 2 && K <= 16, "2 to 16 quotient bits a round");
    static constexpr int T = K > 2 ? (K - 1) / 2 : 1;
    static constexpr int W = T + 5;
    static constexpr int V = T + 5;
    static constexpr int G = K + 2;
    static constexpr int U = G + 4;
    static constexpr int DROP = T + V + W - U;

    std::uint16_t slopes[1 << T];
    std::uint32_t offsets[1 << T];

    constexpr Reciprocals() : slopes(), offsets() {
        for (int address = 0; address < 1 << T; ++address) {
            const std::uint64_t middle = (std::uint64_t{1} << (T + 1)) + static_cast<std::uint64_t>(address) * 2 + 1;
            const std::uint64_t square = middle * middle;
            const std::uint64_t slope = ((std::uint64_t{1} << (V + 2 * T + 2)) + square - 1) / square;
            const std::uint64_t first = ((middle + 1) << (U + T + 1)) / square;
            slopes[address] = static_cast<std::uint16_t>(slope);
            offsets[address] =
                static_cast<std::uint32_t>(first - ((slope + (std::uint64_t{1} << DROP) - 1) >> DROP) - 1);
        }
    }
};

/// quotient = floor((D - below) 2^S / D) for 0 <= below <= D, D > 0, in rounds of K bits, as glint_divider_reciprocal.v
/// finds them (docs/rtl.md): D is shifted until it begins with a 1; an estimate of K bits is at most 2 too small; the
/// remainder says what is missing. ROUNDS K may be more bits than asked for; those are dropped.
template <int S, int D_W>
uint<S + 1> divide_below(uint<D_W> below, uint<D_W> D) {
    constexpr int ROUNDS = (S + 15) / 16;
    constexpr int K = (S + ROUNDS - 1) / ROUNDS;
    static constexpr Reciprocals<K> table{};
    constexpr int T = Reciprocals<K>::T, W = Reciprocals<K>::W, G = Reciprocals<K>::G, U = Reciprocals<K>::U;
    constexpr int N_W = D_W > T + W + 1 ? D_W : T + W + 1;
    constexpr int L_W = N_W + 2;
    constexpr int P_W = N_W + K < 64 ? N_W + K : 64;  // of a product whose low L_W bits count
    constexpr int Q_W = ROUNDS * K;

    uint<N_W> divisor = to_uint<N_W>(to_uint<N_W>(D) << (N_W - D_W));
    uint<N_W> remainder = below == 0 ? to_uint<N_W>(0) : to_uint<N_W>(to_uint<N_W>(D - below) << (N_W - D_W));
    GLINT_UNROLL
    for (int step = 5; step >= 0; --step) {  // at most 63 zeros, by halves
        GLINT_UNROLL_VITIS
        const int count = 1 << step;
        if (count < N_W && (divisor >> (N_W - (count < N_W ? count : 0))) == 0) {
            divisor = to_uint<N_W>(divisor << count);
            remainder = to_uint<N_W>(remainder << count);
        }
    }

    const auto address = static_cast<unsigned>(to_uint<T>(divisor >> (N_W - 1 - T)));
    const uint<2 * W + 1> product =
        product_u<2 * W + 1>(to_uint<W + 1>(table.slopes[address]), to_uint<W>(divisor >> (N_W - 1 - T - W)));
    const uint<U + 1> line =
        to_uint<U + 1>(to_uint<U + 1>(table.offsets[address]) - to_uint<U + 1>(product >> Reciprocals<K>::DROP));
    const uint<G> reciprocal = to_uint<G>(line >> (U - G));  // below 1

    uint<Q_W> quotient = 0;
    GLINT_UNROLL
    for (int round = 0; round < ROUNDS; ++round) {
        GLINT_UNROLL_VITIS
        const uint<2 * G> scaled = product_u<2 * G>(reciprocal, to_uint<G>(remainder >> (N_W - G)));
        const uint<K> estimate = to_uint<K>(scaled >> (G + 1));
        const uint<L_W> taken = to_uint<L_W>(product_u<P_W>(divisor, estimate));
        const uint<L_W> left0 = to_uint<L_W>(to_uint<L_W>(to_uint<L_W>(remainder) << K) - taken);
        const uint<L_W> left1 = to_uint<L_W>(left0 - to_uint<L_W>(divisor));
        const uint<L_W> left2 = to_uint<L_W>(left0 - to_uint<L_W>(to_uint<L_W>(divisor) << 1));
        const bool fits1 = (left1 >> (L_W - 1)) == 0;
        const bool fits2 = (left2 >> (L_W - 1)) == 0;
        remainder = to_uint<N_W>(fits2 ? left2 : fits1 ? left1 : left0);
        const uint<K> digit = to_uint<K>(estimate + to_uint<K>(fits2 ? 2 : fits1 ? 1 : 0));
        quotient = to_uint<Q_W>(to_uint<Q_W + K>(to_uint<Q_W + K>(quotient) << K) | to_uint<Q_W>(digit));
    }
    const uint<S + 1> below_one = to_uint<S + 1>(quotient >> (Q_W - S));
    return below == 0 ? to_uint<S + 1>(to_uint<S + 1>(1) << S) : below_one;
}

#else

/// quotient = floor((D - below) 2^S / D) for 0 <= below <= D, D > 0: S + 1 steps, one quotient bit each. The remainder
/// is below D; doubled it has D_W + 1 bits.
template <int S, int D_W>
uint<S + 1> divide_below(uint<D_W> below, uint<D_W> D) {
    uint<D_W> remainder = to_uint<D_W>(below == 0 ? to_uint<D_W>(0) : to_uint<D_W>(D - below));
    uint<S + 1> quotient = to_uint<S + 1>(below == 0);
    GLINT_UNROLL
    for (int step = 1; step <= S; ++step) {
        GLINT_UNROLL_VITIS
        const uint<D_W + 2> doubled = to_uint<D_W + 2>(to_uint<D_W + 2>(remainder) << 1);
        const uint<D_W + 2> left = to_uint<D_W + 2>(doubled - to_uint<D_W + 2>(D));
        const bool fits = (left >> (D_W + 1)) == 0;
        remainder = to_uint<D_W>(fits ? left : doubled);
        quotient = to_uint<S + 1>(to_uint<S + 1>(quotient << 1) | to_uint<S + 1>(fits));
    }
    return quotient;
}

#endif

/// floor(x 2^S / D) for 0 <= x <= D, D > 0.
template <int S, int D_W>
uint<S + 1> divide(uint<D_W> x, uint<D_W> D) {
    return divide_below<S, D_W>(to_uint<D_W>(D - x), D);
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
