// The effect `cook_torrance_modified`: docs/effects/cook_torrance_modified.md.

#include <cmath>

#include "glint/cook_torrance.hpp"
#include "microfacets.hpp"

namespace glint {
namespace {

constexpr int stretch_bits = 8;  ///< fraction bits of the port stretch
constexpr std::int64_t coefficient_limit = 8;

struct ModifiedFormat {
    int F = 0, O = 0;
    microfacets::WordLengths w;
    int K = 0;  ///< fraction bits of x, the coefficients and the cubic
    microfacets::Attenuation attenuation;
    microfacets::ScaledPower power;

    struct Steps {
        microfacets::Attenuation::Steps a;
        std::int64_t x = 0, h1 = 0, h2 = 0, h3 = 0, factor = 0, z = 0;
        microfacets::ScaledPower::Steps last;
    };

    // x < 2^K, and |c| <= 8: |h1| <= 16, |h2| <= 24, |h3| <= 32, each a rounding more.
    Steps steps(const std::int64_t* in) const {
        const std::int64_t nl = in[0], nv = in[1], nh = in[2], level = in[4], stretch = in[5];
        const std::int64_t* c = in + 6;
        const std::int64_t one = std::int64_t{1} << K;
        Steps s;
        if (nl <= 0 || nv <= 0 || nh <= 0) return s;
        s.a = attenuation.steps(nl, nv, nh, std::max<std::int64_t>(0, in[3]));
        s.x = (((std::int64_t{1} << F) - nh) * stretch) >> (F + stretch_bits - K);
        s.z = -level - rnd(s.a.gain, w.L - w.S);
        if (s.x >= one) return s;
        s.h1 = c[2] + rnd(c[3] * s.x, K);
        s.h2 = c[1] + rnd(s.h1 * s.x, K);
        s.h3 = c[0] + rnd(s.h2 * s.x, K);
        s.factor = std::clamp<std::int64_t>(s.h3, 0, 2 * one);
        s.last = power.steps(s.z, s.factor);
        return s;
    }
};

ModifiedFormat make_modified_format(const Profile& profile) {
    microfacets::check_profile("cook_torrance_modified", profile);
    const int F = profile.F, O = profile.O, K = O + 5;
    const microfacets::WordLengths w = microfacets::word_lengths(O);
    return {F,
            O,
            w,
            K,
            microfacets::make_attenuation("cook_torrance_modified", F, w),
            microfacets::make_scaled_power("cook_torrance_modified", K, O, w)};
}

EffectPort stretch_port() {
    const std::int64_t one = std::int64_t{1} << stretch_bits;
    return {"stretch", EffectPort::Kind::parameter, stretch_bits + 10, false, stretch_bits, one, 1024 * one - 1};
}

EffectPort coefficient_port(std::string_view port, const Profile& profile) {
    const int K = profile.O + 5;
    const std::int64_t limit = coefficient_limit << K;
    return {port, EffectPort::Kind::parameter, K + 4, true, K, -limit, limit - 1};
}

class CookTorranceModified final : public EffectModel {
public:
    explicit CookTorranceModified(const Profile& profile)
        : EffectModel("cook_torrance_modified", profile,
                      {dot_port("nl", profile), dot_port("nv", profile), dot_port("nh", profile),
                       dot_port("vh", profile), microfacets::level_port(microfacets::word_lengths(profile.O)),
                       stretch_port(), coefficient_port("c0", profile), coefficient_port("c1", profile),
                       coefficient_port("c2", profile), coefficient_port("c3", profile)},
                      {term_port("y", profile, microfacets::E_out)}),
          f_(make_modified_format(profile)) {}

    const ModifiedFormat& format() const { return f_; }

private:
    void value(const std::int64_t* in, std::int64_t* out) const override { out[0] = f_.steps(in).last.y; }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const ModifiedFormat::Steps x = f_.steps(in);
        const int L = f_.w.L, S = f_.w.S, K = f_.K;
        return after_inputs(in, {{"ul", x.a.ul, L},
                                 {"uv", x.a.uv, L},
                                 {"uh", x.a.uh, L},
                                 {"uc", x.a.uc, L},
                                 {"loss", x.a.loss, L},
                                 {"gain", x.a.gain, L},
                                 {"x", x.x, K},
                                 {"h1", x.h1, K},
                                 {"h2", x.h2, K},
                                 {"h3", x.h3, K},
                                 {"factor", x.factor, K},
                                 {"z", x.z, S},
                                 {"p", x.last.p, S},
                                 {"y", x.last.y, f_.O}});
    }

    /// The term where the cubic is 1; legal arguments in front of the surface.
    static double peak(const double* in) {
        return std::exp2(in[4] + std::log2(cook_torrance::attenuation(in[0], in[1], in[2], std::max(0.0, in[3]))));
    }

    static bool dark(const double* in) { return in[0] <= 0.0 || in[1] <= 0.0 || in[2] <= 0.0; }

    void real(const double* in, double* out) const override {
        out[0] = 0.0;
        if (dark(in)) return;
        const double x = (1.0 - in[2]) * in[5];
        if (x >= 1.0) return;
        const double cubic = in[6] + x * (in[7] + x * (in[8] + x * in[9]));
        out[0] = std::min(peak(in) * std::clamp(cubic, 0.0, 2.0), outputs()[0].real(outputs()[0].high));
    }

    double scale(const double* in) const override { return dark(in) ? 1.0 : std::max(1.0, peak(in)); }

