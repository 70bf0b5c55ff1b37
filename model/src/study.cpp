#include "glint/study.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glint/reference.hpp"

namespace glint {
namespace {

template <class Column>
Summary summary(const std::vector<StudyRow>& rows, int first, int last, Column column) {
    Summary out;
    std::vector<double> values;
    for (const StudyRow& row : rows) {
        if (row.n < first || row.n > last) continue;
        values.push_back(column(row));
        if (values.back() > out.largest) {
            out.largest = values.back();
            out.n = row.n;
        }
    }
    if (values.empty()) return out;
    std::sort(values.begin(), values.end());
    out.median = (values[values.size() / 2] + values[(values.size() - 1) / 2]) / 2.0;
    return out;
}

// ---- the formulas, over any number type --------------------------------------------------------------------------
// `x - one`, with the constant `one` of the type, is a decrement; every other sum or difference is an addition.

struct One {};
constexpr One one{};

inline double operator+(double x, One) { return x + 1.0; }
inline double operator-(double x, One) { return x - 1.0; }
inline double at_least_0(double x) { return x > 0.0 ? x : 0.0; }

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
};

template <class T>
T square(T x) {
    return x * x;
}

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
        const T k = T{0.786} * n;
        return at_least_0(k * c * c + (T{1.0} - k) * c);
    }
};
/// The cubic at n = 50, its coefficients and its cut as a memory gives them.
struct Cubic {
    double A, B, C, cut;
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

template <class Formula>
double value_of(double c, double n) {
    return Formula{}(c, n);
}
template <class Formula>
Operations count_of(const Formula& formula = {}) {
    tally = {};
    formula(Counted{0.99}, Counted{50.0});
    return tally;
}

/// A c^3 + B c^2 + C c from its conditions, which is how the paper writes it: costly, and done once per n.
double cubic_value(double c, double n) { return find_lobe("cubic").reference(c, n); }

}  // namespace

Summary Study::delta(int first, int last) const {
    return summary(rows, first, last, [](const StudyRow& row) { return row.delta.value; });
}

Summary Study::absolute(int first, int last) const {
    return summary(rows, first, last, [](const StudyRow& row) { return row.absolute.value; });
}

Study study(const Lobe& lobe) {
    // A golden model knows the real function of its lobe, for whole spans at once.
    const auto model = lobe.golden(parse_profile("p12"));
    Study out{lobe.name, {}};
    for (int n = 2; n <= 1000; ++n) {
        const double edge = std::atan(1.0 / std::sqrt(n - 1.0));
        std::vector<double> theta;
        for (int i = 0; i <= 1000; ++i) theta.push_back(edge * i / 1000.0);
        const std::size_t zone = theta.size();
        const double far = std::min(std::numbers::pi / 2.0, 16.0 * edge);
        for (int i = 0; i <= 2000; ++i) theta.push_back(far * i / 2000.0);
        for (int i = 0; i <= 100; ++i) theta.push_back(std::numbers::pi / 2.0 * i / 100.0);
        std::vector<double> c(theta.size()), f(theta.size());
        for (std::size_t i = 0; i < c.size(); ++i) c[i] = std::max(0.0, std::cos(theta[i]));
        model->reference(n, c, f);
        StudyRow row{n, {}, {}};
        for (std::size_t i = 0; i < c.size(); ++i) {
            const double exact = std::pow(c[i], n);
            const double error = std::abs(f[i] - exact);
            if (error > row.absolute.value) row.absolute = {error, theta[i]};
            if (i < zone && error / exact > row.delta.value) row.delta = {error / exact, theta[i]};
        }
        out.rows.push_back(row);
    }
    return out;
}

int Operations::cycles(const Latencies& l) const {
    return multiplications * l.multiplication + divisions * l.division + additions * l.addition +
           increments * l.increment + comparisons * l.comparison;
}

const std::vector<Form>& forms() {
    static const std::vector<Form> all{
        {"schlick", "c / (n - n c + c)", value_of<Schlick>, [] { return count_of<Schlick>(); }},
        {"cosine_power", "max(0, (n/8)(c - 1) + 1)^8", value_of<CosinePower>, [] { return count_of<CosinePower>(); }},
        {"quadratic", "k c c + (1 - k) c, k = 0.786 n; cut at 0", value_of<Quadratic>,
         [] { return count_of<Quadratic>(); }},
        {"cubic", "c (C + c (B + c A)), A, B, C and the cut from a memory", cubic_value,
         [] {
             return count_of(Cubic{1.0, 1.0, 1.0, 0.5});
         }},
        {"bps", "s (c1 + s (b + a s)) + d0, s = c / (n - c (n - 1)); cut at 0", value_of<Bps>,
         [] { return count_of<Bps>(); }},
    };
    return all;
}

}  // namespace glint
