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
    double least_roughness = 0.0;   ///< less counts as this
    double greatest_index = 1e300;  ///< more counts as this
};

/// Those whose effect is in the registry, in its order.
std::span<const LightingModel> lighting_models();

/// nullptr when there is none of that name.
const LightingModel* find_model(std::string_view name);

/// Adds a line for each roughness and index that a material's model cannot take as it is.
void warn_of_limits(const std::vector<Material>& materials, std::vector<std::string>& warnings);

}  // namespace glint::render
