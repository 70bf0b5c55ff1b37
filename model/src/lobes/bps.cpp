// The lobe `bps`: docs/lobes/bps.md.

#include <algorithm>
#include <cmath>

#include "bps.hpp"
#include "lobe.hpp"

namespace glint {
namespace {

// Range of each intermediate, for every legal format. q stands for quotient / 2^S, in [0, 1]; u = 2^-K.
//
//   C         0 .. 2^F
//   D         C + n (2^F - C), between 2^F (n = 1 or C = 2^F) and n 2^F (C = 0): F + 10 bits, never 0
//   quotient  C <= D, so C 2^S / D <= 2^S, which is reached at C = D only, that is at C = 2^F: S + 1 bits
//   a q       a = -1.631 + at most u/2: between -1.67 and 0 (K >= 4): product below 2^(K + S + 1) in magnitude
//   h1        b + rnd(a q): between b + a - u = 1.36 - 2u and b = 2.995 + u/2: below 2^(K + 2), positive for K >= 4
//   h1 q      0 .. 3.03: below 2^(K + S + 2)
//   h2        c1 + rnd(h1 q): c1 + b q + a q^2 rises to 1.001 at q = 0.918, so with roundings from -0.41 to 1.13
//   h2 q + d0 from -0.02 to 1.13 (K >= 4): below 2^(K + S + 1) in magnitude
//   y         see largest_output below: at most 2^O, checked when the format is made
//
// The largest of them, h1 q + 2^(S-1), is below 2^(K + S + 2) <= 2^62, and C 2^S <= 2^60: 64 bits are enough.

/// The polynomial, and the fraction before it.
struct BpsFormat : BpsPolynomial {
    static constexpr std::string_view lobe = "bps";
    int F = 0;  ///< fraction bits of the cosine, 8..30

    Steps steps(int n, std::int64_t C) const {
        Steps x;
        const std::int64_t one = std::int64_t{1} << F;
        x.D = n * one - (n - 1) * C;
        x.quotient = (C << S) / x.D;  // both positive: / is the floor
        horner(x);
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        return {{"C", C, F},     {"D", x.D, F},   {"quotient", x.quotient, S},
                {"h1", x.h1, K}, {"h2", x.h2, K}, {"y", x.y, O}};
    }

    double real(double c, double n) const { return reference::bps_horner(c, n); }
    static void real_lanes(double n, std::span<const double> c, std::span<double> out) {
        reference::bps_batch(n, c, out);
    }

    /// Lanes of doubles hold every intermediate exactly while it has at most 52 bits; then nothing is rounded but by
    /// the contract.
    bool has_lanes() const { return F + S <= 50 && K + S <= 46; }

