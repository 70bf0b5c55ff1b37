// The lobe `cosine_power`: docs/lobes/cosine_power.md.

#include <array>
#include <bit>

#include "lobe.hpp"

namespace glint {
namespace {

/// max(0, 1 - n (1 - c) / a)^a in the domain; the paper writes the base as (n / a) (c - 1) + 1.
double power(double c, double n, int log2_a) {
    if (c == 1.0) return 1.0;  // also for n = infinity, where n (1 - c) would be NaN
    double x = std::max(0.0, 1.0 - std::ldexp(n * (1.0 - c), -log2_a));
    for (int i = 0; i < log2_a; ++i) x *= x;
    return x;
}

constexpr int shipped_log2_a = 3;  // the paper's a = 8

double reference_cosine_power(double c, double n) {
    return reference::with_domain(c, n, [](double x, double m) { return power(x, m, shipped_log2_a); });
}

struct CosinePowerFormat {
    static constexpr std::string_view lobe = "cosine_power";
    static constexpr int max_log2_a = 6;

    int F = 0;       ///< fraction bits of the cosine
    int log2_a = 0;  ///< so many squarings: 1 .. 6
    int S = 0;       ///< fraction bits of the powers: O .. min(30, F + log2 a)
    int O = 0;       ///< fraction bits of the output

    struct Steps {
        std::int64_t base = 0;
        std::array<std::int64_t, max_log2_a> p{};  ///< p1, p2, p4, ...: log2 a of them
        std::int64_t y = 0;
    };

    // n d <= 1023 2^30. base is 0 .. a 2^F <= 2^36; a p is 0 .. 2^S, and its square with the half that rounds it is
    // below 2^61; all stay at their upper ends exactly where C = 2^F.
    Steps steps(int n, std::int64_t C) const {
        Steps x;
        const std::int64_t one = std::int64_t{1} << F;
        x.base = std::max<std::int64_t>(0, (one << log2_a) - n * (one - C));
        x.p[0] = rnd(x.base, F + log2_a - S);
        std::size_t last = 0;
        for (; static_cast<int>(last) + 1 < log2_a; ++last) x.p[last + 1] = rnd(x.p[last] * x.p[last], S);
        x.y = rnd(x.p[last] * x.p[last], 2 * S - O);
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        static constexpr std::array<std::string_view, max_log2_a> names{"p1", "p2", "p4", "p8", "p16", "p32"};
        std::vector<Intermediate> out{{"C", C, F}, {"base", x.base, F + log2_a}};
        for (std::size_t i = 0; static_cast<int>(i) < log2_a; ++i) out.push_back({names[i], x.p[i], S});
        out.push_back({"y", x.y, O});
        return out;
    }

