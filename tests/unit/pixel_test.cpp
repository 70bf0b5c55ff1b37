// What is special about the effect `pixel`: docs/effects/pixel.md.
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/vectors.hpp"

using namespace glint;

namespace {

using Values = std::vector<std::int64_t>;
using Vector = std::array<long double, 3>;

long double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// A pixel with random material and light, which asks for `effects`; its vectors are 0.
Values random_pixel(const EffectModel& model, std::int64_t effects, Random& random) {
    Values in;
    for (const EffectPort& port : model.inputs()) {
        in.push_back(port.kind == EffectPort::Kind::component ? 0 : random.between(port.low, port.high));
    }
    in[0] = effects;
    return in;
}

/// Places vector `v`: every length there is, or the unit vector nearest to a direction.
void set_vector(Values& in, std::size_t v, bool unit, Random& random) {
    Vector x{};
    while (dot(x, x) == 0) {
        const std::int64_t most = std::int64_t{1} << (random.between(0, 1) == 0 ? 15 : random.between(1, 15));
        for (long double& c : x) c = static_cast<long double>(random.between(-most, most - 1));
    }
    const long double scale = unit ? 32768 / std::sqrt(dot(x, x)) : 1;
    for (std::size_t c = 0; c < 3; ++c) {
        in[1 + 3 * v + c] = std::min<std::int64_t>(32767, std::llround(scale * x[c]));
    }
}

}  // namespace

TEST_CASE("frame: dot products are within the bounds of docs/effects/pixel.md") {
    // Ulp, beyond which nothing was seen: halves but for what doubles a half, and cosines.
    const std::map<std::string, long double> bounds{{"nl", 0.5L}, {"nv", 0.5L}, {"lv", 0.5L}, {"rv", 2.5001L},
                                                    {"nh", 1.0L}, {"vh", 0.5L}, {"ht", 1.0L}, {"hb", 1.0L}};
    for (const Profile& profile : shipped_profiles()) {
        CAPTURE(profile.name);
        const auto model = find_effect("pixel").golden(profile, "bps");
        const long double one = std::ldexp(1.0L, profile.F);
        Random random(3);
        std::map<std::string, long double> worst;
        std::uint64_t cut = 0;
        for (int i = 0; i < 20000; ++i) {
            Values in = random_pixel(*model, 0, random);
            for (std::size_t v = 0; v < 5; ++v) set_vector(in, v, i % 2 == 0, random);
            const auto at = [&](std::size_t v) {
                Vector out;
                for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<long double>(in[1 + 3 * v + c]) / 32768;
                return out;
            };
            const Vector l = at(0), v = at(1), n = at(2), t = at(3), b = at(4), h = l + v;
            const auto angle = [&](const Vector& a) {
                const long double square = dot(a, a) * dot(h, h);
                return square > 0 ? dot(a, h) / std::sqrt(square) : 0.0L;
            };
            const auto to_one = [](long double x) { return std::clamp(x, -1.0L, 1.0L); };
            const std::map<std::string, long double> real{
                {"nl", dot(n, l)}, {"nv", dot(n, v)},
                {"lv", dot(l, v)}, {"rv", 2 * to_one(dot(n, l)) * to_one(dot(n, v)) - to_one(dot(l, v))},
                {"nh", angle(n)},  {"vh", std::sqrt(dot(h, h)) / 2},
                {"ht", angle(t)},  {"hb", angle(b)}};
            for (const Intermediate& value : model->trace(in)) {
                const auto found = real.find(std::string(value.name));
                if (found == real.end()) continue;
                cut += std::abs(found->second) > 1;
                long double& w = worst[found->first];
                w = std::max(w, std::abs(static_cast<long double>(value.code) - to_one(found->second) * one));
            }
        }
        REQUIRE(worst.size() == bounds.size());
        for (const auto& [name, bound] : bounds) {
            CAPTURE(name);
            CHECK(worst[name] <= bound);
            CHECK(worst[name] > 0.3L);
        }
        CHECK(cut > 500);
    }
}

