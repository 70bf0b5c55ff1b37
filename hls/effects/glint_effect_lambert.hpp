// glint_effect_lambert: the HLS kernel of the effect `lambert`. The arithmetic is docs/effects/lambert.md.
#ifndef GLINT_EFFECT_LAMBERT_HPP
#define GLINT_EFFECT_LAMBERT_HPP

#include "../blocks/glint_effect.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants, class Word>
void effect_lambert(std::int32_t nl, Word* y, bool* clamped) {
    constexpr int F = Constants::F;
    constexpr int O = Constants::O;
    static_assert(O >= 4 && O < F && F <= 30, "F: 8 to 30, O: 4 to F - 1");

    const Cut<sint<F + 2>> cut = cut_dot<F>(nl);
    const uint<F + 2> positive = to_uint<F + 2>(cut.value < 0 ? sint<F + 2>{0} : cut.value);  // 0 .. 2^F
    *y = to_uint<O + 1>(rnd<F - O>(positive));
    *clamped = cut.clamped;
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
