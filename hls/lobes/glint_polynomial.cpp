// The top functions of the lobe `polynomial`, one per shipped profile.
#include "glint_polynomial.hpp"

#include "../generated/glint_polynomial_p12_constants.hpp"
#include "../generated/glint_polynomial_p16_constants.hpp"
#include "../generated/glint_polynomial_p8_constants.hpp"

GLINT_TOP_FUNCTION(glint_polynomial_p8, polynomial)
GLINT_TOP_FUNCTION(glint_polynomial_p12, polynomial)
GLINT_TOP_FUNCTION(glint_polynomial_p16, polynomial)