    double real(double c, double n) const { return power(c, n, log2_a); }
};

std::vector<int> cosine_power_numbers(int F, int O) { return {F, 1 << shipped_log2_a, O + 4, O}; }

CosinePowerFormat cosine_power_format(const Profile& profile) {
    constexpr std::string_view lobe = CosinePowerFormat::lobe;
    if (profile.shipped()) {
        return {profile.F, shipped_log2_a, cosine_power_numbers(profile.F, profile.O)[2], profile.O};
    }
    check_custom(profile, lobe, "F,a,S,O");
    const int a = profile.custom[1];
    if (a < 2 || a > 64 || !std::has_single_bit(static_cast<unsigned>(a))) {
        throw Error(fmt::format("a = {} is not legal for {}: 2, 4, 8, 16, 32 or 64", a, lobe));
    }
    const int log2_a = std::countr_zero(static_cast<unsigned>(a));
    const int exact = profile.F + log2_a;  // fraction bits of the base
    in_range(lobe, "O", profile.O, 4, std::min(28, exact));
    const int S = in_range(lobe, "S", profile.custom[2], profile.O, std::min(30, exact));
    return {profile.F, log2_a, S, profile.O};
}

/// The script for any a: one line of the contract, one of the real function and one rewriting rule a squaring.
GeneratedFile cosine_power_script(const Profile& profile, const CosinePowerFormat& f) {
    std::string powers, real_powers, rules, claims, questions;
    int exponent = 1;
    std::string before = "base";  // the real power that p<exponent> stands for
    for (int i = 1; i < f.log2_a; ++i, exponent *= 2) {
        powers += fmt::format("p{1} = rnd_S(p{0} * p{0});\n", exponent, 2 * exponent);
        real_powers += fmt::format("f{0} = {1} * {1};\n", 2 * exponent, before);
        rules += fmt::format("p{1} - f{1} -> (p{1} - p{0} * p{0}) + (p{0} - {2}) * (p{0} + {2});\n", exponent,
                             2 * exponent, before);
        claims += fmt::format(" /\\ p{} in [0, 1]", 2 * exponent);
        questions += fmt::format(" /\\ p{} in ?", 2 * exponent);
        before = fmt::format("f{}", 2 * exponent);
    }
    return gappa_script(
        CosinePowerFormat::lobe, profile, fmt::format("F, a, S, O: {}, {}, {}, {}", f.F, 1 << f.log2_a, f.S, f.O),
        fmt::format(R"(
# A name here has the meaning of docs/lobes/cosine_power.md, but stands for the value, not the code; f<k> is the real
# power <k> of the base. The script speaks of a base that is not below 0: where it is, it is cut to 0, and every power
# of it is 0 without an error.

@rnd_S = fixed<-{S}, nu>;
@rnd_O = fixed<-{O}, nu>;

base = 1 - n * (1 - C) / {a};
p1 = rnd_S(base);
{powers}y = rnd_O(p{last} * p{last});

{real_powers}f = {real} * {real};
error = (y - f) * 1b{O};

{{ C in [0, 1] /\ n in [1, 1023] /\ base in [0, 1] ->
  p1 in [0, 1]{claims} /\ y in [0, 1] /\
  p1 in ?{questions} /\ y in ? /\ error in ? }}

# The error, one term for each rounding: squaring doubles the one before and adds its own.
y - f -> (y - p{last} * p{last}) + (p{last} - {real}) * (p{last} + {real});
{rules})",
                    fmt::arg("S", f.S), fmt::arg("O", f.O), fmt::arg("a", 1 << f.log2_a), fmt::arg("powers", powers),
                    fmt::arg("real_powers", real_powers), fmt::arg("last", exponent), fmt::arg("real", before),
                    fmt::arg("claims", claims), fmt::arg("questions", questions), fmt::arg("rules", rules)));
}

std::vector<GeneratedFile> emit_cosine_power(const Profile& profile, const Architecture& architecture) {
    const CosinePowerFormat f = cosine_power_format(profile);
    const auto text = [](int x) { return std::to_string(x); };
    auto files = generated_sources(
        CosinePowerFormat::lobe, profile, architecture,
        {{block::ports(), block::rounded(), block::power(f.log2_a - 1)}},
        {{"F", text(f.F), ""}, {"LOG2_A", text(f.log2_a), ""}, {"S", text(f.S), ""}, {"O", text(f.O), ""}},
        {{"int F", text(f.F), "fraction bits of the cosine"},
         {"int LOG2_A", text(f.log2_a), "the lobe is a power of exponent a = 2^LOG2_A"},
         {"int S", text(f.S), "fraction bits of the powers"},
         {"int O", text(f.O), "fraction bits of the output"}});
    files.push_back(cosine_power_script(profile, f));
    return files;
}

std::vector<HardCase> cosine_power_hard_cases(const GoldenModel& model) {
    const CosinePowerFormat f = cosine_power_format(model.profile());
    const int one = model.profile().one();
    const int a = 1 << f.log2_a;
    auto cases = common_hard_cases(model);
    cases.push_back({fmt::format("c = 0, n = {}", a - 1), a - 1, 0,
                     "the largest n without a cut: the base is 1/a, not 0, and still positive at c = 0"});
    cases.push_back({fmt::format("c = 0, n = {}", a), a, 0, "the base is exactly 0 and is not cut"});
    cases.push_back({fmt::format("c = 0, n = {}", a + 1), a + 1, 0,
                     "the first n with a cut: unclamped, the even power would rise again"});
    for (const int n : {50, 1000}) {
        const std::int64_t d = (std::int64_t{a} << f.F) / n;  // n d <= a 2^F: the base is not cut
        cases.push_back({fmt::format("n = {}, the last cosine that is cut", n), n,
                         static_cast<std::int32_t>(one - d - 1), "the base is negative by its last bits"});
        cases.push_back({fmt::format("n = {}, the first cosine that is not cut", n), n,
                         static_cast<std::int32_t>(one - d), "the base is 0 or a few of its last bits"});
        const int zero = first_code(model, n, "y") - 1;
        cases.push_back({fmt::format("n = {}, the last y = 0", n), n, zero, "rounds down to 0"});
        cases.push_back({fmt::format("n = {}, the first y > 0", n), n, zero + 1, "rounds up to 1 ulp"});
    }
    return cases;
}

}  // namespace

Lobe cosine_power_lobe() {
    return {CosinePowerFormat::lobe,
            "max(0, (n/a)(c - 1) + 1)^a, a = 8",
            "F,a,S,O",
            reference_cosine_power,
            make_plain<cosine_power_format>,
            emit_cosine_power,
            cosine_power_hard_cases,
            cosine_power_numbers};
}

}  // namespace glint
