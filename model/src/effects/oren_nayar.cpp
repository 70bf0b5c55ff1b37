// The effect `oren_nayar`: docs/effects/oren_nayar.md.

#include "glint/oren_nayar.hpp"

#include <algorithm>
#include <cmath>

#include "effect.hpp"

namespace glint {

OrenNayarParameters oren_nayar_parameters(double sigma) {
    if (!(sigma >= 0) || std::isinf(sigma)) {
        throw Error(fmt::format("sigma {} is not legal for oren_nayar: 0 or more, in radians", sigma));
    }
    const double s2 = std::min(sigma * sigma, 1e9);  // both fractions have reached their limits by then
    return {1 - 0.5 * s2 / (s2 + 0.33), 0.45 * s2 / (s2 + 0.09)};
}

namespace {

struct OrenNayarFormat {
    int F = 0;
    int S = 0;  ///< fraction bits of a, b, q, ratio and p
    int O = 0;

    struct Steps {
        std::int64_t q = 0, ratio = 0, p = 0, y = 0;
    };

    // |lv 2^F - nl nv| <= 2^(2F+1), a nl <= 2^(S+F), b p 2^(F-S) <= 2^(S+F-1): with S <= F - 1 all is below 2^62.
    Steps steps(std::int64_t nl, std::int64_t nv, std::int64_t lv, std::int64_t a, std::int64_t b) const {
        Steps x;
        if (nl <= 0 || nv <= 0) return x;
        x.q = std::max<std::int64_t>(0, rnd((lv << F) - nl * nv, 2 * F - S));
        x.ratio = nl >= nv ? std::int64_t{1} << S : (nl << S) / nv;
        x.p = rnd(x.q * x.ratio, S);
        x.y = rnd(a * nl + ((b * x.p) << (F - S)), S + F - O);
        return x;
    }
};

/// A parameter 0 .. `most`, most <= 2^S.
EffectPort share_port(std::string_view name, int S, std::int64_t most) {
    return {name, EffectPort::Kind::parameter, S + 1, false, S, 0, most};
}

class OrenNayar final : public EffectModel {
public:
    explicit OrenNayar(const Profile& profile) : OrenNayar(profile, {profile.F, profile.O + 2, profile.O}) {}

private:
    OrenNayar(const Profile& profile, const OrenNayarFormat& f)
        : EffectModel(
              "oren_nayar", profile,
              {dot_port("nl", profile), dot_port("nv", profile), dot_port("lv", profile),
               share_port("a", f.S, std::int64_t{1} << f.S), share_port("b", f.S, std::int64_t{1} << (f.S - 1))},
              {term_port("y", profile, 0)}),
          f_(f) {
        check_output_bits("oren_nayar", profile, std::min(27, profile.F - 3));
    }

    void value(const std::int64_t* in, std::int64_t* out) const override {
        out[0] = f_.steps(in[0], in[1], in[2], in[3], in[4]).y;
    }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const OrenNayarFormat::Steps x = f_.steps(in[0], in[1], in[2], in[3], in[4]);
        return {{"nl", in[0], f_.F},      {"nv", in[1], f_.F}, {"lv", in[2], f_.F},
                {"a", in[3], f_.S},       {"b", in[4], f_.S},  {"q", x.q, f_.S},
                {"ratio", x.ratio, f_.S}, {"p", x.p, f_.S},    {"y", x.y, f_.O}};
    }

    void real(const double* in, double* out) const override {
        const double nl = in[0], nv = in[1], lv = in[2], a = in[3], b = in[4];
        out[0] = 0;
        if (nl <= 0 || nv <= 0) return;
        out[0] = a * nl + b * std::max(0.0, lv - nl * nv) * (nl >= nv ? 1.0 : nl / nv);
    }

    OrenNayarFormat f_;
};

std::unique_ptr<EffectModel> make_oren_nayar(const Profile& profile, std::string_view) {
    return std::make_unique<OrenNayar>(profile);
}

std::vector<GeneratedFile> emit_oren_nayar(const Profile& profile, std::string_view) {
    const OrenNayar model(profile);
    const auto text = [](int value) { return std::to_string(value); };
    return {effect_wrapper(model, {{"F", text(profile.F), ""}, {"O", text(profile.O), ""}}),
            effect_constants(model, {{"int F", text(profile.F), "fraction bits of the dot products"},
                                     {"int O", text(profile.O), "fraction bits of the output"}})};
}

std::vector<EffectCase> oren_nayar_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const auto ports = model.inputs();
    const std::int64_t one = model.profile().one();
    const auto add = [&](std::string name, std::vector<std::int64_t> dots, double sigma, std::string risk) {
        const OrenNayarParameters p = oren_nayar_parameters(sigma);
        dots.insert(dots.end(), {ports[3].code(p.a), ports[4].code(p.b)});
        cases.push_back({std::move(name), std::move(dots), std::move(risk)});
    };
    add("V and L along N", {one, one, one}, 0.3, "sin = tan = 0: y = A, and no 0 / 0");
    add("V along N", {one / 2, one, one / 2}, 0.3, "the sine of V's angle is 0: y = A N.L");
    add("L along N", {one, one / 2, one / 2}, 0.3, "the sine of L's angle is 0: y = A");
    add("grazing light, V opposite", {1, one / 2, -one / 2}, 0.3, "q below 0 is cut: y = A N.L, a fraction of an ulp");
    add("grazing light and viewer, side by side", {1, 1, one}, 1, "q is nearly 1, and the ratio exactly 1");
    add("grazing light, V beside it", {1, 2, one}, 1, "the ratio is exactly 1/2");
    add("grazing viewer", {one, 1, 0}, 1, "a division by nv would be by 1 ulp");
    add("nv = nl + 1 ulp", {one / 2, one / 2 + 1, one / 2}, 1, "the greatest ratio below 1");
    add("viewer in the surface", {one / 2, 0, one / 2}, 0.5, "division by 0; the result is 0");
    add("light in the surface", {0, one / 2, one / 2}, 0.5, "0 / nv; the result is 0");
    add("light and viewer in the surface", {0, 0, one}, 0.5, "0 / 0; the result is 0");
    add("light behind", {-one / 2, one / 2, one / 2}, 0.5, "a negative ratio; the result is 0");
    add("viewer behind", {one / 2, -one / 2, one / 2}, 0.5, "a negative q nv; the result is 0");
    add("sigma = 0", {one / 3, one / 5, one / 7}, 0, "exactly Lambert's result");
    add("sigma without bound", {one / 3, one / 5, one / 2}, 1e6, "A = 1/2, B = 0.45");
    add("dots that no vectors have", {one, 1, one}, 0.4, "q = 1: more than 1 comes out, and fits");
    add("dots above 1", {one + 1, one + 2, one + 3}, 0.4, "vectors a little longer than 1: count as 1");
    cases.push_back(
        {"the greatest result", {one, 1, one, ports[3].high, ports[4].high}, "A + B = 1.5: the bit above 1"});
    return cases;
}

}  // namespace

Effect oren_nayar_effect();

Effect oren_nayar_effect() {
    return {"oren_nayar",
            "N.L (A + B max(0, L.V - N.L N.V) / max(N.L, N.V))",
            "M. Oren, S. K. Nayar 1994",
            make_oren_nayar,
            emit_oren_nayar,
            oren_nayar_cases,
            0.75,
            false};
}

}  // namespace glint
