// The lobe `polynomial`: docs/lobes/polynomial.md.

#include <array>
#include <charconv>
#include <cmath>

#include "glint/fit.hpp"
#include "lobe.hpp"
#include "numbers.hpp"

namespace glint {
namespace {

/// What a polynomial is made of, as real numbers.
struct Polynomial {
    Variable variable;
    std::vector<double> coefficients;  ///< of the powers 0, 1, ...: 3 to 7 of them
};

/// The least squares fit of its document, rounded to four decimals: 0 at t = 0, 1 at t = 1.
const Polynomial& shipped_polynomial() {
    static const Polynomial polynomial{Variable::symmetric,
                                       {polynomial_coefficients.begin(), polynomial_coefficients.end()}};
    return polynomial;
}

double value(const Polynomial& p, double c, double n) {
    const double x = c == 1.0 ? 1.0 : variable_value(p.variable, c, n);  // also for n = infinity
    double f = 0.0;
    for (std::size_t i = p.coefficients.size(); i-- > 0;) f = f * x + p.coefficients[i];
    return std::clamp(f, 0.0, 1.0);
}

/// "symmetric:0:-0.3444:2.8786:-1.5342": the variable, then the coefficients of the powers 0, 1, ...
Polynomial parse_polynomial(std::string_view text) {
    const auto refuse = [&](std::string_view why) {
        return Error(
            fmt::format("options '{}' are not legal for polynomial: {}; legal are schlick or symmetric, then the "
                        "coefficients of the powers 0, 1, ..., 3 to 7 of them below 64, separated by ':'",
                        text, why));
    };
    Polynomial out{Variable::schlick, {}};
    std::string_view field = text.substr(0, text.find(':'));
    out.variable = parse_variable(field);
    for (std::string_view rest = text; field.size() != rest.size();) {
        rest.remove_prefix(field.size() + 1);
        field = rest.substr(0, rest.find(':'));
        double number = 0.0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
        if (error != std::errc{} || end != field.data() + field.size() || !(std::abs(number) < 64.0)) {
            throw refuse(fmt::format("coefficient '{}'", field));
        }
        out.coefficients.push_back(number);
    }
    if (out.coefficients.size() < 3 || out.coefficients.size() > 7) {
        throw refuse(fmt::format("{} coefficients", out.coefficients.size()));
    }
    return out;
}

double reference_polynomial(double c, double n) {
    return reference::with_domain(c, n, [](double x, double m) { return value(shipped_polynomial(), x, m); });
}

struct PolynomialFormat {
    static constexpr std::string_view lobe = "polynomial";
    static constexpr std::size_t max_degree = 6;

    Polynomial polynomial;
    int F = 0;                    ///< fraction bits of the cosine
    int S = 0;                    ///< fraction bits of the quotient: O .. 30
    int K = 0;                    ///< fraction bits of the coefficients: O .. 30
    int O = 0;                    ///< fraction bits of the output
    int I = 0;                    ///< integer bits of a Horner value: see words()
    std::vector<std::int64_t> k;  ///< the coefficients at K bits

    std::size_t degree() const { return k.size() - 1; }

    struct Steps {
        std::int64_t D = 0, quotient = 0;
        std::array<std::int64_t, max_degree> h{};  ///< h1, h2, ...: degree - 1 of them, from the index 1
        std::int64_t r = 0, y = 0;
    };

    // numerator <= 2^(F+1) and <= D <= 2047 2^F, so quotient is 0 .. 2^S and numerator 2^S <= 2^61. What words() shows
    // of I: a Horner value is below 2^(I+K), a sum of the two below with the half that rounds it below 2^(I+K+S) <=
    // 2^62.
    Steps steps(int n, std::int64_t C) const {
        Steps x;
        const std::int64_t one = std::int64_t{1} << F;
        const bool symmetric = polynomial.variable == Variable::symmetric;
        const std::int64_t numerator = symmetric ? one + C : C;
        x.D = numerator + (symmetric ? 2 * n : n) * (one - C);
        x.quotient = (numerator << S) / x.D;
        std::int64_t h = k.back();
        for (std::size_t j = 1; j < degree(); ++j) h = x.h[j] = k[degree() - j] + rnd(h * x.quotient, S);
        x.r = rnd(h * x.quotient + k[0] * (std::int64_t{1} << S), S + K - O);
        x.y = std::clamp<std::int64_t>(x.r, 0, std::int64_t{1} << O);
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        static constexpr std::array<std::string_view, max_degree> names{"", "h1", "h2", "h3", "h4", "h5"};
        std::vector<Intermediate> out{{"C", C, F}, {"D", x.D, F}, {"quotient", x.quotient, S}};
        for (std::size_t j = 1; j < degree(); ++j) out.push_back({names[j], x.h[j], K});
        out.push_back({"r", x.r, O});
        out.push_back({"y", x.y, O});
        return out;
    }

