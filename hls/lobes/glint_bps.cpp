// The top functions of the lobe `bps`, one per shipped profile. For a custom profile, `glint emit` writes the header of
// constants; a top function of this form takes it.
#include "glint_bps.hpp"

#include "../generated/glint_bps_p12_constants.hpp"
#include "../generated/glint_bps_p16_constants.hpp"
#include "../generated/glint_bps_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_bps_p8, bps)
GLINT_TOP_FUNCTION(glint_bps_p12, bps)
GLINT_TOP_FUNCTION(glint_bps_p16, bps)
