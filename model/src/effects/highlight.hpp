// The effects that are a lobe of one cosine, in front of the light only: `phong` and `blinn_phong`.
#pragma once

#include "effect.hpp"

namespace glint {

/// The model; `cosine` names the port of the lobe's cosine. Throws Error as the lobe does.
std::unique_ptr<EffectModel> make_highlight(std::string_view effect, std::string_view cosine, const Profile& profile,
                                            std::string_view lobe);

/// The Verilog wrapper glint_effect_<effect>_<lobe>_<profile>.
std::vector<GeneratedFile> emit_highlight(std::string_view effect, std::string_view cosine, const Profile& profile,
                                          std::string_view lobe);

std::vector<EffectCase> highlight_cases(const EffectModel& model);

}  // namespace glint
