// The material of the effect `oren_nayar`: docs/effects/oren_nayar.md.
#pragma once

namespace glint {

/// The parameters a and b of the effect, as real numbers for its ports.
struct OrenNayarParameters {
    double a = 1;  ///< 1/2 .. 1
    double b = 0;  ///< 0 .. 0.45
};

/// Of a surface whose facets' slopes have the standard deviation sigma, in radians: A and B of Oren and Nayar 1994.
/// Legal: 0 (then the effect is Lambert's, exactly) to any finite number. Throws Error.
OrenNayarParameters oren_nayar_parameters(double sigma);

}  // namespace glint
