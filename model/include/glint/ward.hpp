// The material of the effect `ward`: docs/effects/ward.md.
#pragma once

namespace glint {

/// The least roughness of the effect `ward`: its peak, 1 / (4 pi alpha^2) = 199, is the last power of two below 256, at
/// which the term saturates.
inline constexpr double ward_least_alpha = 0.02;

/// The parameters of the effect, as real numbers for its ports.
struct WardParameters {
    double kx = 0;        ///< sqrt(2 / ln 2) / alpha_x
    double ky = 0;        ///< the same of alpha_y
    double log_peak = 0;  ///< log2(1 / (4 pi alpha_x alpha_y))
};

/// Of a surface whose facets' slopes along T and B have the standard deviations alpha_x and alpha_y.
/// Legal: ward_least_alpha .. 1, each. Throws Error.
WardParameters ward_parameters(double alpha_x, double alpha_y);

}  // namespace glint
