#include <array>
#include <cmath>

#include <fmt/format.h>

#include "glint/decay_bounds.hpp"
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

TEST_CASE("decay: the bounds that its document calls proven") {
    struct Row {
        const char* profile;
        double ulp;
    };
    const Lobe& lobe = find_lobe("decay");
    for (const Row& row : {Row{"p8", 1.4361}, Row{"p12", 1.7726}, Row{"p16", 1.9302}}) {
        const Profile profile = parse_profile(row.profile);
        const double ulp = std::ldexp(lobe.error_bound(profile), profile.O);
        CHECK(std::ceil(ulp * 1e4) / 1e4 == row.ulp);
        CHECK(ulp < lobe.bound_ulp);
    }
}

TEST_CASE("decay: what is proven is not below what is measured over every input, nor far above it") {
    DecayBounds bounds;
    int formats = 0;
    for (const int F : {9, 10, 16}) {
        for (const auto& [A, M, V] :
             {std::array{1, 3, 5}, std::array{2, 6, 6}, std::array{3, 5, 9}, std::array{4, 8, 7}}) {
            for (const auto& [H, G, W] : {std::array{1, 0, 3}, std::array{3, 2, 4}, std::array{4, 1, 4}}) {
                const int O = F == 16 ? 8 : 7 + V % 3;
                const std::vector<int> numbers{F, A, M, V, H, G, W, 1, O};
                const Profile profile = parse_profile(fmt::format("{}", fmt::join(numbers, ",")));
                const Range n = F == 16 ? Range{1, max_n, 73} : Range{1, max_n, 1};
                const auto model = find_lobe("decay").golden(profile);
                const double measured = sweep(*model, n, {0, profile.one(), 1}).total.approximation.value;
                const double proven = bounds(numbers);
                INFO(profile.name << ": measured " << measured << ", proven " << proven);
                CHECK(proven == find_lobe("decay").error_bound(profile));
                CHECK(proven >= measured);
                CHECK(proven < 1.5 * measured);
                CHECK(bounds(numbers, measured / 2) >= measured / 2);  // it stops early, and says so
                ++formats;
            }
        }
    }
    CHECK(formats == 36);
    CHECK_THROWS_WITH(bounds({20, 6, 19, 16, 6, 2, 5, 1, 16}), "M of a proof = 19 is not legal for decay: 1 to 18");
}

TEST_CASE("decay: the shortest entries of fall fit their widths") {
    const Lobe& lobe = find_lobe("decay");
    for (int H = 1; H <= 8; ++H) {
        const Profile profile = parse_profile(fmt::format("16,1,3,9,{},0,4,1,{}", H, std::max(4, H + 3)));
        CHECK_FALSE(lobe.emit(profile, default_architecture(lobe)).empty());
    }
}
