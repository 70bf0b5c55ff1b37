// The top functions of the effect `tint`, one per shipped profile.
#include "glint_effect_tint.hpp"

#include "../generated/glint_effect_tint_p12_constants.hpp"
#include "../generated/glint_effect_tint_p16_constants.hpp"
#include "../generated/glint_effect_tint_p8_constants.hpp"

#define GLINT_TOP(top)                                                                                               \
    extern "C" void top(std::uint32_t s, std::uint32_t k_r, std::uint32_t k_g, std::uint32_t k_b, std::uint32_t i_r, \
                        std::uint32_t i_g, std::uint32_t i_b, std::uint32_t* r, std::uint32_t* g, std::uint32_t* b,  \
                        bool* clamped);                                                                              \
    GLINT_PIPELINE_CATAPULT                                                                                          \
    extern "C" void top(std::uint32_t s, std::uint32_t k_r, std::uint32_t k_g, std::uint32_t k_b, std::uint32_t i_r, \
                        std::uint32_t i_g, std::uint32_t i_b, std::uint32_t* r, std::uint32_t* g, std::uint32_t* b,  \
                        bool* clamped) {                                                                             \
        GLINT_PIPELINE_VITIS                                                                                         \
        glint_hls::effect_tint<top##_constants>(s, k_r, k_g, k_b, i_r, i_g, i_b, r, g, b, clamped);                  \
    }

GLINT_TOP(glint_effect_tint_p8)
GLINT_TOP(glint_effect_tint_p12)
GLINT_TOP(glint_effect_tint_p16)
