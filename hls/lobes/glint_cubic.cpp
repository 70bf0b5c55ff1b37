// The top functions of the lobe `cubic`, one per shipped profile.
#include "glint_cubic.hpp"

#include "../generated/glint_cubic_p12_constants.hpp"
#include "../generated/glint_cubic_p16_constants.hpp"
#include "../generated/glint_cubic_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_cubic_p8, cubic)
GLINT_TOP_FUNCTION(glint_cubic_p12, cubic)
GLINT_TOP_FUNCTION(glint_cubic_p16, cubic)
