// glint_spherical_gaussian: the HLS kernel of the lobe `spherical_gaussian`. The arithmetic is
// docs/lobes/spherical_gaussian.md.
#ifndef GLINT_SPHERICAL_GAUSSIAN_HPP
#define GLINT_SPHERICAL_GAUSSIAN_HPP

#include "../blocks/glint_exp_log.hpp"

#include "../blocks/glint_names_begin.hpp"  // after all others

namespace glint_hls {

template <class Constants>
std::uint32_t spherical_gaussian(uint<10> n, sint<Constants::F + 2> cos_code) {
    constexpr int F = Constants::F;
    constexpr int K = Constants::K;
    constexpr int S = Constants::S;
    constexpr int W = K + F + 11;  // of g (2^F - C), below 1509 2^(K + F) also with the half that rounds it

    const Corrected<F> in = correct<F>(n, cos_code);
    const uint<K + 1> a = to_uint<K + 1>(Constants::a);
    const uint<K + 1> b = to_uint<K + 1>(Constants::b);
    const uint<K + 11> g = to_uint<K + 11>(product_u<K + 11>(in.n, a) + b);
    const uint<W> scaled = product_u<W>(g, in.distance);
    const uint<S + 11> t = to_uint<S + 11>(rnd<K + F - S>(scaled));
    return word<F, Constants::O>(in, exp2<Constants, S + 11>(t));
}

}  // namespace glint_hls

#include "../blocks/glint_names_end.hpp"

#endif
