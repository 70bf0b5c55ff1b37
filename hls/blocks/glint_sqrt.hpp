// glint_sqrt: the integer square root for HLS kernels. Contract and steps are those of rtl/blocks/glint_sqrt.v.
#ifndef GLINT_SQRT_HPP
#define GLINT_SQRT_HPP

#include "glint_int.hpp"

#include "glint_names_begin.hpp"  // after all others

namespace glint_hls {

/// floor(sqrt(x)) of 2 Y_W bits, Y_W at most 31: Y_W restoring steps, one bit of the root each. What a step leaves is
/// at most twice the root so far, so at most 2^(Y_W+1) - 2 in the end, and below 2^(Y_W+2) with the next two bits
/// beside it.
template <int Y_W>
uint<Y_W> floor_sqrt(uint<2 * Y_W> x) {
    uint<Y_W + 1> remainder = 0;
    uint<Y_W> root = 0;
    GLINT_UNROLL
    for (int step = Y_W - 1; step >= 0; --step) {
        GLINT_UNROLL_VITIS
        const uint<2> bits = to_uint<2>(x >> (2 * step));
        const uint<Y_W + 2> shifted = to_uint<Y_W + 2>(to_uint<Y_W + 2>(to_uint<Y_W + 2>(remainder) << 2) | bits);
        const uint<Y_W + 2> trial = to_uint<Y_W + 2>(to_uint<Y_W + 2>(to_uint<Y_W + 2>(root) << 2) | 1U);
        const bool fits = shifted >= trial;
        remainder = to_uint<Y_W + 1>(fits ? to_uint<Y_W + 2>(shifted - trial) : shifted);
        root = to_uint<Y_W>((root << 1) | to_uint<Y_W>(fits));
    }
    return root;
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