    /// The contract in doubles. Why each line gives the contract's bits, given the widths that has_lanes() asks for:
    /// - Sums and products of integers below 2^52 are exact, and so is a scaling by a power of two.
    /// - C 2^S and D are exact, and their division rounds once, relatively by 2^-53 at most. A quotient that is not an
    ///   integer lies at least 1/D below the next integer k, relatively 1/(k D) > 1/(C 2^S + D) > 2^-52: rounding
    ///   never reaches k, so truncation is the floor.
    /// - rnd(x, k) is x 2^-k + 2^-(k+1) to the nearest integer, which has no ties left; and to add 1.5 2^52 to a number
    ///   below 2^51 in magnitude rounds it to the nearest integer, since doubles from 2^52 to 2^53 are the integers.
    static std::uint32_t lanes(const BpsFormat& f, const std::uint16_t* n, const std::int32_t* cos_code,
                               std::uint32_t* packed, std::size_t count) {
        std::uint32_t bits = 0;
        constexpr double shifter = 0x1.8p52;
        const std::int32_t one = std::int32_t{1} << f.F;
        const double two_S = std::ldexp(1.0, f.S);
        const double inv_S = std::ldexp(1.0, -f.S);
        const double nudge = std::ldexp(1.0, -f.S - 1);
        const int cut = f.S + f.K - f.O;
        const double inv_cut = std::ldexp(1.0, -cut);
        const double a = std::ldexp(static_cast<double>(f.a), -f.S);
        const double b = static_cast<double>(f.b) - shifter;
        const double c1 = static_cast<double>(f.c1) - shifter;
        const double d0 = std::ldexp(static_cast<double>(f.d0), f.S - cut) + std::ldexp(1.0, -cut - 1);
#pragma omp simd reduction(| : bits)
        for (std::size_t i = 0; i < count; ++i) {
            const std::int32_t code = cos_code[i];
            const std::int32_t exponent = n[i];
            const bool below = code < 0;
            const bool above = code > one;
            const bool none = exponent == 0;
            const std::int32_t C_code = below ? 0 : (above ? one : code);
            const double C = C_code;
            const double D = C + static_cast<double>(none ? 1 : exponent) * static_cast<double>(one - C_code);
            const double q = static_cast<std::int32_t>(C * two_S / D);
            const double h1 = ((a * q + nudge) + shifter) + b;
            const double h2 = ((h1 * (q * inv_S) + nudge) + shifter) + c1;
            const double y = ((h2 * (q * inv_cut) + d0) + shifter) - shifter;
            const std::int32_t cut_y = static_cast<std::int32_t>(y);
            const std::uint32_t value = below || cut_y < 0 ? 0U : static_cast<std::uint32_t>(cut_y);
            const std::uint32_t result = value | (below || above || none ? 0x8000'0000U : 0U);
            packed[i] = result;
            bits |= result;
        }
        return bits;
    }
};

/// The largest y over the quotients first..last, if above `known`; exact, by bisection. On a stretch where h1 and h2
/// do not change (h1 falls with the quotient and h2 at one h1 >= 0 rises, so equal ends mean equal throughout), y is
/// monotone and an end is the largest. Stretches that cannot exceed `known` are not opened: there, with h1 and h2
/// taken at whichever end is larger, y is bounded by max(h2) q + d0.
std::int64_t largest_output(const BpsPolynomial& f, std::int64_t first, std::int64_t last, std::int64_t known) {
    BpsPolynomial::Steps low, high;
    low.quotient = first;
    high.quotient = last;
    f.horner(low);
    f.horner(high);
    known = std::max({known, low.y, high.y});
    if (last - first <= 1 || (low.h1 == high.h1 && low.h2 == high.h2)) return known;
    const std::int64_t h2_most = f.c1 + rnd(low.h1 * last, f.S);
    const std::int64_t bound =
        rnd(std::max<std::int64_t>(0, h2_most) * last + f.d0 * (std::int64_t{1} << f.S), f.S + f.K - f.O);
    if (bound <= known) return known;
    const std::int64_t middle = first + (last - first) / 2;
    known = largest_output(f, middle, last, known);  // the polynomial is largest near q = 1: look there first
    return largest_output(f, first, middle, known);
}

}  // namespace

void BpsPolynomial::horner(Steps& x) const {
    x.h1 = b + rnd(a * x.quotient, S);
    x.h2 = c1 + rnd(x.h1 * x.quotient, S);
    x.y = std::max<std::int64_t>(0, rnd(x.h2 * x.quotient + d0 * (std::int64_t{1} << S), S + K - O));
}

BpsPolynomial bps_polynomial(std::string_view who, const Profile& profile, int S, int K) {
    BpsPolynomial f{.O = profile.O};
    f.S = in_range(who, "S", S, f.O, 30);
    f.K = in_range(who, "K", K, f.O, 30);
    f.a = quantize_constant(reference::bps_constants.a, f.K);
    f.b = quantize_constant(reference::bps_constants.b, f.K);
    f.c1 = quantize_constant(reference::bps_constants.c1, f.K);
    f.d0 = quantize_constant(reference::bps_constants.d0, f.K);
    const std::int64_t top = largest_output(f, 0, std::int64_t{1} << f.S, 0);
    if (top > (std::int64_t{1} << f.O)) {
        throw Error(fmt::format("profile '{}' is not legal for {}: y reaches {}, above 2^O = {}; raise K",
                                profile.argument(), who, top, std::int64_t{1} << f.O));
    }
    return f;
}

namespace {

std::vector<int> bps_numbers(int F, int O) { return {F, O + 3, O + 3, O}; }

BpsFormat bps_format(const Profile& profile) {
    if (!profile.shipped()) check_custom(profile, BpsFormat::lobe, "F,S,K,O");
    const std::vector<int> numbers = profile.shipped() ? bps_numbers(profile.F, profile.O) : profile.custom;
    return {bps_polynomial(BpsFormat::lobe, profile, numbers[1], numbers[2]), profile.F};
}

/// The arithmetic of docs/lobes/bps.md on real numbers, for which Gappa proves the range of every intermediate and a
/// bound of the rounding error.
std::string bps_gappa_body(const BpsFormat& f) {
    const auto& published = reference::bps_constants;
    return fmt::format(R"(
# A name here has the meaning of docs/lobes/bps.md, but stands for the value, not the code: C is the cosine code / 2^F,
# h1 is the contract's integer h1 / 2^K, y is its y / 2^O before negative results are cut to 0, and P is f_bps before
# the same cut. A cut brings no two numbers further apart, so the bound of `error` holds after it as well.

# Every improvement of an interval counts, however small: bounds then do not depend on the order in which Gappa looks.
#@-Echange-threshold=0
# Gappa checks each equation below as algebra, for D other than 0, and warns of that; where it divides by D, in that of
# s, D <> 0 is asked for, and proven.
#@-Wno-null-denominator

@floor_S = fixed<-{S}, dn>;
@rnd_K = fixed<-{K}, nu>;
@rnd_O = fixed<-{O}, nu>;

# The constants as published, and as the model rounds them to K bits.
a = {a};
b = {b};
c1 = {c1};
d0 = {d0};
a_K = {a_K}b-{K};
b_K = {b_K}b-{K};
c1_K = {c1_K}b-{K};
d0_K = {d0_K}b-{K};

# The contract.
D = n - (n - 1) * C;
s = C / D;
quotient = floor_S(s);
product_1 = a_K * quotient;
h1 = b_K + rnd_K(product_1);
product_2 = h1 * quotient;
h2 = c1_K + rnd_K(product_2);
product_3 = h2 * quotient;
sum_3 = product_3 + d0_K;
y = rnd_O(sum_3);

# The real function, at s and at the quotient, and the error in ulps of the output.
P = ((a * s + b) * s + c1) * s + d0;
h1_real = a * quotient + b;
h2_real = h1_real * quotient + c1;
P_quotient = h2_real * quotient + d0;
error = (y - P) * 1b{O};

{{ C in [0, 1] /\ n in [1, 1023] ->
  # Claimed, since the words of the hardware and of the 64-bit model rest on it. Half a unit, which rnd adds before it
  # cuts, still fits: the words end at 4 for h1 and h2 and what they are cut from, at 2 for sum_3.
  D in [1, 1023] /\ quotient in [0, 1] /\
  product_1 in [-3, 0] /\ h1 in [-3, 3] /\ product_2 in [0, 3] /\ h2 in [-3, 3] /\
  product_3 in [-1.5, 1.5] /\ sum_3 in [-1.5, 1.5] /\ y in [-1, 1] /\
  # What is asked.
  D in ? /\ s in ? /\ quotient in ? /\ product_1 in ? /\ h1 in ? /\ product_2 in ? /\ h2 in ? /\
  product_3 in ? /\ sum_3 in ? /\ y in ? /\ error in ? }}

# D and s written so that their ranges follow from those of C and n.
D -> 1 + (n - 1) * (1 - C);
s -> 1 - n * (1 - C) / D {{ D <> 0 }};

# The error, one term for each rounding. Each of the differences on the left is a difference of large and almost equal
# numbers, of whose intervals nothing follows; on the right stand the small numbers of which it is made.
y - P -> (y - sum_3) + (h2 - h2_real) * quotient + (d0_K - d0) + (P_quotient - P);
h2 - h2_real -> (rnd_K(product_2) - product_2) + (c1_K - c1) + (h1 - h1_real) * quotient;
h1 - h1_real -> (rnd_K(product_1) - product_1) + (b_K - b) + (a_K - a) * quotient;
P_quotient - P ->
  (quotient - s) * (a * (quotient * quotient + quotient * s + s * s) + b * (quotient + s) + c1);

# The terms depend on s: bounded piece by piece, they do not take their worst values together.
error $ s in 256;
)",
                       fmt::arg("S", f.S), fmt::arg("K", f.K), fmt::arg("O", f.O), fmt::arg("a", published.a),
                       fmt::arg("b", published.b), fmt::arg("c1", published.c1), fmt::arg("d0", published.d0),
                       fmt::arg("a_K", f.a), fmt::arg("b_K", f.b), fmt::arg("c1_K", f.c1), fmt::arg("d0_K", f.d0));
}

std::vector<GeneratedFile> emit_bps(const Profile& profile, const Architecture& architecture) {
    const BpsFormat f = bps_format(profile);
    // The constants of f_bps are below 4 in magnitude, with 1.0 as 2^K: K + 3 bits with the sign.
    const auto literal = [&](std::int64_t value) { return verilog_literal(value, f.K + 3); };
    const auto text = [](std::int64_t value) { return std::to_string(value); };
    auto files =
        generated_sources("bps", profile, architecture, {{block::ports(), block::ratio(f.S), block::horner(3)}},
                          {{"F", text(f.F), ""},
                           {"S", text(f.S), ""},
                           {"K", text(f.K), ""},
                           {"O", text(f.O), ""},
                           {"A", literal(f.a), ""},
                           {"B", literal(f.b), ""},
                           {"C1", literal(f.c1), ""},
                           {"D0", literal(f.d0), ""}},
                          {{"int F", text(f.F), "fraction bits of the cosine"},
                           {"int S", text(f.S), "fraction bits of the quotient"},
                           {"int K", text(f.K), "fraction bits of the constants below"},
                           {"int O", text(f.O), "fraction bits of the output"},
                           {"std::int64_t a", text(f.a), ""},
                           {"std::int64_t b", text(f.b), ""},
                           {"std::int64_t c1", text(f.c1), ""},
                           {"std::int64_t d0", text(f.d0), ""}});
    files.push_back(
        gappa_script("bps", profile, fmt::format("F, S, K, O: {}, {}, {}, {}", f.F, f.S, f.K, f.O), bps_gappa_body(f)));
    return files;
}

std::vector<HardCase> bps_hard_cases(const GoldenModel& model) {
    const int one = model.profile().one();
    const std::vector<std::string_view> everywhere{"exhaustive", "kernel", "oracle", "bound"};
    const std::vector<std::string_view> around_cut{"exhaustive", "kernel", "oracle", "bound", "sign-changes"};
    // The code whose Schlick fraction is nearest to s: c = n s / (1 + (n - 1) s).
    const auto at = [&](double s, int n) {
        return static_cast<std::int32_t>(std::lround(n * s / (1.0 + (n - 1) * s) * one));
    };
    // Walks from a code in steps until the result is (or is not) 0.
    const auto walk = [&](int n, std::int32_t code, int step, bool zero) {
        while (code > 0 && code < one && (model.eval(n, code) == 0) != zero) code += step;
        return code;
    };
    const std::int32_t middle = at(0.066, 50);  // the polynomial's minimum, -0.0094
    return {
        {"constant divisor", 1, one / 2, "D = 2^F whatever c: a divider that expects D > 2^F fails", everywhere},
        {"largest divisor", 1023, 0, "D = 1023 2^F needs all of its F + 10 bits", everywhere},
        {"c = 0", 50, 0, "quotient 0: the result is d0, the lobe's floor, and must not be taken for 0", everywhere},
        {"c = 1 ulp, n = 1", 1, 1, "least nonzero dividend", everywhere},
        {"c = 1 ulp, n = 1023", 1023, 1, "quotient 0 though c > 0", everywhere},
        {"c = 1 - 1 ulp, n = 1", 1, one - 1, "quotient next to 2^S", everywhere},
        {"c = 1 - 1 ulp, n = 1023", 1023, one - 1,
         "steepest place: one code of c moves the quotient by up to n 2^(S-F)", everywhere},
        {"c = 1", 1000, one, "quotient 2^S needs the bit S; the peak is 0.9927, not 1", everywhere},
        {"last result before the cut", 50, walk(50, middle, -1, false),
         "s near 0.0078: the polynomial turns negative; an unsigned result would wrap to almost 1", around_cut},
        {"deepest below 0", 50, middle, "s near 0.066: the sum is negative; max(0, .) has to see its sign", around_cut},
        {"first result after the cut", 50, walk(50, middle, 1, false), "s near 0.126: the polynomial turns positive",
         around_cut},
        {"largest h2",
         50,
         at(0.918, 50),
         "h2 reaches 1.001: one integer bit and a sign, not a fraction",
         {"exhaustive", "kernel", "oracle", "bound", "widths"}},
        {"n = 0", 0, one / 2, "(n - 1) would wrap to 1023; counts as 1", covered_illegal},
        {"c just above 1", 50, one + 1, "1 - c would be negative and D too small; counts as 1", covered_illegal},
        {"greatest code", 1023, 2 * one - 1, "as above, at the end of the port", covered_illegal},
        {"c just below 0", 50, -1, "would be a huge unsigned number; the result is 0", covered_illegal},
        {"least code", 1, -2 * one, "its negative does not fit the port", covered_illegal},
        {"n = 0 and c < 0", 0, -one, "two corrections at once: the result is 0, clamped once", covered_illegal},
    };
}

}  // namespace

Lobe bps_lobe() {
    return {"bps",
            "a s^3 + b s^2 + c1 s + d0, s = c / (n - n c + c)",
            "F,S,K,O",
            reference::bps_horner,
            make_plain<bps_format>,
            emit_bps,
            bps_hard_cases,
            bps_numbers,
            {},
            true};
}

}  // namespace glint
