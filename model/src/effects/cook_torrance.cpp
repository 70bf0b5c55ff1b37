// The effect `cook_torrance`: docs/effects/cook_torrance.md.

#include "glint/cook_torrance.hpp"

#include <cmath>

#include "microfacets.hpp"

namespace glint {
namespace {

constexpr int excess_bits = 12;  ///< fraction bits of the port excess
constexpr int t_integer_bits = 7;

struct CookTorranceFormat {
    int F = 0, O = 0;
    microfacets::WordLengths w;
    int R = 0;  ///< fraction bits of root and q
    int W = 0;  ///< fraction bits of s and e
    microfacets::Attenuation attenuation;
    exp_log::Log2 log2_q;
    microfacets::ScaledPower power;

    struct Steps {
        microfacets::Attenuation::Steps a;
        std::int64_t s = 0, e = 0, t = 0, root = 0, q = 0, uq = 0, across = 0, square = 0, ratio = 0, factor = 0, z = 0;
        microfacets::ScaledPower::Steps last;
    };

    // The widest: falloff s 2^(S-O) < 2^(O + 10 + W + 4) = 2^(2 O + 28) <= 2^60, the radicand at most 16 * 2^(2 R),
    // below 2^(2 O + 25) <= 2^57.
    Steps steps(const std::int64_t* in) const {
        const std::int64_t nl = in[0], nv = in[1], nh = in[2], falloff = in[4], level = in[5], excess = in[6];
        const std::int64_t vh = std::max<std::int64_t>(0, in[3]);
        const int S = w.S;
        const std::int64_t one = std::int64_t{1} << S;
        Steps x;
        if (nl <= 0 || nv <= 0 || nh <= 0 || excess == 0) return x;
        x.a = attenuation.steps(nl, nv, nh, vh);

        x.s = ((std::int64_t{1} << (2 * F)) - nh * nh) >> (2 * F - W);
        x.e = (std::int64_t{1} << W) - x.s;
        const std::int64_t dividend = (falloff * x.s) << (S - O);
        const std::int64_t infinite = std::int64_t{1} << (S + t_integer_bits);
        // dividend / e >= 2^(S+7), without a product that would not fit; e may be 0.
        const bool beyond = (dividend >> (S + t_integer_bits)) >= x.e;
        x.t = beyond ? infinite : dividend / x.e;

        x.root = floor_sqrt((excess << (2 * R - excess_bits)) + ((vh * vh) << (2 * R - 2 * F)));
        x.q = x.root + (vh << (R - F));
        x.uq = log2_q.steps(x.q).u;
        x.across = rnd(vh * x.root, F + R - S);
        x.square = rnd(vh * vh, 2 * F - S);
        const std::int64_t numerator = x.across + x.square - one, denominator = x.across - x.square + one;
        x.ratio = (std::abs(numerator) << S) / denominator;
        x.factor = one + rnd(x.ratio * x.ratio, S);

        x.z = 12 * one - level - rnd(x.a.gain + 4 * (x.a.uh + x.uq), w.L - S) + x.t;
        if (!beyond) x.last = power.steps(x.z, x.factor);
        return x;
    }
};

CookTorranceFormat make_cook_torrance_format(const Profile& profile) {
    microfacets::check_profile("cook_torrance", profile);
    const int F = profile.F, O = profile.O;
    const microfacets::WordLengths w = microfacets::word_lengths(O);
    const int R = O + 10, W = O + 14;
    return {F,
            O,
            w,
            R,
            W,
            microfacets::make_attenuation("cook_torrance", F, w),
            exp_log::make_log2("cook_torrance", R + 3, w.T, w.L, microfacets::cut(R + 3, w.L)),
            microfacets::make_scaled_power("cook_torrance", w.S, O, w)};
}

EffectPort falloff_port(const Profile& profile) {
    const std::int64_t one = std::int64_t{1} << profile.O;
    return {"falloff", EffectPort::Kind::parameter, profile.O + 10, false, profile.O, one, 1024 * one - 1};
}

EffectPort excess_port() {
    return {"excess", EffectPort::Kind::parameter, excess_bits + 4, false, excess_bits, 0, 15 << excess_bits};
}

class CookTorrance final : public EffectModel {
public:
    explicit CookTorrance(const Profile& profile)
        : EffectModel(
              "cook_torrance", profile,
              {dot_port("nl", profile), dot_port("nv", profile), dot_port("nh", profile), dot_port("vh", profile),
               falloff_port(profile), microfacets::level_port(microfacets::word_lengths(profile.O)), excess_port()},
              {term_port("y", profile, microfacets::E_out)}),
          f_(make_cook_torrance_format(profile)) {}