    double real(double c, double n) const { return value(polynomial, c, n); }

    /// The least I for which every Horner value, and the last sum with its half, is below 2^(I+K) in magnitude whatever
    /// the quotient: h q lies between 0 and h for q in [0, 1], rnd keeps both ends, and the next coefficient is added.
    void words() {
        std::int64_t low = k.back(), high = k.back(), most = std::max(std::abs(low), std::abs(high));
        for (std::size_t j = 1; j <= degree(); ++j) {
            low = k[degree() - j] + std::min<std::int64_t>(low, 0);
            high = k[degree() - j] + std::max<std::int64_t>(high, 0);
            most = std::max({most, std::abs(low), std::abs(high)});
        }
        most += std::int64_t{1} << (K - O);
        for (I = 1; most >= std::int64_t{1} << (I + K);) ++I;
        if (I + K + S > 62) {
            throw Error(fmt::format("S = {}, K = {} are not legal for {}: Horner values below 2^{} need {} bits, of 62",
                                    S, K, lobe, I, I + K + S));
        }
    }
};

std::vector<int> polynomial_numbers(int F, int O) { return {F, O + 3, O + 3, O}; }

PolynomialFormat polynomial_format(const Profile& profile) {
    constexpr std::string_view lobe = PolynomialFormat::lobe;
    PolynomialFormat f{profile.options.empty() ? shipped_polynomial() : parse_polynomial(profile.options),
                       profile.F,
                       0,
                       0,
                       profile.O,
                       0,
                       {}};
    if (!profile.shipped()) check_custom(profile, lobe, "F,S,K,O");
    const std::vector<int> numbers = profile.shipped() ? polynomial_numbers(profile.F, profile.O) : profile.custom;
    f.S = in_range(lobe, "S", numbers[1], f.O, 30);
    f.K = in_range(lobe, "K", numbers[2], f.O, 30);
    for (const double c : f.polynomial.coefficients) f.k.push_back(quantize_constant(c, f.K));
    f.words();
    return f;
}

/// The script for any degree: a line of the contract, of the real function and of the rules each Horner step.
GeneratedFile polynomial_script(const Profile& profile, const PolynomialFormat& f) {
    const std::size_t degree = f.degree();
    std::string published, codes, steps, real_steps, rules, claims, questions, real;
    // A coefficient that K bits hold exactly has one name, and no error.
    const auto exact = [&](std::size_t i) {
        return std::ldexp(f.polynomial.coefficients[i], f.K) == static_cast<double>(f.k[i]);
    };
    const auto code = [&](std::size_t i) { return fmt::format("k{}{}", i, exact(i) ? "" : "_K"); };
    const auto off = [&](std::size_t i) { return exact(i) ? std::string() : fmt::format(" + (k{0}_K - k{0})", i); };
    for (std::size_t i = 0; i <= degree; ++i) {
        published += fmt::format("k{} = {};\n", i, f.polynomial.coefficients[i]);
        if (!exact(i)) codes += fmt::format("k{}_K = {}b-{};\n", i, f.k[i], f.K);
        real = i == 0 ? fmt::format("k{}", degree) : fmt::format("({} * s + k{})", real, degree - i);
    }
    std::string h = code(degree), h_real = fmt::format("k{}", degree);
    for (std::size_t j = 1; j < degree; ++j) {
        const std::size_t i = degree - j;
        steps += fmt::format("product_{0} = {1} * quotient;\nh{0} = {2} + rnd_K(product_{0});\n", j, h, code(i));
        real_steps += fmt::format("h{0}_real = {1} * quotient + k{2};\n", j, h_real, i);
        rules += fmt::format("h{0} - h{0}_real -> (rnd_K(product_{0}) - product_{0}){1}", j, off(i));
        rules += h == h_real ? ";\n" : fmt::format(" + ({} - {}) * quotient;\n", h, h_real);
        claims += fmt::format(" /\\ h{} in [-{}, {}]", j, 1 << f.I, 1 << f.I);
        questions += fmt::format("product_{0} in ? /\\ h{0} in ? /\\ ", j);
        h = fmt::format("h{}", j);
        h_real = fmt::format("h{}_real", j);
    }
    // (P(quotient) - P(s)) / (quotient - s): the divided difference of each power.
    std::string divided = fmt::format("k1");
    for (std::size_t i = 2; i <= degree; ++i) {
        std::string sum;
        for (std::size_t a = 0; a < i; ++a) {
            std::string product;
            for (std::size_t b = 0; b < i - 1; ++b) {
                product += fmt::format("{}{}", b == 0 ? "" : " * ", b < a ? "s" : "quotient");
            }
            sum += fmt::format("{}{}", a == 0 ? "" : " + ", product);
        }
        divided += fmt::format(" + k{} * ({})", i, sum);
    }
    const bool symmetric = f.polynomial.variable == Variable::symmetric;
    return gappa_script(
        PolynomialFormat::lobe, profile, fmt::format("F, S, K, O: {}, {}, {}, {}", f.F, f.S, f.K, f.O),
        fmt::format(R"(
# A name here has the meaning of docs/lobes/polynomial.md, but stands for the value, not the code; y and P before they
# are cut to 0 .. 1. A cut brings no two numbers further apart, so the bound of `error` holds after it as well.

# Every improvement of an interval counts, however small: bounds then do not depend on the order in which Gappa looks.
#@-Echange-threshold=0
# Gappa checks each equation below as algebra, for D other than 0, and warns of that; where it divides by D, in that of
# s, D <> 0 is asked for, and proven.
#@-Wno-null-denominator

@floor_S = fixed<-{S}, dn>;
@rnd_K = fixed<-{K}, nu>;
@rnd_O = fixed<-{O}, nu>;

# The coefficients as decided on, and as the model rounds them to K bits.
{published}{codes}
# The contract.
{D}s = {s} / D;
quotient = floor_S(s);
{steps}product_y = {h} * quotient;
sum_y = product_y + {k0};
y = rnd_O(sum_y);

# The real function, at s and at the quotient, and the error in ulps of the output.
P = {real};
{real_steps}P_quotient = {h_real} * quotient + k0;
error = (y - P) * 1b{O};

{{ C in [0, 1] /\ n in [1, 1023] ->
  D in [1, 2047] /\ quotient in [0, 1]{claims} /\
  D in ? /\ s in ? /\ quotient in ? /\
  {questions}product_y in ? /\ sum_y in ? /\ y in ? /\ error in ? }}

# D and s written so that their ranges follow from those of C and n.
{D_rule}
# The error, one term for each rounding.
y - P -> (y - sum_y) + ({h} - {h_real}) * quotient{k0_off} + (P_quotient - P);
{rules}P_quotient - P -> (quotient - s) * ({divided});

# The terms depend on s: bounded piece by piece, they do not take their worst values together.
error $ s in 256;
)",
                    fmt::arg("S", f.S), fmt::arg("K", f.K), fmt::arg("O", f.O), fmt::arg("published", published),
                    fmt::arg("codes", codes), fmt::arg("k0", code(0)), fmt::arg("k0_off", off(0)),
                    fmt::arg("steps", steps), fmt::arg("h", h), fmt::arg("h_real", h_real), fmt::arg("real", real),
                    fmt::arg("real_steps", real_steps), fmt::arg("claims", claims), fmt::arg("questions", questions),
                    fmt::arg("rules", rules), fmt::arg("divided", divided), fmt::arg("s", symmetric ? "(1 + C)" : "C"),
                    fmt::arg("D", symmetric ? "D = (1 + C) + 2 * n * (1 - C);\n" : "D = C + n * (1 - C);\n"),
                    fmt::arg("D_rule", symmetric ? "D -> 2 + (2 * n - 1) * (1 - C);\n"
                                                 : "D -> 1 + (n - 1) * (1 - C);\n"
                                                   "s -> 1 - n * (1 - C) / D { D <> 0 };\n")));
}

std::vector<GeneratedFile> emit_polynomial(const Profile& profile, const Architecture& architecture) {
    const PolynomialFormat f = polynomial_format(profile);
    const auto text = [](auto x) { return std::to_string(x); };
    const std::string variable = text(f.polynomial.variable == Variable::symmetric ? 1 : 0);
    const int width = f.K + f.I + 1;
    std::string packed;
    for (std::size_t i = f.k.size(); i-- > 0;) {
        packed += fmt::format("{}{}", verilog_literal(f.k[i], width), i == 0 ? "" : ", ");
    }
    std::vector<Constant> kernel{{"int F", text(f.F), "fraction bits of the cosine"},
                                 {"int S", text(f.S), "fraction bits of the quotient"},
                                 {"int K", text(f.K), "fraction bits of the coefficients"},
                                 {"int O", text(f.O), "fraction bits of the output"},
                                 {"int I", text(f.I), "integer bits of a Horner value"},
                                 {"int VARIABLE", variable, "0: schlick, 1: symmetric"},
                                 {"int DEGREE", text(f.degree()), "of the polynomial"}};
    for (std::size_t i = 0; i <= PolynomialFormat::max_degree; ++i) {
        const bool used = i <= f.degree();
        kernel.push_back({fmt::format("std::int64_t k{}", i), text(used ? f.k[i] : 0),
                          used ? fmt::format("{}", f.polynomial.coefficients[i]) : "not used"});
    }
    auto files = generated_sources(PolynomialFormat::lobe, profile, architecture,
                                   {{block::ports(), block::ratio(f.S), block::horner(static_cast<int>(f.degree()))}},
                                   {{"F", text(f.F), ""},
                                    {"S", text(f.S), ""},
                                    {"K", text(f.K), ""},
                                    {"O", text(f.O), ""},
                                    {"I", text(f.I), ""},
                                    {"VARIABLE", variable, ""},
                                    {"DEGREE", text(f.degree()), ""},
                                    {"COEFFICIENTS", "{" + packed + "}", ""}},
                                   kernel);
    files.push_back(polynomial_script(profile, f));
    return files;
}

std::vector<HardCase> polynomial_hard_cases(const GoldenModel& model) {
    auto cases = common_hard_cases(model);
    for (const int n : {50, 1000}) {
        // Between its zeros the polynomial is below 0; it is 0 at t = 0, and n = 1000 comes near.
        const int zero = first_code(model, n, "y") - 1;
        cases.push_back({fmt::format("n = {}, the last y = 0", n), n, zero, "cut to 0 from below"});
        cases.push_back({fmt::format("n = {}, the first y > 0", n), n, zero + 1, "rounds up to 1 ulp"});
        std::int32_t deepest = 0;
        std::int64_t least = 0;
        for (std::int32_t C = 0; C <= zero; C += std::max(1, zero / 4096)) {
            for (const Intermediate& value : model.trace(n, C)) {
                if (value.name == "r" && value.code < least) {
                    least = value.code;
                    deepest = C;
                }
            }
        }
        cases.push_back(
            {fmt::format("n = {}, deepest below 0", n), n, deepest, "without the cut a huge unsigned number"});
    }
    return cases;
}

}  // namespace

Lobe polynomial_lobe() {
    return {PolynomialFormat::lobe,
            "-1.5342 t^3 + 2.8786 t^2 - 0.3444 t, t = (1 + c) / ((1 + c) + 2 n (1 - c))",
            "F,S,K,O",
            reference_polynomial,
            make_plain<polynomial_format>,
            emit_polynomial,
            polynomial_hard_cases,
            polynomial_numbers,
            "VARIABLE:k0:k1:...",
            true};
}

}  // namespace glint
