#include "models.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "glint/cook_torrance.hpp"
#include "glint/oren_nayar.hpp"
#include "glint/ward.hpp"

namespace glint::render {
namespace {

std::vector<double> none(const Material&) { return {}; }

std::vector<double> exponent_alone(const Material& material) { return {static_cast<double>(material.exponent)}; }

std::vector<double> oren_nayar(const Material& material) {
    const OrenNayarParameters p = oren_nayar_parameters(material.roughness);
    return {p.a, p.b};
}

/// The tangent T runs around the vertical axis, as the grooves of a lathe do: along them a surface is smoother.
std::vector<double> ward(const Material& material) {
    const double aspect = std::sqrt(1.0 - 0.9 * material.anisotropy);
    const auto alpha = [](double x) { return std::clamp(x, ward_least_alpha, 1.0); };
    const WardParameters p = ward_parameters(alpha(material.roughness * aspect), alpha(material.roughness / aspect));
    return {p.kx, p.ky, p.log_peak};
}

double facets(const Material& material) {
    return std::clamp(material.roughness, cook_torrance::least_roughness, cook_torrance::greatest_roughness);
}
double index(const Material& material) { return std::clamp(material.index, 1.0, cook_torrance::greatest_index); }

std::vector<double> microfacets(const Material& material) {
    return cook_torrance::parameters(facets(material), index(material));
}
std::vector<double> modified_microfacets(const Material& material) {
    return cook_torrance::modified_parameters(facets(material), index(material));
}

constexpr LightingModel all[] = {
    {"lambert", true, none},
    {"oren_nayar", true, oren_nayar},
    {"phong", false, exponent_alone},
    {"blinn_phong", false, exponent_alone},
    {"ward", false, ward, ward_least_alpha},
    {"cook_torrance", false, microfacets, cook_torrance::least_roughness, cook_torrance::greatest_index},
    {"cook_torrance_modified", false, modified_microfacets, cook_torrance::least_roughness,
     cook_torrance::greatest_index},
};

}  // namespace

std::span<const LightingModel> lighting_models() {
    static const std::vector<LightingModel> known = [] {
        std::vector<LightingModel> out;
        for (const Effect& effect : effects()) {
            const auto model = std::find_if(std::begin(all), std::end(all),
                                            [&](const LightingModel& m) { return m.name == effect.name; });
            if (model != std::end(all)) out.push_back(*model);
        }
        return out;
    }();
    return known;
}

const LightingModel* find_model(std::string_view name) {
    for (const LightingModel& model : lighting_models()) {
        if (model.name == name) return &model;
    }
    return nullptr;
}

std::string known_models() {
    std::string out;
    for (const LightingModel& model : lighting_models()) out += (out.empty() ? "" : ", ") + std::string(model.name);
    return out;
}

void warn_of_limits(const std::vector<Material>& materials, std::vector<std::string>& warnings) {
    for (const Material& material : materials) {
        for (const std::string& name : {material.diffuse_model, material.specular_model}) {
            const LightingModel* model = find_model(name);
            if (model == nullptr) continue;
            if (material.roughness < model->least_roughness) {
                warnings.push_back(fmt::format("material '{}': Pr {:g} counts as {:g} for {}", material.name,
                                               material.roughness, model->least_roughness, name));
            }
            if (material.index > model->greatest_index) {
                warnings.push_back(fmt::format("material '{}': Ni {:g} counts as {:g} for {}", material.name,
                                               material.index, model->greatest_index, name));
            }
        }
    }
}

}  // namespace glint::render
