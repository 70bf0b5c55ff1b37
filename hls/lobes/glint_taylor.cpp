// The top functions of the lobe `taylor`, one per shipped profile.
#include "glint_taylor.hpp"

#include "../generated/glint_taylor_p12_constants.hpp"
#include "../generated/glint_taylor_p16_constants.hpp"
#include "../generated/glint_taylor_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_taylor_p8, taylor)
GLINT_TOP_FUNCTION(glint_taylor_p12, taylor)
GLINT_TOP_FUNCTION(glint_taylor_p16, taylor)
