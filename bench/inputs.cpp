#include "functions.hpp"
#include "glint/profile.hpp"

namespace glint::bench {

template <class T>
Inputs<T>::Inputs(std::span<const double> cosines, std::span<const int> exponents)
    : integer_n(exponents.begin(), exponents.end()) {
    for (const double cosine : cosines) c.push_back(static_cast<T>(cosine));
    for (const int exponent : exponents) n.push_back(static_cast<T>(exponent));
    for (int exponent = 1; exponent <= max_n; ++exponent) memory.emplace_back(exponent);
}

template struct Inputs<double>;
template struct Inputs<float>;

}  // namespace glint::bench
