// Cook-Torrance and its modified form as real functions, and what they need to know of a material: the numbers at the
// ports of the effects cook_torrance and cook_torrance_modified.
#pragma once

#include <array>
#include <vector>

namespace glint::cook_torrance {

/// Legal materials: the roughness m and the index of refraction.
inline constexpr double least_roughness = 0.05;
inline constexpr double greatest_roughness = 1.0;
inline constexpr double greatest_index = 4.0;

/// Beckmann's distribution of microfacets, exp(-(tan a / m)^2) / (m^2 cos^4 a) with nh = cos a: the paper's (7),
/// without a factor 1 / pi. 0 for nh <= 0. Legal: nh <= 1, m > 0.
double beckmann(double nh, double m);

/// Fresnel's reflectance of a dielectric for unpolarised light, the paper's (8), at the cosine vh of the angle of
/// incidence. Legal: 0 <= vh <= 1, eta >= 1. 0 everywhere for eta = 1, also at vh = 0, where the formula is 0 / 0.
double fresnel(double vh, double eta);

/// G / N.V of Cook-Torrance: min(1, 2 nh nv / vh, 2 nh nl / vh) / nv, with vh below 0 taken as 0, where G is 1.
/// Legal: nl > 0, nv > 0, nh > 0.
double attenuation(double nl, double nv, double nh, double vh);

/// F D G / (pi N.V). 0 where nl <= 0, nv <= 0 or nh <= 0.
double term(double nl, double nv, double nh, double vh, double m, double eta);

/// What a cubic that stands for the distribution is a polynomial of.
enum class Variable {
    angle,  ///< a, as in the paper
    half    ///< 1 - N.H, as in the hardware
};

/// m^2 times the distribution as a cubic of x = (the variable) / end, and 0 from x = 1 on and where the cubic is
/// negative.
struct Cubic {
    Variable variable = Variable::half;
    double m = 0.0;
    double end = 0.0;                      ///< the variable where the cubic stops, at 0
    std::array<double, 4> coefficients{};  ///< of the powers 0 to 3 of x

    double operator()(double nh) const;
    struct Error {
        double largest = 0.0;  ///< of the distribution times m^2, over all angles, as a part of its greatest value
        double largest_angle = 0.0;  ///< radians
        double rms = 0.0;            ///< over all angles, in the same unit
    };
    Error error() const;
};

/// Least squares over angles at equal steps up to `end`, with the value 0 at the end; and of all ends the one with the
/// least largest error over all angles. Throws Error unless m is legal.
Cubic fit_beckmann(double m, Variable variable);

/// The modified form's constant for Fresnel's reflectance: the mean over V.H in [0.4, 1], where it changes little.
/// Throws Error unless 1 <= eta <= 4.
double mean_fresnel(double eta);

/// The modified term: that of cook_torrance with `cubic` / m^2 for D and `reflectance` for F.
double modified_term(double nl, double nv, double nh, double vh, const Cubic& cubic, double reflectance);

/// The real numbers at the material's ports, in their order, of the effect cook_torrance: falloff, level, excess.
/// Throws Error unless 0.05 <= m <= 1 and 1 <= eta <= 4.
std::vector<double> parameters(double m, double eta);

/// Of the effect cook_torrance_modified: level, stretch, c0, c1, c2, c3. Throws Error as above.
std::vector<double> modified_parameters(double m, double eta);

}  // namespace glint::cook_torrance
