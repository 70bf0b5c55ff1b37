// The effect `phong`: docs/effects/phong.md.

#include "highlight.hpp"

namespace glint {
namespace {

std::unique_ptr<EffectModel> make_phong(const Profile& profile, std::string_view lobe) {
    return make_highlight("phong", "rv", profile, lobe);
}

std::vector<GeneratedFile> emit_phong(const Profile& profile, std::string_view lobe) {
    return emit_highlight("phong", "rv", profile, lobe);
}

}  // namespace

Effect phong_effect() {
    return {"phong", "lobe(n, R.V) where N.L > 0", "B. T. Phong 1975", make_phong, emit_phong, highlight_cases, 1.0,
            true};
}

}  // namespace glint
