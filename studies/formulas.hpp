// The lobes as formulas over any number type, in the form that the paper counts: counted in forms.cpp, timed in double
// and in float in bench/. Legal: 0 <= c <= 1, n from least_n of the formula on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <string_view>
#include <tuple>

#include "glint/reference.hpp"
#include "model/src/lobes/numbers.hpp"

namespace glint::formulas {

// ---- number types ------------------------------------------------------------------------------------------------
// `x - one`, with the constant `one` of the type, is a decrement; every other sum or difference is an addition.

struct One {};
inline constexpr One one{};

template <std::floating_point T>
T operator+(T x, One) {
    return x + T{1};
}
template <std::floating_point T>
T operator-(T x, One) {
    return x - T{1};
}
template <std::floating_point T>
T at_least_0(T x) {
    return x > T{0} ? x : T{0};
}
template <std::floating_point T>
T lesser(T x, T y) {
    return std::min(x, y);
}
template <std::floating_point T>
T greater(T x, T y) {
    return std::max(x, y);
}
template <std::floating_point T>
T exponential(T x) {
    return std::exp(x);
}
template <std::floating_point T>
T logarithm(T x) {
    return std::log(x);
}
template <std::floating_point T>
T arc_cosine(T x) {
    return std::acos(x);
}
template <std::floating_point T>
T power(T x, T y) {
    return std::pow(x, y);
}
template <std::floating_point T>
T square_root(T x) {
    return std::sqrt(x);
}
template <std::floating_point T>
T sine(T x) {
    return std::sin(x);
}
template <std::floating_point T>
T tangent(T x) {
    return std::tan(x);
}

/// A constant, rounded to the type.
template <class T>
constexpr T number(long double x) {
    if constexpr (std::floating_point<T>) {
        return static_cast<T>(x);
    } else {
        return T{static_cast<double>(x)};
    }
}

template <class T>
T square(T x) {
    return x * x;
}

// ---- the formulas ------------------------------------------------------------------------------------------------

/// A formula takes c and its Argument, which stands for the exponent: n itself unless the formula says otherwise.
struct OfExponent {
    static constexpr int least_n = 1;  ///< the formula is the lobe from this n on
    template <class T>
    using Argument = T;
};

struct Schlick : OfExponent {
    static constexpr std::string_view name = "schlick", lobe = "schlick", text = "c / (n - n c + c)";
    template <class T>
    T operator()(T c, T n) const {
        return c / (n - n * c + c);
    }
};
struct CosinePower : OfExponent {
    static constexpr std::string_view name = "cosine_power", lobe = "cosine_power", text = "max(0, (n/8)(c - 1) + 1)^8";
    template <class T>
    T operator()(T c, T n) const {
        const T base = (n / T{8.0}) * (c - one) + one;
        return square(square(square(at_least_0(base))));
    }
};
struct Quadratic : OfExponent {
    static constexpr std::string_view name = "quadratic", lobe = "quadratic",
                                      text = "k c c + (1 - k) c, k = 0.786 n; cut at 0";
    template <class T>
    T operator()(T c, T n) const {
        const T k = number<T>(quadratic_slope) * n;
        return at_least_0(k * c * c + (T{1.0} - k) * c);
    }
};

/// What f_kub needs of an n: the coefficients from the conditions of the paper, and the cosine of the local minimum,
/// where the cut is.
template <class T>
struct CubicMemory {
    T A{}, B{}, C{}, cut{};

