// The lobe `quadratic`: docs/lobes/quadratic.md.

#include "lobe.hpp"
#include "numbers.hpp"

namespace glint {
namespace {

/// 0.786 n c^2 + (1 - 0.786 n) c in the domain, without the cancellation near c = 1.
double quadratic(double c, double n) {
    if (c == 1.0) return 1.0;  // also for n = infinity, where n (1 - c) would be NaN
    return c * std::max(0.0, 1.0 - quadratic_slope * (n * (1.0 - c)));
}

double reference_quadratic(double c, double n) { return reference::with_domain(c, n, quadratic); }

struct QuadraticFormat {
    static constexpr std::string_view lobe = "quadratic";
    int F = 0;               ///< fraction bits of the cosine
    int S = 0;               ///< fraction bits of w: O .. 30
    int K = 0;               ///< fraction bits of the constant: O .. 30, and F + K <= 52
    int O = 0;               ///< fraction bits of the output
    std::int64_t slope = 0;  ///< 0.786 at K bits

    struct Steps {
        std::int64_t scaled = 0, line = 0, w = 0, y = 0;
    };

    // slope < 2^K, so scaled d < 1023 2^(F+K) < 2^62. line is 0 .. 2^(F+K), w is 0 .. 2^S, and C w with the half that
    // rounds it at most 2^60 + 2^59; the upper ends are reached at C = 2^F only.
    Steps steps(int n, std::int64_t C) const {
        Steps x;
        x.scaled = slope * n;
        x.line = std::max<std::int64_t>(0, (std::int64_t{1} << (F + K)) - x.scaled * ((std::int64_t{1} << F) - C));
        x.w = rnd(x.line, F + K - S);
        x.y = rnd(C * x.w, F + S - O);
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        return {{"C", C, F}, {"scaled", x.scaled, K}, {"line", x.line, F + K}, {"w", x.w, S}, {"y", x.y, O}};
    }

    double real(double c, double n) const { return quadratic(c, n); }
};

std::vector<int> quadratic_numbers(int F, int O) { return {F, O + 1, O + 2, O}; }

QuadraticFormat quadratic_format(const Profile& profile) {
    constexpr std::string_view lobe = QuadraticFormat::lobe;
    if (!profile.shipped()) check_custom(profile, lobe, "F,S,K,O");
    const std::vector<int> numbers = profile.shipped() ? quadratic_numbers(profile.F, profile.O) : profile.custom;
    QuadraticFormat f{profile.F, 0, 0, profile.O};
    in_range(lobe, "O", f.O, 4, std::min(28, 52 - f.F));
    f.K = in_range(lobe, "K", numbers[2], f.O, std::min(30, 52 - f.F));
    f.S = in_range(lobe, "S", numbers[1], f.O, std::min(30, f.F + f.K));
    f.slope = quantize_constant(quadratic_slope, f.K);
    return f;
}

std::vector<GeneratedFile> emit_quadratic(const Profile& profile, const Architecture& architecture) {
    const QuadraticFormat f = quadratic_format(profile);
    const auto text = [](std::int64_t x) { return std::to_string(x); };
    auto files =
        generated_sources(QuadraticFormat::lobe, profile, architecture,
                          {{block::ports(), block::product(), block::rounded(), block::rounded()}, {"glint_delay"}},
                          {{"F", text(f.F), ""},
                           {"S", text(f.S), ""},
                           {"K", text(f.K), ""},
                           {"O", text(f.O), ""},
                           {"SLOPE", fmt::format("{}'d{}", f.K, f.slope), ""}},
                          {{"int F", text(f.F), "fraction bits of the cosine"},
                           {"int S", text(f.S), "fraction bits of w"},
                           {"int K", text(f.K), "fraction bits of the constant"},
                           {"int O", text(f.O), "fraction bits of the output"},
                           {"std::int64_t slope", text(f.slope), fmt::format("{}", quadratic_slope)}});
    files.push_back(gappa_script(QuadraticFormat::lobe, profile,
                                 fmt::format("F, S, K, O: {}, {}, {}, {}", f.F, f.S, f.K, f.O),
                                 fmt::format(R"(
# A name here has the meaning of docs/lobes/quadratic.md, but stands for the value, not the code, and before values below
# 0 are cut to 0: rnd and a product with C keep the sign, so the cut may as well come last, on y and on f, and a cut
# brings no two numbers further apart. Where m > 1.3 both are below 0, so both are cut to 0 without an error.

@rnd_S = fixed<-{S}, nu>;
@rnd_O = fixed<-{O}, nu>;

# The constant as published, and as the model rounds it to K bits.
slope = {slope};
slope_K = {code}b-{K};

m = n * (1 - C);
line = 1 - slope_K * m;
w = rnd_S(line);
product_y = C * w;
y = rnd_O(product_y);

f = C * (1 - slope * m);
error = (y - f) * 1b{O};

{{ C in [0, 1] /\ n in [1, 1023] /\ m in [0, 1.3] ->
  line in [-1, 1] /\ w in [-1, 1] /\ product_y in [-1, 1] /\ y in [-1, 1] /\
  line in ? /\ w in ? /\ product_y in ? /\ y in ? /\ error in ? }}

# The error, one term for each rounding and one for that of the constant.
y - f -> (y - product_y) + C * ((w - line) + (slope - slope_K) * m);
)",
                                             fmt::arg("S", f.S), fmt::arg("K", f.K), fmt::arg("O", f.O),
                                             fmt::arg("slope", quadratic_slope), fmt::arg("code", f.slope))));
    return files;
}

std::vector<HardCase> quadratic_hard_cases(const GoldenModel& model) {
    const QuadraticFormat f = quadratic_format(model.profile());
    const int one = model.profile().one();
    auto cases = common_hard_cases(model);
    cases.push_back({"n = 1, c = 1/4", 1, one / 4, "n = 1 is not cut: w is positive for every cosine"});
    for (const int n : {2, 50, 1000}) {
        // scaled d <= 2^(F+K): the line is not cut.
        const std::int64_t d = (std::int64_t{1} << (f.F + f.K)) / (f.slope * n);
        const auto first = static_cast<std::int32_t>(one - d);
        cases.push_back({fmt::format("n = {}, the last cosine that is cut", n), n, first - 1,
                         "the line is negative by its last bits"});
        cases.push_back({fmt::format("n = {}, the first cosine that is not cut", n), n, first,
                         "the line is 0 or a few of its last bits"});
        const int zero = first_code(model, n, "y") - 1;
        cases.push_back({fmt::format("n = {}, the last y = 0", n), n, zero, "rounds down to 0"});
        cases.push_back({fmt::format("n = {}, the first y > 0", n), n, zero + 1, "rounds up to 1 ulp"});
    }
    return cases;
}

}  // namespace

Lobe quadratic_lobe() {
    return {QuadraticFormat::lobe,
            "max(0, 0.786 n c^2 + (1 - 0.786 n) c)",
            "F,S,K,O",
            reference_quadratic,
            make_plain<quadratic_format>,
            emit_quadratic,
            quadratic_hard_cases,
            quadratic_numbers};
}

}  // namespace glint
