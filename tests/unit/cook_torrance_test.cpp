// What is special about Cook-Torrance and its modified form: materials, the fit, symmetry, the error over materials.

#include "glint/cook_torrance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/vectors.hpp"

using namespace glint;
using namespace glint::cook_torrance;

namespace {

constexpr double pi = std::numbers::pi;

double uniform(Random& random) { return std::ldexp(static_cast<double>(random.next() >> 11), -53); }

std::vector<std::int64_t> codes(const EffectModel& model, const std::array<double, 4>& dots,
                                const std::vector<double>& material) {
    std::vector<std::int64_t> in;
    for (const double x : dots) in.push_back(model.inputs()[in.size()].code(x));
    for (const double x : material) in.push_back(model.inputs()[in.size()].code(x));
    return in;
}

std::vector<double> reals(const EffectModel& model, const std::vector<std::int64_t>& in) {
    std::vector<double> out;
    for (std::size_t p = 0; p < in.size(); ++p) out.push_back(model.inputs()[p].real(in[p]));
    return out;
}

struct Vector {
    double x, y, z;
};
double operator*(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector unit(Vector a) {
    const double length = std::sqrt(a * a);
    return {a.x / length, a.y / length, a.z / length};
}

/// Dot products of unit vectors above the surface, half of them near a mirror's, so that the highlight is hit.
std::array<double, 4> directions(Random& random) {
    const auto above = [&] {
        const double angle = 0.5 * pi * std::sqrt(uniform(random)), turn = 2.0 * pi * uniform(random);
        return Vector{std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)};
    };
    const Vector v = above();
    Vector l = above();
    if (random.next() % 2 == 0) {
        const double spread = uniform(random) * uniform(random);
        l = unit({-v.x + spread * (uniform(random) - 0.5), -v.y + spread * (uniform(random) - 0.5), v.z});
    }
    const Vector h = unit({l.x + v.x, l.y + v.y, l.z + v.z});
    return {l.z, v.z, h.z, v * h};
}

}  // namespace

TEST_CASE("Cook-Torrance: the distribution, the reflectance and the attenuation") {
    CHECK(beckmann(1.0, 0.05) == Approx(400.0));
    CHECK(beckmann(std::cos(0.3), 0.5) ==
          Approx(4.0 * std::exp(-std::pow(std::tan(0.3) / 0.5, 2)) / std::pow(std::cos(0.3), 4)));
    CHECK(beckmann(0.0, 1.0) == 0.0);
    CHECK(beckmann(-0.5, 1.0) == 0.0);
    CHECK(beckmann(1e-300, 1.0) == 0.0);
    // It is a density of projected area: its integral over the hemisphere with cos a is pi.
    for (const double m : {0.05, 0.3, 1.0}) {
        double sum = 0.0;
        constexpr int steps = 20000;
        for (int k = 0; k < steps; ++k) {
            const double angle = 0.5 * pi * (k + 0.5) / steps;
            sum += beckmann(std::cos(angle), m) * std::cos(angle) * std::sin(angle);
        }
        CHECK(sum * 2.0 * pi * 0.5 * pi / steps == Approx(pi).epsilon(1e-6));
    }

    CHECK(fresnel(1.0, 1.5) == Approx(0.04));
    CHECK(fresnel(0.0, 1.5) == Approx(1.0));
    CHECK(fresnel(1.0, 4.0) == Approx(0.36));
    CHECK(fresnel(0.0, 1.0) == 0.0);
    CHECK(fresnel(0.7, 1.0) == 0.0);
    for (const double eta : {1.001, 1.5, 4.0}) {
        for (double c = 0.0; c <= 1.0; c += 0.125) {
            // The paper's own form.
            const double g = std::sqrt(eta * eta + c * c - 1.0);
            const double first = std::pow((g - c) / (g + c), 2);
            const double second = std::pow((c * (g + c) - 1.0) / (c * (g - c) + 1.0), 2);
            CHECK(fresnel(c, eta) == Approx(0.5 * first * (1.0 + second)).epsilon(1e-9));
        }
    }

    CHECK(attenuation(1.0, 0.5, 1.0, 0.0) == 2.0);
    CHECK(attenuation(1.0, 0.5, 1.0, -1.0) == 2.0);
    CHECK(attenuation(0.5, 0.25, 0.5, 1.0) == Approx(2.0 * 0.5 * 0.25 / 1.0 / 0.25));
    CHECK(attenuation(0.125, 0.25, 0.5, 1.0) == Approx(2.0 * 0.5 * 0.125 / 1.0 / 0.25));
}

