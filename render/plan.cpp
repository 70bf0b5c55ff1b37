#include "plan.hpp"

#include <algorithm>
#include <bitset>

#include "glint/shade.hpp"
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

/// The effects that a material shows, as bits of MASK, and the lobe that they are made of.
ShadePlan shade_of(const MaterialPlan& material, const Plan& plan) {
    static const std::vector<std::string_view> order = shade_effects();
    ShadePlan out{{}, 0, material.fragments};
    const auto add = [&](std::string_view effect) {
        const auto bit = std::find(order.begin(), order.end(), effect) - order.begin();
        out.mask |= 1U << bit;
    };
    if (material.ambient_shown) add("ambient");
    for (const Term& t : material.terms) {
        if (!t.shown) continue;
        const UnitPlan& of = plan.units[t.unit];
        add(of.effect);
        if (!of.lobe.empty()) out.lobe = of.lobe;
    }
    return out;
}

/// The units of `shade` that cover all materials: one for each lobe, since a unit holds one. A material without a lobe
/// goes to the unit whose MASK it adds least to.
std::vector<ShadePlan> shade_units(const Plan& plan) {
    std::vector<ShadePlan> wanted;
    for (const MaterialPlan& material : plan.materials) wanted.push_back(shade_of(material, plan));
    std::stable_partition(wanted.begin(), wanted.end(), [](const ShadePlan& w) { return !w.lobe.empty(); });
    std::vector<ShadePlan> out;
    for (const ShadePlan& material : wanted) {
        if (material.mask == 0) continue;
        const auto added = [&](const ShadePlan& u) { return std::bitset<32>(material.mask & ~u.mask).count(); };
        const auto found =
            material.lobe.empty()
                ? std::min_element(out.begin(), out.end(),
                                   [&](const ShadePlan& a, const ShadePlan& b) { return added(a) < added(b); })
                : std::find_if(out.begin(), out.end(), [&](const ShadePlan& u) { return u.lobe == material.lobe; });
        if (found == out.end()) {
            out.push_back(material);
        } else {
            found->mask |= material.mask;
            found->fragments += material.fragments;
        }
    }
    return out;
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
    plan.shade = shade_units(plan);
    for (const Effect& effect : effects()) {
        const bool usable = effect.name == "ambient" || effect.name == "tint" || find_model(effect.name) != nullptr;
        const bool needed = std::any_of(plan.units.begin(), plan.units.end(),
                                        [&](const UnitPlan& u) { return u.effect == effect.name; });
        if (usable && !needed) plan.not_needed.emplace_back(effect.name);
    }
    return plan;
}

Plan from_vectors(Plan plan, const Scene& scene, const std::string& lobe) {
    for (const ShadePlan& unit : plan.shade) plan.pixels.push_back({"pixel", unit.lobe.empty() ? lobe : unit.lobe, 0});
    for (MaterialPlan& material : plan.materials) {
        const ShadePlan wanted = shade_of(material, plan);
        if (wanted.mask == 0) continue;
        const auto found = std::find_if(plan.shade.begin(), plan.shade.end(), [&](const ShadePlan& unit) {
            return (wanted.mask & ~unit.mask) == 0 && (wanted.lobe.empty() || wanted.lobe == unit.lobe);
        });
        material.pixel = static_cast<std::size_t>(found - plan.shade.begin());
        const std::uint64_t passes =
            (material.ambient_shown ? 1 : 0) + (material.terms.empty() ? 0 : scene.lights.size());
        plan.pixels.at(material.pixel).evaluations += passes * material.fragments;
    }
    return plan;
}

}  // namespace glint::render
