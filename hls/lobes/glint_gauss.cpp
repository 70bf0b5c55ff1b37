// The top functions of the lobe `gauss`, one per shipped profile.
#include "glint_gauss.hpp"

#include "../generated/glint_gauss_p12_constants.hpp"
#include "../generated/glint_gauss_p16_constants.hpp"
#include "../generated/glint_gauss_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_gauss_p8, gauss)
GLINT_TOP_FUNCTION(glint_gauss_p12, gauss)
GLINT_TOP_FUNCTION(glint_gauss_p16, gauss)
