#include <cmath>

#include "catch.hpp"
#include "glint/lobes.hpp"
#include "glint/sweep.hpp"

using namespace glint;

TEST_CASE("blinn_phong: exactly 1 at c = 1, never above, never falls with c, never rises with n") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("blinn_phong").golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
        }
    }
    // All inputs at p8; at the others the blocks are monotone at all inputs (exp_log_test.cpp).
    const Profile p8 = parse_profile("p8");
    const auto model = find_lobe("blinn_phong").golden(p8);
    std::vector<std::uint32_t> sharper(static_cast<std::size_t>(p8.one()) + 1);  // the results of n + 1
    for (int n = max_n; n >= 1; --n) {
        std::uint32_t before = 0;
        for (int C = 0; C <= p8.one(); ++C) {
            const std::uint32_t y = model->eval(n, C);
            std::uint32_t& narrow = sharper[static_cast<std::size_t>(C)];
            if (y < before || y < narrow || y > 1U << p8.O) FAIL("n " << n << " C " << C);
            before = y;
            narrow = y;
        }
    }
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
