#include "glint/cook_torrance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::cook_torrance {
namespace {

using std::numbers::pi;

// N.H below which the distribution of every legal roughness is nothing (exp(-1e12)): keeps tan^2 finite.
constexpr double least_half = 1e-6;

void check_roughness(double m) {
    if (!(m >= least_roughness && m <= greatest_roughness)) {
        throw Error(fmt::format("roughness {} is not legal: {} to {}", m, least_roughness, greatest_roughness));
    }
}

void check_index(double eta) {
    if (!(eta >= 1.0 && eta <= greatest_index)) {
        throw Error(fmt::format("index of refraction {} is not legal: 1 to {}", eta, greatest_index));
    }
}

/// m^2 D at an angle.
double bell(double angle, double m) { return m * m * beckmann(std::cos(angle), m); }

double variable_at(Variable variable, double angle) {
    return variable == Variable::angle ? angle : 2.0 * std::pow(std::sin(0.5 * angle), 2);  // 1 - cos, not cancelled
}

constexpr int fit_angles = 400;
constexpr int error_angles = 2000;  // over [0, pi/2]

/// The least-squares cubic (1 - x)(b0 + b1 x + b2 x^2) up to the angle `last`.
Cubic fit_up_to(double m, Variable variable, double last) {
    Cubic out{variable, m, variable_at(variable, last), {}};
    // The normal equations: three unknowns and a basis of order 1, so that they are well conditioned.
    long double a[3][4] = {};
    for (int k = 0; k < fit_angles; ++k) {
        const double angle = last * (k + 0.5) / fit_angles;
        const double x = variable_at(variable, angle) / out.end;
        const long double y = bell(angle, m);
        const long double basis[3] = {1.0L - x, (1.0L - x) * x, (1.0L - x) * x * x};
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) a[i][j] += basis[i] * basis[j];
            a[i][3] += basis[i] * y;
        }
    }
    // Elimination without exchange: the matrix is positive definite.
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
            if (i == k) continue;
            const long double factor = a[i][k] / a[k][k];
            for (int j = k; j < 4; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    const auto b = [&](int k) { return static_cast<double>(a[k][3] / a[k][k]); };
    out.coefficients = {b(0), b(1) - b(0), b(2) - b(1), -b(2)};
    return out;
}

}  // namespace

double beckmann(double nh, double m) {
    if (nh < least_half) return 0.0;
    const double square = nh * nh;
    const double tangent = (1.0 - nh) * (1.0 + nh) / square;
    return std::exp(-tangent / (m * m)) / (m * m * square * square);
}

double fresnel(double vh, double eta) {
    const double excess = (eta - 1.0) * (eta + 1.0);
    if (excess == 0.0) return 0.0;
    const double c = vh;
    const double g = std::sqrt(excess + c * c);
    // (g - c) / (g + c) = excess / (g + c)^2, which does not cancel.
    const double across = excess / ((g + c) * (g + c));
    const double ratio = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return 0.5 * across * across * (1.0 + ratio * ratio);
}

double attenuation(double nl, double nv, double nh, double vh) {
    const double lit = 2.0 * nh * std::min(nl, nv);
    return (lit < vh ? lit / vh : 1.0) / nv;
}

double term(double nl, double nv, double nh, double vh, double m, double eta) {
    if (nl <= 0.0 || nv <= 0.0 || nh <= 0.0) return 0.0;
    return fresnel(std::max(0.0, vh), eta) * beckmann(nh, m) * attenuation(nl, nv, nh, vh) / pi;
}

double Cubic::operator()(double nh) const {
    const double v = variable == Variable::angle ? std::acos(std::clamp(nh, -1.0, 1.0)) : 1.0 - nh;
    const double x = v / end;
    if (!(x < 1.0)) return 0.0;
    const auto& c = coefficients;
    return std::max(0.0, c[0] + x * (c[1] + x * (c[2] + x * c[3])));
}

Cubic::Error Cubic::error() const {
    Error out;
    double peak = 0.0, sum = 0.0;
    for (int k = 0; k <= error_angles; ++k) {
        const double angle = 0.5 * pi * k / error_angles;
        const double y = bell(angle, m);
        const double difference = std::abs((*this)(std::cos(angle)) - y);
        peak = std::max(peak, y);
        sum += difference * difference;
        if (difference > out.largest) {
            out.largest = difference;
            out.largest_angle = angle;
        }
    }
    out.largest /= peak;
    out.rms = std::sqrt(sum / (error_angles + 1)) / peak;
    return out;
}

// The largest error is no smooth function of the end, so the ends are tried: 1 % steps, from where the cubic would cut
// off half of the highlight to where it would be lost in it.
Cubic fit_beckmann(double m, Variable variable) {
    check_roughness(m);
    const double widest = std::min(0.5 * pi, 4.0 * m + 0.15);
    Cubic best;
    double least = 0.0;
    for (int percent = 30; percent <= 100; ++percent) {
        const Cubic cubic = fit_up_to(m, variable, widest * percent / 100.0);
        const double largest = cubic.error().largest;
        if (percent == 30 || largest < least) {
            best = cubic;
            least = largest;
        }
    }
    return best;
}

// Simpson's rule; the function is smooth there.
double mean_fresnel(double eta) {
    check_index(eta);
    constexpr int steps = 64;
    double sum = 0.0;
    for (int k = 0; k <= steps; ++k) {
        const double weight = k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
        sum += weight * fresnel(0.4 + 0.6 * k / steps, eta);
    }
    return sum / (3.0 * steps);
}

double modified_term(double nl, double nv, double nh, double vh, const Cubic& cubic, double reflectance) {
    if (nl <= 0.0 || nv <= 0.0 || nh <= 0.0) return 0.0;
    return reflectance * cubic(nh) / (cubic.m * cubic.m) * attenuation(nl, nv, nh, vh) / pi;
}

// For eta = 1, level is minus infinity, which the port's code cuts to its least; excess = 0 says that the term is 0.
std::vector<double> parameters(double m, double eta) {
    check_roughness(m);
    check_index(eta);
    const double excess = (eta - 1.0) * (eta + 1.0);
    return {std::numbers::log2e / (m * m), std::log2(excess * excess / (2.0 * pi * m * m)), excess};
}

// For eta = 1 the level is left out, and the cubic is 0.
std::vector<double> modified_parameters(double m, double eta) {
    const Cubic cubic = fit_beckmann(m, Variable::half);
    const double reflectance = mean_fresnel(eta);
    if (reflectance == 0.0) return {0.0, 1.0 / cubic.end, 0.0, 0.0, 0.0, 0.0};
    const auto& c = cubic.coefficients;
    return {std::log2(reflectance / (pi * m * m)), 1.0 / cubic.end, c[0], c[1], c[2], c[3]};
}

}  // namespace glint::cook_torrance
