// The top functions of the lobe `quadratic`, one per shipped profile.
#include "glint_quadratic.hpp"

#include "../generated/glint_quadratic_p12_constants.hpp"
#include "../generated/glint_quadratic_p16_constants.hpp"
#include "../generated/glint_quadratic_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_quadratic_p8, quadratic)
GLINT_TOP_FUNCTION(glint_quadratic_p12, quadratic)
GLINT_TOP_FUNCTION(glint_quadratic_p16, quadratic)
