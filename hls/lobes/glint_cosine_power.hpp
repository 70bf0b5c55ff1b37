// glint_cosine_power: the HLS kernel of the lobe `cosine_power`. The arithmetic is docs/lobes/cosine_power.md.
#ifndef GLINT_COSINE_POWER_HPP
#define GLINT_COSINE_POWER_HPP

#include "../blocks/glint_unit.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// Constants: a generated header, generated/glint_cosine_power_<profile>_constants.hpp.
template <class Constants>
std::uint32_t cosine_power(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int LOG2_A = Constants::LOG2_A;
    constexpr int S = Constants::S;
    constexpr int O = Constants::O;
    static_assert(F >= 8 && F <= 30, "F: 8 to 30");
    static_assert(LOG2_A >= 1 && LOG2_A <= 6, "LOG2_A: 1 to 6");
    static_assert(O >= 4 && O <= 28, "O: 4 to 28");
    static_assert(S >= O && S <= 30 && S <= F + LOG2_A, "S: O to 30 and to F + LOG2_A");

    const Corrected<F> in = correct<F>(n, cos_code);

    // base = max(0, a 2^F - n d): n d <= 1023 2^F, a 2^F <= 2^(F+6), and the half that rounds is below it: between
    // -1023 2^F and 2^(F+7), F + 11 bits with the sign. Rounded before it is cut: rnd is monotone and keeps 0.
    constexpr int CUT = F + LOG2_A - S;
    constexpr std::int64_t offset = (std::int64_t{1} << (F + LOG2_A)) + ((std::int64_t{1} << CUT) >> 1);
    const sint<F + 11> base =
        to_sint<F + 11>(to_sint<F + 11>(offset) - static_cast<sint<F + 11>>(scaled_distance<F>(in)));
    const uint<S + 1> p1 = base < 0 ? to_uint<S + 1>(0) : to_uint<S + 1>(floor_shift<CUT>(base));  // 0 .. 2^S
    return word<F, O>(in, power<S, O, LOG2_A - 1>(p1, to_uint<3>(0)));  // p2, p4, ..., y: 0 .. 2^S, 0 .. 2^O
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