TEST_CASE("Cook-Torrance: the ports' function is F D G / (pi N.V)") {
    const auto model = find_effect("cook_torrance").golden(parse_profile("p12"), "");
    const auto modified = find_effect("cook_torrance_modified").golden(parse_profile("p12"), "");
    Random random(7);
    int compared = 0;
    for (int k = 0; k < 20000; ++k) {
        const double m = 0.05 * std::pow(20.0, uniform(random)), eta = 1.0 + 3.0 * uniform(random);
        const auto dots = directions(random);
        std::vector<double> in(dots.begin(), dots.end());
        for (const double x : parameters(m, eta)) in.push_back(x);
        const double expected = term(dots[0], dots[1], dots[2], dots[3], m, eta);
        if (expected > 255.0) continue;
        ++compared;
        CHECK(model->reference(in)[0] == Approx(expected).epsilon(1e-9).margin(1e-12));
        if (k % 400 != 0) continue;
        const Cubic cubic = fit_beckmann(m, Variable::half);
        std::vector<double> short_in(dots.begin(), dots.end());
        for (const double x : modified_parameters(m, eta)) short_in.push_back(x);
        CHECK(modified->reference(short_in)[0] ==
              Approx(modified_term(dots[0], dots[1], dots[2], dots[3], cubic, mean_fresnel(eta)))
                  .epsilon(1e-9)
                  .margin(1e-12));
    }
    CHECK(compared > 15000);
}

TEST_CASE("Cook-Torrance: materials that are not legal are refused") {
    for (const double m : {0.0499, 1.001, -1.0, std::nan("")}) {
        CHECK_THROWS_AS(parameters(m, 1.5), Error);
        CHECK_THROWS_AS(modified_parameters(m, 1.5), Error);
        CHECK_THROWS_AS(fit_beckmann(m, Variable::angle), Error);
    }
    for (const double eta : {0.999, 4.001, std::nan("")}) {
        CHECK_THROWS_AS(parameters(0.5, eta), Error);
        CHECK_THROWS_AS(modified_parameters(0.5, eta), Error);
        CHECK_THROWS_AS(mean_fresnel(eta), Error);
    }
}

TEST_CASE("Cook-Torrance: every legal material fits its ports") {
    for (const char* profile : {"p8", "p12", "p16"}) {
        for (const char* name : {"cook_torrance", "cook_torrance_modified"}) {
            const auto model = find_effect(name).golden(parse_profile(profile), "");
            for (const double m : {0.05, 0.06, 0.1, 0.2, 0.3, 0.5, 0.7, 0.85, 1.0}) {
                for (const double eta : {1.01, 1.33, 2.5, 4.0}) {
                    const auto material =
                        model->inputs().size() == 7 ? parameters(m, eta) : modified_parameters(m, eta);
                    for (std::size_t p = 0; p < material.size(); ++p) {
                        const EffectPort& port = model->inputs()[4 + p];
                        CHECK(std::abs(port.real(port.code(material[p])) - material[p]) <=
                              std::ldexp(0.5000001, -port.fraction_bits));
                    }
                }
            }
        }
    }
}

TEST_CASE("Cook-Torrance: an index of 1 reflects nothing") {
    Random random(3);
    for (const char* name : {"cook_torrance", "cook_torrance_modified"}) {
        const auto model = find_effect(name).golden(parse_profile("p12"), "");
        const auto material = model->inputs().size() == 7 ? parameters(0.05, 1.0) : modified_parameters(0.05, 1.0);
        for (int k = 0; k < 1000; ++k) {
            std::array<double, 4> dots = directions(random);
            if (k % 10 == 0) dots[3] = 0.0;
            const auto in = codes(*model, dots, material);
            const EffectResult result = model->eval_port(in);
            CHECK(result.values[0] == 0);
            CHECK_FALSE(result.clamped);
            CHECK(model->reference(reals(*model, in))[0] == 0.0);
        }
    }
}

TEST_CASE("Cook-Torrance: symmetric where N.L = N.V, and after N.V is taken out") {
    const auto model = find_effect("cook_torrance").golden(parse_profile("p16"), "");
    Random random(5);
    const auto material = parameters(0.4, 1.5);
    for (int k = 0; k < 2000; ++k) {
        const auto d = directions(random);
        std::vector<double> there(d.begin(), d.end()), back{d[1], d[0], d[2], d[3]};
        for (const double x : material) there.push_back(x), back.push_back(x);
        const double y = model->reference(there)[0], swapped = model->reference(back)[0];
        if (y > 200.0 || swapped > 200.0) continue;
        CHECK(y * d[1] == Approx(swapped * d[0]).epsilon(1e-9).margin(1e-12));
        // Of the integers: -log2 of the cosines enters as uv alone, beside what is symmetric.
        const auto a = model->trace(codes(*model, d, material)),
                   b = model->trace(codes(*model, {d[1], d[0], d[2], d[3]}, material));
        CHECK(a[7].code == b[8].code);
        CHECK(a[11].code == b[11].code);
    }
}

