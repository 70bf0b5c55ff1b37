#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "glint/error.hpp"
#include "glint/reference.hpp"
#include "lobe_checks.hpp"

using namespace glint;

namespace {

/// The shipped profiles, and the plain formula, whose `a` is not 0.
struct Words {
    std::string name;
    int F, a, S, O;
};

const std::vector<Words> formats{{"p8", 16, 0, 13, 8},
                                 {"p12", 18, 0, 17, 12},
                                 {"p16", 20, 0, 21, 16},
                                 {"18,2,17,12", 18, 2, 17, 12},
                                 {"18,4,17,12", 18, 4, 17, 12},
                                 {"18,8,17,12", 18, 8, 17, 12},
                                 {"18,16,18,12", 18, 16, 18, 12},
                                 {"18,32,19,12", 18, 32, 19, 12},
                                 {"26,0,30,28", 26, 0, 30, 28},
                                 {"30,32,26,20", 30, 32, 26, 20},
                                 {"8,0,4,4", 8, 0, 4, 4}};

/// Whether the intermediates of one input fit the words that the Verilog declares.
bool fits(const std::vector<Intermediate>& trace, const Words& f) {
    const auto& [name, F, a, S, O] = f;
    const int shift = a == 0 ? 4 : static_cast<int>(std::lround(std::log2(2 * a)));
    const auto within = [&](std::string_view what, int bits) { return unsigned_bits(value(trace, what), bits); };
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
    check_small_powers(find_lobe("cayley"));
    SUCCEED();
}

TEST_CASE(
    "cayley: every input of p8, and hard ones of other formats, is within its words, at most 1, and never falls") {
    check_words(find_lobe("cayley"), formats, fits);
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

TEST_CASE("cayley: the real function at its ends") { check_real_ends(find_lobe("cayley")); }

TEST_CASE("cayley: illegal formats are refused") {
    for (const std::string name :
         {"18,17,12", "18,1,17,12", "18,6,17,12", "18,64,17,12", "18,0,11,12", "30,0,27,12", "18,0,31,12"}) {
        CHECK_THROWS_AS(find_lobe("cayley").golden(parse_profile(name)), Error);
    }
}
