#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "glint/error.hpp"
#include "glint/sweep.hpp"
#include "lobe_checks.hpp"

using namespace glint;

namespace {

struct Format {
    int F, log2_a, S, O;
};

/// The contract again, with the values that the Verilog and the kernel hold on the way: the base before it is rounded
/// and cut, the squares before they are.
struct Plain {
    std::int64_t product = 0, offset_base = 0, base = 0;
    std::vector<std::int64_t> p, sums;
    std::int64_t y = 0;
};

void plain(const Format& f, int n, std::int64_t C, Plain& x) {
    const std::int64_t one = std::int64_t{1} << f.F;
    const int cut = f.F + f.log2_a - f.S;
    const std::int64_t half = (std::int64_t{1} << cut) >> 1;
    x.product = n * (one - C);
    x.offset_base = (one << f.log2_a) + half - x.product;
    x.base = std::max<std::int64_t>(0, (one << f.log2_a) - x.product);
    x.p = {(x.base + half) >> cut};
    x.sums.clear();
    for (int i = 1; i <= f.log2_a; ++i) {
        const int drop = i < f.log2_a ? f.S : 2 * f.S - f.O;
        x.sums.push_back(x.p.back() * x.p.back() + (std::int64_t{1} << (drop - 1)));
        x.p.push_back(x.sums.back() >> drop);
    }
    x.y = x.p.back();
    x.p.pop_back();
}

/// The widths that rtl/lobes/glint_cosine_power.v and hls/lobes/glint_cosine_power.hpp declare.
bool fits(const Format& f, const Plain& x) {
    const auto power = [&](std::int64_t p) { return unsigned_bits(p, f.S + 1) && p <= std::int64_t{1} << f.S; };
    const auto sum = [&](std::int64_t s) { return unsigned_bits(s, 2 * f.S + 1); };
    return unsigned_bits(x.product, f.F + 10) && signed_bits(x.offset_base, f.F + 11) &&
           std::all_of(x.p.begin(), x.p.end(), power) && std::all_of(x.sums.begin(), x.sums.end(), sum) &&
           unsigned_bits(x.y, f.O + 1) && x.y <= std::int64_t{1} << f.O;
}

}  // namespace

TEST_CASE("cosine_power: the contract and its widths at every input of p8, monotone, 1 at c = 1, 0 in the tail") {
    const Profile profile = parse_profile("p8");
    const Format f{16, 3, 12, 8};
    const auto model = find_lobe("cosine_power").golden(profile);
    Plain x;
    std::int64_t zeros = 0;
    for (int n = 1; n <= max_n; ++n) {
        std::uint32_t last = 0;
        for (int C = 0; C <= profile.one(); ++C) {
            const std::uint32_t y = model->eval(n, C);
            plain(f, n, C, x);
            if (y != x.y || y < last || !fits(f, x)) FAIL("n " << n << " C " << C);
            if (x.base == 0) {
                ++zeros;
                if (y != 0) FAIL("n " << n << " C " << C << ": the base is 0, the result " << y);
            }
            last = y;
        }
        if (last != 1U << profile.O) FAIL("n " << n << ": y " << last << " at c = 1");
    }
    CHECK(zeros > 0);
}

TEST_CASE("cosine_power: every intermediate is the contract's, corners of many formats") {
    for (const std::string name : {"p8", "p12", "p16", "8,2,8,4", "8,64,14,14", "30,64,30,28", "30,2,30,4",
                                   "18,4,20,12", "20,16,21,16", "16,32,18,8"}) {
        CAPTURE(name);
        const Profile profile = parse_profile(name);
        Format f{profile.F, 3, profile.O + 4, profile.O};
        if (!profile.shipped()) {
            f.log2_a = static_cast<int>(std::lround(std::log2(profile.custom[1])));
            f.S = profile.custom[2];
        }
        const auto model = find_lobe("cosine_power").golden(profile);
        const std::int64_t one = profile.one();
        Plain x;
        for (int n = 1; n <= max_n; ++n) {
            const std::int64_t cut = std::max<std::int64_t>(0, one - (one << f.log2_a) / n);
            for (std::int64_t C : {std::int64_t{0}, std::int64_t{1}, cut - 1, cut, cut + 1, one / 2, one - 1, one}) {
                C = std::clamp<std::int64_t>(C, 0, one);
                plain(f, n, C, x);
                const auto trace = model->trace(n, C);
                bool same = fits(f, x) && trace.size() == x.p.size() + 3 && trace[0].code == C &&
                            trace[1].code == x.base && trace.back().code == x.y && model->eval(n, C) == x.y;
                for (std::size_t i = 0; same && i < x.p.size(); ++i) {
                    same = trace[i + 2].code == x.p[i] &&
                           trace[i + 2].name == std::string("p").append(std::to_string(1 << i));
                }
                if (!same) FAIL("n " << n << " C " << C);
            }
            if (model->eval(n, one) != 1U << profile.O) FAIL("n " << n << " at c = 1");
        }
    }
    SUCCEED();
}

TEST_CASE("cosine_power: S = O + 1 + log2 a keeps the rounding error below 1 ulp for every a") {
    for (int log2_a = 1; log2_a <= 6; ++log2_a) {
        const Profile profile =
            parse_profile("16," + std::to_string(1 << log2_a) + "," + std::to_string(9 + log2_a) + ",8");
        const auto model = find_lobe("cosine_power").golden(profile);
        const double worst = sweep(*model, {1, max_n, 31}, {0, profile.one(), 1}).total.rounding.value;
        CAPTURE(profile.name);
        CHECK(worst > 0.5);
        CHECK(worst < 1.0 - std::ldexp(1.0, -log2_a - 1));
    }
}

TEST_CASE("cosine_power: c^n where n = a, the base ends above 0 below a") {
    // 12,4,14,8: the base has 14 bits, as the powers; c^4 is off by the second square's rounding only.
    const auto model = find_lobe("cosine_power").golden(parse_profile("12,4,14,8"));
    for (int C = 0; C <= 1 << 12; ++C) {
        const double exact = std::pow(std::ldexp(C, -12), 4) * 256;
        if (!(std::abs(model->eval(4, C) - exact) <= 0.5 + std::ldexp(1.0, -6))) FAIL("C " << C);
    }
    // One n below a the base ends above 0, at 1/a; from n = a on it ends at 0.
    const auto p12 = find_lobe("cosine_power").golden(parse_profile("p12"));
    CHECK(p12->trace(7, 0)[1].code == 1 << 18);
    CHECK(p12->trace(8, 0)[1].code == 0);
    CHECK(p12->trace(8, 1)[1].code == 8);
    CHECK(p12->trace(9, 0)[1].code == 0);
    CHECK(p12->eval(1, 0) == 1407);  // (7/8)^8 = 0.3436: small exponents keep a floor
}

TEST_CASE("cosine_power: profiles that are not legal") {
    const Lobe& lobe = find_lobe("cosine_power");
    for (const char* name : {"18,12", "18,8,12", "18,3,16,12", "18,1,16,12", "18,0,16,12", "18,96,16,12", "18,8,11,12",
                             "18,8,22,12", "8,2,9,10", "30,8,31,28", "18,8,16,16,12"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(lobe.golden(parse_profile(name)), Error);
        CHECK_THROWS_AS(lobe.emit(parse_profile(name), default_architecture(lobe)), Error);
    }
    for (const char* name : {"8,2,9,9", "8,64,14,14", "18,8,21,12", "30,8,30,28"}) {
        CAPTURE(name);
        CHECK_NOTHROW(lobe.golden(parse_profile(name)));
    }
}
