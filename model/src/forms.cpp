#include "glint/forms.hpp"

#include <cmath>
#include <type_traits>

#include "glint/reference.hpp"
#include "lobes/numbers.hpp"

namespace glint {
namespace {

// ---- number types ------------------------------------------------------------------------------------------------
// `x - one`, with the constant `one` of the type, is a decrement; every other sum or difference is an addition.

struct One {};
constexpr One one{};

inline double operator+(double x, One) { return x + 1.0; }
inline double operator-(double x, One) { return x - 1.0; }
inline double at_least_0(double x) { return x > 0.0 ? x : 0.0; }
inline double exponential(double x) { return std::exp(x); }
inline double arc_cosine(double x) { return std::acos(x); }
inline double power(double x, double y) { return std::pow(x, y); }

Operations tally;

/// A number that counts what is done to it.
struct Counted {
    double x = 0.0;
    friend Counted operator+(Counted a, Counted b) { return ++tally.additions, Counted{a.x + b.x}; }
    friend Counted operator-(Counted a, Counted b) { return ++tally.additions, Counted{a.x - b.x}; }
    friend Counted operator+(Counted a, One) { return ++tally.increments, Counted{a.x + 1.0}; }
    friend Counted operator-(Counted a, One) { return ++tally.increments, Counted{a.x - 1.0}; }
    friend Counted operator*(Counted a, Counted b) { return ++tally.multiplications, Counted{a.x * b.x}; }
    friend Counted operator/(Counted a, Counted b) { return ++tally.divisions, Counted{a.x / b.x}; }
    friend Counted at_least_0(Counted a) { return ++tally.comparisons, a.x > 0.0 ? a : Counted{0.0}; }
    friend bool operator<(Counted a, Counted b) { return ++tally.comparisons, a.x < b.x; }
    friend Counted exponential(Counted a) { return ++tally.calls, Counted{std::exp(a.x)}; }
    friend Counted arc_cosine(Counted a) { return ++tally.calls, Counted{std::acos(a.x)}; }
    friend Counted power(Counted a, Counted b) { return ++tally.calls, Counted{std::pow(a.x, b.x)}; }
};

template <class T>
T square(T x) {
    return x * x;
}

// ---- the formulas, over any number type --------------------------------------------------------------------------

struct Schlick {
    template <class T>
    T operator()(T c, T n) const {
        return c / (n - n * c + c);
    }
};
struct CosinePower {
    template <class T>
    T operator()(T c, T n) const {
        const T base = (n / T{8.0}) * (c - one) + one;
        return square(square(square(at_least_0(base))));
    }
};
struct Quadratic {
    template <class T>
    T operator()(T c, T n) const {
        const T k = T{quadratic_slope} * n;
        return at_least_0(k * c * c + (T{1.0} - k) * c);
    }
};

/// The coefficients at one n from the conditions of the paper, and the cosine of the local minimum, where the cut is.
struct CubicMemory {
    double A = 0, B = 0, C = 0, cut = 0;
    explicit CubicMemory(double n) {
        // A c^2 + B c + C, which is f / c, by divided differences over 1, R and L.
        const long double m = n;
        const long double R = std::pow(0.5L, 1.0L / m);
        const long double L = std::pow(1.0L / 18.0L, 1.0L / m);
        const long double first = (0.5L / R - 1.0L) / (R - 1.0L);
        const long double a = ((1.0L / 18.0L / L - 0.5L / R) / (L - R) - first) / (L - 1.0L);
        const long double b = first - a * (1.0L + R);
        const long double c = 1.0L - a - b;
        A = static_cast<double>(a);
        B = static_cast<double>(b);
        C = static_cast<double>(c);
        if (n > 3) cut = static_cast<double>((-b + std::sqrt(b * b - 3.0L * a * c)) / (3.0L * a));
    }
};
struct Cubic : CubicMemory {
    using CubicMemory::CubicMemory;
    template <class T>
    T operator()(T c, T) const {
        const T c2 = c * c;
        return c < T{cut} ? T{0.0} : T{A} * (c2 * c) + T{B} * c2 + T{C} * c;
    }
};
struct CubicHorner : CubicMemory {
    using CubicMemory::CubicMemory;
    template <class T>
    T operator()(T c, T) const {
        return c < T{cut} ? T{0.0} : c * (T{C} + c * (T{B} + c * T{A}));
    }
};
struct Bps {
    template <class T>
    T operator()(T c, T n) const {
        const T s = c / (n - c * (n - one));
        const auto& k = reference::bps_constants;
        return at_least_0(s * (T{k.c1} + s * (T{k.b} + T{k.a} * s)) + T{k.d0});
    }
};
struct SymmetricCubic {
    template <class T>
    T operator()(T c, T n) const {
        const T p = c + one;
        const T t = p / (p - T{2.0} * n * (c - one));
        const auto& k = polynomial_coefficients;
        return at_least_0(t * (T{k[1]} + t * (T{k[2]} + T{k[3]} * t)));
    }
};
struct Cayley {
    template <class T>
    T operator()(T c, T n) const {
        const T x = (n - T{8.0}) * (c - one);
        const T r = at_least_0(c + T{15.0 / 256.0} * x) / (T{-273.0 / 4096.0} * x + one);
        return square(square(square(r)));
    }
};
struct Taylor {
    template <class T>
    T operator()(T c, T n) const {
        const T t = c - one;
        const T x = T{1.0 / 16.0} * n * (t * (T{taylor_bend} * t - one));
        const T r = T{0.5} * (square(x - one) + one);
        return x < T{1.0} ? square(square(square(square(r)))) : T{0.0};
    }
};
struct SphericalGaussian {
    template <class T>
    T operator()(T c, T n) const {
        return exponential((n + T{spherical_gaussian_shift}) * (c - one));
    }
};
struct Gauss {
    template <class T>
    T operator()(T c, T n) const {
        return exponential(T{-0.5} * n * square(arc_cosine(c)));
    }
};
struct BlinnPhong {
    template <class T>
    T operator()(T c, T n) const {
        return power(c, n);
    }
};

// ---- a formula behind function pointers, whole loops at a time so that it is inlined ------------------------------

template <class Formula>
Formula prepared(double n) {
    if constexpr (std::is_constructible_v<Formula, double>) {
        return Formula(n);
    } else {
        return Formula{};
    }
}

template <class Formula>
Form form(std::string_view lobe, std::string_view formula, int least_n = 1) {
    return {lobe,
            formula,
            least_n,
            [] {
                const Formula f = prepared<Formula>(50.0);
                tally = {};
                f(Counted{0.99}, Counted{50.0});
                return tally;
            },
            [](double c, double n) { return prepared<Formula>(n)(c, n); },
            [](std::span<const double> c, double n, std::span<double> y) {
                const Formula f = prepared<Formula>(n);
                for (std::size_t i = 0; i < c.size(); ++i) y[i] = f(c[i], n);
            },
            [](double n, int steps) {
                const Formula f = prepared<Formula>(n);
                double y = 0.0;
                for (int i = 0; i < steps; ++i) y = f(0.99 + 1e-9 * y, n);
                return y;
            }};
}

}  // namespace

int Operations::cycles(const Latencies& l) const {
    return multiplications * l.multiplication + divisions * l.division + additions * l.addition +
           increments * l.increment + comparisons * l.comparison;
}

std::span<const Form> forms() {
    static const std::vector<Form> all{
        form<Schlick>("schlick", "c / (n - n c + c)"),
        form<CosinePower>("cosine_power", "max(0, (n/8)(c - 1) + 1)^8"),
        form<Quadratic>("quadratic", "k c c + (1 - k) c, k = 0.786 n; cut at 0"),
        form<Cubic>("cubic", "A c^3 + B c^2 + C c; A, B, C and the cut from a memory"),
        form<CubicHorner>("cubic", "c (C + c (B + c A)); A, B, C and the cut from a memory"),
        form<Bps>("bps", "s (c1 + s (b + a s)) + d0, s = c / (n - c (n - 1)); cut at 0"),
        form<SymmetricCubic>("polynomial", "t (k1 + t (k2 + k3 t)), t = (1 + c) / (1 + c - 2 n (c - 1)); cut at 0"),
        form<Cayley>("cayley", "(max(0, c + 15/256 x) / (1 - 273/4096 x))^8, x = (n - 8)(c - 1)", 7),
        form<Taylor>("taylor", "(((x - 1)^2 + 1) / 2)^16, x = n/16 t (0.625 t - 1), t = c - 1; 0 from x = 1 on", 9),
        form<SphericalGaussian>("spherical_gaussian", "exp((n + 0.775)(c - 1)), std::exp"),
        form<Gauss>("gauss", "exp(-n/2 acos(c)^2), std::exp and std::acos"),
        form<BlinnPhong>("blinn_phong", "std::pow(c, n)"),
    };
    return all;
}

}  // namespace glint
