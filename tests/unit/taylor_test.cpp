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

struct Words {
    std::string name;
    int F, log_a, E, S, O;
};

const std::vector<Words> formats{{"p8", 16, 4, 20, 14, 8},
                                 {"p12", 18, 4, 24, 18, 12},
                                 {"p16", 20, 4, 30, 22, 16},
                                 {"18,8,25,17,12", 18, 3, 25, 17, 12},
                                 {"18,32,25,19,12", 18, 5, 25, 19, 12},
                                 {"29,16,50,30,28", 29, 4, 50, 30, 28},
                                 {"8,16,16,10,4", 8, 4, 16, 10, 4}};

/// Whether the intermediates of one input fit the words that the Verilog declares.
bool fits(const std::vector<Intermediate>& trace, const Words& f) {
    const auto up_to = [&](std::string_view name, std::int64_t limit) {
        const std::int64_t x = value(trace, name);
        return x >= 0 && x <= limit;
    };
    const std::int64_t whole = std::int64_t{1} << f.S;
    const std::int64_t e_limit = (std::int64_t{13} << f.E) / 8;
    return up_to("e", e_limit) && up_to("x", (std::int64_t{1} << (f.E + 11)) - 1) && up_to("v", whole) &&
           up_to("r", whole) && up_to("r2", whole) && up_to("r4", whole) && up_to("y", std::int64_t{1} << f.O);
}

}  // namespace

TEST_CASE("taylor: exactly 1 at c = 1, exactly 0 in the tail") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("taylor").golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
            if (n >= 10 && model->eval(n, 0) != 0) FAIL(profile.name << " n " << n);
        }
        CHECK(value(model->trace(50, profile.one() / 2), "r") == 0);
        CHECK(model->eval(50, profile.one() / 2) == 0);
        CHECK(value(model->trace(7, 0), "r") > 0);
    }
}

TEST_CASE("taylor: n of 1 to 6 and 8 are powers of c, within their rounding") {
    check_small_powers(find_lobe("taylor"));
    SUCCEED();
}

TEST_CASE(
    "taylor: every input of p8, and hard ones of other formats, is within its words, at most 1, and never falls") {
    check_words(find_lobe("taylor"), formats, fits);
    SUCCEED();
}

TEST_CASE("taylor: at p16 the jump to 0 is at the real function's place, at every n") {
    // There it is 1 ulp: at another place the rounding error would be 1 ulp, not less.
    const Profile profile = parse_profile("p16");
    const auto model = find_lobe("taylor").golden(profile);
    const std::int64_t one = profile.one();
    for (int n = 7; n <= max_n; ++n) {
        if (n == 8) continue;
        // The least d with x >= 1, exactly: n (8 d 2^F + 5 d^2) >= 128 2^(2F). None for n = 7 and 9.
        std::int64_t low = 0;
        std::int64_t high = one + 1;
        while (low < high) {
            const std::int64_t d = (low + high) / 2;
            if (n * (8 * d * one + 5 * d * d) >= 128 * one * one) {
                high = d;
            } else {
                low = d + 1;
            }
        }
        if ((low == one + 1) != (n <= 9)) FAIL("n " << n);
        if (low <= one && model->eval(n, one - low) != 0) FAIL("n " << n << " d " << low);
        if (model->eval(n, one - low + 1) == 0) FAIL("n " << n << " d " << low - 1);
    }
    SUCCEED();
}

TEST_CASE("taylor: the real function at its ends") { check_real_ends(find_lobe("taylor")); }

TEST_CASE("taylor: illegal formats are refused") {
    for (const std::string name : {"18,17,12", "18,4,25,17,12", "18,64,25,17,12", "18,16,17,17,12", "18,16,37,17,12",
                                   "18,16,25,11,12", "30,16,40,17,12", "18,16,25,31,12"}) {
        CHECK_THROWS_AS(find_lobe("taylor").golden(parse_profile(name)), Error);
    }
}