TEST_CASE("Cook-Torrance: the term falls to 0 at the edge of the surface and never from below") {
    for (const char* name : {"cook_torrance", "cook_torrance_modified"}) {
        const auto model = find_effect(name).golden(parse_profile("p12"), "");
        const auto material = model->inputs().size() == 7 ? parameters(0.3, 1.5) : modified_parameters(0.3, 1.5);
        for (const double nl : {-1.0, -1e-5, 0.0}) {
            CHECK(model->eval_port(codes(*model, {nl, 0.5, 0.9, 0.5}, material)).values[0] == 0);
            CHECK(model->eval_port(codes(*model, {0.5, nl, 0.9, 0.5}, material)).values[0] == 0);
            CHECK(model->eval_port(codes(*model, {0.5, 0.5, nl, 0.5}, material)).values[0] == 0);
        }
    }
    // Coefficients that make the cubic negative everywhere.
    const auto model = find_effect("cook_torrance_modified").golden(parse_profile("p12"), "");
    std::vector<std::int64_t> in = codes(*model, {1.0, 1.0, 0.9, 1.0}, {0.0, 1.0, -1.0, -1.0, -1.0, -1.0});
    CHECK(model->eval_port(in).values[0] == 0);
    CHECK(model->reference(reals(*model, in))[0] == 0.0);
    in = codes(*model, {1.0, 1.0, 1.0, 1.0}, {0.0, 1.0, 5.0, 0.0, 0.0, 0.0});
    CHECK(model->eval_port(in).values[0] == 2 << 12);
}

TEST_CASE("The cubic for the distribution") {
    for (const double m : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
        const Cubic angle = fit_beckmann(m, Variable::angle), half = fit_beckmann(m, Variable::half);
        for (const Cubic& cubic : {angle, half}) {
            const auto& c = cubic.coefficients;
            CHECK(c[0] + c[1] + c[2] + c[3] == Approx(0.0).margin(1e-12));
            for (const double x : c) CHECK(std::abs(x) < (cubic.variable == Variable::half ? 6.5 : 64.0));
            for (double nh = -1.0; nh <= 1.0; nh += 1.0 / 512) CHECK(cubic(nh) >= 0.0);
            CHECK(cubic(0.0) == 0.0);
            CHECK(cubic.error().largest < (m <= 0.7 ? 0.065 : 0.085));
        }
        // In N.H the error is a third of that in the angle for smooth surfaces.
        if (m <= 0.4) CHECK(half.error().largest < 0.45 * angle.error().largest);
    }
    // By roughness, as docs/effects/cook_torrance_modified.md says: in % of the peak.
    CHECK(fit_beckmann(0.05, Variable::half).error().largest == Approx(0.0203).epsilon(0.005));
    CHECK(fit_beckmann(0.3, Variable::half).error().largest == Approx(0.0077).epsilon(0.01));
    CHECK(fit_beckmann(0.05, Variable::angle).error().largest == Approx(0.0624).epsilon(0.005));
}

TEST_CASE("The constant for the reflectance") {
    CHECK(mean_fresnel(1.0) == 0.0);
    for (const double eta : {1.1, 1.5, 2.5, 4.0}) {
        double sum = 0.0;
        for (int k = 0; k < 6000; ++k) sum += fresnel(0.4 + 0.6 * (k + 0.5) / 6000, eta);
        CHECK(mean_fresnel(eta) == Approx(sum / 6000).epsilon(1e-6));
        CHECK(mean_fresnel(eta) >= fresnel(1.0, eta) * 0.99);
        CHECK(mean_fresnel(eta) <= fresnel(0.4, eta));
    }
}

// The figures of the documents: 10^6 materials and vectors, a third at each profile.
TEST_CASE("Cook-Torrance: error over materials") {
    for (const char* name : {"cook_torrance", "cook_torrance_modified"}) {
        const Effect& effect = find_effect(name);
        for (const char* profile : {"p8", "p12", "p16"}) {
            const auto model = effect.golden(parse_profile(profile), "");
            Random random(11);
            std::vector<std::vector<double>> materials;
            for (int k = 0; k < 100; ++k) {
                const double m = 0.05 * std::pow(20.0, uniform(random)),
                             eta = 1.0 + 3.0 * uniform(random) * uniform(random);
                materials.push_back(model->inputs().size() == 7 ? parameters(m, eta) : modified_parameters(m, eta));
            }
            double worst = 0.0;
            int lit = 0, saturated = 0;
            for (int k = 0; k < 333'334; ++k) {
                const auto in = codes(*model, directions(random), materials[random.next() % materials.size()]);
                const auto y = static_cast<double>(model->eval_port(in).values[0]);
                const std::vector<double> x = reals(*model, in);
                const double real = model->reference(x)[0];
                worst = std::max(worst, std::abs(y - std::ldexp(real, model->profile().O)) / model->bound_scale(x));
                lit += y > 0.0;
                saturated += real > 255.9;
            }
            INFO(name << ' ' << profile << ": " << worst << " ulp, " << lit << " lit, " << saturated << " saturated");
            CHECK(worst < 0.75);
            CHECK(worst > 0.5);
            CHECK(worst < effect.bound_ulp);
            CHECK(lit > 100'000);
        }
    }
}
