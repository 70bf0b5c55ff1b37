#include "glint/reference.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "catch.hpp"

using namespace glint;
namespace ref = glint::reference;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::nan("");
}  // namespace

TEST_CASE("f_b, f_s and f_bps at points worked out by hand") {
    CHECK(ref::blinn_phong(0.5, 3) == 0.125);
    CHECK(ref::blinn_phong(1, 1000) == 1);
    CHECK(ref::schlick(0.5, 1) == Approx(0.5).epsilon(1e-15));
    CHECK(ref::schlick(0.5, 3) == Approx(0.25).epsilon(1e-15));
    // s = 1/4: -1.631/64 + 2.995/16 - 0.374/4 + 0.002737
    CHECK(ref::bps(0.5, 3) == Approx(0.070940125).epsilon(1e-14));
    CHECK(ref::bps(1, 50) == Approx(0.992737).epsilon(1e-14));
    CHECK(ref::bps(0, 50) == Approx(2.737e-3).epsilon(1e-14));
}

TEST_CASE("the printed form and Horner's are one function") {
    std::vector<double> c, batch;
    for (int i = 0; i <= 4096; ++i) c.push_back(i / 4096.0);
    batch.resize(c.size());
    for (const double n : {1.0, 2.0, 8.0, 50.0, 333.3, 1000.0, 1023.0}) {
        ref::bps_batch(n, c, batch);
        for (std::size_t i = 0; i < c.size(); ++i) {
            if (std::abs(ref::bps(c[i], n) - ref::bps_horner(c[i], n)) > 2e-15)
                FAIL("printed: c " << c[i] << " n " << n);
            if (std::abs(batch[i] - ref::bps_horner(c[i], n)) > 2e-15) FAIL("batch: c " << c[i] << " n " << n);
        }
    }
    SUCCEED();
}

TEST_CASE("f_bps is cut to 0 between its sign changes and nowhere else") {
    // Signs of the polynomial: + below s = 0.0078.., - up to 0.1263.., + above. s = c at n = 1.
    CHECK(ref::bps(0.00780, 1) > 0);
    CHECK(ref::bps(0.00781, 1) == 0);
    CHECK(ref::bps(0.12633, 1) == 0);
    CHECK(ref::bps(0.12634, 1) > 0);
}

TEST_CASE("arguments outside the domain have the documented answers") {
    for (const auto f : {ref::blinn_phong, ref::schlick, ref::bps, ref::bps_horner}) {
        CHECK(std::isnan(f(nan_value, 50)));
        CHECK(std::isnan(f(0.5, nan_value)));
        CHECK(f(-0.1, 50) == 0);
        CHECK(f(-infinity, 50) == 0);
        CHECK(f(1.5, 50) == f(1, 50));
        CHECK(f(infinity, 50) == f(1, 50));
        CHECK(f(0.7, 0) == f(0.7, 1));
        CHECK(f(0.7, -3) == f(0.7, 1));
        CHECK(f(0.7, -infinity) == f(0.7, 1));
        CHECK(f(1, infinity) == f(1, 50));      // the limit at c = 1
        CHECK(f(0.7, infinity) == f(0, 50));    // and below it
        CHECK(std::isfinite(f(0.999, 1e308)));  // huge n
        CHECK(f(0.5, 1e308) == Approx(f(0, 50)).margin(1e-12));
        CHECK(std::isfinite(f(1e-308, 1)));
    }
}

TEST_CASE("angles") {
    const ref::Vector n{0, 0, 1};
    const ref::Vector l{0.6, 0, 0.8};
    const ref::Vector mirrored{-0.6, 0, 0.8};
    CHECK(ref::cos_blinn(n, l, mirrored) == Approx(1).epsilon(1e-15));
    CHECK(ref::cos_phong(n, l, mirrored) == Approx(1).epsilon(1e-15));
    // Viewer at the light: half vector is L, mirror direction is not.
    CHECK(ref::cos_blinn(n, l, l) == Approx(0.8).epsilon(1e-15));
    CHECK(ref::cos_phong(n, l, l) == Approx(0.28).epsilon(1e-14));
    // Lengths do not matter, huge or tiny.
    CHECK(ref::cos_blinn({0, 0, 1e300}, {6e-310, 0, 8e-310}, {-6e200, 0, 8e200}) == Approx(1).epsilon(1e-12));
    // No direction, no angle.
    CHECK(std::isnan(ref::cos_blinn({0, 0, 0}, l, l)));
    CHECK(std::isnan(ref::cos_blinn(n, l, {-0.6, 0, -0.8})));
    CHECK(std::isnan(ref::cos_phong(n, {0, 0, 0}, l)));
    CHECK(std::isnan(ref::cos_phong(n, l, {infinity, 0, 0})));
    CHECK(ref::cos_phong(n, l, {-0.6, 0, -0.8}) == Approx(-0.28).epsilon(1e-14));
}

TEST_CASE("the epicentre ends at the inflection point of cos^n") {
    for (const double n : {2.0, 8.0, 50.0, 1000.0}) {
        const double theta = std::acos(ref::epicentre_cosine(n));
        CHECK(std::tan(theta) * std::tan(theta) == Approx(1 / (n - 1)).epsilon(1e-9));
        const auto f = [&](double t) { return std::pow(std::cos(t), n); };
        const double h = 1e-4 / std::sqrt(n);
        CHECK(std::abs(f(theta + h) - 2 * f(theta) + f(theta - h)) / (h * h) < 1e-2 * n);
    }
    CHECK(ref::epicentre_cosine(1) == 0);
}
