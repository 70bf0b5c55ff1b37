// A number that counts what is done to it: what an evaluation of a formula costs.
#pragma once

#include <algorithm>
#include <cmath>

#include "studies/forms.hpp"
#include "studies/formulas.hpp"

namespace glint::studies {

inline thread_local Operations tally;

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
    friend Counted lesser(Counted a, Counted b) { return ++tally.comparisons, Counted{std::min(a.x, b.x)}; }
    friend Counted greater(Counted a, Counted b) { return ++tally.comparisons, Counted{std::max(a.x, b.x)}; }
    friend bool operator<(Counted a, Counted b) { return ++tally.comparisons, a.x < b.x; }
    friend Counted exponential(Counted a) { return ++tally.calls, Counted{std::exp(a.x)}; }
    friend Counted arc_cosine(Counted a) { return ++tally.calls, Counted{std::acos(a.x)}; }
    friend Counted logarithm(Counted a) { return ++tally.calls, Counted{std::log(a.x)}; }
    friend Counted power(Counted a, Counted b) { return ++tally.calls, Counted{std::pow(a.x, b.x)}; }
    friend Counted square_root(Counted a) { return ++tally.calls, Counted{std::sqrt(a.x)}; }
    friend Counted sine(Counted a) { return ++tally.calls, Counted{std::sin(a.x)}; }
    friend Counted tangent(Counted a) { return ++tally.calls, Counted{std::tan(a.x)}; }
};

/// What is done to counted numbers while `evaluate()` runs.
Operations count(auto evaluate) {
    tally = {};
    evaluate();
    return tally;
}

}  // namespace glint::studies
