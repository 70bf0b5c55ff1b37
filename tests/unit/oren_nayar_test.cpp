// The effect `oren_nayar`: docs/effects/oren_nayar.md.
#include "glint/oren_nayar.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/vectors.hpp"

using namespace glint;

namespace {

using Values = std::vector<std::int64_t>;

std::unique_ptr<EffectModel> model_at(const Profile& profile) { return find_effect("oren_nayar").golden(profile, ""); }

/// Any legal dot products and parameters; every second time, small ones as often as large ones.
Values random_input(const EffectModel& model, Random& random) {
    Values in;
    const bool small = random.next() % 2 == 0;
    for (const EffectPort& port : model.inputs()) {
        const std::int64_t x = random.between(port.name == "lv" ? port.low : 0, port.high);
        in.push_back(small ? x >> random.between(0, port.bits - 2) : x);
    }
    return in;
}

double error_ulp(const EffectModel& model, const Values& in) {
    std::vector<double> arguments;
    for (std::size_t p = 0; p < in.size(); ++p) arguments.push_back(model.inputs()[p].real(in[p]));
    return std::abs(static_cast<double>(model.eval_port(in).values[0]) -
                    std::ldexp(model.reference(arguments)[0], model.profile().O));
}

}  // namespace

TEST_CASE("oren_nayar: parameters of a smooth, a rough and a roughest surface") {
    CHECK(oren_nayar_parameters(0).a == 1);
    CHECK(oren_nayar_parameters(0).b == 0);
    CHECK(oren_nayar_parameters(0.3).a == Approx(1 - 0.5 * 0.09 / 0.42));
    CHECK(oren_nayar_parameters(0.3).b == Approx(0.225));
    CHECK(oren_nayar_parameters(1e300).a == Approx(0.5));
    CHECK(oren_nayar_parameters(1e300).b == Approx(0.45));
    for (const double sigma : {-1e-9, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_AS(oren_nayar_parameters(sigma), Error);
    }
}

TEST_CASE("oren_nayar: the real function is that of the angles") {
    Random random(1);
    const auto uniform = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
    const auto model = model_at(parse_profile("p12"));
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double light = uniform() * 1.57, viewer = uniform() * 1.57, azimuth = uniform() * 2 * std::numbers::pi;
        const OrenNayarParameters p = oren_nayar_parameters(uniform() * 2);
        const double nl = std::cos(light), nv = std::cos(viewer);
        const double lv = nl * nv + std::sin(light) * std::sin(viewer) * std::cos(azimuth);
        const double wanted = nl * (p.a + p.b * std::max(0.0, std::cos(azimuth)) * std::sin(std::max(light, viewer)) *
                                              std::tan(std::min(light, viewer)));
        const double found = model->reference(std::array{nl, nv, lv, p.a, p.b})[0];
        worst = std::max(worst, std::abs(found - wanted));
        if (found > 1) FAIL("more light than there is at light " << light << " viewer " << viewer);
    }
    CHECK(worst < 1e-12);
    CHECK(worst > 0);
}

