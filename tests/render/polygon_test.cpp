// Generated outlines of every kind, in every plane and direction: the triangles cover the polygon, once.
#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "catch.hpp"

using namespace glint::render;

namespace {

using Flat = std::array<double, 2>;
using Outline = std::vector<Flat>;
using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) / static_cast<double>(1ULL << 53U);
}

/// Twice the area, with a sign.
double area(const Outline& outline) {
    double out = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Flat& a = outline[i];
        const Flat& b = outline[(i + 1) % outline.size()];
        out += a[0] * b[1] - a[1] * b[0];
    }
    return out;
}

Outline star(Random& random, std::size_t corners) {
    Outline out;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        const double radius = between(random, 0.2, 2.0);
        out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return out;
}

Outline comb(Random& random, std::size_t teeth) {
    Outline out{{static_cast<double>(2 * teeth), -1.0}};
    for (std::size_t i = teeth; i-- > 0;) {
        const double x = static_cast<double>(2 * i);
        out.push_back({x + 2.0, between(random, 1.0, 3.0)});
        out.push_back({x + 1.0, between(random, -0.5, 0.5)});
    }
    out.push_back({0.0, 2.0});
    out.push_back({0.0, -1.0});
    return out;
}

Outline spiral(Random&, std::size_t turns) {
    Outline out;
    const std::size_t steps = 6 * turns;
    for (const double side : {0.0, 0.5}) {
        Outline arm;
        for (std::size_t i = 0; i <= steps; ++i) {
            const double angle = std::numbers::pi / 3.0 * static_cast<double>(i);
            const double radius = 1.0 + side + angle / std::numbers::pi;
            arm.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        if (side > 0.0) std::reverse(arm.begin(), arm.end());
        out.insert(out.end(), arm.begin(), arm.end());
    }
    return out;
}

/// An outline with a hole, joined to it by a line that is run through twice.
Outline keyhole(Random& random, std::size_t corners) {
    Outline out;
    const auto ring = [&](double radius, double direction) {
        for (std::size_t i = 0; i <= corners; ++i) {
            const double angle =
                direction * 2.0 * std::numbers::pi * static_cast<double>(i % corners) / static_cast<double>(corners);
            out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
    };
    ring(between(random, 2.0, 3.0), 1.0);
    ring(between(random, 0.5, 0.9), -1.0);
    return out;
}

/// Two squares that a line without width joins, outside of both.
Outline dumbbell(Random&, std::size_t) {
    return {{0, 0}, {1, 0}, {1, 1}, {3, 1}, {3, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 1}, {1, 1}, {0, 1}};
}

/// Two squares that share a corner.
Outline pair(Random&, std::size_t) { return {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}; }

Outline letter_l(Random& random, std::size_t) {
    const double w = between(random, 0.1, 0.9);
    return {{0, 0}, {3, 0}, {3, w}, {w, w}, {w, 2}, {0, 2}};
}

Outline dart(Random& random, std::size_t) { return {{0, 0}, {6, 1}, {0, 2}, {between(random, 0.5, 4.0), 1}}; }

/// Corners in the middle of sides, and corners that are there twice or three times.
Outline crowded(const Outline& outline) {
    Outline out;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Flat& a = outline[i];
        const Flat& b = outline[(i + 1) % outline.size()];
        out.insert(out.end(), 1 + i % 3, a);
        out.push_back({0.5 * a[0] + 0.5 * b[0], 0.5 * a[1] + 0.5 * b[1]});
    }
    return out;
}

double rounded(double x) { return std::round(x * 1e6) / 1e6; }

/// A random orthogonal frame and a random place.
struct Plane {
    Vec3 u, v, place;
    explicit Plane(Random& random) {
        const auto any = [&] { return Vec3{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)}; };
        u = direction(any());
        v = direction(cross(u, any()));
        place = 5.0 * any();
    }
    Vec3 operator()(const Flat& p) const {
        const Vec3 out = place + p[0] * u + p[1] * v;
        return {rounded(out.x), rounded(out.y), rounded(out.z)};
    }
};

int winding(const Outline& outline, const Flat& p) {
    int out = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Flat& a = outline[i];
        const Flat& b = outline[(i + 1) % outline.size()];
        const double side = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        if (a[1] <= p[1] && b[1] > p[1] && side > 0) ++out;
        if (a[1] > p[1] && b[1] <= p[1] && side < 0) --out;
    }
    return out;
}

