// glint_schlick: the HLS kernel of the lobe `schlick`. The arithmetic is that of docs/lobes/schlick.md.
#ifndef GLINT_SCHLICK_HPP
#define GLINT_SCHLICK_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants>
std::uint32_t schlick(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");

    const Corrected<F> in = correct<F>(n, cos_code);
    const uint<O + 2> quotient = ratio<F, O + 1>(in);  // 0 .. 2^(O+1)
    const uint<O + 2> y = rnd<1>(quotient);            // at most 2^O
    return word<F, O>(in, to_uint<O + 1>(y));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
