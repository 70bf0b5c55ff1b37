#include <cmath>
#include <numbers>

#include "glint/vectors.hpp"
#include "models.hpp"

namespace glint::bench {
namespace {

using Triple = std::array<double, 3>;
using std::numbers::pi;

Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Triple sum(double p, const Triple& a, double q, const Triple& b) {
    return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}

/// Of unit length at an angle from a unit vector, to the side that `turn` says.
Triple around(const Triple& axis, double angle, double turn) {
    const Triple side = cross(axis, std::abs(axis[0]) < 0.5 ? Triple{1, 0, 0} : Triple{0, 1, 0});
    const Triple x = sum(1.0 / std::sqrt(dot(side, side)), side, 0.0, side);
    const Triple tilt = sum(std::cos(turn), x, std::sin(turn), cross(axis, x));
    return sum(std::cos(angle), axis, std::sin(angle), tilt);
}

}  // namespace

std::vector<studies::paper2::Scene> highlight_scenes(std::size_t count, double widest) {
    constexpr double degree = pi / 180.0;
    Random random(1);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random.between(0, 1 << 30)) / (1 << 30);
    };
    const auto turn = [&] { return uniform(0.0, 2.0 * pi); };
    std::vector<studies::paper2::Scene> out(count);
    for (studies::paper2::Scene& s : out) {
        s.N = around({0, 0, 1}, std::acos(uniform(-1.0, 1.0)), turn());
        s.T = around(s.N, 0.5 * pi, turn());
        s.B = cross(s.N, s.T);
        const Triple H = around(s.N, uniform(degree, widest * degree), turn());
        s.L = around(H, uniform(degree, 48.0 * degree), turn());
        s.V = sum(2.0 * dot(H, s.L), H, -1.0, s.L);
    }
    return out;
}

}  // namespace glint::bench