    const CookTorranceFormat& format() const { return f_; }

private:
    void value(const std::int64_t* in, std::int64_t* out) const override { out[0] = f_.steps(in).last.y; }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const CookTorranceFormat::Steps x = f_.steps(in);
        const int L = f_.w.L, S = f_.w.S;
        return after_inputs(in, {{"ul", x.a.ul, L},
                                 {"uv", x.a.uv, L},
                                 {"uh", x.a.uh, L},
                                 {"uc", x.a.uc, L},
                                 {"loss", x.a.loss, L},
                                 {"gain", x.a.gain, L},
                                 {"s", x.s, f_.W},
                                 {"e", x.e, f_.W},
                                 {"t", x.t, S},
                                 {"root", x.root, f_.R},
                                 {"q", x.q, f_.R},
                                 {"uq", x.uq, L},
                                 {"across", x.across, S},
                                 {"square", x.square, S},
                                 {"ratio", x.ratio, S},
                                 {"factor", x.factor, S},
                                 {"z", x.z, S},
                                 {"p", x.last.p, S},
                                 {"y", x.last.y, f_.O}});
    }

    // Powers as one exponent: none alone is finite for all arguments.
    void real(const double* in, double* out) const override {
        const double nl = in[0], nv = in[1], nh = in[2], vh = std::max(0.0, in[3]);
        const double falloff = in[4], level = in[5], excess = in[6];
        out[0] = 0.0;
        if (nl <= 0.0 || nv <= 0.0 || nh <= 0.0 || excess <= 0.0) return;
        const double root = std::sqrt(excess + vh * vh);
        const double q = root + vh;
        const double ratio = (vh * q - 1.0) / (vh * (root - vh) + 1.0);
        const double tangent = (1.0 - nh) * (1.0 + nh) / (nh * nh);
        const double exponent = level - falloff * tangent - 4.0 * (std::log2(nh) + std::log2(q)) +
                                std::log2(cook_torrance::attenuation(nl, nv, nh, vh));
        out[0] = std::min(std::exp2(exponent) * (1.0 + ratio * ratio), outputs()[0].real(outputs()[0].high));
    }

    double scale(const double* in) const override {
        double y = 0.0;
        real(in, &y);
        return std::max(1.0, y);
    }

