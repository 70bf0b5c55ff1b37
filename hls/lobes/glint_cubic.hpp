// glint_cubic: the HLS kernel of the lobe `cubic`. The arithmetic is docs/lobes/cubic.md.
#ifndef GLINT_CUBIC_HPP
#define GLINT_CUBIC_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants>
std::uint32_t cubic(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int S = Constants::S;
    constexpr int K = Constants::K;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(S >= O && S <= F, "S: O to F");
    static_assert(K >= O && K <= 30, "K: O to 30");

    const Corrected<F> in = correct<F>(n, cos_code);
    const auto row = static_cast<unsigned>(in.n);
    const uint<F + 1> cut = to_uint<F + 1>(Constants::row_cut(row));
    const sint<K + 1> g1 = to_sint<K + 1>(Constants::row_g1(row));
    const sint<K> g2 = to_sint<K>(Constants::row_g2(row));
    const sint<K - 3> g3 = to_sint<K - 3>(Constants::row_g3(row));

    // Where X < cut, n X <= 3 2^F: T is at most 3 2^S. Ranges of h2 and h1: the document's table.
    constexpr int SUM_W = K + S + 3;
    const bool beyond = in.distance >= cut;
    const uint<F + 11> scaled = scaled_distance<F>(in);
    const uint<F + 11> rounded = F == S ? scaled : rnd<(F > S ? F - S : 1)>(scaled);
    const uint<S + 2> T = beyond ? to_uint<S + 2>(0) : to_uint<S + 2>(rounded);
    const sint<K> h2 = to_sint<K>(g2 + rnd<S>(product<SUM_W>(g3, T)));
    const sint<K + 2> h1 = to_sint<K + 2>(g1 + rnd<S>(product<SUM_W>(h2, T)));
    const sint<SUM_W> one = static_cast<sint<SUM_W>>(sint<SUM_W>{1} << (K + S));
    const sint<SUM_W> sum = to_sint<SUM_W>(one + product<SUM_W>(h1, T));
    const sint<O + 3> y = to_sint<O + 3>(rnd<K + S - O>(sum));
    return word<F, O>(in, beyond || y < 0 ? to_uint<O + 1>(0) : to_uint<O + 1>(y));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
