// The top functions of the effect `cook_torrance_modified`, one per shipped profile.
#include "glint_effect_cook_torrance_modified.hpp"

#include "../generated/glint_effect_cook_torrance_modified_p12_constants.hpp"
#include "../generated/glint_effect_cook_torrance_modified_p16_constants.hpp"
#include "../generated/glint_effect_cook_torrance_modified_p8_constants.hpp"

#define GLINT_TOP(top)                                                                                               \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t vh, std::int32_t level,      \
                        std::uint32_t stretch, std::int32_t c0, std::int32_t c1, std::int32_t c2, std::int32_t c3,   \
                        std::uint32_t* y, bool* clamped);                                                            \
    GLINT_PIPELINE_CATAPULT                                                                                          \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t vh, std::int32_t level,      \
                        std::uint32_t stretch, std::int32_t c0, std::int32_t c1, std::int32_t c2, std::int32_t c3,   \
                        std::uint32_t* y, bool* clamped) {                                                           \
        GLINT_PIPELINE_VITIS                                                                                         \
        glint_hls::effect_cook_torrance_modified<top##_constants>(nl, nv, nh, vh, level, stretch, c0, c1, c2, c3, y, \
                                                                  clamped);                                          \
    }

GLINT_TOP(glint_effect_cook_torrance_modified_p8)
GLINT_TOP(glint_effect_cook_torrance_modified_p12)
GLINT_TOP(glint_effect_cook_torrance_modified_p16)
