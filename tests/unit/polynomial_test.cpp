#include <algorithm>
#include <cmath>
#include <string>

#include "glint/error.hpp"
#include "glint/fixed_point.hpp"
#include "lobe_checks.hpp"

using namespace glint;

namespace {

struct Format {
    int F, S, K, O;
    std::int64_t k1, k2, k3;
};

/// The contract again, with the values that the Verilog and the kernel hold on the way.
struct Plain {
    std::int64_t numerator, scaled, D, quotient, sum_1, h1, sum_2, h2, sum_y, r, y;
};

Plain plain(const Format& f, int n, std::int64_t C) {
    Plain x{};
    const std::int64_t one = std::int64_t{1} << f.F;
    const std::int64_t unit = std::int64_t{1} << f.S;
    x.numerator = one + C;
    x.scaled = n * (one - C);
    x.D = x.numerator + 2 * x.scaled;
    x.quotient = x.numerator * unit / x.D;
    x.sum_1 = f.k3 * x.quotient + f.k2 * unit + unit / 2;
    x.h1 = x.sum_1 >> f.S;
    x.sum_2 = x.h1 * x.quotient + f.k1 * unit + unit / 2;
    x.h2 = x.sum_2 >> f.S;
    const int cut = f.S + f.K - f.O;
    x.sum_y = x.h2 * x.quotient + (std::int64_t{1} << (cut - 1));
    x.r = x.sum_y >> cut;
    x.y = std::min(std::int64_t{1} << f.O, std::max<std::int64_t>(0, x.r));
    return x;
}

/// The widths that rtl/lobes/glint_polynomial.v, rtl/blocks/glint_ratio.v and hls/lobes/glint_polynomial.hpp declare, I
/// = 2.
bool fits(const Format& f, const Plain& x) {
    const int h = f.K + 3, sum = h + f.S;
    return unsigned_bits(x.numerator, f.F + 2) && unsigned_bits(x.scaled, f.F + 10) && unsigned_bits(x.D, f.F + 11) &&
           x.D > 0 && unsigned_bits(x.quotient, f.S + 1) && x.quotient <= std::int64_t{1} << f.S &&
           signed_bits(f.k3 * x.quotient, sum) && signed_bits(x.sum_1, sum) && signed_bits(x.h1, h) &&
           signed_bits(x.h1 * x.quotient, sum) && signed_bits(x.sum_2, sum) && signed_bits(x.h2, h) &&
           signed_bits(x.h2 * x.quotient, sum) && signed_bits(x.sum_y, sum) && signed_bits(x.r, f.O + 3) &&
           unsigned_bits(x.y, f.O + 1);
}

Format format(const Profile& profile) {
    Format f{profile.F, profile.O + 3, profile.O + 3, profile.O, 0, 0, 0};
    if (!profile.shipped()) {
        f.S = profile.custom[1];
        f.K = profile.custom[2];
    }
    f.k1 = quantize_constant(-0.3444, f.K);
    f.k2 = quantize_constant(2.8786, f.K);
    f.k3 = quantize_constant(-1.5342, f.K);
    return f;
}

}  // namespace

TEST_CASE("polynomial: the contract and its widths at every input of p8, monotone above its minimum, 1 at c = 1") {
    const Profile profile = parse_profile("p8");
    const Format f = format(profile);
    const auto model = find_lobe("polynomial").golden(profile);
    std::int64_t cut = 0;
    for (int n = 1; n <= max_n; ++n) {
        std::uint32_t last = 0;
        for (int C = 0; C <= profile.one(); ++C) {
            const std::uint32_t y = model->eval(n, C);
            const Plain x = plain(f, n, C);
            if (y != x.y || y < last || !fits(f, x)) FAIL("n " << n << " C " << C);
            cut += x.r < 0 ? 1 : 0;
            last = y;
        }
        if (last != 1U << profile.O) FAIL("n " << n << ": y " << last << " at c = 1");
    }
    CHECK(cut > 0);
}

