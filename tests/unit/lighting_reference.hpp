// The lighting models of paper 2 from the reference functions of the effects, which share no code with the formulas
// that are counted and timed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "glint/effect.hpp"
#include "glint/oren_nayar.hpp"
#include "glint/ward.hpp"
#include "studies/paper2.hpp"

/// The unit vector at a polar and an azimuth angle, with the normal {0, 0, 1}.
inline std::array<double, 3> unit_vector(double polar, double azimuth) {
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

/// By the name of the model, for one material.
class LightingReference {
public:
    explicit LightingReference(const glint::studies::paper2::Material& material) : material_(material) {}

    std::map<std::string, double, std::less<>> operator()(const glint::studies::paper2::Scene& s) const {
        namespace ct = glint::cook_torrance;
        const double nl = dot(s.N, s.L), nv = dot(s.N, s.V), lv = dot(s.L, s.V);
        std::array<double, 3> H{};
        for (std::size_t i = 0; i < 3; ++i) H[i] = (s.L[i] + s.V[i]) / std::sqrt(2.0 + 2.0 * lv);
        const double nh = dot(s.N, H), vh = dot(s.V, H);
        const auto modified = [&](const ct::Cubic& cubic) {
            return nl + ct::modified_term(nl, nv, nh, vh, cubic, reflectance_);
        };
        // The specular terms of the effects have N.L in them where the model has.
        const std::vector<double> in{nl, nv, nh, dot(H, s.T), dot(H, s.B), w_.kx, w_.ky, w_.log_peak};
        const double ward = ward_->reference(in)[0];
        const double oren_nayar = oren_nayar_->reference(std::vector<double>{nl, nv, lv, o_.a, o_.b})[0];
        return {{"lambert", nl},
                {"phong", nl + std::pow(std::max(0.0, 2.0 * nl * nv - lv), material_.exponent)},
                {"blinn_phong", nl + std::pow(nh, material_.exponent)},
                {"cook_torrance", nl + ct::term(nl, nv, nh, vh, material_.roughness, material_.index)},
                {"ward", nl + ward},
                {"oren_nayar", oren_nayar},
                {"oren_nayar_no_trigonometry", oren_nayar},
                {"modified_angle", modified(angle_)},
                {"modified_half", modified(half_)}};
    }

private:
    static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    glint::studies::paper2::Material material_;
    double reflectance_ = glint::cook_torrance::mean_fresnel(material_.index);
    glint::cook_torrance::Cubic angle_ =
        glint::cook_torrance::fit_beckmann(material_.roughness, glint::cook_torrance::Variable::angle);
    glint::cook_torrance::Cubic half_ =
        glint::cook_torrance::fit_beckmann(material_.roughness, glint::cook_torrance::Variable::half);
    glint::WardParameters w_ = glint::ward_parameters(material_.alpha_x, material_.alpha_y);
    glint::OrenNayarParameters o_ = glint::oren_nayar_parameters(material_.roughness);
    std::unique_ptr<glint::EffectModel> ward_ = glint::find_effect("ward").golden(glint::parse_profile("p12"), "");
    std::unique_ptr<glint::EffectModel> oren_nayar_ =
        glint::find_effect("oren_nayar").golden(glint::parse_profile("p12"), "");
};