TEST_CASE("frame: c^1000 from L, V and N of 16 bits, in the highlight") {
    // Of real unit vectors, rounded to the ports; by nh and blinn_phong at p16, against c^n of the real vectors.
    const Profile profile = parse_profile("p16");
    const auto model = find_effect("pixel").golden(profile, "blinn_phong");
    const auto lobe = find_lobe("blinn_phong").golden(profile);
    Random random(5);
    const auto any = [&] {
        const auto uniform = [&] { return static_cast<long double>(random.next() >> 11) * 0x1p-53L - 0.5L; };
        return Vector{uniform(), uniform(), uniform()};
    };
    const auto scaled = [](const Vector& v, long double to) { return Vector{v[0] * to, v[1] * to, v[2] * to}; };
    const auto unit = [&](const Vector& v) { return scaled(v, 1 / std::sqrt(dot(v, v))); };
    Values in = random_pixel(*model, 0, random);
    long double worst = 0;
    for (int i = 0; i < 50000; ++i) {
        const Vector l = unit(any()), v = unit(any()), sum = l + v;
        if (dot(sum, sum) < 0.5L) continue;
        const Vector h = unit(sum), n = unit(h + scaled(any(), 0.15L));
        for (std::size_t c = 0; c < 3; ++c) {
            const auto code = [](long double x) { return std::min<std::int64_t>(32767, std::llround(32768 * x)); };
            in[1 + c] = code(l[c]);
            in[4 + c] = code(v[c]);
            in[7 + c] = code(n[c]);
        }
        for (const Intermediate& value : model->trace(in)) {
            if (value.name != "nh") continue;
            const auto y = lobe->eval(1000, static_cast<std::int32_t>(std::max<std::int64_t>(0, value.code)));
            worst = std::max(worst, std::abs(y / 65536.0L - std::pow(std::max(0.0L, dot(n, h)), 1000)));
        }
    }
    CAPTURE(worst);
    CHECK(worst > 0.0005L);
    CHECK(worst <= 0.003L);
}

TEST_CASE("pixel: a light after a light, through the ambient ports, is their sum, cut once") {
    const Profile profile = parse_profile("p12");
    const auto model = find_effect("pixel").golden(profile, "bps");
    const auto ports = model->inputs();
    const std::int64_t one = std::int64_t{1} << profile.O;
    const auto place = [&](std::string_view name) {
        for (std::size_t p = 0; p < ports.size(); ++p) {
            if (ports[p].name == name) return p;
        }
        throw Error("no such port");
    };
    const std::size_t ka = place("ka_r"), ia = place("ia_r"), kd = place("kd_r"), ks = place("ks_r"), i = place("i_r");
    Random random(4);
    std::uint64_t wrong = 0, cut = 0, grew = 0;
    for (int k = 0; k < 3000; ++k) {
        std::int64_t sum[3] = {0, 0, 0};
        Values so_far{0, 0, 0};
        for (int light = 0; light < 3; ++light) {
            Values in = random_pixel(*model, 2 + (random.between(0, 1) == 0 ? 8 : 4), random);
            for (std::size_t v = 0; v < 3; ++v) set_vector(in, v, true, random);
            for (std::size_t c = 0; c < 3; ++c) {
                in[kd + c] /= 4;
                in[ks + c] /= 8;
                in[i + c] /= 2;
            }
            const EffectResult alone = model->eval_port(in);
            in[0] |= 1;
            for (std::size_t c = 0; c < 3; ++c) {
                in[ka + c] = one;
                in[ia + c] = so_far[c];
            }
            const Values before = so_far;
            so_far = model->eval_port(in).values;
            grew += so_far != before;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += alone.values[c];
        }
        for (std::size_t c = 0; c < 3; ++c) {
            wrong += so_far[c] != std::min(one, sum[c]);
            cut += sum[c] > one;
        }
    }
    CHECK(wrong == 0);
    CHECK(cut > 20);
    CHECK(grew > 1000);
}

TEST_CASE("pixel: F at the ends of what is legal") {
    CHECK_NOTHROW(find_effect("pixel").golden(parse_profile("16,11,11,8"), "bps"));
    CHECK_THROWS_AS(find_effect("pixel").golden(parse_profile("15,11,11,8"), "bps"), Error);
    CHECK_THROWS_AS(find_effect("pixel").golden(parse_profile("30,11,11,8"), "bps"), Error);
}
