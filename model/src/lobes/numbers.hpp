// Numbers of the lobes' formulas that the golden models and the counted formulas (forms.cpp) both need.
#pragma once

#include <array>

namespace glint {

/// Of f_kv, as published (Zavalniuk, Romanyuk, Satsiuk 2024).
inline constexpr double quadratic_slope = 0.786;

/// Of Lagarde's spherical Gaussian, as published (2012); the golden model has it as 31 / 40.
inline constexpr double spherical_gaussian_shift = 0.775;

/// Of the square in the lobe `taylor`: docs/lobes/taylor.md; 5 / 8 in the golden model.
inline constexpr double taylor_bend = 0.625;

/// The powers 0 to 3 of t in the lobe `polynomial` without options: docs/lobes/polynomial.md.
inline constexpr std::array<double, 4> polynomial_coefficients{0.0, -0.3444, 2.8786, -1.5342};

}  // namespace glint
