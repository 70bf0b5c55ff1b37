#include "glint/lobes.hpp"

unsigned answer();

unsigned answer() { return glint::find_lobe("bps").golden(glint::parse_profile("p12"))->eval(50, 256901); }
