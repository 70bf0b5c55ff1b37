// What paper 2 prints (Khlebnikov, Yurov 2010: local lighting models and a faster Cook-Torrance), as data with its
// place in the paper, and the numbers that its claims and figures are held against.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "glint/cook_torrance.hpp"
#include "studies/forms.hpp"

namespace glint::studies::paper2 {

/// A row of the paper's table: a shader of the whole model.
struct TableRow {
    std::string_view model;
    int instructions = 0;
    double pixels_per_second = 0.0;
};
std::span<const TableRow> table();
/// The row of a model by its name there; null where the paper has none.
const TableRow* printed(std::string_view model);

/// Of the modified Cook-Torrance: the instructions that are left, and how much faster it is.
inline constexpr int printed_modified_instructions = 60;
inline constexpr double printed_speedup = 1.77;

/// Unit vectors of a surface, a light and a viewer.
struct Scene {
    std::array<double, 3> N{}, L{}, V{};
    std::array<double, 3> T{}, B{};  ///< tangents
};

/// What the counted models take of a material; what depends on it alone is at hand.
struct Material {
    double exponent = 50.0;  ///< of Phong and Blinn-Phong
    double roughness = 0.3;  ///< m of Cook-Torrance, sigma of Oren-Nayar in radians
    double index = 1.5;      ///< of refraction
    double alpha_x = 0.2;    ///< of Ward
    double alpha_y = 0.4;
};

/// A model of the paper as a formula from unit vectors to the intensity in one channel, with the factor 1 for every
/// intensity of a light and every coefficient of a material, and ambient light 0.
struct CountedModel {
    std::string_view name;   ///< an identifier: "phong"
    std::string_view model;  ///< as in table(), or a variant of it, or Lambert
    std::string_view form;   ///< for people: what is evaluated
    Operations operations;
    double value = 0.0;
};
/// The names of the counted models, in their order.
std::vector<std::string_view> model_names();

/// Lambert; Phong, Blinn-Phong, Cook-Torrance, Ward and Oren-Nayar; then Oren-Nayar without trigonometry, the modified
/// Cook-Torrance with its cubic in the angle, as in the paper, and with one in N.H. The code is that which bench/ times
/// (studies/lighting.hpp). Throws Error unless the material is legal for Cook-Torrance.
std::vector<CountedModel> counted_models(const Scene& scene, const Material& material);

/// All operations, each as one: as instructions of a shader are.
int total(const Operations& operations);

/// Fig. 1: m^2 D over the angle (0 to pi/2), and its cubics.
struct DistributionFigure {
    double m = 0.0;
    cook_torrance::Cubic angle, half;
    std::vector<double> x, distribution, angle_cubic, half_cubic;
};
DistributionFigure figure_1(double m, int points);

/// Fig. 2: the reflectance over V.H (0 to 1), and the constant for it.
struct ReflectanceFigure {
    double index = 0.0;
    double mean = 0.0;
    double steep = 0.0;    ///< the part of its whole fall that lies below V.H = 0.4, where the paper has it
    double largest = 0.0;  ///< difference from the constant over V.H in [0.4, 1], relative to the constant
    std::vector<double> x, reflectance;
};
ReflectanceFigure figure_2(double index, int points);

/// Phong against Blinn-Phong at one exponent: over the angle of the viewer from the mirrored light, in the plane of
/// incidence. There N.H is the cosine of half that angle, so R.V = 2 (N.H)^2 - 1, and the highlight is twice as wide.
struct HighlightFigure {
    double n = 0.0;
    double phong_width = 0.0, blinn_phong_width = 0.0;  ///< angle where it is 1/2, radians
    /// Exponent with which Blinn-Phong is as wide as Phong with n there; it tends to 4 n as n grows.
    double equal_width = 0.0;
    double largest = 0.0;  ///< difference of Blinn-Phong with 4 n from Phong with n
    std::vector<double> x, phong, blinn_phong, blinn_phong_4n;
};
/// Over 0 to pi/2. n of at least 1.
HighlightFigure highlight_figure(double n, int points);

/// How far the modified term is from Cook-Torrance: over viewers in the plane of incidence at equal angles, for a light
/// at an angle from the normal, as parts of the greatest of Cook-Torrance there.
struct Likeness {
    double m = 0.0, index = 0.0, light = 0.0;
    double largest = 0.0, rms = 0.0;
    double largest_angle = 0.0;  ///< of the viewer from the normal, radians; positive on the light's side
};
Likeness likeness(double m, double index, double light);

}  // namespace glint::studies::paper2
