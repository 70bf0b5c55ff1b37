#include "studies/forms.hpp"

#include "studies/counted.hpp"
#include "studies/formulas.hpp"

namespace glint::studies {
namespace {

template <class Formula>
Form form() {
    return {Formula::name,
            Formula::lobe,
            Formula::text,
            Formula::least_n,
            [] {
                using Argument = typename Formula::template Argument<Counted>;
                const Argument argument{50.0};
                return count([&] { Formula{}(Counted{0.99}, argument); });
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

}  // namespace glint::studies
