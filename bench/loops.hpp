// The loops around a formula. Unnamed on purpose: every source file that includes them has compiler flags of its own,
// and the linker must not take the code of one for that of another.
#pragma once

#include <type_traits>

#include "functions.hpp"

namespace glint::bench {
namespace {

/// The exponent of input i in the form that a formula takes.
template <class Argument, class T>
inline decltype(auto) argument(const T* n, const int* integer_n, const formulas::CubicMemory<T>* memory,
                               std::size_t i) {
    if constexpr (std::is_same_v<Argument, T>) {
        return n[i];
    } else if constexpr (std::is_same_v<Argument, int>) {
        return integer_n[i];
    } else {
        return (memory[integer_n[i] - 1]);
    }
}

template <class Formula, class T>
void each(const Inputs<T>& in, T* __restrict y) {
    using Argument = typename Formula::template Argument<T>;
    const T* c = in.c.data();
    const T* n = in.n.data();
    const int* integer_n = in.integer_n.data();
    const auto* memory = in.memory.data();
    const std::size_t count = in.size();
    for (std::size_t i = 0; i < count; ++i) y[i] = Formula{}(c[i], argument<Argument>(n, integer_n, memory, i));
}

template <class Formula, class T>
Function<T> array_function(std::string_view name = Formula::name) {
    return {name, Formula::lobe, Formula::text, Formula::least_n, each<Formula, T>, nullptr};
}

}  // namespace
}  // namespace glint::bench
