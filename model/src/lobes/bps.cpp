#include "glint/bps.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "glint/lanes.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"

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

struct Steps {
    std::int64_t D = 0, quotient = 0, h1 = 0, h2 = 0, y = 0;
};

/// The polynomial part: what follows the quotient.
void horner(const BpsFormat& f, Steps& x) {
    x.h1 = f.b + rnd(f.a * x.quotient, f.S);
    x.h2 = f.c1 + rnd(x.h1 * x.quotient, f.S);
    x.y = std::max<std::int64_t>(0, rnd(x.h2 * x.quotient + f.d0 * (std::int64_t{1} << f.S), f.S + f.K - f.O));
}

Steps steps(const BpsFormat& f, int n, std::int64_t C) {
    Steps x;
    const std::int64_t one = std::int64_t{1} << f.F;
    x.D = n * one - (n - 1) * C;
    x.quotient = (C << f.S) / x.D;  // both positive: / is the floor
    horner(f, x);
    return x;
}

/// The largest y over the quotients first..last, if above `known`; exact, by bisection. On a stretch where h1 and h2
/// do not change (h1 falls with the quotient and h2 at one h1 >= 0 rises, so equal ends mean equal throughout), y is
/// monotone and an end is the largest. Stretches that cannot exceed `known` are not opened: there, with h1 and h2
/// taken at whichever end is larger, y is bounded by max(h2) q + d0.
std::int64_t largest_output(const BpsFormat& f, std::int64_t first, std::int64_t last, std::int64_t known) {
    Steps low, high;
    low.quotient = first;
    high.quotient = last;
    horner(f, low);
    horner(f, high);
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

class Bps final : public GoldenModel {
public:
    Bps(const Profile& profile, const BpsFormat& format) : GoldenModel("bps", profile), f_(format) {}

    void reference(double n, std::span<const double> c, std::span<double> out) const override {
        reference::bps_batch(n, c, out);
    }

private:
    std::uint32_t value(int n, std::int32_t cosine) const override {
        return static_cast<std::uint32_t>(steps(f_, n, cosine).y);
    }

    std::vector<Intermediate> intermediates(int n, std::int32_t cosine) const override {
        const Steps x = steps(f_, n, cosine);
        return {{"C", cosine, f_.F}, {"D", x.D, f_.F},   {"quotient", x.quotient, f_.S},
                {"h1", x.h1, f_.K},  {"h2", x.h2, f_.K}, {"y", x.y, f_.O}};
    }

    void batch(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code,
               std::span<std::uint32_t> packed) const override {
        // Lanes of doubles hold every intermediate exactly while it has at most 52 bits; then nothing is rounded but
        // by the contract. Wider formats take the scalar form.
        if (f_.F + f_.S <= 50 && f_.K + f_.S <= 46) {
            batch_in_doubles(f_, n.data(), cos_code.data(), packed.data(), n.size());
            return;
        }
        for (std::size_t i = 0; i < n.size(); ++i) packed[i] = pack(eval_port(n[i], cos_code[i]));
    }

    /// The contract in doubles. Why each line gives the contract's bits, given the widths that batch() asks for:
    /// - Sums and products of integers below 2^52 are exact, and so is a scaling by a power of two.
    /// - C 2^S and D are exact, and their division rounds once, relatively by 2^-53 at most. A quotient that is not an
    ///   integer lies at least 1/D below the next integer k, relatively 1/(k D) > 1/(C 2^S + D) > 2^-52: rounding
    ///   never reaches k, so truncation is the floor.
    /// - rnd(x, k) is x 2^-k + 2^-(k+1) to the nearest integer, which has no ties left; and to add 1.5 2^52 to a number
    ///   below 2^51 in magnitude rounds it to the nearest integer, since doubles from 2^52 to 2^53 are the integers.
    GLINT_LANES static void batch_in_doubles(const BpsFormat& f, const std::uint16_t* n, const std::int32_t* cos_code,
                                             std::uint32_t* packed, std::size_t count) {
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
#pragma omp simd
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
            packed[i] = value | (below || above || none ? 0x8000'0000U : 0U);
        }
    }

    BpsFormat f_;
};

int in_range(std::string_view what, int value, int low, int high) {
    if (value < low || value > high) {
        throw Error(fmt::format("{} = {} is not legal for bps: {} to {}", what, value, low, high));
    }
    return value;
}

}  // namespace

BpsFormat bps_format(const Profile& profile) {
    BpsFormat f{.F = profile.F, .O = profile.O};
    if (profile.shipped()) {
        f.S = f.K = profile.O + 3;
    } else {
        if (profile.custom.size() != 4) {
            throw Error(fmt::format("profile '{}' is not legal for bps: four numbers F,S,K,O", profile.argument()));
        }
        in_range("F", f.F, 8, 30);
        in_range("O", f.O, 4, 28);
        f.S = in_range("S", profile.custom[1], f.O, 30);
        f.K = in_range("K", profile.custom[2], f.O, 30);
    }
    f.a = quantize_constant(reference::bps_constants.a, f.K);
    f.b = quantize_constant(reference::bps_constants.b, f.K);
    f.c1 = quantize_constant(reference::bps_constants.c1, f.K);
    f.d0 = quantize_constant(reference::bps_constants.d0, f.K);
    const std::int64_t top = largest_output(f, 0, std::int64_t{1} << f.S, 0);
    if (top > (std::int64_t{1} << f.O)) {
        throw Error(fmt::format("profile '{}' is not legal for bps: y reaches {}, above 2^O = {}; raise K",
                                profile.argument(), top, std::int64_t{1} << f.O));
    }
    return f;
}

Lobe bps_lobe();

Lobe bps_lobe() {
    return {"bps",
            "a s^3 + b s^2 + c1 s + d0, s = c / (n - n c + c)",
            "F,S,K,O",
            reference::bps_horner,
            make_bps,
            emit_bps,
            bps_hard_cases,
            {},
            true};
}

std::unique_ptr<GoldenModel> make_bps(const Profile& profile) {
    return std::make_unique<Bps>(profile, bps_format(profile));
}

}  // namespace glint
