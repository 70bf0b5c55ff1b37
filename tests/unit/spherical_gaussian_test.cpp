#include <cmath>

#include "catch.hpp"
#include "glint/lobes.hpp"
#include "glint/sweep.hpp"

using namespace glint;

TEST_CASE("spherical_gaussian: exactly 1 at c = 1, never above, never falls with c, never rises with n") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("spherical_gaussian").golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
        }
    }
    // All inputs at p8; at the others the blocks are monotone at all inputs (exp_log_test.cpp).
    const Profile p8 = parse_profile("p8");
    const auto model = find_lobe("spherical_gaussian").golden(p8);
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
