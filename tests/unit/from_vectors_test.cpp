// The effects `bps_vectors` and `blinn_phong_vectors`: docs/effects/.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"
#include "glint/vectors.hpp"

using namespace glint;

namespace {

using Values = std::vector<std::int64_t>;

std::unique_ptr<EffectModel> model_at(std::string_view profile, std::string_view effect = "bps_vectors") {
    return find_effect(effect).golden(parse_profile(profile), "");
}

std::int64_t value(const EffectModel& model, const Values& in) { return model.eval_port(in).values[0]; }

/// 1 - c, without the difference of two numbers that are almost equal; of vectors whose angle is below 90 degrees.
double distance(const Values& v) {
    const auto at = [&](std::size_t i) { return static_cast<double>(v[i]); };
    const double x = at(1) * at(5) - at(2) * at(4), y = at(2) * at(3) - at(0) * at(5),
                 z = at(0) * at(4) - at(1) * at(3);
    const double p = at(0) * at(3) + at(1) * at(4) + at(2) * at(5);
    const double s = (at(0) * at(0) + at(1) * at(1) + at(2) * at(2)) * (at(3) * at(3) + at(4) * at(4) + at(5) * at(5));
    return (x * x + y * y + z * z) / (s + p * std::sqrt(s));
}

double f_bps(double q) {
    const auto& k = reference::bps_constants;
    return std::max(0.0, ((k.a * q + k.b) * q + k.c1) * q + k.d0);
}

/// A vector, its length at the end of a power of 16 or any, and another that makes with it an angle in the highlight.
Values in_highlight(Random& random) {
    Values in;
    const std::int64_t top = std::int64_t{1} << random.between(12, 15);
    for (int i = 0; i < 3; ++i) in.push_back(random.between(-top, top - 1));
    if (random.between(0, 1) == 0) in = {top == 32768 ? 16384 : top, random.between(-80, 80), random.between(-80, 80)};
    const std::int64_t n = random.between(0, 1) == 0 ? 1023 : random.between(1, 1023);
    double length = 0;
    for (const std::int64_t x : in) length += static_cast<double>(x * x);
    const auto most =
        static_cast<std::int64_t>(std::min(30000.0, std::sqrt(length / static_cast<double>(n)) * 1.3)) + 1;
    for (std::size_t i = 0; i < 3; ++i)
        in.push_back(std::clamp<std::int64_t>(in[i] + random.between(-most, most), -32768, 32767));
    in.push_back(n);
    return in;
}

/// The greatest errors in ulp: of an effect, and of the lobe behind `cosine`. `real` gets 1 - c and n.
template <class Real>
std::pair<double, double> greatest_errors(std::string_view effect, std::string_view lobe, const Profile& profile,
                                          Real&& real) {
    const auto model = find_effect(effect).golden(profile, ""), cosine = find_effect("cosine").golden(profile, "");
    const auto behind = find_lobe(lobe).golden(profile);
    Random random(3);
    double found = 0, by_cosine = 0;
    for (int i = 0; i < 400000; ++i) {
        const Values in = in_highlight(random);
        if (in[0] * in[3] + in[1] * in[4] + in[2] * in[5] <= 0) continue;
        const double exact = std::ldexp(real(distance(in), static_cast<double>(in[6])), profile.O);
        found = std::max(found, std::abs(static_cast<double>(value(*model, in)) - exact));
        const std::int64_t code = cosine->eval_port(std::span(in).first(6)).values[0];
        const std::uint32_t y = behind->eval(static_cast<int>(in[6]), static_cast<std::int32_t>(code));
        by_cosine = std::max(by_cosine, std::abs(static_cast<double>(y) - exact));
    }
    return {found, by_cosine};
}

}  // namespace

TEST_CASE("bps_vectors: parallel vectors have the peak, at any lengths and any n, at every W") {
    for (const std::string_view profile :
         {"p8", "p12", "p16", "8,8,16,8,8,8", "20,18,30,30,30,28", "18,9,20,12,12,8"}) {
        CAPTURE(profile);
        const auto model = model_at(profile);
        const int W = model->inputs()[0].bits;
        const std::int64_t peak = value(*model, {1, 0, 0, 1, 0, 0, 1});
        Random random(1);
        std::uint64_t wrong = 0;
        for (int i = 0; i < 50000; ++i) {
            const std::int64_t most = (std::int64_t{1} << (W / 2 - 1)) - 1;
            Values in;
            for (int k = 0; k < 3; ++k) in.push_back(random.between(-most, most));
            if (in[0] == 0 && in[1] == 0 && in[2] == 0) continue;
            const std::int64_t m = random.between(1, std::int64_t{1} << (W - W / 2));
            for (std::size_t k = 0; k < 3; ++k) in.push_back(m * in[k]);
            in.push_back(random.between(1, 1023));
            wrong += value(*model, in) != peak;
            for (std::size_t k = 3; k < 6; ++k) in[k] = -in[k];
            wrong += !(model->eval_port(in) == EffectResult{{0}, false});
        }
        CHECK(wrong == 0);
    }
    CHECK(value(*model_at("p16"), {1, 0, 0, 1, 0, 0, 1}) == 65060);  // that of bps
}

