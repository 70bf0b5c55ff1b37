#include "glint/reference.hpp"

#include <algorithm>
#include <cmath>

#include "domain.hpp"

namespace glint::reference {
namespace {

/// c / (c + n (1 - c)): the same number as c / (n - n c + c), without the cancellation near c = 1.
double schlick_in_domain(double c, double n) {
    if (c == 1.0) return 1.0;  // also for n = infinity, where n (1 - c) would be NaN
    return c / (c + n * (1.0 - c));
}

Vector unit(const Vector& v) {
    const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (!(largest > 0.0) || !std::isfinite(largest)) return {nan, nan, nan};
    // Scaled first, so that neither huge nor tiny components lose the square.
    const Vector scaled{v[0] / largest, v[1] / largest, v[2] / largest};
    const double length = std::hypot(scaled[0], scaled[1], scaled[2]);
    return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

double dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

}  // namespace

double blinn_phong(double c, double n) {
    return with_domain(c, n, [](double x, double m) { return std::pow(x, m); });
}

double schlick(double c, double n) { return with_domain(c, n, schlick_in_domain); }

double bps(double c, double n) {
    return with_domain(c, n, [](double x, double m) {
        const double s = schlick_in_domain(x, m);
        const auto& k = bps_constants;
        return std::max(0.0, k.a * s * s * s + k.b * s * s + k.c1 * s + k.d0);
    });
}

double bps_horner(double c, double n) {
    return with_domain(c, n, [](double x, double m) {
        const double s = schlick_in_domain(x, m);
        const auto& k = bps_constants;
        return std::max(0.0, s * (k.c1 + s * (k.b + k.a * s)) + k.d0);
    });
}

void bps_batch(double n, std::span<const double> c, std::span<double> out) {
    const auto k = bps_constants;
    const double* in = c.data();
    double* result = out.data();
    const std::size_t count = std::min(c.size(), out.size());
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        const double s = in[i] / (in[i] + n * (1.0 - in[i]));
        const double f = s * (k.c1 + s * (k.b + k.a * s)) + k.d0;
        result[i] = f > 0.0 ? f : 0.0;
    }
}

double epicentre_cosine(double n) { return std::sqrt((n - 1.0) / n); }

double cos_blinn(const Vector& normal, const Vector& light, const Vector& view) {
    const Vector l = unit(light);
    const Vector v = unit(view);
    return dot(unit(normal), unit({l[0] + v[0], l[1] + v[1], l[2] + v[2]}));
}

double cos_phong(const Vector& normal, const Vector& light, const Vector& view) {
    const Vector n = unit(normal);
    const Vector l = unit(light);
    const double twice = 2.0 * dot(l, n);
    return dot(unit(view), {twice * n[0] - l[0], twice * n[1] - l[1], twice * n[2] - l[2]});
}

}  // namespace glint::reference
