// The Verilated units as units of the renderer.
#pragma once

#include <memory>
#include <string>

#include "engine.hpp"

namespace glint::render {

/// Why a plan cannot run on simulated units in this build, in one line; empty when it can.
std::string rtl_obstacle(const Plan& plan, const Profile& profile);

/// Brings up, resets and drives one simulated unit. Throws Error where the build has none.
std::unique_ptr<Unit> rtl_unit(const EffectModel& model, const std::string& lobe);

}  // namespace glint::render
