// The top functions of the lobe `bps`, one per shipped profile. For a custom profile, `glint emit` writes the header of
// constants; a top function of this form takes it.
#include "glint_bps.hpp"

#include "generated/glint_bps_p12_constants.hpp"
#include "generated/glint_bps_p16_constants.hpp"
#include "generated/glint_bps_p8_constants.hpp"

#ifdef GLINT_HLS_PRAGMAS
#pragma hls_pipeline_init_interval 1
#endif
extern "C" std::uint32_t glint_bps_p8(std::uint16_t n, std::int32_t cos_code) {
#ifdef GLINT_HLS_PRAGMAS
#pragma HLS PIPELINE II = 1
#endif
    return glint_hls::bps_word<glint_bps_p8_constants>(n, cos_code);
}

#ifdef GLINT_HLS_PRAGMAS
#pragma hls_pipeline_init_interval 1
#endif
extern "C" std::uint32_t glint_bps_p12(std::uint16_t n, std::int32_t cos_code) {
#ifdef GLINT_HLS_PRAGMAS
#pragma HLS PIPELINE II = 1
#endif
    return glint_hls::bps_word<glint_bps_p12_constants>(n, cos_code);
}

#ifdef GLINT_HLS_PRAGMAS
#pragma hls_pipeline_init_interval 1
#endif
extern "C" std::uint32_t glint_bps_p16(std::uint16_t n, std::int32_t cos_code) {
#ifdef GLINT_HLS_PRAGMAS
#pragma HLS PIPELINE II = 1
#endif
    return glint_hls::bps_word<glint_bps_p16_constants>(n, cos_code);
}
