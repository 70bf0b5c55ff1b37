// The simulated units of effects that this build contains (library glint-effect-units).
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "unit.hpp"

namespace glint::testbench {

/// Made with a seed for what the registers hold at first. Tags have 32 bits.
struct EffectUnitKind {
    std::string_view effect;
    std::string_view lobe;     ///< of effects that are made of one; empty for the others
    std::string_view profile;  ///< its name, e.g. "p12"
    int mask;  ///< MASK of shade, the bits of its port `effects` that are built; -1: all, as of every other effect
    std::unique_ptr<EffectUnit> (*fast)(std::uint64_t seed);
    std::unique_ptr<EffectUnit> (*traced)(std::uint64_t seed);  ///< the same Verilog, built for waveforms
};

/// Written by CMake from effects.def, GLINT_EFFECTS, GLINT_EFFECT_LOBES and GLINT_PROFILES: every effect whose Verilog
/// is there.
std::span<const EffectUnitKind> effect_unit_kinds();

/// The lobe does not matter for effects that take none. Throws Error with what this build has.
const EffectUnitKind& find_effect_unit(std::string_view effect, std::string_view lobe, std::string_view profile,
                                       int mask = -1);

}  // namespace glint::testbench
