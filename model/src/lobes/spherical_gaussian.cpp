// The lobe `spherical_gaussian`: docs/lobes/spherical_gaussian.md.

#include <cmath>

#include "exp_log.hpp"
#include "numbers.hpp"

namespace glint {
namespace {

double spherical_gaussian_in_domain(double c, double n) {
    if (c == 1.0) return 1.0;  // also for n = infinity, where the product would be NaN
    return std::exp((n + spherical_gaussian_shift) * (c - 1.0));
}

double spherical_gaussian(double c, double n) { return reference::with_domain(c, n, spherical_gaussian_in_domain); }

struct SphericalGaussianFormat {
    static constexpr std::string_view lobe = "spherical_gaussian";
    int F = 0;           ///< fraction bits of the cosine
    int K = 0;           ///< fraction bits of a, b and g
    std::int64_t a = 0;  ///< log2 e
    std::int64_t b = 0;  ///< 0.775 log2 e
    exp_log::Exp2 exp2;

    struct Steps {
        std::int64_t g = 0, t = 0, p = 0, y = 0;
    };

    // g <= 1509 2^K, so g (2^F - C) < 2^(K + F + 11) <= 2^62.
    Steps steps(int n, std::int64_t C) const {
        Steps x;
        x.g = n * a + b;
        x.t = rnd(x.g * ((std::int64_t{1} << F) - C), K + F - exp2.S);
        const exp_log::Exp2::Steps last = exp2.steps(x.t);
        x.p = last.p;
        x.y = last.y;
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        return {{"C", C, F}, {"g", x.g, K}, {"t", x.t, exp2.S}, {"p", x.p, exp2.S}, {"y", x.y, exp2.O}};
    }

    double real(double c, double n) const { return spherical_gaussian_in_domain(c, n); }
};

std::vector<int> spherical_gaussian_numbers(int F, int O) { return {F, O + 1, O / 4, O + 4, O}; }

SphericalGaussianFormat spherical_gaussian_format(const Profile& profile) {
    constexpr std::string_view lobe = SphericalGaussianFormat::lobe;
    if (!profile.shipped()) check_custom(profile, lobe, "F,K,E,S,O");
    const std::vector<int> numbers =
        profile.shipped() ? spherical_gaussian_numbers(profile.F, profile.O) : profile.custom;
    const int K = in_range(lobe, "K", numbers[1], 4, 51 - profile.F);
    const int E = numbers[2];
    const int S = numbers[3];
    SphericalGaussianFormat f{profile.F, K, 0, 0, exp_log::make_exp2(lobe, E, S, profile.O)};
    in_range(lobe, "S", S, profile.O + 1, K + profile.F - 1);
    const exp_log::Wide log2_e = exp_log::over_ln2(exp_log::wide_one);
    f.a = exp_log::nearest(log2_e, K);
    f.b = exp_log::nearest(log2_e * 31 / 40, K);  // 0.775 = 31 / 40
    return f;
}

std::vector<GeneratedFile> emit_spherical_gaussian(const Profile& profile, const Architecture& architecture) {
    const SphericalGaussianFormat f = spherical_gaussian_format(profile);
    const auto text = [](std::int64_t value) { return std::to_string(value); };
    // a = 1.44 2^K and b = 1.12 2^K: K + 1 bits.
    return generated_sources(f.lobe, profile, architecture,
                             {{block::ports(), block::rounded(), block::rounded(), block::exp2()}, {"glint_delay"}},
                             {{"F", text(f.F), ""},
                              {"K", text(f.K), ""},
                              {"E", text(f.exp2.E), ""},
                              {"S", text(f.exp2.S), ""},
                              {"O", text(f.exp2.O), ""},
                              {"A", fmt::format("{}'d{}", f.K + 1, f.a), ""},
                              {"B", fmt::format("{}'d{}", f.K + 1, f.b), ""}},
                             {{"int F", text(f.F), "fraction bits of the cosine"},
                              {"int K", text(f.K), "fraction bits of a, b and g"},
                              {"int E", text(f.exp2.E), "address bits of exp2"},
                              {"int S", text(f.exp2.S), "fraction bits of t and p"},
                              {"int O", text(f.exp2.O), "fraction bits of the output"},
                              {"std::int64_t a", text(f.a), "log2 e"},
                              {"std::int64_t b", text(f.b), "0.775 log2 e"}},
                             {f.exp2.table()});
}

std::vector<HardCase> spherical_gaussian_hard_cases(const GoldenModel& model) {
    std::vector<HardCase> cases = common_hard_cases(model);
    exp_log::add_end_cases(model, cases);
    return cases;
}

}  // namespace

Lobe spherical_gaussian_lobe() {
    return {"spherical_gaussian",
            "exp((n + 0.775) (c - 1))",
            "F,K,E,S,O",
            spherical_gaussian,
            make_plain<spherical_gaussian_format>,
            emit_spherical_gaussian,
            spherical_gaussian_hard_cases,
            spherical_gaussian_numbers,
            {},
            false,
            false,
            true};
}

}  // namespace glint
