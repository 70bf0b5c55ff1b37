// The lobes as real functions, in double: what the fixed-point models are measured against.
//
// Arguments outside the domain have defined answers, the same for every lobe:
//   NaN in any argument            NaN
//   c < 0, -infinity               0 (the light or the viewer is behind the surface)
//   c > 1, +infinity               counts as 1
//   n < 1, negative, -infinity     counts as 1
//   n = +infinity                  the limit: what n -> infinity tends to at that c
// Huge finite n is computed as it stands; nothing overflows.
#pragma once

#include <array>
#include <span>

namespace glint::reference {

/// The constants of f_bps as published (Zavalniuk, Romanyuk, Satsiuk 2024): a s^3 + b s^2 + c1 s + d0.
struct BpsConstants {
    double a = -1.631;
    double b = 2.995;
    double c1 = -0.374;
    double d0 = 2.737e-3;
};
inline constexpr BpsConstants bps_constants{};

/// f_b = c^n, the target: Blinn-Phong when c is cos(N, H), Phong when c is cos(V, R). In [0, 1].
double blinn_phong(double c, double n);

/// f_s = c / (n - n c + c), Schlick's rational approximation (Graphics Gems IV, 1994). In [0, 1].
double schlick(double c, double n);

/// f_bps as printed: a s^3 + b s^2 + c1 s + d0 with s = f_s; values below 0 are cut to 0. In [0, 1).
double bps(double c, double n);

/// f_bps in Horner form, s (c1 + s (b + a s)) + d0, s = c / (n - c (n - 1)); values below 0 are cut to 0. In [0, 1).
double bps_horner(double c, double n);

/// bps_horner for every c of a span at one n: the form that the sweeps use. Legal arguments only: 0 <= c <= 1, n >= 1.
void bps_batch(double n, std::span<const double> c, std::span<double> out);

/// The least cosine of the epicentre zone: theta in [0, x_per], x_per the inflection point of cos^n,
/// tan^2(x_per) = 1 / (n - 1), hence cos(x_per) = sqrt((n - 1) / n). Legal: n >= 1 (0 at n = 1).
double epicentre_cosine(double n);

using Vector = std::array<double, 3>;

/// cos(gamma) of Blinn: N . H with H = (L + V) / |L + V|. Vectors need not have unit length.
/// NaN when one has no direction: length 0, not finite, or L = -V, where there is no half vector.
double cos_blinn(const Vector& normal, const Vector& light, const Vector& view);

/// cos(psi) of Phong: V . R with R = 2 (L . N) N - L. Vectors need not have unit length.
/// NaN when one has no direction: length 0 or not finite.
double cos_phong(const Vector& normal, const Vector& light, const Vector& view);

}  // namespace glint::reference
