#include "catch.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"

using namespace glint;

TEST_CASE("schlick: exactly 1 at c = 1, exactly c rounded at n = 1") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = find_lobe("schlick").golden(profile);
        for (int n = 1; n <= max_n; ++n) {
            if (model->eval(n, profile.one()) != 1U << profile.O) FAIL(profile.name << " n " << n);
        }
        const int cut = profile.F - profile.O;
        for (int C = 0; C <= profile.one(); ++C) {
            if (model->eval(1, C) != static_cast<std::uint32_t>((C + (1 << cut >> 1)) >> cut)) FAIL("C " << C);
        }
    }
    SUCCEED();
}
