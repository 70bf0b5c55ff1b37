// glint_blinn_phong: the HLS kernel of the lobe `blinn_phong`. The arithmetic is docs/lobes/blinn_phong.md.
#ifndef GLINT_BLINN_PHONG_HPP
#define GLINT_BLINN_PHONG_HPP

#include "../blocks/glint_exp_log.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants>
std::uint32_t blinn_phong(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int L = Constants::L;
    constexpr int S = Constants::S;

    const Corrected<F> in = correct<F>(n, cos_code);
    const uint<L + 5> u = log2<Constants>(in.C);
    // At most 1023 * 31 * 2^L, also with the half that rounds it: 15 integer bits.
    const uint<L + 15> scaled = product_u<L + 15>(in.n, u);
    const uint<S + 15> t = to_uint<S + 15>(rnd<L - S>(scaled));
    return word<F, Constants::O>(in, exp2<Constants, S + 15>(t));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
