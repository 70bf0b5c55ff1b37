// The effect `lambert`: docs/effects/lambert.md.

#include <algorithm>

#include "effect.hpp"

namespace glint {
namespace {

class Lambert final : public EffectModel {
public:
    explicit Lambert(const Profile& profile)
        : EffectModel("lambert", profile, {dot_port("nl", profile)}, {term_port("y", profile, 0)}) {
        check_output_bits("lambert", profile, std::min(profile.F, 28));
    }

private:
    // nl is -2^F .. 2^F, so y is 0 .. 2^O.
    void value(const std::int64_t* in, std::int64_t* out) const override {
        out[0] = rnd(std::max<std::int64_t>(0, in[0]), profile().F - profile().O);
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        std::int64_t y = 0;
        value(in, &y);
        return after_inputs(in, {{"y", y, profile().O}});
    }

    void real(const double* in, double* out) const override { out[0] = std::max(0.0, in[0]); }
};

std::vector<GeneratedFile> emit_lambert(const Profile& profile, std::string_view) {
    const Lambert model(profile);
    return {effect_wrapper(model, {{block::stream(), block::step(2)}, {"glint_dot"}},
                           {{"F", std::to_string(profile.F), ""}, {"O", std::to_string(profile.O), ""}}),
            effect_top(model),
            effect_constants(model, {{"int F", std::to_string(profile.F), "fraction bits of the dot product"},
                                     {"int O", std::to_string(profile.O), "fraction bits of the output"}})};
}

std::vector<EffectCase> lambert_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const Profile& profile = model.profile();
    if (profile.F > profile.O) {
        const std::int64_t half = std::int64_t{1} << (profile.F - profile.O - 1);
        cases.push_back({"nl = half an ulp of y", {half}, "a half rounds up, to 1"});
        cases.push_back({"nl just below half an ulp of y", {half - 1}, "rounds to 0"});
        cases.push_back({"nl = 1 - half an ulp of y", {profile.one() - half}, "rounds up into the highest bit"});
    }
    return cases;
}

}  // namespace

Effect lambert_effect() {
    return {"lambert", "max(0, N.L)", "J. H. Lambert 1760", make_model<Lambert>, emit_lambert, lambert_cases, 0.5};
}

}  // namespace glint
