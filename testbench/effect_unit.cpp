#include "effect_unit.hpp"

#include <fmt/format.h>

#include "glint/effect.hpp"
#include "glint/error.hpp"

namespace glint::testbench {

namespace {

std::string with_mask(int mask) { return mask < 0 ? "" : fmt::format(" MASK {}", mask); }

}  // namespace

const EffectUnitKind& find_effect_unit(std::string_view effect, std::string_view lobe, std::string_view profile,
                                       int mask) {
    if (!find_effect(effect).takes_lobe) lobe = {};
    std::string known;
    for (const EffectUnitKind& kind : effect_unit_kinds()) {
        if (kind.effect == effect && kind.lobe == lobe && kind.profile == profile && kind.mask == mask) return kind;
        known += fmt::format("{}{}{}{} {}{}", known.empty() ? "" : ", ", kind.effect, kind.lobe.empty() ? "" : " ",
                             kind.lobe, kind.profile, with_mask(kind.mask));
    }
    throw Error(fmt::format(
        "unit '{}{}{} {}{}' is not in this build, which has: {} (the CMake lists GLINT_EFFECTS, GLINT_EFFECT_LOBES, "
        "GLINT_PROFILES and GLINT_SHADE_MASKS say)",
        effect, lobe.empty() ? "" : " ", lobe, profile, with_mask(mask), known));
}

}  // namespace glint::testbench
