// The effect `cosine`: docs/effects/cosine.md.

#include <algorithm>
#include <cmath>

#include "cosine.hpp"
#include "effect.hpp"

namespace glint {
namespace {

/// 16, or the number between F and O of a custom profile that has three.
int component_bits(const Profile& profile) {
    const int W = profile.custom.size() == 3 ? profile.custom[1] : 16;
    if (W < 8 || W > 18) throw Error(fmt::format("W = {} is not legal for the effect cosine: 8 to 18", W));
    if (profile.F < W - 1 || profile.F > 29) {
        throw Error(fmt::format("F = {} is not legal for the effect cosine of {} bits: {} to 29", profile.F, W, W - 1));
    }
    return W;
}

class Cosine final : public EffectModel {
public:
    explicit Cosine(const Profile& profile) : Cosine(profile, component_bits(profile)) {}
    const CosineFormat& format() const { return f_; }

private:
    Cosine(const Profile& profile, int W)
        : EffectModel("cosine", profile,
                      {component_port("a_x", W), component_port("a_y", W), component_port("a_z", W),
                       component_port("b_x", W), component_port("b_y", W), component_port("b_z", W)},
                      {dot_port("c", profile)}),
          f_{W, profile.F} {}

    /// All codes are legal; of a vector that is 0 the answer is 0, and `clamped` says so.
    bool correct(std::int64_t* in) const override {
        const auto none = [](const std::int64_t* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; };
        return none(in) || none(in + 3);
    }

    void value(const std::int64_t* in, std::int64_t* out) const override { out[0] = f_.steps(in, in + 3).c; }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const CosineFormat::Steps x = f_.steps(in, in + 3);
        const int bits = 2 * f_.W - 2;
        return after_inputs(in, {{"p", x.p, bits},
                                 {"aa", x.aa, bits},
                                 {"bb", x.bb, bits},
                                 {"j", x.j, 0},
                                 {"r", x.r, f_.F + 2},
                                 {"c", x.c, f_.F}});
    }

    void real(const double* in, double* out) const override {
        const auto dot = [](const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
        const double squares = dot(in, in) * dot(in + 3, in + 3);
        out[0] = squares > 0 ? dot(in, in + 3) / std::sqrt(squares) : 0;
    }

    CosineFormat f_;
};

std::vector<GeneratedFile> emit_cosine(const Profile& profile, std::string_view) {
    const Cosine model(profile);
    const auto [W, F] = model.format();
    return {effect_wrapper(model, {{block::stream(), block::cosine(F), block::step()}},
                           {{"W", std::to_string(W), ""}, {"F", std::to_string(F), ""}}, {},
                           {{"MULTIPLIER_STAGES", "1", "1 .. 4", "clocks of a product"}}),
            effect_top(model),
            effect_constants(model, {{"int W", std::to_string(W), "bits of a component"},
                                     {"int F", std::to_string(F), "fraction bits of the cosine"}})};
}

std::vector<EffectCase> cosine_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const std::int64_t high = model.inputs()[0].high, low = model.inputs()[0].low, half = (high + 1) / 2;
    const auto add = [&](std::string name, std::vector<std::int64_t> in, std::string risk) {
        cases.push_back({std::move(name), std::move(in), std::move(risk)});
    };
    add("a vector with itself", {high, 1, -3, high, 1, -3}, "exactly 2^F, and s is a square that the root cuts");
    add("parallel, lengths 1 and the greatest", {1, 1, 1, high, high, high}, "exactly 2^F for lengths far apart");
    add("opposite", {high, 1, -3, -high, -1, 3}, "exactly -2^F, the least that may come out");
    add("opposite by one component", {low, 0, 0, high, 0, 0}, "-2^F of the least code, which has no negative");
    add("perpendicular", {high, high, 0, high, -high, 0}, "p is exactly 0");
    add("nearly perpendicular", {high, high, 0, high, 1 - high, 0}, "p is the least there is beside s near its top");
    add("one component each, along an axis", {0, 1, 0, 0, high, 0}, "exactly 2^F");
    add("one component each, across", {0, 1, 0, 0, 0, low}, "exactly 0");
    add("the shortest vectors", {1, 0, 0, 1, 0, 0}, "s = 1: moved up as far as it can be");
    add("the shortest vectors, a diagonal", {1, 0, 0, 1, 1, 0}, "s = 2: an irrational root of the least digits");
    add("short, opposite", {0, 0, -1, 0, 0, 1}, "-1 moved up to the top");
    add("the longest vectors", {low, low, low, low, low, low}, "p, the squares and s at their tops; exactly 2^F");
    add("the longest vectors, opposite", {low, low, low, high, high, high},
        "the most negative p; not quite opposite lengths");
    add("the shortest and the longest", {1, 0, 0, low, low, low}, "lengths at both ends: -1 / sqrt(3)");
    add("s just below a power of 16", {half - 1, 0, 0, half, 0, 0}, "one more nibble to move; the least root follows");
    add("s a power of 16", {half, 0, 0, half, 0, 0}, "the least root, 2^F");
    add("s at the top of a nibble", {low, low, low, low, low, low + 1}, "the greatest root");
    add("one ulp from parallel", {high, 0, 0, high, 1, 0}, "1 - 2^-31: rounds to 2^F");
    add("far from parallel by one component", {high, 0, 0, high, high / 64, 0}, "in the highlight, not at its top");
    add("the first vector is 0", {0, 0, 0, 1, 2, 3}, "0 / 0: 0, and clamped");
    add("the second vector is 0", {1, 2, 3, 0, 0, 0}, "0 / 0: 0, and clamped");
    add("both vectors are 0", {0, 0, 0, 0, 0, 0}, "0 / 0: 0, and clamped");
    return cases;
}

}  // namespace

Effect cosine_effect() {
    return {"cosine", "a.b / (|a| |b|), of two vectors", "Euclid", make_model<Cosine>, emit_cosine, cosine_cases, 1.0};
}

}  // namespace glint