/// The triangles of an outline in a plane: their area is the outline's, and random points are in as many triangles as
/// the outline winds around them.
void check(const Outline& outline, const std::function<Vec3(const Flat&)>& place, Random& random) {
    std::vector<Vec3> polygon;
    for (const Flat& p : outline) polygon.push_back(place(p));
    const Triangulation cut = triangulate(polygon);
    CHECK(cut.simple);
    double sum = 0.0;
    for (const auto& t : cut.triangles) {
        sum += length(cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]));
    }
    CHECK(sum == Approx(std::abs(area(outline))).epsilon(1e-4));
    int wrong = 0;
    for (int i = 0; i < 200; ++i) {
        const Flat p{between(random, -3, 5), between(random, -3, 5)};
        int covered = 0;
        for (const auto& t : cut.triangles) {
            covered += std::abs(winding({outline[t[0]], outline[t[1]], outline[t[2]]}, p));
        }
        wrong += covered == std::abs(winding(outline, p)) ? 0 : 1;
    }
    CHECK(wrong <= 1);  // a point on a side that rounding has moved
}

}  // namespace

TEST_CASE("polygon: every simple outline, in every plane and direction, is covered once") {
    Random random(1);
    const std::pair<const char*, Outline (*)(Random&, std::size_t)> kinds[] = {
        {"star", star},         {"comb", comb}, {"spiral", spiral}, {"keyhole", keyhole},
        {"dumbbell", dumbbell}, {"pair", pair}, {"L", letter_l},    {"dart", dart}};
    const std::function<Vec3(const Flat&)> straight[] = {[](const Flat& p) {
                                                             return Vec3{p[0], p[1], 0};
                                                         },
                                                         [](const Flat& p) {
                                                             return Vec3{0.25, p[0], p[1]};
                                                         },
                                                         [](const Flat& p) {
                                                             return Vec3{p[0], -7, p[1]};
                                                         },
                                                         [](const Flat& p) {
                                                             return Vec3{p[0] + 500000.0, 4649776.0 + p[1], 99};
                                                         }};
    std::size_t outlines = 0;
    for (const auto& [name, make] : kinds) {
        for (std::size_t size = 3; size < 18; ++size) {
            for (const bool more : {false, true}) {
                for (const bool backwards : {false, true}) {
                    Outline outline = make(random, size);
                    if (more) outline = crowded(outline);
                    std::rotate(outline.begin(),
                                outline.begin() + static_cast<std::ptrdiff_t>(random() % outline.size()),
                                outline.end());
                    if (backwards) std::reverse(outline.begin(), outline.end());
                    INFO(name << ' ' << size << (more ? ", crowded" : "") << (backwards ? ", backwards" : ""));
                    check(outline, Plane(random), random);
                    check(outline, straight[size % 4], random);
                    ++outlines;
                }
            }
        }
    }
    CHECK(outlines >= 120);
}

TEST_CASE("polygon: one that crosses or covers itself is not simple") {
    const auto simple = [](const Outline& outline) {
        std::vector<Vec3> polygon;
        for (const Flat& p : outline) polygon.push_back({p[0], p[1], 1});
        return triangulate(polygon).simple;
    };
    CHECK(simple({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    CHECK_FALSE(simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    CHECK_FALSE(simple({{0, 0}, {3, 3}, {1, 0}, {0, 1}}));
    CHECK_FALSE(simple({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    Outline pentagram;
    for (int i = 0; i < 5; ++i)
        pentagram.push_back({std::cos(0.8 * i * std::numbers::pi), std::sin(0.8 * i * std::numbers::pi)});
    CHECK_FALSE(simple(pentagram));
    // Two lobes that meet in a corner, run through like an 8.
    CHECK_FALSE(simple({{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}));
}

TEST_CASE("polygon: one without an area gives no triangles") {
    CHECK(triangulate(std::vector<Vec3>{}).triangles.empty());
    CHECK(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}}).triangles.empty());
    CHECK(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}).triangles.empty());
    CHECK(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 1, 1}}).triangles.empty());
    CHECK(triangulate(std::vector<Vec3>(9, Vec3{1, 2, 3})).triangles.empty());
}

TEST_CASE("polygon: whatever the corners, no triangle is without an area and nothing hangs") {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        std::vector<Vec3> polygon;
        for (std::size_t k = 3 + random() % 12; k > 0; --k) {
            const auto coordinate = [&] { return static_cast<double>(random() % 4); };
            polygon.push_back({coordinate(), coordinate(), i % 2 == 0 ? 0.0 : coordinate()});
        }
        const Triangulation cut = triangulate(polygon);
        REQUIRE(cut.triangles.size() + 2 <= polygon.size());
        for (const auto& t : cut.triangles) {
            REQUIRE(length(cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]])) > 0.0);
        }
    }
}

TEST_CASE("polygon: a corner on a straight line is a corner of triangles") {
    std::vector<Vec3> polygon;
    for (const Flat& p : crowded({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}})) {
        if (polygon.empty() || polygon.back() != Vec3{p[0], p[1], 0}) polygon.push_back({p[0], p[1], 0});
    }
    const Triangulation cut = triangulate(polygon);
    CHECK(cut.simple);
    CHECK(cut.triangles.size() == polygon.size() - 2);
}