TEST_CASE("bps_vectors: intermediates within their ranges, a and b change places") {
    for (const std::string_view profile : {"p8", "p12", "p16", "8,8,16,8,8,8", "20,18,30,30,30,28"}) {
        CAPTURE(profile);
        const auto model = model_at(profile);
        const int W = model->inputs()[0].bits;
        Random random(2);
        std::uint64_t wrong = 0;
        for (int i = 0; i < 100000; ++i) {
            Values in;
            for (int k = 0; k < 2; ++k) {
                const std::int64_t top = std::int64_t{1} << random.between(0, W - 1);
                for (int axis = 0; axis < 3; ++axis) in.push_back(random.between(-top, top - 1));
            }
            in.push_back(random.between(0, 1023));
            std::map<std::string, std::int64_t> x;
            int R = 0, S = 0;
            for (const Intermediate& v : model->trace(in)) {
                x[std::string(v.name)] = v.code;
                if (v.name == "r") R = v.fraction_bits;
                if (v.name == "quotient") S = v.fraction_bits;
            }
            const bool none = x["aa"] == 0 || x["bb"] == 0;
            const EffectResult result = model->eval_port(in);
            wrong += result.clamped != (none || in[6] == 0) || result.values[0] != x["y"];
            if (none) {
                wrong += x["y"] != 0;
                continue;
            }
            wrong += x["r"] < std::int64_t{1} << (R - 2) || x["r"] >= std::int64_t{1} << R || x["x"] < 0 ||
                     x["x"] > x["r"] || x["D"] < 1 || x["D"] < x["C"] || x["D"] >= std::int64_t{1} << (R + 3) ||
                     x["quotient"] < 0 || x["quotient"] > std::int64_t{1} << S;
            wrong += value(*model, {in[3], in[4], in[5], in[0], in[1], in[2], in[6]}) != x["y"];
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("bps_vectors: the bound, and what is measured in the highlight") {
    struct Expected {
        std::string_view profile;
        double bound, measured, by_code;  ///< docs/effects/bps_vectors.md
    };
    for (const auto& [profile, bound, measured, by_code] :
         {Expected{"p8", 0.905, 0.814, 3.67}, Expected{"p12", 0.942, 0.790, 13.63},
          Expected{"p16", 0.982, 0.792, 54.19}}) {
        CAPTURE(profile);
        const Profile words = parse_profile(profile);
        const int O = words.O, S = O + 3, R = O + 14;
        const auto lobe = find_lobe("bps").golden(words);

        // The error of bps at each quotient, which n = 1 reaches, and the bound of the fraction times the slope.
        double worst = 0;
        const double n = 1023, v = std::ldexp(1, R - 2), least = v - n - 256;
        const auto& f = reference::bps_constants;
        for (std::int64_t k = 0; k <= std::int64_t{1} << S; ++k) {
            const double low = std::ldexp(static_cast<double>(k), -S);
            const double high = std::min(1.0, std::ldexp(static_cast<double>(k + 1), -S));
            const auto y = static_cast<double>(lobe->eval(1, static_cast<std::int32_t>(k << (words.F - S))));
            const double at =
                std::max(std::abs(y - std::ldexp(f_bps(low), O)), std::abs(y - std::ldexp(f_bps(high), O)));
            const double off =
                std::max(high * (n + 128), high * n + (1 - low) * 128) * (1 + (n - 1) * high) / (n * least);
            const auto slope = [&](double q) { return std::abs((3 * f.a * q + 2 * f.b) * q + f.c1); };
            // Within `off` the slope changes by less than 6 of it.
            worst = std::max(worst, at + std::ldexp((std::max(slope(low), slope(high)) + 6 * off) * off, O));
        }
        CHECK(std::ceil(worst * 1000) / 1000 == Approx(bound));

        const auto [found, by_cosine] = greatest_errors(
            "bps_vectors", "bps", words, [](double d, double n) { return f_bps((1 - d) / (1 - d + n * d)); });
        CHECK(found < bound);
        CHECK(found == Approx(measured).margin(0.0006));
        CHECK(by_cosine == Approx(by_code).margin(0.01));
    }
}

TEST_CASE("blinn_phong_vectors: the bound, and what is measured in the highlight") {
    struct Expected {
        std::string_view profile;
        double p_off, bound, measured, by_code;  ///< docs/exp-log.md; docs/effects/blinn_phong_vectors.md
    };
    for (const auto& [profile, p_off, bound, measured, by_code] :
         {Expected{"p8", 1.1292, 0.795, 0.603, 4.17}, Expected{"p12", 1.0049, 0.811, 0.651, 15.81},
          Expected{"p16", 1.5225, 0.891, 0.692, 61.34}}) {
        CAPTURE(profile);
        const Profile words = parse_profile(profile);
        const int O = words.O, L = O + 15, S = O + 4, T = O / 4 + 4;
        const double n = 1023, ln2 = std::log(2.0);
        const double e = 13.0 / 8 + std::ldexp(2.8854 / 124.7, L - 3 * T);
        const double x = n * (std::ldexp(1 / ln2, 2 - L) + std::ldexp(1.5 * e, -L));
        const double worst =
            0.5 + std::ldexp(p_off, O - S) + std::ldexp(ln2 * (x + std::ldexp(1, -S - 1)), O) * std::exp2(x);
        CHECK(std::ceil(worst * 1000) / 1000 == Approx(bound));

        const auto [found, by_cosine] =
            greatest_errors("blinn_phong_vectors", "blinn_phong", words,
                            [](double d, double exponent) { return std::exp(exponent * std::log1p(-d)); });
        CHECK(found < bound);
        CHECK(found == Approx(measured).margin(0.0006));
        CHECK(by_cosine == Approx(by_code).margin(0.01));
    }
}

TEST_CASE("blinn_phong_vectors: at most 1, little below it for parallel vectors, a and b change places") {
    for (const std::string_view profile : {"p8", "p12", "p16", "8,8,4,16,2,12,8", "20,18,8,31,4,31,28"}) {
        CAPTURE(profile);
        const auto model = model_at(profile, "blinn_phong_vectors");
        const int W = model->inputs()[0].bits, O = model->profile().O;
        Random random(4);
        std::uint64_t wrong = 0;
        for (int i = 0; i < 50000; ++i) {
            Values in;
            for (int k = 0; k < 2; ++k) {
                const std::int64_t top = std::int64_t{1} << random.between(0, W - 1);
                for (int axis = 0; axis < 3; ++axis) in.push_back(random.between(-top, top - 1));
            }
            in.push_back(random.between(0, 1023));
            const EffectResult result = model->eval_port(in);
            const bool none = (in[0] == 0 && in[1] == 0 && in[2] == 0) || (in[3] == 0 && in[4] == 0 && in[5] == 0);
            wrong += result.clamped != (none || in[6] == 0) || (none && result.values[0] != 0) ||
                     result.values[0] < 0 || result.values[0] > std::int64_t{1} << O;
            wrong += value(*model, {in[3], in[4], in[5], in[0], in[1], in[2], in[6]}) != result.values[0];
            if (none || !model->profile().shipped()) continue;
            wrong += value(*model, {in[0], in[1], in[2], in[0], in[1], in[2], in[6]}) < (std::int64_t{1} << O) - 1;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("bps_vectors, blinn_phong_vectors: word lengths that are not legal are refused") {
    for (const std::string_view profile : {"18,15,15,12", "18,7,26,15,15,12", "18,19,26,15,15,12", "18,16,15,15,15,12",
                                           "18,16,31,15,15,12", "18,16,26,11,15,12", "8,16,26,30,4,4"}) {
        CAPTURE(profile);
        CHECK_THROWS_AS(model_at(profile), Error);
    }
    for (const std::string_view profile : {"18,15,15,12", "18,7,7,27,3,16,12", "18,16,7,32,3,16,12",
                                           "18,16,7,27,3,12,12", "18,16,3,27,3,16,12", "18,16,7,27,1,16,12"}) {
        CAPTURE(profile);
        CHECK_THROWS_AS(model_at(profile, "blinn_phong_vectors"), Error);
    }
}
