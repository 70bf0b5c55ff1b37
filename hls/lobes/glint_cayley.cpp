// The top functions of the lobe `cayley`, one per shipped profile.
#include "glint_cayley.hpp"

#include "../generated/glint_cayley_p12_constants.hpp"
#include "../generated/glint_cayley_p16_constants.hpp"
#include "../generated/glint_cayley_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_cayley_p8, cayley)
GLINT_TOP_FUNCTION(glint_cayley_p12, cayley)
GLINT_TOP_FUNCTION(glint_cayley_p16, cayley)
