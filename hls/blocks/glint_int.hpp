// glint_int: integers of a stated width for the HLS kernels.
//
// A kernel names the width of every value: sint<W> and uint<W> hold W bits, and to_sint<W>, to_uint<W> keep the low W
// bits, as a register of W bits would. A value that fits passes unchanged. At most one macro chooses what they are:
//   none               the smallest <cstdint> types that hold W bits
//   GLINT_INT_AP       ap_int<W>, ap_uint<W> of <ap_int.h>: Vitis HLS
//   GLINT_INT_AC       ac_int<W, true>, ac_int<W, false> of <ac_int.h>: Catapult
//   GLINT_INT_BITINT   _BitInt(W) of clang++ from 14, _ExtInt(W) of clang++ 11 to 13
// The types differ in the width of a sum, a difference and a shift: so a kernel converts to the width of the result
// before it adds, subtracts, negates or shifts left; it multiplies by product and product_u, and divides nowhere.
#ifndef GLINT_INT_HPP
#define GLINT_INT_HPP

#if defined(GLINT_INT_AP) + defined(GLINT_INT_AC) + defined(GLINT_INT_BITINT) > 1
#error "define at most one of GLINT_INT_AP, GLINT_INT_AC, GLINT_INT_BITINT"
#endif

#include <cstdint>
#include <type_traits>

#if defined(GLINT_INT_AP)
#include <ap_int.h>
#elif defined(GLINT_INT_AC)
#include <ac_int.h>
#elif defined(GLINT_INT_BITINT) && !defined(__clang__)
#error "GLINT_INT_BITINT: this compiler has no _BitInt in C++; clang++ has"
#endif

#include "glint_names_begin.hpp"  // after all others

// The pragmas of one tool, which is known by what it defines: Bambu __BAMBU__, Vitis HLS __SYNTHESIS__. Catapult
// defines __SYNTHESIS__, too; its script adds GLINT_CATAPULT. Bambu must not see the others': its front end dies of
// `#pragma HLS UNROLL` in a loop and of `#pragma HLS PIPELINE` from a macro.
#if defined(__BAMBU__)
#define GLINT_BAMBU
#elif defined(__SYNTHESIS__) && !defined(GLINT_CATAPULT)
#define GLINT_VITIS
#endif

// GLINT_UNROLL before a loop and GLINT_UNROLL_VITIS as its first line: every pass of it in hardware of its own.
// GLINT_PIPELINE_CATAPULT before a top function and GLINT_PIPELINE_VITIS as its first line: one result a clock.
// GLINT_ROM_VITIS after the table `values`: a memory with as many ports as calls read it, replicated where it must be.
// GLINT_INLINE before a function template: no call of it is left. Bambu pipelines no function with a call.
#define GLINT_UNROLL
#define GLINT_UNROLL_VITIS
#define GLINT_PIPELINE_CATAPULT
#define GLINT_PIPELINE_VITIS
#define GLINT_ROM_VITIS
#define GLINT_INLINE
#if defined(GLINT_BAMBU)
#undef GLINT_UNROLL
#define GLINT_UNROLL _Pragma("clang loop unroll(full)")
#undef GLINT_INLINE
#define GLINT_INLINE __attribute__((always_inline)) inline
#elif defined(GLINT_CATAPULT)
#undef GLINT_UNROLL
#define GLINT_UNROLL _Pragma("hls_unroll yes")
#undef GLINT_PIPELINE_CATAPULT
#define GLINT_PIPELINE_CATAPULT _Pragma("hls_pipeline_init_interval 1")
#elif defined(GLINT_VITIS)
#undef GLINT_UNROLL_VITIS
#define GLINT_UNROLL_VITIS _Pragma("HLS UNROLL")
#undef GLINT_PIPELINE_VITIS
#define GLINT_PIPELINE_VITIS _Pragma("HLS PIPELINE II = 1")
#undef GLINT_ROM_VITIS
#define GLINT_ROM_VITIS _Pragma("HLS BIND_STORAGE variable = values type = rom_np")
#endif

