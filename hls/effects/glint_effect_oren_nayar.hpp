// glint_effect_oren_nayar: the HLS kernel of the effect `oren_nayar`. The arithmetic is docs/effects/oren_nayar.md.
#ifndef GLINT_EFFECT_OREN_NAYAR_HPP
#define GLINT_EFFECT_OREN_NAYAR_HPP

#include "../blocks/glint_effect.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants, class Word>
void effect_oren_nayar(std::int32_t nl_port, std::int32_t nv_port, std::int32_t lv_port, std::uint32_t a_port,
                       std::uint32_t b_port, Word* y, bool* clamped) {
    constexpr int F = Constants::F;
    constexpr int O = Constants::O;
    constexpr int S = O + 2;

    const Cut<sint<F + 2>> nl = cut_dot<F>(nl_port);
    const Cut<sint<F + 2>> nv = cut_dot<F>(nv_port);
    const Cut<sint<F + 2>> lv = cut_dot<F>(lv_port);
    const Cut<uint<S + 1>> a = cut_colour<S>(a_port);
    const uint<S + 1> b_most = to_uint<S + 1>(uint<S + 1>{1} << (S - 1));
    const uint<S + 1> b_code = to_uint<S + 1>(b_port);
    const bool b_above = b_code > b_most;
    const uint<S + 1> b = b_above ? b_most : b_code;
    *clamped = nl.clamped || nv.clamped || lv.clamped || a.clamped || b_above;

    // In the dark any numbers will do that the divider can take: 1 and 1.
    const bool dark = nl.value <= 0 || nv.value <= 0;
    const uint<F + 1> light = dark ? to_uint<F + 1>(1) : to_uint<F + 1>(nl.value);
    const uint<F + 1> viewer = dark ? to_uint<F + 1>(1) : to_uint<F + 1>(nv.value);

    // -2 .. 1 at 2 F bits; q is at most 1.
    const sint<2 * F + 2> both = product<2 * F + 2>(light, viewer);
    const sint<2 * F + 2> difference = to_sint<2 * F + 2>(product<2 * F + 2>(lv.value, sint<F + 2>{1} << F) - both);
    const sint<S + 2> rounded = to_sint<S + 2>(rnd<2 * F - S>(difference));
    const uint<S + 1> q = rounded < 0 ? to_uint<S + 1>(0) : to_uint<S + 1>(rounded);

    // The divider wants a quotient of at most 1, and gets one.
    const uint<S + 1> ratio = divide<S, F + 1>(light >= viewer ? viewer : light, viewer);
    const uint<2 * S + 1> share = product_u<2 * S + 1>(q, ratio);
    const uint<S + 1> p = to_uint<S + 1>(rnd<S>(share));

    // a nl <= 1, b p <= 1/2 at S + F bits: one bit for 1.5, one for the half that rounds.
    constexpr int W = S + F + 2;
    const uint<W> lambert = product_u<W>(a.value, light);
    const uint<W> facets = to_uint<W>(product_u<W>(b, p) << (F - S));
    const uint<W> sum = to_uint<W>(lambert + facets);
    *y = dark ? static_cast<Word>(0) : static_cast<Word>(to_uint<O + 1>(rnd<S + F - O>(sum)));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
