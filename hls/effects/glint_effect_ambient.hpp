// glint_effect_ambient: the HLS kernel of the effect `ambient`. The arithmetic is docs/effects/ambient.md.
#ifndef GLINT_EFFECT_AMBIENT_HPP
#define GLINT_EFFECT_AMBIENT_HPP

#include "../blocks/glint_effect.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// rnd(k i, O) for k = 0 .. 2^O and i of O + 4 bits. The product and the half that rounds it fit 2 O + 4 bits, since
/// 2^O (2^(O+4) - 1) + 2^(O-1) is below 2^(2O+4).
template <int O>
uint<O + 4> ambient_channel(uint<O + 1> k, std::uint32_t i) {
    const uint<2 * O + 4> product = product_u<2 * O + 4>(k, to_uint<O + 4>(i));
    return to_uint<O + 4>(rnd<O>(product));
}

template <class Constants, class Word>
void effect_ambient(std::uint32_t k_r, std::uint32_t k_g, std::uint32_t k_b, std::uint32_t i_r, std::uint32_t i_g,
                    std::uint32_t i_b, Word* r, Word* g, Word* b, bool* clamped) {
    constexpr int O = Constants::O;
    static_assert(O >= 4 && O <= 27, "O: 4 to 27");

    const Cut<uint<O + 1>> red = cut_colour<O>(k_r);
    const Cut<uint<O + 1>> green = cut_colour<O>(k_g);
    const Cut<uint<O + 1>> blue = cut_colour<O>(k_b);
    *r = ambient_channel<O>(red.value, i_r);
    *g = ambient_channel<O>(green.value, i_g);
    *b = ambient_channel<O>(blue.value, i_b);
    *clamped = red.clamped || green.clamped || blue.clamped;
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
