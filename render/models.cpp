#include "models.hpp"

#include <algorithm>

namespace glint::render {
namespace {

std::vector<double> none(const Material&) { return {}; }
std::vector<double> exponent_alone(const Material& material) { return {static_cast<double>(material.exponent)}; }

constexpr LightingModel all[] = {
    {"lambert", true, none},
    {"phong", false, exponent_alone},
    {"blinn_phong", false, exponent_alone},
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

}  // namespace glint::render
