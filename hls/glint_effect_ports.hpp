// glint_effect_ports: what the kernels of the effects share: inputs cut to what is legal (docs/effects.md).
#ifndef GLINT_EFFECT_PORTS_HPP
#define GLINT_EFFECT_PORTS_HPP

#include "glint_int.hpp"

namespace glint_hls {

/// A dot product from its port of F + 2 bits, cut to -1 .. 1; `changed` is set where that changed it.
template <int F>
sint<F + 2> dot(std::int32_t code, bool& changed) {
    const sint<F + 2> one = to_sint<F + 2>(sint<F + 2>{1} << F);
    const sint<F + 2> minus_one = to_sint<F + 2>(-one);
    const sint<F + 2> x = to_sint<F + 2>(code);
    if (x >= minus_one && x <= one) return x;
    changed = true;
    return x < 0 ? minus_one : one;
}

/// An unsigned code from its port of W bits, cut to at most 2^TOP.
template <int W, int TOP>
uint<W> at_most(std::uint32_t code, bool& changed) {
    const uint<W> top = to_uint<W>(uint<W>{1} << TOP);
    const uint<W> x = to_uint<W>(code);
    if (x <= top) return x;
    changed = true;
    return top;
}

}  // namespace glint_hls

// The pragmas of a top function, one result a clock: before its head, and first in its body.
#ifdef GLINT_HLS_PRAGMAS
#define GLINT_EFFECT_PIPELINE_HEAD _Pragma("hls_pipeline_init_interval 1")
#define GLINT_EFFECT_PIPELINE_BODY _Pragma("HLS PIPELINE II = 1")
#else
#define GLINT_EFFECT_PIPELINE_HEAD
#define GLINT_EFFECT_PIPELINE_BODY
#endif

#endif
