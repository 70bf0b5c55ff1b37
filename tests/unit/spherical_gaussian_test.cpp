#include <cmath>

#include "glint/sweep.hpp"
#include "lobe_checks.hpp"

using namespace glint;

TEST_CASE("spherical_gaussian: exactly 1 at c = 1, never above, never falls with c, never rises with n") {
    check_peak(find_lobe("spherical_gaussian"));
    check_monotone_in_both(
        find_lobe("spherical_gaussian"));  // at other profiles the blocks are, at all inputs (exp_log_test.cpp)
    SUCCEED();
}

TEST_CASE("spherical_gaussian: at c = 0 still exp(-n - 0.775)") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("spherical_gaussian").golden(profile);
        for (int n = 1; n <= 20; ++n) {
            CHECK(std::abs(model->eval(n, 0) - std::ldexp(std::exp(-n - 0.775), profile.O)) < 1);
        }
        CHECK(model->eval(1, 0) > 0);
        CHECK(model->eval(1023, 0) == 0);
    }
}
