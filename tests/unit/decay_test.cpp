#include <cmath>

#include "glint/sweep.hpp"
#include "lobe_checks.hpp"

using namespace glint;

TEST_CASE("decay: exactly 1 at c = 1 and nowhere else, 0 at c = 0, never falls with c") {
    check_peak(find_lobe("decay"));
    for (const char* text : {"p8", "p12", "p16", "16,4,8,8,4,1,4,0,9", "10,1,3,4,3,0,3,1,10", "9,2,8,9,7,4,4,0,9"}) {
        const Profile profile = parse_profile(text);
        const auto model = find_lobe("decay").golden(profile);
        const std::uint32_t top = 1U << profile.O;
        for (const int n : {1, 2, 3, 4, 5, 7, 8, 9, 31, 50, 255, 256, 511, 1000, 1023}) {
            std::uint32_t last = 0;
            for (int C = 0; C <= profile.one(); ++C) {
                const std::uint32_t y = model->eval(n, C);
                if (y < last || (y == top) != (C == profile.one())) FAIL(text << " n " << n << " C " << C);
                last = y;
            }
            CHECK(model->eval(n, 0) == 0);
        }
    }
}

TEST_CASE("decay: n = 1 is the cosine, cut") {
    const Profile p12 = parse_profile("p12");
    const auto model = find_lobe("decay").golden(p12);
    for (int C = 0; C <= p12.one(); ++C) {
        if (model->eval(1, C) != static_cast<std::uint32_t>(C >> (p12.F - p12.O))) FAIL("C " << C);
    }
}

TEST_CASE("decay: the table of n does not change a result") {
    const auto all = find_lobe("decay").golden(parse_profile("16,4,8,8,4,1,4,1,9"));
    const auto cut = find_lobe("decay").golden(parse_profile("16,4,8,8,4,1,4,0,9"));
    for (int n = 1; n <= max_n; ++n) {
        for (int C = 0; C <= 1 << 16; C += 7) {
            if (all->eval(n, C) != cut->eval(n, C)) FAIL("n " << n << " C " << C);
        }
    }
}

TEST_CASE("decay: the errors that docs/cost.md names, over every input") {
    struct Figure {
        const char* profile;
        double bound;
    };
    for (const Figure& f : {Figure{"16,4,8,8,4,1,4,0,9", 1.0 / 256}, Figure{"16,4,10,10,4,2,4,1,11", 1.0 / 1024}}) {
        const Profile profile = parse_profile(f.profile);
        const auto model = find_lobe("decay").golden(profile);
        const SweepResult result = sweep(*model, {1, max_n, 1}, {0, profile.one(), 1});
        CHECK(result.total.approximation.value < f.bound);
        CHECK(result.total.inputs == 1023U * 65537U);
    }
}

TEST_CASE("decay: each intermediate fits its width") {
    struct Format {
        std::string_view name;
        int E, M, V, fall_bits;
    };
    const std::vector<Format> formats{{"p8", 4, 8, 8, 10}, {"p12", 5, 12, 12, 14}, {"p16", 5, 16, 16, 18}};
    check_words(find_lobe("decay"), formats, [](const std::vector<Intermediate>& trace, const Format& f) {
        return unsigned_bits(value(trace, "octave"), f.E) && unsigned_bits(value(trace, "m"), f.M) &&
               unsigned_bits(value(trace, "w"), f.V + 3) && unsigned_bits(value(trace, "x"), f.V + f.E + 2) &&
               unsigned_bits(value(trace, "fall"), f.fall_bits);
    });
}
