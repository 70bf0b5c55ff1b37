// glint_decay: the HLS kernel of the lobe `decay`. The arithmetic is docs/lobes/decay.md.
#ifndef GLINT_DECAY_HPP
#define GLINT_DECAY_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// A number of WIDTH bits shifted up, ones moving in from below, till its leading one is at the top, but by 2^KEPT_W -
/// 1 places at most: 2^KEPT_W - 1 less those places, and the REST_W bits after the leading one (0 where there is none).
template <int KEPT_W, int REST_W>
struct Normalised {
    uint<KEPT_W> kept;
    uint<REST_W> rest;
};
template <int WIDTH, int KEPT_W, int REST_W, bool FILL>
Normalised<KEPT_W, REST_W> normalise(uint<WIDTH> x) {
    uint<WIDTH> top = x;
    uint<KEPT_W> kept = 0;
    GLINT_UNROLL
    for (int j = KEPT_W - 1; j >= 0; --j) {
        GLINT_UNROLL_VITIS
        const int places = 1 << j;
        const bool keep = (top >> (WIDTH - places)) != 0;
        const uint<WIDTH> low = FILL ? to_uint<WIDTH>((uint<WIDTH + 1>{1} << places) - 1) : to_uint<WIDTH>(0);
        const uint<WIDTH> moved = to_uint<WIDTH>(to_uint<WIDTH>(top << places) | low);
        top = keep ? top : moved;
        kept = to_uint<KEPT_W>((kept << 1) | to_uint<KEPT_W>(keep));
    }
    const bool reached = (top >> (WIDTH - 1)) != 0;
    return {kept, reached ? to_uint<REST_W>(top >> (WIDTH - 1 - REST_W)) : to_uint<REST_W>(0)};
}

template <class Constants>
std::uint32_t decay(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int A = Constants::A;
    constexpr int M = Constants::M;
    constexpr int V = Constants::V;
    constexpr int H = Constants::H;
    constexpr int G = Constants::G;
    constexpr int W = Constants::W;
    constexpr int N = Constants::N;
    constexpr int O = Constants::O;
    constexpr int E = Constants::E;
    constexpr int R = M - A;
    constexpr int SLOPE_W = V + 2 - (A < 4 ? A : 4);
    constexpr int Q = V - H;
    constexpr int X_W = V + E + 2;
    constexpr int FALL_W = O + G;

    const Corrected<F> in = correct<F>(n, cos_code);

    // w: the octave and the piece of d - 1 = 2^F - 1 - C; of no use for C = 2^F.
    const Normalised<E, M> d = normalise<F, E, M, true>(to_uint<F>(~in.C));
    const auto piece = static_cast<unsigned>((static_cast<unsigned>(d.kept) << A) | (d.rest >> R));
    const uint<SLOPE_W> slope = to_uint<SLOPE_W>(Constants::logarithm_slope(piece));
    const uint<SLOPE_W + R> rise = to_uint<SLOPE_W + R>(to_uint<SLOPE_W + R>(slope) * to_uint<R>(d.rest));
    const uint<V + 3> w = to_uint<V + 3>(to_uint<V + 3>(Constants::logarithm_base(piece)) + to_uint<V + 3>(rise >> R));

    const Normalised<4, 9> exponent = normalise<10, 4, 9, false>(in.n);
    const unsigned entry = N != 0 ? static_cast<unsigned>(in.n) : static_cast<unsigned>(exponent.rest);
    const uint<V> lambda = to_uint<V>(Constants::exponent_lambda(entry));
    const uint<E + 2> octaves = to_uint<E + 2>(to_uint<E + 2>(d.kept) + to_uint<E + 2>(exponent.kept));
    const uint<X_W> x = to_uint<X_W>(to_uint<X_W>(to_uint<X_W>(octaves) << V) + to_uint<X_W>(lambda) + to_uint<X_W>(w));

    // fall: 0 before the octaves of its table, its greatest value after them.
    constexpr unsigned end = (1U << E) + 10U;
    const auto octave = static_cast<unsigned>(x >> V);
    const auto cell = static_cast<unsigned>(to_uint<W + H>(x >> Q));
    constexpr int STEP_W = O + G - H - 1;
    const uint<STEP_W> step = to_uint<STEP_W>(Constants::fall_slope(cell));
    const uint<STEP_W + Q> part = to_uint<STEP_W + Q>(to_uint<STEP_W + Q>(step) * to_uint<Q>(x));
    const uint<FALL_W> inside =
        to_uint<FALL_W>(to_uint<FALL_W>(Constants::fall_base(cell)) + to_uint<FALL_W>(part >> Q));
    const uint<FALL_W> top = to_uint<FALL_W>(~to_uint<FALL_W>(0));
    const uint<FALL_W> fall = octave + (1U << W) < end ? to_uint<FALL_W>(0) : octave >= end ? top : inside;

    const uint<F> low = to_uint<F>(in.C);
    const bool one = (in.C >> F) != 0;
    const uint<O> between = in.n == 1 ? to_uint<O>(low >> (F - O)) : to_uint<O>(~to_uint<O>(fall >> G));
    const uint<O + 1> y = one        ? to_uint<O + 1>(uint<O + 1>{1} << O)
                          : low == 0 ? to_uint<O + 1>(0)
                                     : to_uint<O + 1>(between);
    return word<F, O>(in, y);
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
