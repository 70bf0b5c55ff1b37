// The lobe `gauss`: docs/lobes/gauss.md.

#include <cmath>

#include "exp_log.hpp"

namespace glint {
namespace {

double gauss_in_domain(double c, double n) {
    if (c == 1.0) return 1.0;  // also for n = infinity, where the product would be NaN
    const double theta = std::acos(c);
    return std::exp(-0.5 * n * theta * theta);
}

double gauss(double c, double n) { return reference::with_domain(c, n, gauss_in_domain); }

/// theta^2 / (2 ln 2) of d = 1 - cos(theta) = x / 2^bits, from theta^2 = 2 sum of (2 d)^k / (k^2 binomial(2 k, k)).
exp_log::Wide half_square_angle(int x, int bits) {
    exp_log::Wide term = (exp_log::wide_one * x) >> bits;  // (2 d)^k / binomial(2 k, k)
    exp_log::Wide sum = 0;
    for (int k = 1; term != 0; ++k) {
        sum += term / (k * k);
        term = ((term * x) >> bits) * (k + 1) / (2 * k + 1);
    }
    return exp_log::over_ln2(sum);
}

struct GaussFormat {
    static constexpr std::string_view lobe = "gauss";
    int F = 0;  ///< fraction bits of the cosine
    int T = 0;  ///< address bits of v
    int L = 0;  ///< fraction bits of v
    exp_log::Pieces angle;
    exp_log::Exp2 exp2;

    struct Steps {
        std::int64_t h = 0, v = 0, t = 0, p = 0, y = 0;
    };

    // v <= 1.78 2^L, so n v < 2^(L + 11) <= 2^49.
    Steps steps(int n, std::int64_t C) const {
        Steps x;
        const std::int64_t d = (std::int64_t{1} << F) - C;
        const std::int64_t index = std::min(d >> angle.R, (std::int64_t{1} << T) - 1);  // d = 2^F ends the last piece
        const exp_log::Pieces::Steps piece = angle.steps(static_cast<std::size_t>(index), d - (index << angle.R));
        x.h = piece.h;
        x.v = piece.value;
        x.t = rnd(n * x.v, L - exp2.S);
        const exp_log::Exp2::Steps last = exp2.steps(x.t);
        x.p = last.p;
        x.y = last.y;
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        return {{"C", C, F}, {"v", x.v, L}, {"t", x.t, exp2.S}, {"p", x.p, exp2.S}, {"y", x.y, exp2.O}};
    }

    double real(double c, double n) const { return gauss_in_domain(c, n); }
};

GaussFormat gauss_format(const Profile& profile) {
    constexpr std::string_view lobe = GaussFormat::lobe;
    const exp_log::WordLengths x = exp_log::word_lengths(lobe, profile);
    in_range(lobe, "T", x.T, 4, std::min(10, profile.F - 1));
    in_range(lobe, "L", x.L, std::max(profile.F + 1, 2 * x.T + 1), 38);
    return {profile.F, x.T, x.L, exp_log::make_pieces(half_square_angle, x.T, profile.F - x.T, x.L, 0),
            exp_log::make_exp2(lobe, x.E, x.S, profile.O)};
}

std::vector<GeneratedFile> emit_gauss(const Profile& profile, const Architecture& architecture) {
    const GaussFormat f = gauss_format(profile);
    const auto text = [](int value) { return std::to_string(value); };
    return generated_sources(
        f.lobe, profile, architecture,
        {{block::ports(), block::step(), block::parabola(), block::rounded(), block::exp2()}, {"glint_delay"}},
        {{"F", text(f.F), ""},
         {"T", text(f.T), ""},
         {"L", text(f.L), ""},
         {"E", text(f.exp2.E), ""},
         {"S", text(f.exp2.S), ""},
         {"O", text(f.exp2.O), ""}},
        {{"int F", text(f.F), "fraction bits of the cosine"},
         {"int T", text(f.T), "address bits of v"},
         {"int L", text(f.L), "fraction bits of v"},
         {"int E", text(f.exp2.E), "address bits of exp2"},
         {"int S", text(f.exp2.S), "fraction bits of t and p"},
         {"int O", text(f.exp2.O), "fraction bits of the output"}},
        {f.angle.table("half_square_angle", "angle", f.L + 1, f.L - f.T + 3, f.L - 2 * f.T + 1), f.exp2.table()});
}

std::vector<HardCase> gauss_hard_cases(const GoldenModel& model) {
    std::vector<HardCase> cases = common_hard_cases(model);
    exp_log::add_end_cases(model, cases);
    const int one = model.profile().one();
    cases.push_back({"c = 1 ulp, n = 2", 2, 1, "the last place before the end of the last piece"});
    cases.push_back({"c = 0, n = 2", 2, 0, "the end of the last piece, which no address names"});
    cases.push_back({"c = 1/2 + 1 ulp, n = 3", 3, one / 2 + 1, "the last place of a piece"});
    return cases;
}

}  // namespace

Lobe gauss_lobe() {
    return {"gauss",
            "exp(-n theta^2 / 2), theta = acos c",
            "F,T,L,E,S,O",
            gauss,
            make_plain<gauss_format>,
            emit_gauss,
            gauss_hard_cases,
            exp_log::shipped_numbers,
            {},
            false,
            false,
            true};
}

}  // namespace glint
