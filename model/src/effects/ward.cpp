// The effect `ward`: docs/effects/ward.md.

#include "glint/ward.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../lobes/exp_log.hpp"
#include "effect.hpp"

namespace glint {

WardParameters ward_parameters(double alpha_x, double alpha_y) {
    for (const double alpha : {alpha_x, alpha_y}) {
        if (!(alpha >= ward_least_alpha && alpha <= 1)) {
            throw Error(fmt::format("alpha {} is not legal for ward: {} to 1", alpha, ward_least_alpha));
        }
    }
    const double k = std::sqrt(2 / std::numbers::ln2);
    return {k / alpha_x, k / alpha_y, -std::log2(4 * std::numbers::pi * alpha_x * alpha_y)};
}

namespace {

/// Integer bits beyond 1.0 of the result, and of log_peak's power.
constexpr int I = 7;

struct WardFormat {
    int F = 0;
    int H = 0;  ///< fraction bits of hx and hy
    int T = 0, L = 0;
    int E = 0, S = 0;
    int O = 0;
    exp_log::Log2 log2;
    exp_log::Exp2 exp2;  ///< with O + I + 1 bits: y < 2^(I+1)

    struct Steps {
        std::int64_t hx = 0, hy = 0, r2 = 0, t = 0, ul = 0, uv = 0, e = 0, y = 0;
    };

    // |h| k < 2^(F + O + 7) <= 2^57; hx, hy < 2^(H + 4) = 2^(O + 7), so the sum of their squares is below 2^55; r2 and
    // t are below 2^(S + 7), so r2 2^F is below 2^(O + 11 + F) <= 2^61.
    Steps steps(const std::int64_t* in) const {
        const std::int64_t nl = in[0], nv = in[1], nh = in[2], kx = in[5], ky = in[6], log_peak = in[7];
        Steps x;
        if (nl <= 0 || nv <= 0 || nh < 0) return x;
        x.hx = scaled(in[3], kx);
        x.hy = scaled(in[4], ky);
        x.r2 = std::min(rnd(x.hx * x.hx + x.hy * x.hy, 2 * H - S), (std::int64_t{128} << S) - 1);
        x.t = (x.r2 << F) / ((std::int64_t{1} << F) + nh);
        x.ul = log2.steps(nl).u;
        x.uv = log2.steps(nv).u;
        x.e = x.t + rnd(x.ul - x.uv, L + 1 - S) - log_peak + (std::int64_t{I + 1} << S);
        const std::int64_t power = exp2.steps(std::max<std::int64_t>(0, x.e)).y;
        x.y = std::min(power, (std::int64_t{1} << (O + I + 1)) - 1);
        return x;
    }

    std::int64_t scaled(std::int64_t h, std::int64_t k) const {
        return std::min(rnd(std::abs(h) * k, F + O - H), (std::int64_t{16} << H) - 1);
    }
};

WardFormat ward_format(const Profile& profile) {
    constexpr std::string_view name = "ward";
    check_output_bits(name, profile, std::min(20, profile.F - 3));
    const int O = profile.O, T = std::max(4, O / 4 + 1), L = profile.F + 1, E = std::max(2, O / 4), S = O + 4;
    return {profile.F,
            O + 3,
            T,
            L,
            E,
            S,
            O,
            exp_log::make_log2(name, profile.F, T, L),
            exp_log::make_exp2(name, E, S, O + I + 1)};
}

/// k_x or k_y: below 128.
EffectPort scale_port(std::string_view name, const Profile& profile) {
    return {name,
            EffectPort::Kind::parameter,
            profile.O + 7,
            false,
            profile.O,
            0,
            (std::int64_t{1} << (profile.O + 7)) - 1};
}

/// log2 of the peak: -8 .. 8.
EffectPort log_peak_port(const Profile& profile) {
    const int S = profile.O + 4;
    return {"log_peak", EffectPort::Kind::parameter, S + 5, true, S, -(std::int64_t{8} << S), std::int64_t{8} << S};
}

class Ward final : public EffectModel {
public:
    explicit Ward(const Profile& profile)
        : EffectModel(
              "ward", profile,
              {dot_port("nl", profile), dot_port("nv", profile), dot_port("nh", profile), dot_port("ht", profile),
               dot_port("hb", profile), scale_port("kx", profile), scale_port("ky", profile), log_peak_port(profile)},
              {term_port("y", profile, I)}),
          f_(ward_format(profile)) {}

    const WardFormat& format() const { return f_; }

private:
    void value(const std::int64_t* in, std::int64_t* out) const override { out[0] = f_.steps(in).y; }

    std::vector<Intermediate> intermediates(const std::int64_t* in) const override {
        const WardFormat::Steps x = f_.steps(in);
        return after_inputs(in, {{"hx", x.hx, f_.H},
                                 {"hy", x.hy, f_.H},
                                 {"r2", x.r2, f_.S},
                                 {"t", x.t, f_.S},
                                 {"ul", x.ul, f_.L},
                                 {"uv", x.uv, f_.L},
                                 {"e", x.e, f_.S},
                                 {"y", x.y, f_.O}});
    }

    // Powers and roots of the peak, of sqrt(nl / nv) and of the exponential in one: none alone is finite for all.
    void real(const double* in, double* out) const override {
        const double nl = in[0], nv = in[1], nh = in[2];
        out[0] = 0;
        if (nl <= 0 || nv <= 0 || nh < 0) return;
        const double hx = in[3] * in[5], hy = in[4] * in[6];
        const double exponent = in[7] + 0.5 * (std::log2(nl) - std::log2(nv)) - (hx * hx + hy * hy) / (1 + nh);
        out[0] = std::min(std::exp2(exponent), outputs()[0].real(outputs()[0].high));
    }

