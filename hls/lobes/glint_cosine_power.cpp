// The top functions of the lobe `cosine_power`, one per shipped profile.
#include "glint_cosine_power.hpp"

#include "../generated/glint_cosine_power_p12_constants.hpp"
#include "../generated/glint_cosine_power_p16_constants.hpp"
#include "../generated/glint_cosine_power_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_cosine_power_p8, cosine_power)
GLINT_TOP_FUNCTION(glint_cosine_power_p12, cosine_power)
GLINT_TOP_FUNCTION(glint_cosine_power_p16, cosine_power)
