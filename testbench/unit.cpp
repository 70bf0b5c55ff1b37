#include "unit.hpp"

#include <fmt/format.h>

#include "glint/effect.hpp"
#include "glint/error.hpp"

namespace glint::testbench {
namespace {

std::vector<UnitKind>& kinds() {
    static std::vector<UnitKind> all;
    return all;
}

}  // namespace

std::string UnitKind::name() const {
    if (effect.empty()) return fmt::format("{} {} {} {}", lobe, profile, unit, architecture);
    return fmt::format("{}{}{} {}{}{}", effect, lobe.empty() ? "" : " ", lobe, profile,
                       mask < 0 ? "" : fmt::format(" MASK {}", mask), unit == "core" ? "" : fmt::format(" {}", unit));
}

std::vector<int> input_widths(const EffectModel& model) {
    std::vector<int> out;
    for (const EffectPort& port : model.inputs()) out.push_back(port.bits);
    return out;
}

Registration::Registration(const UnitKind& kind) { kinds().push_back(kind); }

std::span<const UnitKind> unit_kinds() { return kinds(); }

const UnitKind& find_effect_unit(std::string_view effect, std::string_view lobe, std::string_view profile, int mask,
                                 std::string_view unit) {
    if (!find_effect(effect).takes_lobe) lobe = {};
    std::string known;
    for (const UnitKind& kind : kinds()) {
        if (kind.effect.empty()) continue;
        if (kind.effect == effect && kind.lobe == lobe && kind.profile == profile && kind.mask == mask &&
            kind.unit == unit)
            return kind;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", kind.name());
    }
    const UnitKind missing{effect, lobe, profile, unit, {}, mask, {}, {}, nullptr};
    throw Error(fmt::format(
        "unit '{}' is not in this build, which has: {} (the CMake lists GLINT_EFFECTS, GLINT_EFFECT_LOBES and "
        "GLINT_PROFILES say)",
        missing.name(), known.empty() ? "none" : known));
}

}  // namespace glint::testbench
