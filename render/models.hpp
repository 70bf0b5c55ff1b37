// The lighting models a material can have: which effect is its term, and what feeds that effect's parameters.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "glint/effect.hpp"
#include "scene.hpp"

namespace glint::render {

struct LightingModel {
    std::string_view name;  ///< of the effect
    bool diffuse = false;   ///< Kd or Ks goes with it
    /// The real values of the effect's ports of kind `parameter`, in their order.
    std::vector<double> (*parameters)(const Material&) = nullptr;
};

/// Those whose effect is in the registry, in its order.
std::span<const LightingModel> lighting_models();

/// nullptr when there is none of that name.
const LightingModel* find_model(std::string_view name);

}  // namespace glint::render
