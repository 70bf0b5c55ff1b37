#include <cmath>

#include "catch.hpp"
#include "glint/lobes.hpp"
#include "glint/sweep.hpp"

using namespace glint;

TEST_CASE("gauss: exactly 1 at c = 1, never above, never falls with c, never rises with n") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("gauss").golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
        }
    }
    // All inputs at p8; at the others the blocks are monotone at all inputs (exp_log_test.cpp).
    const Profile p8 = parse_profile("p8");
    const auto model = find_lobe("gauss").golden(p8);
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
