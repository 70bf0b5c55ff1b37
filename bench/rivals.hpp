// What people use for c^n today.
#pragma once

#include "studies/formulas.hpp"

namespace glint::bench {

/// The same code as the lobe `blinn_phong`: two times of one thing show what a time is worth.
struct Pow : formulas::BlinnPhong {
    static constexpr std::string_view name = "pow";
};

struct PowInteger : formulas::OfExponent {
    static constexpr std::string_view name = "pow_integer", lobe = "blinn_phong",
                                      text = "std::pow(c, n) with n an int: computed in double, whatever c is";
    template <class T>
    using Argument = int;
    template <class T>
    T operator()(T c, int n) const {
        return static_cast<T>(std::pow(c, n));
    }
};

struct ExpLog : formulas::OfExponent {
    static constexpr std::string_view name = "exp_log", lobe = "blinn_phong", text = "std::exp(n std::log(c))";
    template <class T>
    T operator()(T c, T n) const {
        return std::exp(n * std::log(c));
    }
};

/// The text-book loop ends with the highest bit of n; this one always takes ten steps and has no branch to mispredict,
/// so that it can be vectorized.
struct Squaring : formulas::OfExponent {
    static constexpr std::string_view name = "squaring", lobe = "blinn_phong",
                                      text = "exponentiation by squaring, ten steps for the ten bits of n";
    template <class T>
    using Argument = int;
    template <class T>
    T operator()(T c, int n) const {
        T product{1};
        for (int bit = 0; bit < 10; ++bit) {
            product *= (n >> bit & 1) != 0 ? c : T{1};
            c *= c;
        }
        return product;
    }
};

using Timed = decltype(std::tuple_cat(formulas::All{}, std::tuple<Pow, PowInteger, ExpLog, Squaring>{}));

}  // namespace glint::bench