    explicit CubicMemory(double n) {
        // A c^2 + B c + C, which is f / c, by divided differences over 1, R and L.
        const long double m = n;
        const long double R = std::pow(0.5L, 1.0L / m);
        const long double L = std::pow(1.0L / 18.0L, 1.0L / m);
        const long double first = (0.5L / R - 1.0L) / (R - 1.0L);
        const long double a = ((1.0L / 18.0L / L - 0.5L / R) / (L - R) - first) / (L - 1.0L);
        const long double b = first - a * (1.0L + R);
        const long double c = 1.0L - a - b;
        A = number<T>(a);
        B = number<T>(b);
        C = number<T>(c);
        if (n > 3) cut = number<T>((-b + std::sqrt(b * b - 3.0L * a * c)) / (3.0L * a));
    }
};
struct Cubic : OfExponent {
    static constexpr std::string_view name = "cubic", lobe = "cubic",
                                      text = "A c^3 + B c^2 + C c; A, B, C and the cut from a memory";
    template <class T>
    using Argument = CubicMemory<T>;
    template <class T>
    T operator()(T c, const CubicMemory<T>& m) const {
        const T c2 = c * c;
        const T f = m.A * (c2 * c) + m.B * c2 + m.C * c;
        return c < m.cut ? T{0.0} : f;
    }
};
struct CubicHorner : OfExponent {
    static constexpr std::string_view name = "cubic_horner", lobe = "cubic",
                                      text = "c (C + c (B + c A)); A, B, C and the cut from a memory";
    template <class T>
    using Argument = CubicMemory<T>;
    template <class T>
    T operator()(T c, const CubicMemory<T>& m) const {
        const T f = c * (m.C + c * (m.B + c * m.A));
        return c < m.cut ? T{0.0} : f;
    }
};
struct Bps : OfExponent {
    static constexpr std::string_view name = "bps", lobe = "bps",
                                      text = "s (c1 + s (b + a s)) + d0, s = c / (n - c (n - 1)); cut at 0";
    template <class T>
    T operator()(T c, T n) const {
        constexpr auto k = reference::bps_constants;
        const T s = c / (n - c * (n - one));
        return at_least_0(s * (number<T>(k.c1) + s * (number<T>(k.b) + number<T>(k.a) * s)) + number<T>(k.d0));
    }
};
struct SymmetricCubic : OfExponent {
    static constexpr std::string_view name = "polynomial", lobe = "polynomial",
                                      text = "t (k1 + t (k2 + k3 t)), t = (1 + c) / (1 + c - 2 n (c - 1)); cut at 0";
    template <class T>
    T operator()(T c, T n) const {
        constexpr auto k = polynomial_coefficients;
        const T p = c + one;
        const T t = p / (p - T{2.0} * n * (c - one));
        return at_least_0(t * (number<T>(k[1]) + t * (number<T>(k[2]) + number<T>(k[3]) * t)));
    }
};
struct Cayley : OfExponent {
    static constexpr std::string_view name = "cayley", lobe = "cayley",
                                      text = "(max(0, c + 15/256 x) / (1 - 273/4096 x))^8, x = (n - 8)(c - 1)";
    static constexpr int least_n = 7;
    template <class T>
    T operator()(T c, T n) const {
        const T x = (n - T{8.0}) * (c - one);
        const T r = at_least_0(c + T{15.0 / 256.0} * x) / (T{-273.0 / 4096.0} * x + one);
        return square(square(square(r)));
    }
};
struct Taylor : OfExponent {
    static constexpr std::string_view name = "taylor", lobe = "taylor",
                                      text =
                                          "(((x - 1)^2 + 1) / 2)^16, x = n/16 t (0.625 t - 1), t = c - 1; 0 from x "
                                          "= 1 on";
    static constexpr int least_n = 9;
    template <class T>
    T operator()(T c, T n) const {
        const T t = c - one;
        const T x = T{1.0 / 16.0} * n * (t * (T{taylor_bend} * t - one));
        const T r = T{0.5} * (square(x - one) + one);
        const T f = square(square(square(square(r))));
        return x < T{1.0} ? f : T{0.0};
    }
};
struct SphericalGaussian : OfExponent {
    static constexpr std::string_view name = "spherical_gaussian", lobe = "spherical_gaussian",
                                      text = "exp((n + 0.775)(c - 1)), std::exp";
    template <class T>
    T operator()(T c, T n) const {
        return exponential((n + number<T>(spherical_gaussian_shift)) * (c - one));
    }
};
struct Gauss : OfExponent {
    static constexpr std::string_view name = "gauss", lobe = "gauss",
                                      text = "exp(-n/2 acos(c)^2), std::exp and std::acos";
    template <class T>
    T operator()(T c, T n) const {
        return exponential(T{-0.5} * n * square(arc_cosine(c)));
    }
};
struct BlinnPhong : OfExponent {
    static constexpr std::string_view name = "blinn_phong", lobe = "blinn_phong", text = "std::pow(c, n)";
    template <class T>
    T operator()(T c, T n) const {
        return power(c, n);
    }
};
struct Decay : OfExponent {
    static constexpr std::string_view name = "decay", lobe = "decay", text = "exp(n ln c), std::exp and std::log";
    template <class T>
    T operator()(T c, T n) const {
        return exponential(n * logarithm(c));
    }
};

/// The lobes of the paper first.
using All = std::tuple<Schlick, CosinePower, Quadratic, Cubic, CubicHorner, Bps, SymmetricCubic, Cayley, Taylor,
                       SphericalGaussian, Gauss, BlinnPhong, Decay>;

}  // namespace glint::formulas
