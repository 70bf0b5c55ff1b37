#include "glint/lobes.hpp"

#include <array>

#include <fmt/format.h>

#include "glint/bps.hpp"
#include "glint/error.hpp"
#include "glint/reference.hpp"

namespace glint {

std::span<const Lobe> lobes() {
    static const std::array<Lobe, 1> all{{
        {"bps", "a s^3 + b s^2 + c1 s + d0, s = c / (n - n c + c)", "F,S,K,O", reference::bps_horner, make_bps,
         emit_bps, bps_hard_cases},
    }};
    return all;
}

const Lobe& find_lobe(std::string_view name) {
    std::string known;
    for (const Lobe& lobe : lobes()) {
        if (lobe.name == name) return lobe;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", lobe.name);
    }
    throw Error(fmt::format("lobe '{}' is not known: {}", name, known));
}

}  // namespace glint
