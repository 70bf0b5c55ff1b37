#include "effect_unit.hpp"

#include <fmt/format.h>

#include "glint/effect.hpp"
#include "glint/error.hpp"

namespace glint::testbench {

const EffectUnitKind& find_effect_unit(std::string_view effect, std::string_view lobe, std::string_view profile) {
    if (!find_effect(effect).takes_lobe) lobe = {};
    std::string known;
    for (const EffectUnitKind& kind : effect_unit_kinds()) {
        if (kind.effect == effect && kind.lobe == lobe && kind.profile == profile) return kind;
        known += fmt::format("{}{}{}{} {}", known.empty() ? "" : ", ", kind.effect, kind.lobe.empty() ? "" : " ",
                             kind.lobe, kind.profile);
    }
    throw Error(fmt::format(
        "unit '{}{}{} {}' is not in this build, which has: {} (the CMake lists GLINT_EFFECTS, GLINT_EFFECT_LOBES and "
        "GLINT_PROFILES say)",
        effect, lobe.empty() ? "" : " ", lobe, profile, known));
}

}  // namespace glint::testbench
