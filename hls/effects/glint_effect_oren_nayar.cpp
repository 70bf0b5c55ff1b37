// The top functions of the effect `oren_nayar`, one per shipped profile.
#include "glint_effect_oren_nayar.hpp"

#include "../generated/glint_effect_oren_nayar_p12_constants.hpp"
#include "../generated/glint_effect_oren_nayar_p16_constants.hpp"
#include "../generated/glint_effect_oren_nayar_p8_constants.hpp"

#define GLINT_TOP(top)                                                                                       \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t lv, std::uint32_t a, std::uint32_t b, \
                        std::uint32_t* y, bool* clamped);                                                    \
    GLINT_PIPELINE_CATAPULT                                                                                  \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t lv, std::uint32_t a, std::uint32_t b, \
                        std::uint32_t* y, bool* clamped) {                                                   \
        GLINT_PIPELINE_VITIS                                                                                 \
        glint_hls::effect_oren_nayar<top##_constants>(nl, nv, lv, a, b, y, clamped);                         \
    }

GLINT_TOP(glint_effect_oren_nayar_p8)
GLINT_TOP(glint_effect_oren_nayar_p12)
GLINT_TOP(glint_effect_oren_nayar_p16)
