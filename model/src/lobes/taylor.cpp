// The lobe `taylor`: docs/lobes/taylor.md.

#include <algorithm>
#include <cmath>

#include "lobe.hpp"
#include "numbers.hpp"
#include "powers.hpp"

namespace glint {
namespace {

double taylor_in_domain(double c, double n, int a) {
    if (c == 1.0) return 1.0;  // also for n = infinity, where x would be NaN
    const double d = 1.0 - c;
    const double x = n / a * (d + taylor_bend * d * d);
    double square = is_power(n) ? c : x < 1.0 ? 0.5 * ((1.0 - x) * (1.0 - x) + 1.0) : 0.0;
    double product = 1.0;
    for (int bits = is_power(n) ? static_cast<int>(n) : a; bits > 0; bits /= 2) {
        if (bits % 2 == 1) product *= square;
        square *= square;
    }
    return product;
}

double taylor_reference(double c, double n) {
    return reference::with_domain(c, n, [](double x, double y) { return taylor_in_domain(x, y, 16); });
}

struct TaylorFormat {
    static constexpr std::string_view lobe = "taylor";
    int F = 0;      ///< fraction bits of the cosine
    int log_a = 4;  ///< a = 2^log_a
    int E = 0;      ///< fraction bits of e
    int S = 0;      ///< fraction bits of the base and its powers
    int O = 0;      ///< fraction bits of the output

    struct Steps {
        std::int64_t e = 0, x = 0, v = 0, r = 0, y = 0;
        Powers powers{};
    };

    // With d = 2^F - C in 0 .. 2^F: 2^(F+3) d + 5 d^2 <= 13 2^(2F) < 2^62 for F <= 29, e is 0 .. 1.625 2^E, x = n e
    // below 2^(E+11), v, r and the powers 0 .. 2^S, their products with the half that rounds them below 2^61.
    Steps steps(int n, std::int64_t C) const {
        Steps w;
        const std::int64_t d = (std::int64_t{1} << F) - C;
        const std::int64_t one = std::int64_t{1} << (E + log_a);  // 1 as a code of x / a
        w.e = rnd((d << (F + 3)) + 5 * d * d, 2 * F + 3 - E);
        w.x = n * w.e;
        w.v = w.x < one ? rnd(one - w.x, E + log_a - S) : 0;
        if (is_power(n)) {
            w.r = S >= F ? C << (S - F) : rnd(C, F - S);
        } else {
            w.r = w.x < one ? (std::int64_t{1} << (S - 1)) + rnd(w.v * w.v, S + 1) : 0;
        }
        w.powers = powers_by_squaring(w.r, S);
        w.y = power_of(w.powers, is_power(n) ? n : 1 << log_a, S, O);
        return w;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& w) const {
        std::vector<Intermediate> all{{"C", C, F},   {"e", w.e, E},          {"x", w.x, E + log_a}, {"v", w.v, S},
                                      {"r", w.r, S}, {"r2", w.powers[1], S}, {"r4", w.powers[2], S}};
        if (log_a > 3) all.push_back({"r8", w.powers[3], S});
        if (log_a > 4) all.push_back({"r16", w.powers[4], S});
        all.push_back({"y", w.y, O});
        return all;
    }