    CookTorranceFormat f_;
};

std::vector<GeneratedFile> emit_cook_torrance(const Profile& profile, std::string_view) {
    const CookTorrance model(profile);
    const CookTorranceFormat& f = model.format();
    std::vector<Table> memories = microfacets::memories(f.attenuation, f.power);
    memories.insert(memories.begin() + 4, f.log2_q.table("log2_q"));
    return with_tables({effect_wrapper(model,
                                       {{block::stream(), block::step(3), block::sqrt(f.w.S + 9), block::step(3),
                                         block::divider(f.w.S + 1), block::square(), block::scaled_power_factor()},
                                        {"glint_microfacets", "glint_delay", "glint_log2", "glint_attenuation"}},
                                       microfacets::parameters(profile, f.w), memories),
                        effect_top(model),
                        effect_constants(model, microfacets::constants(profile, f.w),
                                         {f.attenuation.log2.table(), f.power.exp2.table()})},
                       memories);
}

std::vector<EffectCase> cook_torrance_cases(const EffectModel& model) {
    std::vector<EffectCase> out = common_effect_cases(model);
    const auto ports = model.inputs();
    const std::int64_t one = model.profile().one();
    const auto add = [&](std::string title, std::vector<std::int64_t> dots, double m, double eta, std::string risk) {
        const std::vector<double> material = cook_torrance::parameters(m, eta);
        for (std::size_t p = 0; p < material.size(); ++p) dots.push_back(ports[4 + p].code(material[p]));
        out.push_back({std::move(title), std::move(dots), std::move(risk)});
    };
    add("L = V = N, m = 0.05, Ni = 4", {one, one, one, one}, 0.05, 4.0, "the greatest peak at normal incidence: 46");
    add("L = V = N, m = 1", {one, one, one, one}, 1.0, 1.5, "the roughest material");
    add("N.L = 0", {0, one / 2, one / 2, one / 2}, 0.2, 1.5, "the logarithm of 0; the result is 0");
    add("nl = 1 ulp", {1, one / 2, one / 2, one / 2}, 0.2, 1.5, "the greatest logarithm");
    add("N.V = 0", {one / 2, 0, one / 2, one / 2}, 0.2, 1.5, "a division by 0; the result is 0");
    add("nv = 1 ulp", {one / 2, 1, one / 2, one / 2}, 0.2, 1.5, "1 / nv is 2^F; G brings it back");
    add("nl = nv = 1 ulp, mirror", {1, 1, one, 1}, 0.05, 1.5, "F = G = 1 and 1 / nv = 2^F: saturates");
    add("V.H = 0", {one / 2, one / 2, one, 0}, 0.2, 1.5, "G divides by 0 and is 1; F is 1");
    add("vh = 0, nv = 1 ulp", {one, 1, one, 0}, 0.2, 1.5, "saturates");
    add("vh below 0", {one / 2, one / 2, one, -one / 2}, 0.2, 1.5, "counts as 0");
    add("N.H = 0", {one / 2, one / 2, 0, one / 2}, 0.2, 1.5, "tan of 90 degrees; the result is 0");
    add("nh = 1 ulp", {one / 2, one / 2, 1, one / 2}, 1.0, 1.5, "tan^2 = 2^(2 F); the result is 0");
    add("nh below 0", {one / 2, one / 2, -one / 2, one / 2}, 1.0, 1.5, "H under the surface; the result is 0");
    add("nh = 1 - 1 ulp, m = 0.05", {one / 2, one / 2, one - 1, one / 2}, 0.05, 1.5, "the steepest place of the peak");
    add("nh = 1 - 1 ulp, m = 1", {one / 2, one / 2, one - 1, one / 2}, 1.0, 1.5, "t rounds to 0");
    add("Ni = 1", {one, one, one, one}, 0.05, 1.0, "no reflectance: 0, though its logarithm is infinite");
    add("Ni = 1, vh = 0", {one / 2, one / 2, one, 0}, 0.05, 1.0, "0 / 0 in the reflectance; the result is 0");
    add("Ni = 1.0002, vh = 0", {one / 2, one / 2, one, 0}, 0.05, 1.0002, "q is the least, its fourth power 2^-22");
    add("Ni = 4, vh = 1", {one, one, one, one}, 0.3, 4.0, "q is the greatest, 5");
    add("Brewster's angle, Ni = 1.5", {one / 2, one / 2, one, std::llround(std::ldexp(0.5547, model.profile().F))}, 0.3,
        1.5, "ratio is 0: it changes its sign");
    add("all dot products 1 ulp", {1, 1, 1, 1}, 0.3, 1.5, "nothing divides by 0");
    add("dot products beyond 1", {one + 1, 2 * one - 1, one + 5, one + 1}, 0.3, 1.5,
        "vectors longer than 1: each counts as 1");
    add("vh small, others 1", {one, one, one, 1}, 0.05, 4.0, "no unit vectors do that; saturates or not, no overflow");
    const auto top = [&](std::size_t p) { return ports[p].high; };
    out.push_back({"all parameters at their tops", {one, one, one, one, top(4), top(5), top(6)}, "saturates"});
    out.push_back(
        {"level at its top, q at its least", {1, 1, one, 1, ports[4].low, top(5), 1}, "the least exponent: saturates"});
    out.push_back({"level at its least", {one, one, one, one, ports[4].low, ports[5].low, top(6)}, "0"});
    return out;
}

}  // namespace

Effect cook_torrance_effect() {
    return {"cook_torrance",
            "F D G / (pi N.V)",
            "R. L. Cook, K. E. Torrance 1982",
            make_model<CookTorrance>,
            emit_cook_torrance,
            cook_torrance_cases,
            1.4};
}

}  // namespace glint
