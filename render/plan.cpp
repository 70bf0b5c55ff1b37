#include "plan.hpp"

#include <algorithm>

#include "models.hpp"

namespace glint::render {
namespace {

std::size_t unit(Plan& plan, std::string_view effect, const std::string& lobe) {
    for (std::size_t u = 0; u < plan.units.size(); ++u) {
        if (plan.units[u].effect == effect && plan.units[u].lobe == lobe) return u;
    }
    plan.units.push_back({std::string(effect), lobe, 0});
    return plan.units.size() - 1;
}

/// The term of a model, with the unit that computes it.
Term term(Plan& plan, const LightingModel& model, const Material& material, const std::string& lobe, bool shown) {
    const bool takes_lobe = find_effect(model.name).takes_lobe;
    const std::string& choice = material.lobe.empty() ? lobe : material.lobe;
    return {unit(plan, model.name, takes_lobe ? choice : std::string()), model.diffuse, shown,
            model.parameters(material)};
}

}  // namespace

Plan make_plan(const Scene& scene, const std::vector<Fragment>& fragments, const std::string& lobe, bool all_effects) {
    std::vector<std::uint64_t> seen(scene.materials.size(), 0);
    for (const Fragment& fragment : fragments) ++seen[fragment.material];

    Plan plan;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        if (seen[m] == 0) continue;
        const Material& material = scene.materials[m];
        MaterialPlan& out = plan.materials.emplace_back();
        out.material = m;
        out.fragments = seen[m];
        out.ambient_shown = material.ambient != Vec3{} && scene.ambient != Vec3{};
        out.ambient = out.ambient_shown || all_effects;
        if (out.ambient) {
            plan.ambient = unit(plan, "ambient", "");
            plan.units[plan.ambient].evaluations += out.fragments;
        }
        if (scene.lights.empty()) continue;
        for (const LightingModel& model : lighting_models()) {
            const bool shown = model.name == (model.diffuse ? material.diffuse_model : material.specular_model);
            if (shown || all_effects) out.terms.push_back(term(plan, model, material, lobe, shown));
        }
        const std::uint64_t pairs = out.fragments * scene.lights.size();
        for (const Term& t : out.terms) {
            plan.units[t.unit].evaluations += pairs;
            plan.tint = unit(plan, "tint", "");
            plan.units[plan.tint].evaluations += pairs;
        }
    }
    for (const Effect& effect : effects()) {
        const bool usable = effect.name == "ambient" || effect.name == "tint" || find_model(effect.name) != nullptr;
        const bool needed = std::any_of(plan.units.begin(), plan.units.end(),
                                        [&](const UnitPlan& u) { return u.effect == effect.name; });
        if (usable && !needed) plan.not_needed.emplace_back(effect.name);
    }
    return plan;
}

}  // namespace glint::render
