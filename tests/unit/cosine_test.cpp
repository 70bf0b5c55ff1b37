// The effect `cosine`: docs/effects/cosine.md.
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
using Real = std::array<double, 3>;

std::unique_ptr<EffectModel> model_at(std::string_view profile) {
    return find_effect("cosine").golden(parse_profile(profile), "");
}

std::int64_t cosine(const EffectModel& model, const Values& in) { return model.eval_port(in).values[0]; }

double dot(const Real& a, const Real& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Real unit(Real v) {
    const double length = std::sqrt(dot(v, v));
    for (double& x : v) x /= length;
    return v;
}

double uniform(Random& random) { return static_cast<double>(random.next() >> 11) * 0x1p-53; }

/// Any vector, of any length alike.
Values random_vector(int W, Random& random) {
    const std::int64_t bits = random.between(1, W);
    Values out;
    for (int i = 0; i < 3; ++i)
        out.push_back(random.between(-(std::int64_t{1} << (bits - 1)), (std::int64_t{1} << (bits - 1)) - 1));
    return out;
}

}  // namespace

TEST_CASE("cosine: parallel, opposite, perpendicular, at any lengths, at every W") {
    for (const std::string_view profile : {"p8", "p12", "p16", "8,8,8", "18,18,12", "29,17,4", "17,18,4"}) {
        CAPTURE(profile);
        const auto model = model_at(profile);
        const int W = model->inputs()[0].bits;
        const std::int64_t one = model->profile().one();
        Random random(1);
        std::uint64_t wrong = 0, inputs = 0;
        for (int i = 0; i < 100000; ++i) {
            const Values a = random_vector(W / 2, random);
            if (a == Values{0, 0, 0}) continue;
            const std::int64_t m = random.between(1, std::int64_t{1} << (W - W / 2)),
                               k = random.between(1, std::int64_t{1} << (W - W / 2));
            const Values x{m * a[0], m * a[1], m * a[2]}, y{k * a[0], k * a[1], k * a[2]};
            if (std::max({x[0], x[1], x[2], y[0], y[1], y[2]}) >= std::int64_t{1} << (W - 1)) continue;
            ++inputs;
            wrong += cosine(*model, {x[0], x[1], x[2], y[0], y[1], y[2]}) != one;
            // A vector across: (y, -x, 0) or, where that is 0, any in the plane.
            const Values across = a[0] == 0 && a[1] == 0 ? Values{1, -1, 0} : Values{-a[1], a[0], 0};
            wrong += cosine(*model, {x[0], x[1], x[2], across[0], across[1], across[2]}) != 0;
            if (std::min({y[0], y[1], y[2]}) == -(std::int64_t{1} << (W - 1))) continue;
            wrong += cosine(*model, {x[0], x[1], x[2], -y[0], -y[1], -y[2]}) != -one;
        }
        CHECK(wrong == 0);
        CHECK(inputs > 10000);
    }
}

TEST_CASE("cosine: within its bound, symmetric, its intermediates within their ranges") {
    for (const std::string_view profile : {"p8", "p12", "p16", "8,8,8", "18,18,12", "29,18,4"}) {
        CAPTURE(profile);
        const auto model = model_at(profile);
        const int W = model->inputs()[0].bits, F = model->profile().F;
        const std::int64_t one = model->profile().one(), top = std::int64_t{3} << (2 * W - 2);
        Random random(2);
        std::uint64_t wrong = 0, asymmetric = 0;
        double worst = 0;
        for (int i = 0; i < 200000; ++i) {
            Values in = random_vector(W, random);
            const Values b = random_vector(W, random);
            in.insert(in.end(), b.begin(), b.end());
            std::map<std::string, std::int64_t> x;
            for (const Intermediate& value : model->trace(in)) x[std::string(value.name)] = value.code;
            const EffectResult result = model->eval_port(in);
            if (x["aa"] == 0 || x["bb"] == 0) {
                wrong += !(result == EffectResult{{0}, true});
                continue;
            }
            wrong += result.clamped || x["r"] < one || x["r"] >= 4 * one || std::abs(x["c"]) > one || x["j"] < 0 ||
                     x["j"] >= W || std::abs(x["p"]) > top || x["aa"] > top || x["bb"] > top;
            std::vector<double> real;
            for (std::size_t p = 0; p < 6; ++p) real.push_back(model->inputs()[p].real(in[p]));
            const double t = std::ldexp(model->reference(real)[0], F);
            if (F <= 20) {  // a double is good enough
                const double error = std::abs(static_cast<double>(x["c"]) - t);
                worst = std::max(worst, error);
                wrong += !(error < 0.5 + std::ldexp(std::abs(t), -F - 1) + 1e-6);
            }
            asymmetric += cosine(*model, {in[3], in[4], in[5], in[0], in[1], in[2]}) != x["c"];
            if (std::min({in[0], in[1], in[2]}) > -(std::int64_t{1} << (W - 1))) {
                asymmetric += cosine(*model, {-in[0], -in[1], -in[2], in[3], in[4], in[5]}) != -x["c"];
            }
        }
        CHECK(wrong == 0);
        CHECK(asymmetric == 0);
        if (F <= 20) CHECK(worst > 0.6);  // the part of the root is there
    }
}

TEST_CASE("cosine: c^1000 from vectors of W bits, in the highlight") {
    // N, L and V of real numbers; the ports get N and the sum of the components that stand for L and V, cut to W bits.
    struct Expected {
        std::string_view profile;
        double least, most;
    };
    const auto lobe = find_lobe("blinn_phong").golden(parse_profile("p16"));
    for (const auto& [profile, least, most] :
         {Expected{"20,12,16", 0.01, 0.03}, Expected{"20,14,16", 0.003, 0.008}, Expected{"20,16,16", 0.001, 0.003}}) {
        CAPTURE(profile);
        const auto model = model_at(profile);
        const int W = model->inputs()[0].bits;
        const double scale = std::ldexp(1, W - 1) - 1;
        Random random(3);
        double worst = 0;
        for (int i = 0; i < 400000; ++i) {
            const auto any = [&] { return Real{uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5}; };
            const Real L = unit(any()), V = unit(any());
            const Real sum{L[0] + V[0], L[1] + V[1], L[2] + V[2]};
            if (dot(sum, sum) < 0.5) continue;
            const Real H = unit(sum), off = any();
            const Real N = unit({H[0] + 0.15 * off[0], H[1] + 0.15 * off[1], H[2] + 0.15 * off[2]});
            Values in;
            for (const double x : N) in.push_back(std::llround(x * scale));
            for (const double x : sum) in.push_back(std::llround(x / 2 * scale));  // below 1
            const std::int64_t code = std::max<std::int64_t>(0, cosine(*model, in));
            const double y = std::ldexp(static_cast<double>(lobe->eval(1000, static_cast<std::int32_t>(code))), -16);
            worst = std::max(worst, std::abs(y - std::pow(std::max(0.0, dot(N, H)), 1000)));
        }
        INFO("largest error " << worst);
        CHECK(worst > least);
        CHECK(worst <= most);
    }
}

TEST_CASE("cosine: word lengths that are not legal are refused") {
    for (const std::string_view profile : {"18,7,12", "18,19,12", "16,18,12", "30,16,12"}) {
        CAPTURE(profile);
        CHECK_THROWS_AS(model_at(profile), Error);
    }
    CHECK(model_at("18,15,15,12")->inputs()[0].bits == 16);  // a lobe's list
}