    double real(double c, double n) const { return taylor_in_domain(c, n, 1 << log_a); }
};

// At p16 the jump from 2^-16 to 0 is an ulp: there e is as fine as it takes to jump at the real function's place.
std::vector<int> taylor_numbers(int F, int O) { return {F, 16, O + (O < 16 ? 12 : 14), O + 6, O}; }

TaylorFormat taylor_format(const Profile& profile) {
    if (!profile.shipped()) check_custom(profile, "taylor", "F,a,E,S,O");
    const std::vector<int> numbers = profile.shipped() ? taylor_numbers(profile.F, profile.O) : profile.custom;
    const int a = numbers[1];
    const int E = numbers[2];
    const int S = numbers[3];
    if (a != 8 && a != 16 && a != 32) {
        throw Error(fmt::format("a = {} is not legal for taylor: 8, 16, 32; 16 is the lobe's own", a));
    }
    in_range("taylor", "F", profile.F, 8, 29);
    in_range("taylor", "S", S, profile.O, 30);
    in_range("taylor", "E", E, std::max(profile.F, S), std::min(2 * profile.F, 50));
    return {profile.F, a == 8 ? 3 : a == 16 ? 4 : 5, E, S, profile.O};
}

std::string taylor_gappa_body(const TaylorFormat& f) {
    return fmt::format(R"(
# n: 7, 9 .. 1023, where x < 1

# A name here has the meaning of docs/lobes/taylor.md, but stands for the value, not the code; e_real and so on are those
# of the real function. From x = 1 on the answer and the real function are 0; that the two agree on which inputs these
# are, where it matters, was measured: see there. The base of the powers 1 to 6 and 8 is C itself: C_r and what follows.

@rnd_E = fixed<-{E}, nu>;
@rnd_S = fixed<-{S}, nu>;
@rnd_O = fixed<-{O}, nu>;

# The contract.
d = 1 - C;
e_real = d + 5b-3 * (d * d);
e = rnd_E(e_real);
x = n * e * 1b-4;
w = 1 - x;
v = rnd_S(w);
half_square = rnd_S(v * v * 1b-1);
r = 1b-1 + half_square;
r2 = rnd_S(r * r);
r4 = rnd_S(r2 * r2);
r8 = rnd_S(r4 * r4);
y = rnd_O(r8 * r8);

# The real function.
x_real = n * e_real * 1b-4;
w_real = 1 - x_real;
s = 1b-1 + w_real * w_real * 1b-1;
s2 = s * s;
s4 = s2 * s2;
s8 = s4 * s4;
error = (y - s8 * s8) * 1b{O};

# The powers of C.
C_r = rnd_S(C);
{small_powers}

{{ C in [0, 1] /\ n in [1, 1023] /\ w in [0, 1] /\ w_real in [0, 1] ->
  # Claimed, since the words of the hardware rest on it.
  e in [0, 1.625] /\ v in [0, 1] /\ r in [0.5, 1] /\ r2 in [0, 1] /\ r4 in [0, 1] /\ r8 in [0, 1] /\ y in [0, 1] /\
  {small_power_claims}
  # What is asked.
  e in ? /\ x in ? /\ v in ? /\ r in ? /\ r2 in ? /\ r4 in ? /\ r8 in ? /\ y in ? /\ error in ? }}

# The error, one term for each rounding.
w - w_real -> n * (e_real - e) * 1b-4;
v * v - w_real * w_real -> (v - w_real) * (v + w_real);
r - s -> (half_square - v * v * 1b-1) + (v * v - w_real * w_real) * 1b-1;
r * r - s2 -> (r - s) * (r + s);
r2 * r2 - s4 -> (r2 - s2) * (r2 + s2);
r4 * r4 - s8 -> (r4 - s4) * (r4 + s4);
r8 * r8 - s8 * s8 -> (r8 - s8) * (r8 + s8);
)",
                       fmt::arg("E", f.E), fmt::arg("S", f.S), fmt::arg("O", f.O),
                       fmt::arg("small_powers", gappa_small_powers(f.O)),
                       fmt::arg("small_power_claims", gappa_small_power_claims));
}

std::vector<GeneratedFile> emit_taylor(const Profile& profile, const Architecture& architecture) {
    const TaylorFormat f = taylor_format(profile);
    const std::string a = std::to_string(1 << f.log_a);
    const std::vector<Constant> parameters{{"F", std::to_string(f.F), ""},
                                           {"A", a, ""},
                                           {"E", std::to_string(f.E), ""},
                                           {"S", std::to_string(f.S), ""},
                                           {"O", std::to_string(f.O), ""}};
    auto files = generated_sources("taylor", profile, architecture,
                                   {{block::ports(), block::rounded(), block::rounded(), block::square(), block::step(),
                                     block::power(f.log_a - 1)},
                                    {"glint_delay"}},
                                   parameters,
                                   {{"int F", std::to_string(f.F), "fraction bits of the cosine"},
                                    {"int A", a, "the power"},
                                    {"int E", std::to_string(f.E), "fraction bits of e"},
                                    {"int S", std::to_string(f.S), "fraction bits of the base and its powers"},
                                    {"int O", std::to_string(f.O), "fraction bits of the output"}});
    if (f.log_a == 4) {
        files.push_back(gappa_script("taylor", profile, fmt::format("F, E, S, O: {}, {}, {}, {}", f.F, f.E, f.S, f.O),
                                     taylor_gappa_body(f)));
    }
    return files;
}

std::vector<HardCase> taylor_hard_cases(const GoldenModel& model) {
    const int one = model.profile().one();
    auto cases = common_hard_cases(model);
    const auto add = [&](std::string name, int n, std::int32_t code, std::string risk) {
        cases.push_back({std::move(name), n, code, std::move(risk)});
    };
    add("n = 7, c = 0", 7, 0, "x = 0.71: the only n with a rounded tail of its own, never cut");
    add("n = 9, c = 0", 9, 0, "x = 0.91, v small: not cut");
    add("n = 10, c = 0", 10, 0, "x = 1.02: the least n that is cut");
    add("n = 1, c = 1 - 1 ulp", 1, one - 1, "the power 1 passes through a product with 1.0, which needs the bit S");
    add("n = 5, c = 3/4", 5, one / 4 * 3, "the power 5 is the product of unlike powers");
    add("n = 7, c = 1", 7, one, "the square of v = 1 needs the bit that the base adds 1/2 to");
    add("largest x", 1023, 0, "1023 * 1.625 needs all of its E + 11 bits");
    for (const int n : {50, 1023}) {
        const std::int32_t cut = first_code(model, n, "r");
        add(fmt::format("n = {}, last base cut to 0", n), n, cut - 1,
            "x just above 1: without the cut the base would grow again");
        add(fmt::format("n = {}, first base above 0", n), n, cut, "x just below 1: the base jumps from 0 to 1/2");
        const std::int32_t nonzero = first_code(model, n, "y");
        add(fmt::format("n = {}, last result 0", n), n, nonzero - 1, "rounding of the last product, or the jump");
        add(fmt::format("n = {}, first result above 0", n), n, nonzero, "rounding of the last product, or the jump");
    }
    add("n = 7, c = 0.558", 7, static_cast<std::int32_t>(std::lround(0.558 * one)), "where the approximation is worst");
    return cases;
}

}  // namespace

Lobe taylor_lobe() {
    return {"taylor",
            "(((1 - x)^2 + 1) / 2)^16, x = n/16 (d + 5/8 d^2), d = 1 - c, 0 from x = 1 on; c^n for n = 1 .. 6 and 8",
            "F,a,E,S,O",
            taylor_reference,
            make_plain<taylor_format>,
            emit_taylor,
            taylor_hard_cases,
            taylor_numbers};
}

}  // namespace glint
