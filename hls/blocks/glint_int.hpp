// glint_int: integers of a stated width for the HLS kernels, on <cstdint> alone.
//
// A kernel names the width of every value: sint<W> and uint<W> are the smallest <cstdint> types that hold W bits, and
// to_sint<W>, to_uint<W> keep the low W bits, as a register of W bits would. A value that fits passes unchanged, and a
// tool that tracks bits learns from them how narrow an operand is. To map a kernel to a vendor's types (ap_int, ac_int)
// only this header changes; therefore a kernel converts to the width of the result before it adds, multiplies or shifts
// left, where those types differ from <cstdint>, and divides nowhere.
#ifndef GLINT_INT_HPP
#define GLINT_INT_HPP

#include <cstdint>
#include <type_traits>

#include "glint_names_begin.hpp"  // after all others

// Every tool defines one of these while it synthesizes; each tool takes its own pragmas and passes over the others'.
#if defined(__SYNTHESIS__) || defined(__BAMBU__)
#define GLINT_HLS_PRAGMAS
#endif

// GLINT_UNROLL before a loop and GLINT_UNROLL_VITIS as its first line: every pass of it in hardware of its own.
#ifdef __BAMBU__
#define GLINT_UNROLL_BAMBU _Pragma("clang loop unroll(full)")
#else
#define GLINT_UNROLL_BAMBU
#endif
#ifdef GLINT_HLS_PRAGMAS
#define GLINT_UNROLL _Pragma("hls_unroll yes") GLINT_UNROLL_BAMBU
#define GLINT_UNROLL_VITIS _Pragma("HLS UNROLL")
#else
#define GLINT_UNROLL
#define GLINT_UNROLL_VITIS
#endif

namespace glint_hls {

// What C++14 leaves to the implementation and the helpers below rest on.
static_assert((std::int32_t{-3} >> 1) == -2 && (std::int64_t{-3} >> 1) == -2, ">> of a negative number is the floor");
static_assert(static_cast<std::int32_t>(std::uint32_t{0xfffffffd}) == -3, "conversion to signed wraps modulo 2^W");

template <int W>
using sint = std::conditional_t<
    W <= 8, std::int8_t,
    std::conditional_t<W <= 16, std::int16_t, std::conditional_t<W <= 32, std::int32_t, std::int64_t>>>;

template <int W>
using uint = std::make_unsigned_t<sint<W>>;

/// x mod 2^W, in 0 .. 2^W - 1.
template <int W, class T>
constexpr uint<W> to_uint(T x) {
    static_assert(W >= 1 && W <= 64, "1 to 64 bits");
    constexpr int spare = 8 * static_cast<int>(sizeof(uint<W>)) - W;
    return static_cast<uint<W>>(static_cast<uint<W>>(x) & static_cast<uint<W>>(static_cast<uint<W>>(-1) >> spare));
}

/// x mod 2^W, in -2^(W-1) .. 2^(W-1) - 1.
template <int W, class T>
constexpr sint<W> to_sint(T x) {
    static_assert(W >= 1 && W <= 64, "1 to 64 bits");
    constexpr int spare = 8 * static_cast<int>(sizeof(sint<W>)) - W;
    return static_cast<sint<W>>(static_cast<sint<W>>(static_cast<uint<W>>(x) << spare) >> spare);
}

/// floor(x / 2^k).
template <int k, class T>
constexpr T floor_shift(T x) {
    return static_cast<T>(x >> k);
}

/// rnd(x, k) = floor((x + 2^(k-1)) / 2^k) of the contract, for k > 0; the sum must fit T.
template <int k, class T>
constexpr T rnd(T x) {
    return floor_shift<k>(static_cast<T>(x + static_cast<T>(T{1} << (k - 1))));
}

/// x y, where the caller knows that it fits W signed bits.
template <int W, class T, class U>
constexpr sint<W> product(T x, U y) {
    return static_cast<sint<W>>(static_cast<sint<W>>(x) * static_cast<sint<W>>(y));
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
