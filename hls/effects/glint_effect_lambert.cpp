// The top functions of the effect `lambert`, one per shipped profile.
#include "glint_effect_lambert.hpp"

#include "../generated/glint_effect_lambert_p12_constants.hpp"
#include "../generated/glint_effect_lambert_p16_constants.hpp"
#include "../generated/glint_effect_lambert_p8_constants.hpp"

#define GLINT_TOP(top)                                                      \
    extern "C" void top(std::int32_t nl, std::uint32_t* y, bool* clamped);  \
    GLINT_PIPELINE_CATAPULT                                                 \
    extern "C" void top(std::int32_t nl, std::uint32_t* y, bool* clamped) { \
        GLINT_PIPELINE_VITIS                                                \
        glint_hls::effect_lambert<top##_constants>(nl, y, clamped);         \
    }

GLINT_TOP(glint_effect_lambert_p8)
GLINT_TOP(glint_effect_lambert_p12)
GLINT_TOP(glint_effect_lambert_p16)
