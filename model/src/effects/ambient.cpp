// The effect `ambient`: docs/effects/ambient.md.

#include "effect.hpp"

namespace glint {
namespace {

class Ambient final : public EffectModel {
public:
    explicit Ambient(const Profile& profile)
        : EffectModel(
              "ambient", profile,
              {material_colour_port("k_r", profile), material_colour_port("k_g", profile),
               material_colour_port("k_b", profile), light_colour_port("i_r", profile),
               light_colour_port("i_g", profile), light_colour_port("i_b", profile)},
              {light_colour_port("r", profile), light_colour_port("g", profile), light_colour_port("b", profile)}) {
        check_output_bits("ambient", profile, 27);  // a port of 31 bits
    }

private:
    // k <= 2^O, so a result is at most i: O + 4 bits.
    void value(const std::int64_t* in, std::int64_t* out) const override {
        for (int channel = 0; channel < 3; ++channel) out[channel] = rnd(in[channel] * in[channel + 3], profile().O);
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        std::int64_t out[3];
        value(in, out);
        std::vector<Intermediate> values = after_inputs(in, {});
        for (std::size_t p = 0; p < 3; ++p) values.push_back({outputs()[p].name, out[p], profile().O});
        return values;
    }

    void real(const double* in, double* out) const override {
        for (int channel = 0; channel < 3; ++channel) out[channel] = in[channel] * in[channel + 3];
    }
};

std::vector<GeneratedFile> emit_ambient(const Profile& profile, std::string_view) {
    const Ambient model(profile);
    return {effect_wrapper(model, {{block::stream(), block::step(3)}}, {{"O", std::to_string(profile.O), ""}}),
            effect_top(model),
            effect_constants(model, {{"int O", std::to_string(profile.O), "fraction bits of colours and terms"}})};
}

std::vector<EffectCase> ambient_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const std::int64_t one = std::int64_t{1} << model.profile().O;
    const std::int64_t most = 16 * one - 1;
    cases.push_back({"all at 1", {one, one, one, one, one, one}, "exactly 1"});
    cases.push_back({"k = 1, i at its top", {one, one, one, most, most, most}, "exactly i: needs the highest bit"});
    cases.push_back({"k above 1, i at its top",
                     {2 * one - 1, one + 1, one, most, most, most},
                     "k counts as 1: without the correction the result would not fit"});
    cases.push_back({"each channel its own", {one, one / 2, 0, 3, 5, 7}, "channels mix; 2.5 ulp rounds up to 3"});
    cases.push_back({"half an ulp", {one / 2, one / 2, one / 2, 1, 3, 0}, "a half rounds up"});
    return cases;
}

}  // namespace

Effect ambient_effect() {
    return {"ambient", "k_a I_a per channel", "B. T. Phong 1975", make_model<Ambient>, emit_ambient, ambient_cases,
            0.5};
}

}  // namespace glint
