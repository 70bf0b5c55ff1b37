// The top functions of the effect `cook_torrance`, one per shipped profile.
#include "glint_effect_cook_torrance.hpp"

#include "../generated/glint_effect_cook_torrance_p12_constants.hpp"
#include "../generated/glint_effect_cook_torrance_p16_constants.hpp"
#include "../generated/glint_effect_cook_torrance_p8_constants.hpp"

#define GLINT_TOP(top)                                                                                             \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t vh, std::uint32_t falloff, \
                        std::int32_t level, std::uint32_t excess, std::uint32_t* y, bool* clamped);                \
    GLINT_PIPELINE_CATAPULT                                                                                        \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t vh, std::uint32_t falloff, \
                        std::int32_t level, std::uint32_t excess, std::uint32_t* y, bool* clamped) {               \
        GLINT_PIPELINE_VITIS                                                                                       \
        glint_hls::effect_cook_torrance<top##_constants>(nl, nv, nh, vh, falloff, level, excess, y, clamped);      \
    }

GLINT_TOP(glint_effect_cook_torrance_p8)
GLINT_TOP(glint_effect_cook_torrance_p12)
GLINT_TOP(glint_effect_cook_torrance_p16)