    double scale(const double* in) const override {
        double y = 0;
        real(in, &y);
        return std::max(1.0, y);
    }

    WardFormat f_;
};

/// The unit has a memory for each of the two logarithms.
Table named(std::string_view name, Table table) {
    table.name = name;
    return table;
}

std::vector<GeneratedFile> emit_ward(const Profile& profile, std::string_view) {
    const Ward model(profile);
    const WardFormat& f = model.format();
    const auto text = [](int value) { return std::to_string(value); };
    const std::vector<Table> memories{named("log2_nl", f.log2.table()), named("log2_nv", f.log2.table()),
                                      f.exp2.table()};
    return with_tables(
        {effect_wrapper(
             model,
             {{block::stream(), block::step(6), block::divider(f.S + 7), block::step(), block::exp2(), block::step()},
              {"glint_dot", "glint_delay", "glint_log2"}},
             {{"F", text(f.F), ""}, {"T", text(f.T), ""}, {"E", text(f.E), ""}, {"O", text(f.O), ""}}, memories),
         effect_top(model),
         effect_constants(model,
                          {{"int F", text(f.F), "fraction bits of the dot products"},
                           {"int T", text(f.T), "address bits of log2"},
                           {"int L", text(f.L), "fraction bits of log2"},
                           {"int E", text(f.E), "address bits of exp2"},
                           {"int S", text(f.S), "fraction bits of the exponent"},
                           {"int O", text(f.O), "fraction bits of the output"}},
                          {f.log2.table(), f.exp2.table()})},
        memories);
}

std::vector<EffectCase> ward_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const auto ports = model.inputs();
    const std::int64_t one = model.profile().one();
    const auto add = [&](std::string name, std::vector<std::int64_t> dots, double alpha_x, double alpha_y,
                         std::string risk) {
        const WardParameters p = ward_parameters(alpha_x, alpha_y);
        dots.insert(dots.end(), {ports[5].code(p.kx), ports[6].code(p.ky), ports[7].code(p.log_peak)});
        cases.push_back({std::move(name), std::move(dots), std::move(risk)});
    };
    add("L, V, H along N", {one, one, one, 0, 0}, 0.2, 0.2, "the peak itself, 1 / (4 pi alpha^2)");
    add("the sharpest peak", {one, one, one, 0, 0}, 0.02, 0.02, "199 is near the end of the port");
    add("the sharpest peak, grazing viewer", {one, 1, one, 0, 0}, 0.02, 0.02, "the root of 2^F: saturates");
    add("grazing light, nl = 1 ulp", {1, one, one, 0, 0}, 0.02, 0.02, "the root of 2^-F: a large peak times little");
    add("grazing light and viewer", {1, 1, one / 2, one / 2, 0}, 0.5, 0.5, "1 ulp by 1 ulp: the root is exactly 1");
    add("light in the surface", {0, one / 2, one / 2, 0, 0}, 0.2, 0.2, "the logarithm of 0; the result is 0");
    add("viewer in the surface", {one / 2, 0, one / 2, 0, 0}, 0.2, 0.2, "division by 0; the result is 0");
    add("light and viewer in the surface", {0, 0, 0, one, 0}, 0.2, 0.2, "0 / 0; the result is 0");
    add("light behind", {-one / 2, one / 2, one / 2, 0, 0}, 0.2, 0.2, "the root of a negative number; the result is 0");
    add("viewer behind", {one / 2, -1, one / 2, 0, 0}, 0.2, 0.2, "the root of a negative number; the result is 0");
    add("half vector behind", {one / 2, one / 2, -one, one / 2, 0}, 0.2, 0.2, "1 + N.H = 0; the result is 0");
    add("half vector in the surface", {one / 2, one / 2, 0, one, 0}, 1, 1, "the least divisor");
    add("tangent frame vanishes", {one / 2, one / 2, one / 2, 0, 0}, 0.02, 0.5,
        "H.T = H.B = 0 though H is not N: the peak");
    add("everything vanishes", {0, 0, 0, 0, 0}, 0.2, 0.2, "what NaN upstream becomes; the result is 0");
    add("H.T = H.B = 1", {one / 2, one / 2, one, one, one}, 0.02, 0.02,
        "the scaled H saturates twice; the result is 0");
    add("H.T = -1 - 1 ulp", {one / 2, one / 2, one / 2, -one - 1, 0}, 1, 1, "a vector longer than 1: counts as -1");
    add("brushed metal, across", {one / 2, one / 2, one - one / 200, one / 10, 0}, 0.02, 1,
        "sharp along T: nearly nothing");
    add("brushed metal, along", {one / 2, one / 2, one - one / 200, 0, one / 10}, 0.02, 1,
        "wide along B: nearly the peak");
    add("roughest", {one / 3, one / 5, one / 2, one / 3, one / 4}, 1, 1, "alpha = 1: the peak is 0.08");
    const std::int64_t top = ports[5].high;
    cases.push_back(
        {"all parameters at their tops", {one, 1, 0, 1, 1, top, top, ports[7].high}, "saturates, exponent below 0"});
    cases.push_back({"the least peak", {1, one, one, 0, 0, 0, 0, ports[7].low}, "the greatest exponent without H"});
    cases.push_back(
        {"the peak is 256", {one, one, one, 0, 0, 0, 0, ports[7].high}, "saturates where the exponent is exactly 0"});
    return cases;
}

}  // namespace

Effect ward_effect() {
    return {"ward",
            "sqrt(N.L / N.V) exp(-2 ((H.T / ax)^2 + (H.B / ay)^2) / (1 + N.H)) / (4 pi ax ay)",
            "G. J. Ward 1992",
            make_model<Ward>,
            emit_ward,
            ward_cases,
            1.3};
}

}  // namespace glint
