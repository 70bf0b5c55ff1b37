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

TEST_CASE("shade is ambient and two tints of the sums of what is asked for") {
    struct Part {
        std::string_view name;
        bool diffuse;
    };
    const Part parts[] = {
        {"lambert", true}, {"phong", false},         {"blinn_phong", false},           {"oren_nayar", true},
        {"ward", false},   {"cook_torrance", false}, {"cook_torrance_modified", false}};
    for (const Profile& profile : shipped_profiles()) {
        CAPTURE(profile.name);
        const auto shade = find_effect("shade").golden(profile, "bps");
        const auto make = [&](std::string_view name) { return find_effect(name).golden(profile, "bps"); };
        const auto ambient = make("ambient");
        const auto tint = make("tint");
        const auto ports = shade->inputs();
        REQUIRE(ports[0].name == "effects");
        Random random(5);
        std::uint64_t wrong = 0, dark = 0, corrected = 0;
        for (int i = 0; i < 3000; ++i) {
            Values in;
            for (const EffectPort& port : ports) {
                in.push_back(i % 4 == 0 ? random.between(port.least(), port.greatest())
                                        : random.between(port.low, port.high));
            }
            const auto at = [&](const std::string& name) {
                for (std::size_t p = 0; p < ports.size(); ++p) {
                    if (ports[p].name == name) return in[p];
                }
                FAIL("no port " << name);
                return in[0];
            };
            const auto colour = [&](const std::string& k, const std::string& light) {
                return Values{at(k + "_r"),     at(k + "_g"),     at(k + "_b"),
                              at(light + "_r"), at(light + "_g"), at(light + "_b")};
            };
            const std::int64_t most = (std::int64_t{256} << profile.O) - 1;
            std::int64_t sums[2] = {0, 0};
            bool any[2] = {false, false}, clamped = false;
            for (std::size_t t = 0; t < std::size(parts); ++t) {
                if ((in[0] >> (t + 1) & 1) == 0) continue;
                const auto term = make(parts[t].name);
                Values own;
                for (const EffectPort& port : term->inputs()) {
                    const std::string name(port.name);
                    const bool parameter = port.kind == EffectPort::Kind::parameter && name != "n";
                    own.push_back(at(parameter ? std::string(parts[t].name) + "_" + name : name));
                }
                const EffectResult y = term->eval_port(own);
                const int kind = parts[t].diffuse ? 0 : 1;
                sums[kind] = std::min(most, sums[kind] + y.values[0]);
                any[kind] = true;
                clamped |= y.clamped;
            }
            Values want(3);
            if ((in[0] & 1) != 0) {
                const EffectResult base = ambient->eval_port(colour("ka", "ia"));
                want = base.values;
                clamped |= base.clamped;
            }
            for (int kind = 0; kind < 2; ++kind) {
                Values arguments = colour(kind == 0 ? "kd" : "ks", "i");
                arguments.insert(arguments.begin(), sums[kind]);
                const EffectResult part = tint->eval_port(arguments);
                for (std::size_t c = 0; c < 3; ++c) want[c] += part.values[c];
                clamped |= any[kind] && part.clamped;
            }
            for (std::int64_t& c : want) c = std::min(most, c);
            wrong += !(shade->eval_port(in) == EffectResult{want, clamped});
            dark += want == Values{0, 0, 0};
            corrected += clamped;
        }
        CHECK(wrong == 0);
        CHECK(dark < 2000);
        CHECK(corrected > 300);
        CHECK(corrected < 2700);
    }
}
