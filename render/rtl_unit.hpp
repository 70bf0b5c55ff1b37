// The Verilated units as units of the renderer. Where the build has none, rtl_missing() says why.
#pragma once

#include <memory>
#include <string>

#include "engine.hpp"

namespace glint::render {

bool rtl_available();

/// The line for `--engine rtl` in a build without Verilated units.
std::string rtl_missing();

/// Throws Error, with the list of those there are, when the build lacks a unit of the plan.
void check_rtl(const Plan& plan, const Profile& profile, bool required);

/// Brings up, resets and drives one simulated unit. Throws Error where the build has none.
std::unique_ptr<Unit> rtl_unit(const EffectModel& model, const std::string& lobe);

}  // namespace glint::render
