// What a picture needs: which effects each material calls for, hence which units, and how often each works.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene.hpp"
#include "visibility.hpp"

namespace glint::render {

/// A unit to bring up: an effect, with the lobe it is made of.
struct UnitPlan {
    std::string effect;
    std::string lobe;               ///< empty for an effect that is made of none
    std::uint64_t evaluations = 0;  ///< over the whole picture
};

/// A term of a material: evaluated, then tinted by Kd or Ks.
struct Term {
    std::size_t unit = 0;  ///< of Plan::units
    bool diffuse = false;
    bool shown = true;               ///< false: evaluated only because every unit is to evaluate every fragment
    std::vector<double> parameters;  ///< of the material, for the unit's ports of that kind
};

struct MaterialPlan {
    std::size_t material = 0;  ///< of Scene::materials
    std::uint64_t fragments = 0;
    bool ambient = false;  ///< evaluates `ambient`
    bool ambient_shown = false;
    std::vector<Term> terms;  ///< per light
    std::size_t pixel = 0;    ///< of Plan::pixels
};

/// A unit of the effect `shade`, for the materials that it can shade.
struct ShadePlan {
    std::string lobe;   ///< empty: any, as no highlight has one
    unsigned mask = 0;  ///< the least MASK that holds every effect of those materials
    std::uint64_t fragments = 0;
};

struct Plan {
    std::vector<UnitPlan> units;
    std::vector<MaterialPlan> materials;  ///< those that the camera sees
    std::vector<ShadePlan> shade;         ///< a unit for each lobe; none where all is dark
    std::vector<UnitPlan> pixels;  ///< the effect `pixel` in place of `units`: one for each of `shade`; else empty
    std::vector<std::string> not_needed;  ///< terms, ambient and tint that no visible material calls for
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::size_t ambient = none;  ///< of `units`
    std::size_t tint = none;
};

/// `lobe` is that of materials without one of their own. With `all_effects` every unit evaluates every fragment; what a
/// material does not call for is not shown.
Plan make_plan(const Scene& scene, const std::vector<Fragment>& fragments, const std::string& lobe, bool all_effects);

/// The plan with units of the effect `pixel`, which get vectors: an evaluation for the ambient light, and one for each
/// light. `lobe` is that of a unit without highlights.
Plan from_vectors(Plan plan, const Scene& scene, const std::string& lobe);

}  // namespace glint::render
