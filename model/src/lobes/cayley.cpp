// The lobe `cayley`: docs/lobes/cayley.md.

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "lobe.hpp"
#include "powers.hpp"

namespace glint {
namespace {

/// The real function. a = 0: the lobe; else the plain formula with that a, for study.
double cayley_in_domain(double c, double n, int a) {
    if (c == 1.0) return 1.0;  // also for n = infinity, where m d would be NaN
    const int power = a > 0 ? a : is_power(n) ? static_cast<int>(n) : 8;
    const double m = a > 0 ? n - a : is_power(n) ? 0.0 : n - 8.0;
    // Beyond this num is 0 whatever c; a cut keeps the quotient of two infinities away.
    const double x = std::min(m * (1.0 - c), std::numeric_limits<double>::max() / 2.0);
    const double twice = a > 0 ? 2.0 * a : 16.0;
    const double less = a > 0 ? x : x * (15.0 / 16.0);
    const double more = a > 0 ? x : x * (273.0 / 256.0);
    const double r = std::max(0.0, twice * c - less) / (twice + more);
    double product = 1.0;
    double square = r;
    for (int bits = power; bits > 0; bits /= 2) {
        if (bits % 2 == 1) product *= square;
        square *= square;
    }
    return product;
}

double cayley_reference(double c, double n) {
    return reference::with_domain(c, n, [](double x, double y) { return cayley_in_domain(x, y, 0); });
}

struct CayleyFormat {
    static constexpr std::string_view lobe = "cayley";
    int F = 0;  ///< fraction bits of the cosine
    int a = 0;  ///< 0: the lobe; else the power of the plain formula
    int S = 0;  ///< fraction bits of the base and its powers
    int O = 0;  ///< fraction bits of the output

    struct Steps {
        std::int64_t m = 0, x = 0, num = 0, den = 0, r = 0, y = 0;
        Powers powers{};
    };

    // x = m (2^F - C) is in -2^F .. 1015 2^F, and in -31 2^F .. 1021 2^F with an a of its own. num is 0 .. 2a 2^F, den
    // 2^F (a + 1) or more, below 1099 2^F, and num <= den. So num 2^S <= 2^(F + S + 6) <= 2^62, r and its powers are
    // 0 .. 2^S, and their products with the half that rounds them are below 2^61.
    Steps steps(int n, std::int64_t C) const {
        Steps v;
        const std::int64_t one = std::int64_t{1} << F;
        const int half_den = a > 0 ? a : 8;
        v.m = a > 0 ? n - a : is_power(n) ? 0 : n - 8;
        v.x = v.m * (one - C);
        const std::int64_t sixteenth = a > 0 ? 0 : v.x >> 4;
        v.num = std::max<std::int64_t>(0, 2 * half_den * C - v.x + sixteenth);
        v.den = 2 * half_den * one + v.x + sixteenth + (sixteenth >> 4);
        v.r = (v.num << S) / v.den;
        v.powers = powers_by_squaring(v.r, S);
        v.y = power_of(v.powers, a > 0 ? a : n <= 6 ? n : 8, S, O);
        return v;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& v) const {
        std::vector<Intermediate> all{{"C", C, F},       {"m", v.m, 0}, {"x", v.x, F},          {"num", v.num, F},
                                      {"den", v.den, F}, {"r", v.r, S}, {"r2", v.powers[1], S}, {"r4", v.powers[2], S}};
        if (a > 8) all.push_back({"r8", v.powers[3], S});
        if (a > 16) all.push_back({"r16", v.powers[4], S});
        all.push_back({"y", v.y, O});
        return all;
    }

