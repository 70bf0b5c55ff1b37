#include "glint/lanes.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {
namespace {

std::vector<Lanes> find_lanes() {
    std::vector<Lanes> out{Lanes::base};
#ifdef GLINT_X86_LANES
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) out.push_back(Lanes::avx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw")) {
        out.push_back(Lanes::avx512);
    }
#endif
    return out;
}

Lanes& chosen() {
    static Lanes lanes = lanes_here().back();
    return lanes;
}

}  // namespace

std::string_view lanes_name(Lanes lanes) {
    return lanes == Lanes::avx512 ? "avx512" : lanes == Lanes::avx2 ? "avx2" : "base";
}

std::span<const Lanes> lanes_here() {
    static const std::vector<Lanes> here = find_lanes();
    return here;
}

Lanes lanes() { return chosen(); }

void use_lanes(Lanes lanes) {
    const auto here = lanes_here();
    if (std::find(here.begin(), here.end(), lanes) == here.end()) {
        throw Error(fmt::format("lanes '{}' are not on this machine", lanes_name(lanes)));
    }
    chosen() = lanes;
}

}  // namespace glint
