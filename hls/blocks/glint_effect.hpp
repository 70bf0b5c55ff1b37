// glint_effect: what the kernels of the effects share: the corrections of their ports. Names: docs/effects.md.
#ifndef GLINT_EFFECT_HPP
#define GLINT_EFFECT_HPP

#include "glint_unit.hpp"

#include "glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// An input cut to its legal range, and whether that changed it.
template <class T>
struct Cut {
    T value;
    bool clamped;
};

/// A dot product: -2^F .. 2^F.
template <int F>
Cut<sint<F + 2>> cut_dot(std::int32_t port) {
    const sint<F + 2> code = to_sint<F + 2>(port);
    const sint<F + 2> one = static_cast<sint<F + 2>>(sint<F + 2>{1} << F);
    const sint<F + 2> minus_one = static_cast<sint<F + 2>>(-one);
    const bool above = code > one;
    const bool below = code < minus_one;
    const Cut<sint<F + 2>> cut = {above ? one : below ? minus_one : code, above || below};
    return cut;
}

/// A channel of a material's colour: 0 .. 2^O.
template <int O>
Cut<uint<O + 1>> cut_colour(std::uint32_t port) {
    const uint<O + 1> code = to_uint<O + 1>(port);
    const uint<O + 1> one = to_uint<O + 1>(uint<O + 1>{1} << O);
    const bool above = code > one;
    const Cut<uint<O + 1>> cut = {above ? one : code, above};
    return cut;
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
