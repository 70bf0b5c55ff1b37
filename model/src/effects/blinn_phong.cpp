// The effect `blinn_phong`: docs/effects/blinn_phong.md.

#include "highlight.hpp"

namespace glint {
namespace {

std::unique_ptr<EffectModel> make_blinn_phong(const Profile& profile, std::string_view lobe) {
    return make_highlight("blinn_phong", "nh", profile, lobe);
}

std::vector<GeneratedFile> emit_blinn_phong(const Profile& profile, std::string_view lobe) {
    return emit_highlight("blinn_phong", "nh", profile, lobe);
}

}  // namespace

Effect blinn_phong_effect() {
    return {"blinn_phong",
            "lobe(n, N.H) where N.L > 0",
            "J. F. Blinn 1977",
            make_blinn_phong,
            emit_blinn_phong,
            highlight_cases,
            1.0,
            true};
}

}  // namespace glint
