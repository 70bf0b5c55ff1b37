// Loops over arrays, for the vector lanes of the machine that they run on.
#pragma once

#include <span>
#include <string_view>

namespace glint {

/// What such a loop is compiled for: what every x86-64 (or other) machine has, AVX2, AVX-512 (F, VL, DQ, BW). A machine
/// is asked for its features, not for its model.
enum class Lanes { base, avx2, avx512 };
std::string_view lanes_name(Lanes lanes);

/// Those of this machine, `base` first.
std::span<const Lanes> lanes_here();

/// Those that loops use: the last of lanes_here(), until use_lanes names another. The bits are the same with each.
Lanes lanes();
/// For tests and measurements; not while loops run. Throws Error when the machine has no such lanes.
void use_lanes(Lanes lanes);

#if defined(__x86_64__) && defined(__GNUC__)
#define GLINT_X86_LANES
namespace detail {
// `flatten`: everything that the loop calls is compiled for these lanes, too.
__attribute__((noinline, flatten, target("avx2"))) void avx2(const auto& loop) { loop(); }
__attribute__((noinline, flatten, target("avx512f,avx512vl,avx512dq,avx512bw"))) void avx512(const auto& loop) {
    loop();
}
}  // namespace detail
#endif

/// Runs loop(), a function object around one `#pragma omp simd` loop, compiled for lanes().
void with_lanes(const auto& loop) {
#ifdef GLINT_X86_LANES
    if (lanes() == Lanes::avx512) return detail::avx512(loop);
    if (lanes() == Lanes::avx2) return detail::avx2(loop);
#endif
    loop();
}

}  // namespace glint