    ModifiedFormat f_;
};

std::vector<GeneratedFile> emit_cook_torrance_modified(const Profile& profile, std::string_view) {
    const CookTorranceModified model(profile);
    const ModifiedFormat& f = model.format();
    const std::vector<Table> memories = microfacets::memories(f.attenuation, f.power);
    return with_tables(
        {effect_wrapper(model,
                        {{block::stream(), block::step(), block::attenuation(), block::step(2), block::scaled_power()},
                         {"glint_microfacets", "glint_delay"}},
                        microfacets::parameters(profile, f.w), memories),
         effect_top(model),
         effect_constants(model, microfacets::constants(profile, f.w),
                          {f.attenuation.log2.table(), f.power.exp2.table()})},
        memories);
}

std::vector<EffectCase> cook_torrance_modified_cases(const EffectModel& model) {
    std::vector<EffectCase> out = common_effect_cases(model);
    const auto ports = model.inputs();
    const std::int64_t one = model.profile().one();
    const auto add = [&](std::string title, std::vector<std::int64_t> dots, double m, double eta, std::string risk) {
        const std::vector<double> material = cook_torrance::modified_parameters(m, eta);
        for (std::size_t p = 0; p < material.size(); ++p) dots.push_back(ports[4 + p].code(material[p]));
        out.push_back({std::move(title), std::move(dots), std::move(risk)});
    };
    add("L = V = N, m = 0.05, Ni = 4", {one, one, one, one}, 0.05, 4.0, "the greatest peak at normal incidence: 46");
    add("L = V = N, m = 1", {one, one, one, one}, 1.0, 1.5, "the roughest material");
    add("N.L = 0", {0, one / 2, one / 2, one / 2}, 0.2, 1.5, "the logarithm of 0; the result is 0");
    add("nl = 1 ulp", {1, one / 2, one - one / 100, one / 2}, 0.2, 1.5, "the greatest logarithm");
    add("N.V = 0", {one / 2, 0, one / 2, one / 2}, 0.2, 1.5, "a division by 0; the result is 0");
    add("nv = 1 ulp", {one / 2, 1, one - one / 100, one / 2}, 0.2, 1.5, "1 / nv is 2^F; G brings it back");
    add("nl = nv = 1 ulp, mirror", {1, 1, one, 1}, 0.05, 1.5, "G = 1 and 1 / nv = 2^F: saturates");
    add("V.H = 0", {one / 2, one / 2, one, 0}, 0.2, 1.5, "G divides by 0 and is 1");
    add("vh below 0", {one / 2, one / 2, one, -one / 2}, 0.2, 1.5, "counts as 0");
    add("N.H = 0", {one / 2, one / 2, 0, one / 2}, 1.0, 1.5, "the result is 0");
    add("nh below 0", {one / 2, one / 2, -one / 2, one / 2}, 1.0, 1.5, "H under the surface; the result is 0");
    add("nh = 1 - 1 ulp, m = 0.05", {one / 2, one / 2, one - 1, one / 2}, 0.05, 1.5, "the steepest place of the peak");
    add("Ni = 1", {one, one, one, one}, 0.05, 1.0, "no reflectance: all coefficients are 0");
    for (const double m : {cook_torrance::least_roughness, 0.3, cook_torrance::greatest_roughness}) {
        const cook_torrance::Cubic cubic = cook_torrance::fit_beckmann(m, cook_torrance::Variable::half);
        const std::int64_t end = one - static_cast<std::int64_t>(std::ldexp(cubic.end, model.profile().F));
        add(fmt::format("m = {}, last place before the end", m), {one / 2, one / 2, end + 1, one / 2}, m, 1.5,
            "the cubic is nearly 0, from above or from below");
        add(fmt::format("m = {}, first place beyond the end", m), {one / 2, one / 2, end - 1, one / 2}, m, 1.5,
            "the cubic stops; the result is 0");
    }
    add("dot products beyond 1", {one + 1, 2 * one - 1, one + 5, one + 1}, 0.3, 1.5,
        "vectors longer than 1: each counts as 1");
    add("all dot products 1 ulp", {1, 1, 1, 1}, 1.0, 1.5, "nothing divides by 0");
    const auto legal = [&](std::size_t p, bool top) { return top ? ports[p].high : ports[p].low; };
    out.push_back({"cubic below 0",
                   {one, one, one, one, legal(4, true), legal(5, false), -1, 0, 0, 0},
                   "-1 ulp would be huge if taken as unsigned; the result is 0"});
    out.push_back({"cubic of 1 ulp, level at its top",
                   {1, 1, one, one, legal(4, true), legal(5, false), 1, 0, 0, 0},
                   "the greatest left shift"});
    out.push_back({"cubic above 2",
                   {one, one, one, one, 0, legal(5, false), legal(6, true), 0, 0, 0},
                   "counts as 2: the result is 2"});
    out.push_back(
        {"coefficients at their tops",
         {one, one, one / 2, one, 0, legal(5, false), legal(6, true), legal(7, true), legal(8, true), legal(9, true)},
         "the greatest sums of Horner's rule"});
    out.push_back(
        {"coefficients at their least",
         {one, one, 1, one, 0, legal(5, false), legal(6, false), legal(7, false), legal(8, false), legal(9, false)},
         "the least sums of Horner's rule, at x = 1 - 1 ulp"});
    return out;
}

}  // namespace

Effect cook_torrance_modified_effect() {
    return {"cook_torrance_modified",
            "F D G / (pi N.V), D a cubic of N.H, F a constant",
            "V. V. Khlebnikov, A. A. Yurov 2010",
            make_model<CookTorranceModified>,
            emit_cook_torrance_modified,
            cook_torrance_modified_cases,
            2.5};
}

}  // namespace glint
