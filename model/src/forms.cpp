#include "glint/forms.hpp"

#include <cmath>

#include "formulas.hpp"

namespace glint {
namespace {

Operations tally;

/// A number that counts what is done to it.
struct Counted {
    using One = formulas::One;
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

template <class Formula>
Form form() {
    return {Formula::name,
            Formula::lobe,
            Formula::text,
            Formula::least_n,
            [] {
                using Argument = typename Formula::template Argument<Counted>;
                const Argument argument{50.0};
                tally = {};
                Formula{}(Counted{0.99}, argument);
                return tally;
            },
            [](double c, double n) {
                using Argument = typename Formula::template Argument<double>;
                return Formula{}(c, Argument{n});
            }};
}

}  // namespace

int Operations::cycles(const Latencies& l) const {
    return multiplications * l.multiplication + divisions * l.division + additions * l.addition +
           increments * l.increment + comparisons * l.comparison;
}

std::span<const Form> forms() {
    static const std::vector<Form> all =
        std::apply([](auto... formula) { return std::vector<Form>{form<decltype(formula)>()...}; }, formulas::All{});
    return all;
}

}  // namespace glint
