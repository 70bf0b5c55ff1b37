#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glint::render {
namespace {

/// A corner in the plane, with the coordinate that is dropped left out: no rounding.
struct Point {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// The sum of the products, with the sign of the exact sum: each is split into two doubles, and the parts are added to
/// a sequence whose members do not overlap, so its last one that is not 0 has the sign of all.
double exact_sum(const std::array<std::array<double, 2>, 6>& products) {
    std::array<double, 12> parts{};
    std::size_t count = 0;
    const auto add = [&](double x) {
        for (std::size_t i = 0; i < count; ++i) {
            const double sum = x + parts[i];
            const double rest = sum - x;
            parts[i] = (x - (sum - rest)) + (parts[i] - rest);
            x = sum;
        }
        parts[count++] = x;
    };
    for (const auto& [a, b] : products) {
        const double high = a * b;
        add(std::fma(a, b, -high));
        add(high);
    }
    for (std::size_t i = count; i-- > 0;) {
        if (parts[i] != 0.0) return parts[i];
    }
    return 0.0;
}

/// Twice the area of a triangle, above 0 where it runs counterclockwise; its sign is exact.
double orientation(const Point& a, const Point& b, const Point& c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double area = left - right;
    constexpr double error = 3.4e-16;  // of the four differences, two products and their difference, relative
    if (std::abs(area) > error * (std::abs(left) + std::abs(right))) return area;
    return exact_sum({{{a.x, b.y}, {-a.x, c.y}, {-c.x, b.y}, {-a.y, b.x}, {a.y, c.x}, {c.y, b.x}}});
}

double along(const Point& from, const Point& a, const Point& b) {
    return (a.x - from.x) * (b.x - from.x) + (a.y - from.y) * (b.y - from.y);
}

/// Without the coordinate in which the polygon is thinnest, and counterclockwise. Empty where it has no plane.
std::vector<Point> flattened(std::span<const Vec3> polygon) {
    const Vec3& first = polygon.front();
    Vec3 normal;
    Vec3 largest;  // of the triangles at the first corner: the plane of a figure of eight, whose areas cancel
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Vec3 area = cross(polygon[i] - first, polygon[i + 1] - first);
        normal = normal + area;
        if (dot(area, area) > dot(largest, largest)) largest = area;
    }
    if (dot(normal, normal) <= 1e-20 * dot(largest, largest)) normal = largest;
    if (!(dot(normal, normal) > 0.0)) return {};
    const double x = std::abs(normal.x);
    const double y = std::abs(normal.y);
    const double z = std::abs(normal.z);
    std::vector<Point> out;
    for (const Vec3& p : polygon) {
        const Point point = x > y && x > z ? Point{p.y, p.z} : y > z ? Point{p.z, p.x} : Point{p.x, p.y};
        out.push_back(point);
    }
    if ((x > y && x > z ? normal.x : y > z ? normal.y : normal.z) < 0.0) {
        for (Point& p : out) std::swap(p.x, p.y);
    }
    return out;
}

/// Cuts ears off: an ear is a triangle of three corners in sequence that lies in the polygon. Without it, the rest
/// winds once around what is left and around nothing else, so any ear may go first.
class Clipper {
public:
    explicit Clipper(std::vector<Point> points)
        : points_(std::move(points)),
          next_(points_.size()),
          previous_(points_.size()),
          reflex_(points_.size(), false),
          left_(points_.size()) {
        std::iota(next_.begin(), next_.end(), 1U);
        next_.back() = 0;
        for (std::uint32_t i = 0; i < next_.size(); ++i) previous_[next_[i]] = i;
        std::vector<Point> sorted = points_;
        std::sort(sorted.begin(), sorted.end(),
                  [](const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
        touches_ = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
        const auto [low, high] = std::minmax_element(points_.begin(), points_.end(),
                                                     [](const Point& a, const Point& b) { return a.y < b.y; });
        tolerance_ = 1e-6 * std::max(sorted.back().x - sorted.front().x, high->y - low->y);
    }

    Triangulation run() {
        Triangulation out;
        out.simple = !crosses_itself();
        std::uint32_t at = 0;
        for (std::size_t i = 0; i < points_.size() && left_ > 2; ++i) at = next_[tidy(at)];
        for (std::size_t i = 0; i < left_; ++i, at = next_[at]) note(at);
        int care = clean;
        std::size_t misses = 0;
        while (left_ > 2) {
            const bool thin = care == tolerant && is_thin(at);
            if (thin || is_ear(at, care)) {
                if (!thin) out.triangles.push_back({previous_[at], at, next_[at]});
                remove(at);
                at = tidy(previous_[at]);
                note(at);
                at = next_[at];  // fans are poor triangles
                note(at);
                care = clean;
                misses = 0;
            } else if (misses++ < left_) {
                at = next_[at];
            } else {
                if (care == any) break;
                ++care;
                misses = 0;
                out.simple = out.simple && care <= tolerant;
            }
        }
        return out;
    }

private:
    /// How an ear is told from others: with no corner on the line that cuts it off, which would be left without a
    /// triangle; by exact tests; with corners in it that are as good as on its side, as a file's rounded numbers bring;
    /// what turns the right way; what has an area.
    enum Care { clean, exact, tolerant, convex, any };

    double turn(std::uint32_t i) const { return orientation(points_[previous_[i]], points_[i], points_[next_[i]]); }

    void remove(std::uint32_t i) {
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
        reflex_[i] = false;
        --left_;
    }

    /// A corner that bounds nothing: equal to the one before, or the tip of a line that goes back on itself.
    bool pointless(std::uint32_t i) const {
        const Point& before = points_[previous_[i]];
        return points_[i] == before || (turn(i) == 0.0 && along(points_[i], before, points_[next_[i]]) >= 0.0);
    }

    /// A corner that is as good as on the line between its neighbours.
    bool is_thin(std::uint32_t i) const {
        const Point& a = points_[previous_[i]];
        const Point& c = points_[next_[i]];
        return std::abs(turn(i)) <= tolerance_ * std::hypot(c.x - a.x, c.y - a.y);
    }

    /// Removes pointless corners from `i` on, in both directions; returns the corner at that place.
    std::uint32_t tidy(std::uint32_t i) {
        while (left_ > 2) {
            if (pointless(i)) {
                remove(i);
                i = previous_[i];
            } else if (pointless(next_[i])) {
                remove(next_[i]);
            } else {
                break;
            }
        }
        return i;
    }

    /// Only a corner that is not convex can lie in an ear.
    void note(std::uint32_t i) {
        const bool now = turn(i) <= 0.0;
        if (now && !reflex_[i]) blockers_.push_back(i);
        reflex_[i] = now;
    }

    bool is_ear(std::uint32_t i, int care) {
        const Point& a = points_[previous_[i]];
        const Point& b = points_[i];
        const Point& c = points_[next_[i]];
        const double area = orientation(a, b, c);
        if (care == any) return area != 0.0;
        if (area <= 0.0) return false;
        if (care == convex) return true;
        const auto [left, right] = std::minmax({a.x, b.x, c.x});
        const auto [low, high] = std::minmax({a.y, b.y, c.y});
        const std::array<std::array<Point, 2>, 3> sides{{{a, b}, {b, c}, {c, a}}};
        for (std::size_t k = 0; k < blockers_.size();) {
            const std::uint32_t other = blockers_[k];
            if (!reflex_[other]) {
                blockers_[k] = blockers_.back();
                blockers_.pop_back();
                continue;
            }
            ++k;
            const Point& p = points_[other];
            if (p.x < left || p.x > right || p.y < low || p.y > high) continue;
            std::array<double, 3> inside{};
            bool out = false;
            for (std::size_t s = 0; s < 3 && !out; ++s) {
                const auto& [from, to] = sides[s];
                inside[s] = orientation(from, to, p);
                const double margin = tolerance_ * std::hypot(to.x - from.x, to.y - from.y);
                out = care <= exact ? inside[s] < 0.0 : inside[s] <= margin;
            }
            if (out) continue;
            if (care == clean && inside[2] == 0.0 && p != a && p != c) return false;
            // On a side, or at a corner, it is in the way only where one of its own sides leads into the triangle.
            for (const std::uint32_t neighbour : {previous_[other], next_[other]}) {
                bool enters = true;
                for (std::size_t s = 0; s < 3; ++s) {
                    if (inside[s] > 0.0) continue;
                    enters = enters && orientation(sides[s][0], sides[s][1], points_[neighbour]) > 0.0;
                }
                if (enters) return false;
            }
        }
        // Where the polygon touches itself, the other side of a line without width may be outside.
        return !touches_ || winding({(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0}, sides) == 1;
    }

    /// How often what is left of the polygon winds around the middle of a triangle; 1 where rounding has moved it out.
    int winding(const Point& p, const std::array<std::array<Point, 2>, 3>& sides) const {
        for (const auto& [from, to] : sides) {
            if (orientation(from, to, p) <= 0.0) return 1;
        }
        int out = 0;
        std::uint32_t first = 0;
        while (next_[previous_[first]] != first) ++first;  // one that is left
        std::uint32_t at = first;
        do {
            const Point& a = points_[at];
            const Point& b = points_[next_[at]];
            if (a.y <= p.y && b.y > p.y && orientation(a, b, p) > 0.0) ++out;
            if (a.y > p.y && b.y <= p.y && orientation(a, b, p) < 0.0) --out;
            at = next_[at];
        } while (at != first);
        return out;
    }

    /// Two sides that cross, by more than rounding makes, or run over each other in one direction.
    bool crosses_itself() const {
        struct Side {
            Point a, b;
        };
        const auto [west, east] = std::minmax_element(points_.begin(), points_.end(),
                                                      [](const Point& a, const Point& b) { return a.x < b.x; });
        const auto [south, north] = std::minmax_element(points_.begin(), points_.end(),
                                                        [](const Point& a, const Point& b) { return a.y < b.y; });
        const bool wide = east->x - west->x >= north->y - south->y;
        std::vector<Side> sides;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            Side side{points_[i], points_[next_[i]]};
            if (!wide) {  // the other way round, which all tests here are free to do
                std::swap(side.a.x, side.a.y);
                std::swap(side.b.x, side.b.y);
            }
            if (side.a != side.b) sides.push_back(side);
        }
        std::sort(sides.begin(), sides.end(),
                  [](const Side& s, const Side& t) { return std::min(s.a.x, s.b.x) < std::min(t.a.x, t.b.x); });
        const auto apart = [&](const Side& s, const Side& t) {
            const double one = orientation(s.a, s.b, t.a);
            const double two = orientation(s.a, s.b, t.b);
            const double margin = tolerance_ * std::hypot(s.b.x - s.a.x, s.b.y - s.a.y);
            return std::array<bool, 2>{(one < -margin && two > margin) || (one > margin && two < -margin),
                                       one == 0.0 && two == 0.0};
        };
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Side& s = sides[i];
            const auto [left, right] = std::minmax(s.a.x, s.b.x);
            const auto [low, high] = std::minmax(s.a.y, s.b.y);
            for (std::size_t j = i + 1; j < sides.size(); ++j) {
                const Side& t = sides[j];
                if (std::min(t.a.x, t.b.x) > right) break;
                if (std::min(t.a.y, t.b.y) > high || std::max(t.a.y, t.b.y) < low) continue;
                const auto [across, in_line] = apart(s, t);
                if (across && apart(t, s)[0]) return true;
                const bool one_way = (s.b.x - s.a.x) * (t.b.x - t.a.x) + (s.b.y - s.a.y) * (t.b.y - t.a.y) > 0.0;
                if (!in_line || !one_way) continue;
                const double shared_x =
                    std::min(right, std::max(t.a.x, t.b.x)) - std::max(left, std::min(t.a.x, t.b.x));
                const double shared_y = std::min(high, std::max(t.a.y, t.b.y)) - std::max(low, std::min(t.a.y, t.b.y));
                if (std::max(shared_x, shared_y) > 0.0) return true;
            }
        }
        return false;
    }

    std::vector<Point> points_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<bool> reflex_;
    std::vector<std::uint32_t> blockers_;  // all that are reflex, and some that no longer are
    std::size_t left_;
    bool touches_ = false;
    double tolerance_ = 0.0;
};

/// In single precision, so that equal diagonals of a file's rounded numbers count as equal more often.
bool first_diagonal_is_shorter(std::span<const Vec3> quad) {
    const auto square = [&](std::size_t i, std::size_t k) {
        const auto difference = [](double a, double b) { return static_cast<float>(b) - static_cast<float>(a); };
        const float x = difference(quad[i].x, quad[k].x);
        const float y = difference(quad[i].y, quad[k].y);
        const float z = difference(quad[i].z, quad[k].z);
        return x * x + y * y + z * z;
    };
    return square(0, 2) < square(1, 3);
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 area = cross(b - a, c - a);
    return dot(area, area) > 0.0;
}

}  // namespace

Triangulation triangulate(std::span<const Vec3> polygon) {
    Triangulation out;
    if (polygon.size() < 3) return out;
    if (polygon.size() == 3) {
        out.triangles.push_back({0, 1, 2});
    } else {
        std::vector<Point> points = flattened(polygon);
        if (points.empty()) return out;
        bool convex = polygon.size() == 4;
        for (std::size_t i = 0; i < 4 && convex; ++i) {
            convex = orientation(points[i], points[(i + 1) % 4], points[(i + 2) % 4]) > 0.0;
        }
        if (convex && first_diagonal_is_shorter(polygon)) {
            out.triangles = {{0, 1, 2}, {0, 2, 3}};
        } else if (convex) {
            out.triangles = {{0, 1, 3}, {1, 2, 3}};
        } else {
            out = Clipper(std::move(points)).run();
        }
    }
    std::erase_if(out.triangles, [&](const auto& t) { return !has_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]); });
    return out;
}

}  // namespace glint::render