namespace glint_hls {

#if defined(GLINT_INT_AP)
template <int W>
using sint = ap_int<W>;
template <int W>
using uint = ap_uint<W>;
#elif defined(GLINT_INT_AC)
template <int W>
using sint = ac_int<W, true>;
template <int W>
using uint = ac_int<W, false>;
#elif defined(GLINT_INT_BITINT) && __clang_major__ >= 14
template <int W>
using sint = signed _BitInt(W);
template <int W>
using uint = unsigned _BitInt(W);
#elif defined(GLINT_INT_BITINT)
template <int W>
using sint = signed _ExtInt(W);
template <int W>
using uint = unsigned _ExtInt(W);
#else
#define GLINT_INT_CSTDINT
// What C++14 leaves to the implementation and the helpers below rest on.
static_assert((std::int32_t{-3} >> 1) == -2 && (std::int64_t{-3} >> 1) == -2, ">> of a negative number is the floor");
static_assert(static_cast<std::int32_t>(std::uint32_t{0xfffffffd}) == -3, "conversion to signed wraps modulo 2^W");

template <int W>
using sint = std::conditional_t<
    W <= 8, std::int8_t,
    std::conditional_t<W <= 16, std::int16_t, std::conditional_t<W <= 32, std::int32_t, std::int64_t>>>;

template <int W>
using uint = std::make_unsigned_t<sint<W>>;
#endif

// Ports of W bits of a top function, at most 32: of 32 bits with <cstdint>.
#ifdef GLINT_INT_CSTDINT
template <int W>
using sint_port = std::int32_t;
template <int W>
using uint_port = std::uint32_t;
#else
template <int W>
using sint_port = sint<W>;
template <int W>
using uint_port = uint<W>;
#endif

/// x mod 2^W, in 0 .. 2^W - 1.
template <int W, class T>
constexpr uint<W> to_uint(T x) {
    static_assert(W >= 1 && W <= 64, "1 to 64 bits");
#ifdef GLINT_INT_CSTDINT
    constexpr int spare = 8 * static_cast<int>(sizeof(uint<W>)) - W;
    return static_cast<uint<W>>(static_cast<uint<W>>(x) & static_cast<uint<W>>(static_cast<uint<W>>(-1) >> spare));
#else
    return static_cast<uint<W>>(x);
#endif
}

/// x mod 2^W, in -2^(W-1) .. 2^(W-1) - 1.
template <int W, class T>
constexpr sint<W> to_sint(T x) {
    static_assert(W >= 2 && W <= 64, "2 to 64 bits");
#ifdef GLINT_INT_CSTDINT
    constexpr int spare = 8 * static_cast<int>(sizeof(sint<W>)) - W;
    return static_cast<sint<W>>(static_cast<sint<W>>(static_cast<uint<W>>(x) << spare) >> spare);
#else
    return static_cast<sint<W>>(x);
#endif
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

/// x y, where the caller knows that it fits W signed bits. The vendors' types multiply at the widths of the factors.
template <int W, class T, class U>
constexpr sint<W> product(T x, U y) {
#if defined(GLINT_INT_AP) || defined(GLINT_INT_AC)
    return static_cast<sint<W>>(x * y);
#else
    return static_cast<sint<W>>(static_cast<sint<W>>(x) * static_cast<sint<W>>(y));
#endif
}

/// x y of unsigned factors, where the caller knows that it fits W bits.
template <int W, class T, class U>
constexpr uint<W> product_u(T x, U y) {
#if defined(GLINT_INT_AP) || defined(GLINT_INT_AC)
    return static_cast<uint<W>>(x * y);
#else
    constexpr int at_least = W < 32 ? 32 : W;  // uint16_t would be multiplied as int, and overflow
    return to_uint<W>(static_cast<uint<at_least>>(x) * static_cast<uint<at_least>>(y));
#endif
}

/// x y of a signed factor of X bits and an unsigned one, where the caller knows that it fits W bits. The vendors' types
/// are as narrow as they say; of others a tool knows which high bits are 0, and no more. So the sign is taken apart:
/// x = (x mod 2^(X-1)) - 2^(X-1) where x < 0.
template <int W, int X, class T, class U>
constexpr sint<W> product_s(T x, U y) {
#if defined(GLINT_INT_AP) || defined(GLINT_INT_AC)
    return static_cast<sint<W>>(x * y);
#else
    const uint<W> of_sign = x < 0 ? to_uint<W>(to_uint<W>(y) << (X - 1)) : to_uint<W>(0);
    return to_sint<W>(product_u<W>(to_uint<X - 1>(x), y) - of_sign);
#endif
}

}  // namespace glint_hls

#include "glint_names_end.hpp"

#endif