TEST_CASE("oren_nayar: a smooth surface is Lambert's, bit for bit") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = model_at(profile), lambert = find_effect("lambert").golden(profile, "");
        const std::int64_t smooth = std::int64_t{1} << (profile.O + 2);
        Random random(2);
        std::uint64_t wrong = 0;
        for (std::int64_t nl = -profile.one() - 2; nl <= profile.one() + 2; ++nl) {
            const std::int64_t nv = random.between(1, profile.one());
            const std::int64_t lv = random.between(-profile.one(), profile.one());
            wrong += model->eval_port(Values{nl, nv, lv, smooth, 0}) != lambert->eval_port(Values{nl});
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("oren_nayar: exact values") {
    const auto model = model_at(parse_profile("p12"));
    const std::int64_t one = 262144;
    const auto at = [&](const Values& in) { return model->eval_port(in).values[0]; };
    const auto y = [&](std::int64_t nl, std::int64_t nv, std::int64_t lv) { return at({nl, nv, lv, 14000, 4000}); };
    CHECK(y(one, one, one) == 3500);                             // A
    CHECK(y(one / 2, one, one / 2) == 1750);                     // V along N: A N.L
    CHECK(y(one, one / 2, one / 2) == 3500);                     // L along N: A
    CHECK(y(one / 2, one / 2, one) == 1750 + 750);               // q = 3/4, ratio 1
    CHECK(y(one / 4, one / 2, one / 8 + one / 2) == 875 + 250);  // q = 1/2, ratio 1/2
    CHECK(y(one / 2, one / 2, -one) == 1750);                    // q below 0
    CHECK(at({one, 1, one, 16384, 8192}) == 6144);               // 1.5: the greatest
    CHECK(y(one / 2, 0, one) == 0);
    CHECK(y(0, one / 2, one) == 0);
    CHECK(y(-1, one / 2, one) == 0);
    CHECK(y(one / 2, -one, one) == 0);
}

TEST_CASE("oren_nayar: within its bound, its intermediates within their ranges, monotone") {
    for (const Profile& profile : shipped_profiles()) {
        const auto model = model_at(profile);
        const std::int64_t unit = std::int64_t{1} << (profile.O + 2);
        Random random(3);
        double worst = 0, exact_ratio = 0;
        std::uint64_t outside = 0, falls = 0;
        for (int i = 0; i < 1000000; ++i) {
            Values in = random_input(*model, random);
            const double error = error_ulp(*model, in);
            worst = std::max(worst, error);
            if (in[0] >= in[1]) exact_ratio = std::max(exact_ratio, error);
            if (i % 8 != 0) continue;
            std::map<std::string, std::int64_t> x;
            for (const Intermediate& value : model->trace(in)) x[std::string(value.name)] = value.code;
            outside += x["q"] < 0 || x["q"] > unit || x["ratio"] < 0 || x["ratio"] > unit || x["p"] < 0 ||
                       x["p"] > x["q"] || x["y"] > (std::int64_t{3} << profile.O) / 2 ||
                       (x["nl"] < x["nv"] && x["ratio"] == unit);
            for (const std::size_t p : {std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
                Values more = in;
                if (++more[p] <= model->inputs()[p].high) falls += model->eval_port(more).values[0] < x["y"];
            }
        }
        CAPTURE(profile.name, worst, exact_ratio);
        CHECK(worst < 0.75);
        CHECK(worst > 0.6);  // the last bits of the bound are used
        CHECK(exact_ratio <= 0.5625);
        CHECK(outside == 0);
        CHECK(falls == 0);
    }
}

TEST_CASE("oren_nayar: as much light from L to V as from V to L") {
    // y / N.L is symmetric; a result is off by less than 3/4 ulp.
    for (const Profile& profile : shipped_profiles()) {
        const auto model = model_at(profile);
        Random random(4);
        double worst = 0;
        for (int i = 0; i < 100000; ++i) {
            const Values in = random_input(*model, random);
            const Values back{in[1], in[0], in[2], in[3], in[4]};
            const double there = static_cast<double>(model->eval_port(in).values[0]);
            const double here = static_cast<double>(model->eval_port(back).values[0]);
            const double nl = model->inputs()[0].real(in[0]), nv = model->inputs()[1].real(in[1]);
            worst = std::max(worst, std::abs(there * nv - here * nl) / std::max(nl + nv, 1e-9));
        }
        CHECK(worst < 0.75);
        CHECK(worst > 0);
    }
}

TEST_CASE("oren_nayar: profiles without room for its guard bits are refused") {
    CHECK_NOTHROW(model_at(parse_profile("8,5")));
    CHECK_THROWS_AS(model_at(parse_profile("8,6")), Error);
    CHECK_NOTHROW(model_at(parse_profile("30,27")));
    CHECK_THROWS_AS(model_at(parse_profile("30,28")), Error);
}
