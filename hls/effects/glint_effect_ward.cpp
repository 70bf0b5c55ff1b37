// The top functions of the effect `ward`, one per shipped profile.
#include "glint_effect_ward.hpp"

#include "../generated/glint_effect_ward_p12_constants.hpp"
#include "../generated/glint_effect_ward_p16_constants.hpp"
#include "../generated/glint_effect_ward_p8_constants.hpp"

#define GLINT_TOP(top)                                                                                                \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t ht, std::int32_t hb,          \
                        std::uint32_t kx, std::uint32_t ky, std::int32_t log_peak, std::uint32_t* y, bool* clamped);  \
    GLINT_PIPELINE_CATAPULT                                                                                           \
    extern "C" void top(std::int32_t nl, std::int32_t nv, std::int32_t nh, std::int32_t ht, std::int32_t hb,          \
                        std::uint32_t kx, std::uint32_t ky, std::int32_t log_peak, std::uint32_t* y, bool* clamped) { \
        GLINT_PIPELINE_VITIS                                                                                          \
        glint_hls::effect_ward<top##_constants>(nl, nv, nh, ht, hb, kx, ky, log_peak, y, clamped);                    \
    }

GLINT_TOP(glint_effect_ward_p8)
GLINT_TOP(glint_effect_ward_p12)
GLINT_TOP(glint_effect_ward_p16)
