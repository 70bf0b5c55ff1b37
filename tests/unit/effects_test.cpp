// The plain effects: exact values (docs/effects/).
#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/vectors.hpp"

using namespace glint;

namespace {

using Values = std::vector<std::int64_t>;

EffectResult answer(std::string_view effect, std::string_view profile, const Values& in,
                    std::string_view lobe = "bps") {
    return find_effect(effect).golden(parse_profile(profile), lobe)->eval_port(in);
}

}  // namespace

TEST_CASE("lambert: every input of p8") {
    const auto model = find_effect("lambert").golden(parse_profile("p8"), "");
    std::uint64_t wrong = 0, inputs = 0;
    for (std::int64_t nl = -131072; nl <= 131071; ++nl) {
        const EffectResult result = model->eval_port(Values{nl});
        // Halves up: y is the largest with (2 y - 1) 2^(F - O - 1) <= nl.
        const std::int64_t cut = nl < 0 ? 0 : nl > 65536 ? 65536 : nl;
        const std::int64_t y = result.values.at(0);
        wrong += !((2 * y - 1) * 128 <= cut && cut < (2 * y + 1) * 128);
        wrong += result.clamped != (nl < -65536 || nl > 65536);
        ++inputs;
    }
    CHECK(wrong == 0);
    CHECK(inputs == 262144);
    CHECK(answer("lambert", "p12", {131072}) == EffectResult{{2048}, false});
    CHECK(answer("lambert", "12,12", {-1}) == EffectResult{{0}, false});
    CHECK(answer("lambert", "12,12", {4095}) == EffectResult{{4095}, false});
    CHECK_THROWS_AS(find_effect("lambert").golden(parse_profile("12,13"), ""), Error);
}

TEST_CASE("ambient: k i, rounded once") {
    CHECK(answer("ambient", "p12", {4096, 2048, 0, 4096, 3, 65535}) == EffectResult{{4096, 2, 0}, false});
    CHECK(answer("ambient", "p12", {4096, 4096, 4096, 65535, 65535, 65535}) ==
          EffectResult{{65535, 65535, 65535}, false});
    CHECK(answer("ambient", "p12", {4097, 8191, 4096, 65535, 1, 1}) == EffectResult{{65535, 1, 1}, true});
    CHECK(answer("ambient", "p8", {1, 127, 128, 128, 1, 1}) == EffectResult{{1, 0, 1}, false});
    CHECK_THROWS_AS(find_effect("ambient").golden(parse_profile("30,28"), ""), Error);
}

TEST_CASE("tint: k s i, rounded once, saturating") {
    CHECK(answer("tint", "p12", {4096, 4096, 2048, 0, 4096, 4096, 4096}) == EffectResult{{4096, 2048, 0}, false});
    const std::int64_t most = (1 << 20) - 1;
    CHECK(answer("tint", "p12", {most, 4096, 4096, 4096, 65535, 4096, 4097}) ==
          EffectResult{{most, most, most}, false});
    CHECK(answer("tint", "p12", {most, 4096, 4096, 8191, 4095, 1, 4096}) ==
          EffectResult{{most - 256, 256, most}, true});
    // Half of 1/2 ulp: rounding k s to 1 ulp first would give 1.
    CHECK(answer("tint", "p12", {1, 2048, 2048, 2048, 4096, 2048, 4095}) == EffectResult{{1, 0, 0}, false});
    CHECK_THROWS_AS(find_effect("tint").golden(parse_profile("30,17"), ""), Error);
}

TEST_CASE("phong and blinn_phong are the lobe in front of the surface, and 0 behind it") {
    for (const Lobe& lobe : lobes()) {
        const Profile profile = parse_profile("p12");
        const auto plain = lobe.golden(profile);
        for (const std::string_view name : {"phong", "blinn_phong"}) {
            CAPTURE(name, lobe.name);
            const auto model = find_effect(name).golden(profile, lobe.name);
            Random random(3);
            std::uint64_t wrong = 0, dark = 0;
            for (int i = 0; i < 5000; ++i) {
                const auto n = static_cast<int>(random.between(0, 1023));
                const std::int64_t cosine = random.between(-524288, 524287), nl = random.between(-524288, 524287);
                const EffectResult result = model->eval_port(Values{n, cosine, nl});
                wrong += result.values.at(0) != (nl > 0 ? plain->eval_port(n, cosine).y : 0);
                const auto outside = [](std::int64_t x) { return x < -262144 || x > 262144; };
                wrong += result.clamped != (n == 0 || outside(cosine) || outside(nl));
                dark += nl <= 0;
            }
            CHECK(wrong == 0);
            CHECK(dark > 1000);
        }
    }
    CHECK(answer("blinn_phong", "p12", {50, 256901, 1}) == EffectResult{{1448}, false});
    CHECK(answer("blinn_phong", "p12", {50, 256901, 0}) == EffectResult{{0}, false});
    CHECK(answer("phong", "p12", {50, -1, 262144}) == EffectResult{{0}, false});
    CHECK_THROWS_AS(find_effect("phong").golden(parse_profile("p12"), "nosuch"), Error);
    const auto with_options = find_effect("phong").golden(parse_profile("p12"), "polynomial:symmetric:0:0:3:-2");
    CHECK(with_options->profile().options == "symmetric:0:0:3:-2");
}
