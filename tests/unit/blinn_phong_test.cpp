#include <cmath>

#include "glint/sweep.hpp"
#include "lobe_checks.hpp"

using namespace glint;

TEST_CASE("blinn_phong: exactly 1 at c = 1, never above, never falls with c, never rises with n") {
    check_peak(find_lobe("blinn_phong"));
    check_monotone_in_both(
        find_lobe("blinn_phong"));  // at other profiles the blocks are, at all inputs (exp_log_test.cpp)
    SUCCEED();
}

TEST_CASE("blinn_phong: c itself at n = 1 but for a last place, c^n but for rounding, 0 at c = 0 and in the tail") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("blinn_phong").golden(profile);
        for (int C = 0; C <= profile.one(); ++C) {
            const double off = std::ldexp(C, profile.O - profile.F) - model->eval(1, C);
            if (!(std::abs(off) < 1)) FAIL(profile.name << " C " << C);
        }
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, 0) != 0) FAIL("n " << n);
        }
        CHECK(model->eval(profile.O + 2, profile.one() / 2) == 0);
        CHECK(model->eval(profile.O + 1, profile.one() / 2) == 1);  // a half of the last place rounds up
        for (int n = 1; n <= profile.O; ++n) CHECK(model->eval(n, profile.one() / 2) == 1U << (profile.O - n));
    }
    const Profile p8 = parse_profile("p8");
    const SweepResult all = sweep(*find_lobe("blinn_phong").golden(p8), {1, max_n, 1}, {0, p8.one(), 1}, 0);
    CHECK(all.total.rounding.value < 0.58);
    CHECK(std::ldexp(all.total.approximation.value, p8.O) < 0.58);
}