TEST_CASE("polynomial: every intermediate is the contract's, corners of many formats") {
    for (const std::string name : {"p8", "p12", "p16", "8,4,4,4", "30,30,30,28", "30,12,30,12", "16,30,9,8"}) {
        CAPTURE(name);
        const Profile profile = parse_profile(name);
        const Format f = format(profile);
        const auto model = find_lobe("polynomial").golden(profile);
        const std::int64_t one = profile.one();
        for (int n = 1; n <= max_n; ++n) {
            const std::int64_t zero = one - std::llround(std::ldexp(6.6 / n, profile.F));  // near the cut's end
            for (std::int64_t C : {std::int64_t{0}, std::int64_t{1}, zero, zero + 1, one / 2, one - 1, one}) {
                C = std::clamp<std::int64_t>(C, 0, one);
                const Plain x = plain(f, n, C);
                const auto trace = model->trace(n, C);
                const bool same = fits(f, x) && trace.size() == 7 && trace[1].code == x.D &&
                                  trace[2].code == x.quotient && trace[3].code == x.h1 && trace[4].code == x.h2 &&
                                  trace[5].code == x.r && trace[6].code == x.y && model->eval(n, C) == x.y;
                if (!same) FAIL("n " << n << " C " << C);
            }
        }
    }
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("polynomial").golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
        }
    }
    SUCCEED();
}

TEST_CASE("polynomial: profiles that are not legal") {
    const Lobe& lobe = find_lobe("polynomial");
    for (const char* name : {"18,12", "18,15,12", "18,11,15,12", "18,15,11,12", "18,31,15,12", "18,15,31,12"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(lobe.golden(parse_profile(name)), Error);
        CHECK_THROWS_AS(lobe.emit(parse_profile(name), default_architecture(lobe)), Error);
    }
}

TEST_CASE("polynomial: with the variable, the coefficients and the guard bits of bps it is bps, bit for bit") {
    const LobeChoice choice = parse_lobe("polynomial:schlick:0.002737:-0.374:2.995:-1.631");
    for (const Profile& profile : shipped_profiles()) {
        const auto model = choice.lobe->golden(choice.profile(profile.name));
        const auto bps = find_lobe("bps").golden(profile);
        const int step = profile.name == "p8" ? 1 : 997;
        std::size_t compared = 0;
        for (int n = 1; n <= max_n; ++n) {
            for (int C = profile.one(); C >= 0; C -= step) {
                if (model->eval(n, C) != bps->eval(n, C)) FAIL(profile.name << " n " << n << " C " << C);
                ++compared;
            }
        }
        CHECK(compared > 100000);
    }
}

TEST_CASE("polynomial: options name the files, and what makes no sense is refused") {
    const LobeChoice one = parse_lobe("polynomial:symmetric:0:-1:2");
    const LobeChoice other = parse_lobe("polynomial:symmetric:0:-1:2.5");
    CHECK(one.profile("p12").name != other.profile("p12").name);
    CHECK(one.profile("p12").argument() == "p12");
    CHECK(one.profile("18,14,14,12").argument() == "18,14,14,12");
    CHECK_THROWS_AS(parse_lobe("bps:symmetric:0:1:2"), Error);
    CHECK_THROWS_AS(parse_lobe("polynomial:"), Error);
    for (const char* text :
         {"phong:0:1:2", "symmetric", "symmetric:0:1", "symmetric:0:1:2:3:4:5:6:7", "symmetric:0:x:2", "symmetric:0::2",
          "symmetric:0:1:64", "symmetric:0:1:nan", "symmetric:0:1:2:"}) {
        CAPTURE(text);
        const LobeChoice choice = parse_lobe(std::string("polynomial:").append(text));
        CHECK_THROWS_AS(choice.lobe->golden(choice.profile("p12")), Error);
    }
}
