// The effect `phong`: docs/effects/phong.md.

#include "highlight.hpp"

namespace glint {
namespace {

constexpr std::string_view name = "phong";
constexpr std::string_view cosine = "rv";

std::unique_ptr<EffectModel> make_phong(const Profile& profile, std::string_view lobe) {
    return make_highlight(name, cosine, profile, lobe);
}

std::vector<GeneratedFile> emit_phong(const Profile& profile, std::string_view lobe) {
    return emit_highlight(name, cosine, profile, lobe);
}

}  // namespace

Effect phong_effect();

Effect phong_effect() {
    return {name, "lobe(n, R.V) where N.L > 0", "B. T. Phong 1975", make_phong, emit_phong, highlight_cases, 1.0, true};
}

}  // namespace glint