    double real(double c, double n) const { return cayley_in_domain(c, n, a); }
};

std::vector<int> cayley_numbers(int F, int O) { return {F, 0, O + 5, O}; }

CayleyFormat cayley_format(const Profile& profile) {
    if (profile.shipped()) {
        const std::vector<int> numbers = cayley_numbers(profile.F, profile.O);
        return {numbers[0], numbers[1], numbers[2], numbers[3]};
    }
    check_custom(profile, "cayley", "F,a,S,O");
    const int a = profile.custom[1];
    const int S = profile.custom[2];
    if (a != 0 && a != 2 && a != 4 && a != 8 && a != 16 && a != 32) {
        throw Error(fmt::format("a = {} is not legal for cayley: 0 for the lobe itself, or 2, 4, 8, 16, 32", a));
    }
    in_range("cayley", "S", S, profile.O, 30);
    in_range("cayley", "F + S", profile.F + S, 0, 56);
    return {profile.F, a, S, profile.O};
}

std::string cayley_gappa_body(const CayleyFormat& f) {
    return fmt::format(R"(
# n: 7 .. 1023, where num >= 0

# A name here has the meaning of docs/lobes/cayley.md, but stands for the value, not the code. The base of n = 8 and of
# the powers 1 to 6 is C itself: C_r and what follows. That num <= den is shown in that document. Where num is below 0
# the answer is 0, and the real function, whose numerator is larger by less than 2^-{F}, is below 2^-{tail}.
#@-Wno-null-denominator

@floor_F = fixed<-{F}, dn>;
@floor_S = fixed<-{S}, dn>;
@rnd_S = fixed<-{S}, nu>;
@rnd_O = fixed<-{O}, nu>;

# The contract.
m = n - 8;
x = m * (1 - C);
sixteenth = floor_F(x * 1b-4);
more = floor_F(sixteenth * 1b-4);
num = 16 * C - x + sixteenth;
den = 16 + x + sixteenth + more;
quotient = num / den;
r = floor_S(quotient);
r2 = rnd_S(r * r);
r4 = rnd_S(r2 * r2);
y = rnd_O(r4 * r4);

# The real function.
num_real = 16 * C - x * 15b-4;
den_real = 16 + x * 273b-8;
s = num_real / den_real;
s2 = s * s;
s4 = s2 * s2;
error = (y - s4 * s4) * 1b{O};

# The powers of C.
C_r = floor_S(C);
{small_powers}

{{ C in [0, 1] /\ n in [7, 1023] /\ num >= 0 /\ den - num >= 0 ->
  # Claimed, since the words of the hardware rest on it.
  m in [-1, 1015] /\ x in [-1, 1015] /\ den in [14, 1099] /\ r in [0, 1] /\ r2 in [0, 1] /\ r4 in [0, 1] /\
  y in [0, 1] /\
  {small_power_claims}
  # What is asked.
  m in ? /\ x in ? /\ num in ? /\ den in ? /\ r in ? /\ r2 in ? /\ r4 in ? /\ y in ? /\ error in ? }}

den -> 16 + m * (1 - C) + sixteenth + more;
den_real -> 16 + m * (1 - C) * 273b-8;

# The error, one term for each rounding.
quotient - s -> ((num - num_real) - s * (den - den_real)) / den {{ den <> 0, den_real <> 0 }};
num - num_real -> sixteenth - x * 1b-4;
den - den_real -> (sixteenth - x * 1b-4) * 17b-4 + (more - sixteenth * 1b-4);
r * r - s2 -> (r - s) * (r + s);
r2 * r2 - s4 -> (r2 - s2) * (r2 + s2);
r4 * r4 - s4 * s4 -> (r4 - s4) * (r4 + s4);
)",
                       fmt::arg("F", f.F), fmt::arg("S", f.S), fmt::arg("O", f.O),
                       fmt::arg("small_powers", gappa_small_powers(f.O)),
                       fmt::arg("small_power_claims", gappa_small_power_claims), fmt::arg("tail", 8 * (f.F + 3)));
}

std::vector<GeneratedFile> emit_cayley(const Profile& profile, const Architecture& architecture) {
    const CayleyFormat f = cayley_format(profile);
    const int squares = static_cast<int>(std::bit_width(static_cast<unsigned>(f.a == 0 ? 8 : f.a))) - 2;
    const std::vector<Constant> parameters{{"F", std::to_string(f.F), ""},
                                           {"A", std::to_string(f.a), ""},
                                           {"S", std::to_string(f.S), ""},
                                           {"O", std::to_string(f.O), ""}};
    auto files = generated_sources(
        "cayley", profile, architecture,
        {{block::ports(), block::step(), block::rounded(), block::divider(f.S + 1), block::power(squares)},
         {"glint_delay"}},
        parameters,
        {{"int F", std::to_string(f.F), "fraction bits of the cosine"},
         {"int A", std::to_string(f.a), "0: the lobe; else the power of the plain formula"},
         {"int S", std::to_string(f.S), "fraction bits of the base and its powers"},
         {"int O", std::to_string(f.O), "fraction bits of the output"}});
    if (f.a == 0) {
        files.push_back(
            gappa_script("cayley", profile, fmt::format("F, S, O: {}, {}, {}", f.F, f.S, f.O), cayley_gappa_body(f)));
    }
    return files;
}

std::vector<HardCase> cayley_hard_cases(const GoldenModel& model) {
    const int one = model.profile().one();
    auto cases = common_hard_cases(model);
    const auto add = [&](std::string name, int n, std::int32_t code, std::string risk) {
        cases.push_back({std::move(name), n, code, std::move(risk)});
    };
    add("n = 7, c = 0", 7, 0, "the only m below 0: den is the least, 14 and a little, and x negative");
    add("n = 7, c = 1 - 1 ulp", 7, one - 1, "x = -1, whose floored sixteenth is -1, not 0");
    add("n = 9, c = 1 - 1 ulp", 9, one - 1, "the first m above 0");
    add("n = 1, c = 1 - 1 ulp", 1, one - 1, "the power 1 passes through a product with 1.0, which needs the bit S");
    add("n = 5, c = 3/4", 5, one / 4 * 3, "the power 5 is the product of unlike powers");
    add("largest den", 1023, 0, "1099 needs all of its F + 11 bits, and num is far below 0");
    for (const int n : {50, 1023}) {
        const std::int32_t cut = first_code(model, n, "num");
        add(fmt::format("n = {}, last num cut to 0", n), n, cut - 1, "just below 0: a lost sign would answer almost 1");
        add(fmt::format("n = {}, first num above 0", n), n, cut, "the base leaves 0");
        const std::int32_t nonzero = first_code(model, n, "y");
        add(fmt::format("n = {}, last result 0", n), n, nonzero - 1, "rounding of the last product");
        add(fmt::format("n = {}, first result above 0", n), n, nonzero, "rounding of the last product");
    }
    add("n = 23, c = 0.844", 23, static_cast<std::int32_t>(std::lround(0.844 * one)),
        "where the approximation is worst");
    return cases;
}

}  // namespace

Lobe cayley_lobe() {
    return {"cayley",
            "(max(0, 16 c - 15/16 m d) / (16 + 273/256 m d))^8, m = n - 8, d = 1 - c; c^n for n = 1 .. 6",
            "F,a,S,O",
            cayley_reference,
            make_plain<cayley_format>,
            emit_cayley,
            cayley_hard_cases,
            cayley_numbers,
            {},
            true};
}

}  // namespace glint
