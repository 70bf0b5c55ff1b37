#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"

using namespace glint;

namespace {

std::int64_t value(const std::vector<Intermediate>& trace, std::string_view name) {
    for (const Intermediate& i : trace) {
        if (i.name == name) return i.code;
    }
    FAIL("no intermediate " << name);
    return 0;
}

/// Whether the intermediates of one input fit the words that the Verilog declares; `a` as in a custom profile.
bool fits(const std::vector<Intermediate>& trace, int F, int a, int S, int O) {
    const int shift = a == 0 ? 4 : static_cast<int>(std::lround(std::log2(2 * a)));
    const auto within = [&](std::string_view name, int bits) {
        const std::int64_t x = value(trace, name);
        return x >= 0 && x < std::int64_t{1} << bits;
    };
    const std::int64_t m = value(trace, "m");
    const std::int64_t x = value(trace, "x");
    const std::int64_t num = value(trace, "num");
    const std::int64_t den = value(trace, "den");
    const std::int64_t whole = std::int64_t{1} << S;
    // The divisor's word is narrower than den may be, but not where num is above 0.
    return m >= -31 && m <= 1021 && x >= -(std::int64_t{1} << (F + 10)) && x < std::int64_t{1} << (F + 10) &&
           within("num", F + shift + 1) && den > 0 && num <= den &&
           (num == 0 || den < std::int64_t{1} << (F + shift + (a == 0 ? 2 : 1))) && value(trace, "r") <= whole &&
           value(trace, "r2") <= whole && value(trace, "r4") <= whole && within("y", O + 1) &&
           value(trace, "y") <= std::int64_t{1} << O;
}

}  // namespace

TEST_CASE("cayley: exactly 1 at c = 1, exactly 0 in the tail") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("cayley").golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
            if (model->eval(n, 0) != 0) FAIL(profile.name << " n " << n);
        }
        CHECK(value(model->trace(50, profile.one() / 2), "num") == 0);
        CHECK(model->eval(50, profile.one() / 2) == 0);
    }
}

TEST_CASE("cayley: n of 1 to 6 and 8 are powers of c, within their rounding") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("cayley").golden(profile);
        for (const int n : {1, 2, 3, 4, 5, 6, 8}) {
            const int step = std::max(1, profile.one() >> 16);
            for (int C = 0; C <= profile.one(); C += step) {
                const double power = std::pow(std::ldexp(C, -profile.F), n);
                if (!(std::abs(model->eval(n, C) - std::ldexp(power, profile.O)) < 1.0)) {
                    FAIL(profile.name << " n " << n << " C " << C);
                }
            }
        }
    }
    SUCCEED();
}

TEST_CASE("cayley: every p8 input is within its words, at most 1, and never falls when c grows") {
    const Profile profile = parse_profile("p8");
    const auto model = find_lobe("cayley").golden(profile);
    for (int n = 1; n <= max_n; ++n) {
        std::uint32_t last = 0;
        for (int C = 0; C <= profile.one(); ++C) {
            const std::uint32_t y = model->eval(n, C);
            if (y < last || y > 1U << profile.O) FAIL("n " << n << " C " << C);
            last = y;
            if (!fits(model->trace(n, C), profile.F, 0, profile.O + 5, profile.O)) FAIL("n " << n << " C " << C);
        }
    }
    SUCCEED();
}

TEST_CASE("cayley: words and monotonicity of the other profiles, the plain formula too") {
    struct Words {
        std::string name;
        int F, a, S, O;
    };
    const std::vector<Words> formats{{"p12", 18, 0, 17, 12},          {"p16", 20, 0, 21, 16},
                                     {"18,2,17,12", 18, 2, 17, 12},   {"18,4,17,12", 18, 4, 17, 12},
                                     {"18,8,17,12", 18, 8, 17, 12},   {"18,16,18,12", 18, 16, 18, 12},
                                     {"18,32,19,12", 18, 32, 19, 12}, {"26,0,30,28", 26, 0, 30, 28},
                                     {"30,32,26,20", 30, 32, 26, 20}, {"8,0,4,4", 8, 0, 4, 4}};
    for (const Words& f : formats) {
        const Profile profile = parse_profile(f.name);
        const auto model = find_lobe("cayley").golden(profile);
        const int step = std::max(1, profile.one() >> 11);
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 31, 32, 33, 50, 512, 1022, 1023}) {
            std::uint32_t last = 0;
            const auto next = [&](int C) {
                if (!fits(model->trace(n, C), f.F, f.a, f.S, f.O)) FAIL(f.name << " n " << n << " C " << C);
                const std::uint32_t y = model->eval(n, C);
                if (y < last) FAIL(f.name << " n " << n << " C " << C);
                last = y;
            };
            for (int C = 0; C < profile.one(); C += step) next(C);
            for (int C = profile.one() - std::min(step - 1, 64); C <= profile.one(); ++C) next(C);
        }
    }
    SUCCEED();
}

TEST_CASE("cayley: the figure that it is there for, within 0.0020 of c^n at every n up to 1000") {
    const auto model = find_lobe("cayley").golden(parse_profile("p12"));
    const int one = model->profile().one();
    double worst = 0.0;
    for (int n = 1; n <= 1000; ++n) {
        // Where the result is not yet or no longer flat: exponents of e from 0 to 16, 400 of them.
        for (int i = 0; i <= 400; ++i) {
            const auto C = static_cast<int>(std::lround(std::exp(-0.04 * i / n) * one));
            const double power = std::pow(std::ldexp(C, -model->profile().F), n);
            worst = std::max(worst, std::abs(std::ldexp(model->eval(n, C), -model->profile().O) - power));
        }
    }
    CHECK(worst < 0.0008);
    CHECK(worst > 0.0005);  // the approximation's own, so these inputs do meet it
}

TEST_CASE("cayley: the real function at its ends") {
    const auto& lobe = find_lobe("cayley");
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(lobe.reference(1.0, infinity) == 1.0);
    CHECK(lobe.reference(0.999, infinity) == 0.0);
    CHECK(lobe.reference(0.0, 1e308) == 0.0);
    CHECK(lobe.reference(0.5, 3.0) == 0.125);
    CHECK(lobe.reference(0.5, 8.0) == 0.00390625);
    CHECK(lobe.reference(-0.5, 8.0) == 0.0);
    CHECK(lobe.reference(2.0, 50.0) == 1.0);
}

TEST_CASE("cayley: illegal formats are refused") {
    for (const std::string name :
         {"18,17,12", "18,1,17,12", "18,6,17,12", "18,64,17,12", "18,0,11,12", "30,0,27,12", "18,0,31,12"}) {
        CHECK_THROWS_AS(find_lobe("cayley").golden(parse_profile(name)), Error);
    }
}
