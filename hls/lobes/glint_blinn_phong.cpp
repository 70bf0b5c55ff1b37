// The top functions of the lobe `blinn_phong`, one per shipped profile.
#include "glint_blinn_phong.hpp"

#include "../generated/glint_blinn_phong_p12_constants.hpp"
#include "../generated/glint_blinn_phong_p16_constants.hpp"
#include "../generated/glint_blinn_phong_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_blinn_phong_p8, blinn_phong)
GLINT_TOP_FUNCTION(glint_blinn_phong_p12, blinn_phong)
GLINT_TOP_FUNCTION(glint_blinn_phong_p16, blinn_phong)
