// The top functions of the lobe `schlick`, one per shipped profile.
#include "glint_schlick.hpp"

#include "../generated/glint_schlick_p12_constants.hpp"
#include "../generated/glint_schlick_p16_constants.hpp"
#include "../generated/glint_schlick_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_schlick_p8, schlick)
GLINT_TOP_FUNCTION(glint_schlick_p12, schlick)
GLINT_TOP_FUNCTION(glint_schlick_p16, schlick)
