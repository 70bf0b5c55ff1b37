#include <cmath>

#include "glint/sweep.hpp"
#include "lobe_checks.hpp"

using namespace glint;

TEST_CASE("gauss: exactly 1 at c = 1, never above, never falls with c, never rises with n") {
    check_peak(find_lobe("gauss"));
    check_monotone_in_both(find_lobe("gauss"));  // at other profiles the blocks are, at all inputs (exp_log_test.cpp)
    SUCCEED();
}

TEST_CASE("gauss: at c = 0 the end of the last piece, exp(-n pi^2 / 8)") {
    const double pi = std::acos(-1.0);
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("gauss").golden(profile);
        for (int n = 1; n <= 20; ++n) {
            const double real = std::ldexp(std::exp(-n * pi * pi / 8), profile.O);
            CHECK(std::abs(model->eval(n, 0) - real) < 1);
        }
        CHECK(model->eval(1, 0) > 0);
        CHECK(model->eval(1023, 0) == 0);
    }
}
