#include "smoothing.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

using namespace glint::render;

namespace {

/// A fan of triangles around vertex 0, up or down by `rise` at its rim.
struct Fan {
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::vector<Vec3> areas;

    Fan(std::uint32_t count, double rise) {
        const auto rim = [&](std::uint32_t i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            return Vec3{std::cos(angle), std::sin(angle), rise};
        };
        for (std::uint32_t i = 0; i < count; ++i) {
            faces.push_back({0, 1 + i, 1 + (i + 1) % count});
            areas.push_back(cross(rim(i), rim(i + 1)));
        }
    }
};

}  // namespace

TEST_CASE("smoothing: the work is linear in the faces around a vertex") {
    for (const std::uint32_t count : {1000U, 100000U}) {
        const Fan fan(count, -0.2);
        const Smoothing smoothing(fan.faces, fan.areas, count + 1);
        CHECK(smoothing.comparisons() < 400 * count);
        // A flat cone is smooth at its tip.
        for (std::size_t f = 0; f < count; f += 97) {
            CHECK(smoothing.normal(f, 0).z == Approx(1.0));
            CHECK(length(smoothing.normal(f, 1)) == Approx(1.0));
        }
    }
}

TEST_CASE("smoothing: many faces around a vertex give what few do") {
    // A steep cone: a face has only those within 60 degrees around it.
    const Fan many(6000, -2.0);
    const Fan few(60, -2.0);
    const Smoothing of_many(many.faces, many.areas, 6001);
    const Smoothing of_few(few.faces, few.areas, 61);
    for (std::size_t f = 0; f < 60; ++f) {
        CHECK(dot(of_many.normal(100 * f + 50, 0), of_few.normal(f, 0)) > std::cos(0.2));
    }
}
