// The top functions of the lobe `spherical_gaussian`, one per shipped profile.
#include "glint_spherical_gaussian.hpp"

#include "../generated/glint_spherical_gaussian_p12_constants.hpp"
#include "../generated/glint_spherical_gaussian_p16_constants.hpp"
#include "../generated/glint_spherical_gaussian_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_spherical_gaussian_p8, spherical_gaussian)
GLINT_TOP_FUNCTION(glint_spherical_gaussian_p12, spherical_gaussian)
GLINT_TOP_FUNCTION(glint_spherical_gaussian_p16, spherical_gaussian)
