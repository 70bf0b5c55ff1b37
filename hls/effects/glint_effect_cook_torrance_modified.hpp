// glint_effect_cook_torrance_modified: the HLS kernel of the effect `cook_torrance_modified`. The arithmetic is
// docs/effects/cook_torrance_modified.md.
#ifndef GLINT_EFFECT_COOK_TORRANCE_MODIFIED_HPP
#define GLINT_EFFECT_COOK_TORRANCE_MODIFIED_HPP

#include "../blocks/glint_microfacets.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// c + rnd(h x, K) of Horner's rule, of an h of H_W bits; the result has one bit more than h. 0 <= x < 1 at K bits, so
/// the product with the half that rounds it fits H_W + K bits.
template <int K, int H_W>
sint<H_W + 1> horner(sint<K + 4> c, sint<H_W> h, uint<K> x) {
    const sint<H_W + K> exact = product<H_W + K>(h, x);
    return to_sint<H_W + 1>(to_sint<H_W + 1>(c) + to_sint<H_W + 1>(rnd<K>(exact)));
}

template <class Constants, class Word>
void effect_cook_torrance_modified(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t vh,
                                   std::int32_t level_port, std::uint32_t stretch_port, std::int32_t c0,
                                   std::int32_t c1, std::int32_t c2, std::int32_t c3, Word* y, bool* clamped) {
    constexpr int F = Constants::F;
    constexpr int L = Constants::L;
    constexpr int O = Constants::O;
    constexpr int S = Constants::S;
    constexpr int K = O + 5;

    const Facet<F> f = facet<F>(nl, nv, nh, vh);
    const Cut<sint<S + 6>> level = cut_level<S>(level_port);
    const Cut<uint<18>> stretch = cut_from_one<18, 8>(stretch_port);
    *clamped = f.clamped || level.clamped || stretch.clamped;

    // Below 1024 at F + 8 bits; past the end, 1, the result is 0 whatever x is.
    const uint<F + 1> distance = to_uint<F + 1>(to_uint<F + 1>(uint<F + 1>{1} << F) - f.nh);
    const uint<F + 19> stretched = product_u<F + 19>(distance, stretch.value);
    const bool past = (stretched >> (F + 8)) != 0;
    const uint<K> x = to_uint<K>(stretched >> (F + 8 - K));

    const sint<K + 5> h1 = horner<K, K + 4>(to_sint<K + 4>(c2), to_sint<K + 4>(c3), x);
    const sint<K + 6> h2 = horner<K, K + 5>(to_sint<K + 4>(c1), h1, x);
    const sint<K + 7> h3 = horner<K, K + 6>(to_sint<K + 4>(c0), h2, x);
    const sint<K + 7> two = to_sint<K + 7>(sint<K + 7>{2} << K);
    const uint<K + 2> factor = h3 < 0 ? to_uint<K + 2>(0) : to_uint<K + 2>(h3 > two ? two : h3);

    // -96 .. 47: 8 bits before the point.
    const sint<S + 8> gain = to_sint<S + 8>(rnd<L - S>(to_sint<L + 8>(attenuation<Constants>(f).gain)));
    const sint<S + 8> z = to_sint<S + 8>(-to_sint<S + 8>(gain + to_sint<S + 8>(level.value)));

    const uint<O + 8> value = scaled_power<Constants, K, K, S + 8>(z, factor);
    *y = f.dark || past ? static_cast<Word>(0) : static_cast<Word>(value);
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
