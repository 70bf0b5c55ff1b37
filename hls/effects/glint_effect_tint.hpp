// glint_effect_tint: the HLS kernel of the effect `tint`. The arithmetic is docs/effects/tint.md.
#ifndef GLINT_EFFECT_TINT_HPP
#define GLINT_EFFECT_TINT_HPP

#include "../blocks/glint_effect.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// min(2^(O+8) - 1, rnd(k i s, 2 O)) for k = 0 .. 2^O, i of O + 4 and s of O + 8 bits. `colour` is at most
/// 2^O (2^(O+4) - 1), the product below 2^(3O+12), with the half that rounds it too; the quotient has O + 12 bits.
template <int O>
uint<O + 8> tint_channel(uint<O + 8> s, uint<O + 1> k, std::uint32_t i) {
    constexpr int W = 3 * O + 12;
    const uint<2 * O + 4> colour = product_u<2 * O + 4>(k, to_uint<O + 4>(i));
    const uint<W> product = product_u<W>(colour, s);
    const uint<O + 12> rounded = to_uint<O + 12>(rnd<2 * O>(product));
    const bool too_large = floor_shift<O + 8>(rounded) != 0;
    return too_large ? to_uint<O + 8>(-1) : to_uint<O + 8>(rounded);
}

template <class Constants, class Word>
void effect_tint(std::uint32_t s, std::uint32_t k_r, std::uint32_t k_g, std::uint32_t k_b, std::uint32_t i_r,
                 std::uint32_t i_g, std::uint32_t i_b, Word* r, Word* g, Word* b, bool* clamped) {
    constexpr int O = Constants::O;
    static_assert(O >= 4 && O <= 16, "O: 4 to 16");

    const uint<O + 8> term = to_uint<O + 8>(s);
    const Cut<uint<O + 1>> red = cut_colour<O>(k_r);
    const Cut<uint<O + 1>> green = cut_colour<O>(k_g);
    const Cut<uint<O + 1>> blue = cut_colour<O>(k_b);
    *r = tint_channel<O>(term, red.value, i_r);
    *g = tint_channel<O>(term, green.value, i_g);
    *b = tint_channel<O>(term, blue.value, i_b);
    *clamped = red.clamped || green.clamped || blue.clamped;
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
