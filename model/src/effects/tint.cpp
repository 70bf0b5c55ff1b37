// The effect `tint`: docs/effects/tint.md.

#include <algorithm>
#include <cmath>

#include "effect.hpp"

namespace glint {
namespace {

class Tint final : public EffectModel {
    static constexpr int E = 7;  ///< integer bits beyond 1.0 of the term, and of the result

public:
    explicit Tint(const Profile& profile)
        : EffectModel(
              "tint", profile,
              {term_port("s", profile, E), material_colour_port("k_r", profile), material_colour_port("k_g", profile),
               material_colour_port("k_b", profile), light_colour_port("i_r", profile),
               light_colour_port("i_g", profile), light_colour_port("i_b", profile)},
              {term_port("r", profile, E), term_port("g", profile, E), term_port("b", profile, E)}) {
        check_output_bits("tint", profile, 16);  // k i s with the addend that rounds it is below 2^(3 O + 13)
    }

private:
    struct Channel {
        std::int64_t colour = 0, y = 0;
    };

    // colour = k i is at most 2^O (2^(O+4) - 1), at 2 O bits; times s below 2^(O+8) it is below 2^(3 O + 12).
    Channel channel(std::int64_t s, std::int64_t k, std::int64_t i) const {
        Channel x;
        x.colour = k * i;
        x.y = std::min(rnd(x.colour * s, 2 * profile().O), outputs()[0].high);
        return x;
    }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        for (int c = 0; c < 3; ++c) out[c] = channel(in[0], in[1 + c], in[4 + c]).y;
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        static constexpr std::string_view names[] = {"colour_r", "colour_g", "colour_b"};
        std::vector<Intermediate> values = after_inputs(in, {}), last;
        for (std::size_t c = 0; c < 3; ++c) {
            const Channel x = channel(in[0], in[1 + c], in[4 + c]);
            values.push_back({names[c], x.colour, 2 * profile().O});
            last.push_back({outputs()[c].name, x.y, profile().O});
        }
        values.insert(values.end(), last.begin(), last.end());
        return values;
    }

    void real(const double* in, double* out) const override {
        const double most = outputs()[0].real(outputs()[0].high);
        for (int c = 0; c < 3; ++c) out[c] = std::min(in[0] * in[1 + c] * in[4 + c], most);
    }
};

std::vector<GeneratedFile> emit_tint(const Profile& profile, std::string_view) {
    const Tint model(profile);
    return {effect_wrapper(model, {{block::stream(), block::step(4)}}, {{"O", std::to_string(profile.O), ""}}),
            effect_top(model),
            effect_constants(model, {{"int O", std::to_string(profile.O), "fraction bits of colours and terms"}})};
}

std::vector<EffectCase> tint_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const std::int64_t one = std::int64_t{1} << model.profile().O;
    const std::int64_t bright = 16 * one - 1;  // the greatest i
    const std::int64_t most = 256 * one - 1;   // the greatest s, and the greatest result
    cases.push_back({"all at 1", {one, one, one, one, one, one, one}, "exactly 1"});
    cases.push_back({"all at their tops", {most, one, one, one, bright, bright, bright}, "saturates in every channel"});
    cases.push_back({"k above 1", {one, 2 * one - 1, one + 1, one, one, one, one}, "k counts as 1"});
    cases.push_back({"s at its top, k = i = 1", {most, one, one, one, one, one, one}, "fits, just"});
    cases.push_back({"s at its top, i one ulp above 1",
                     {most, one, one, one, one + 1, one, one - 1},
                     "the least that saturates, beside two that do not"});
    cases.push_back({"each channel its own", {one, one, one / 2, 0, 3, 5, 7}, "channels mix; 2.5 ulp rounds up to 3"});
    cases.push_back(
        {"half an ulp", {1, one, one, one / 2, one / 2, one / 2 - 1, one}, "one rounding: halves up, once"});
    cases.push_back({"two roundings would differ",
                     {1, one / 2, one / 2, one / 2, one, one / 2, one / 2 + 1},
                     "k s alone is half an ulp; only the product of all three may be rounded"});
    return cases;
}

}  // namespace

Effect tint_effect() {
    return {"tint", "k s I per channel", "B. T. Phong 1975", make_model<Tint>, emit_tint, tint_cases, 0.5};
}

}  // namespace glint
