// The functions in double and float that are timed: formulas of the lobes and what people use for c^n today, each as a
// loop over independent inputs and as a chain of evaluations of which each waits for the one before.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "studies/formulas.hpp"

namespace glint::bench {

/// Inputs in a number type, with n in every form that a formula takes. Lengths are equal; n in 1..max_n.
template <class T>
struct Inputs {
    std::vector<T> c;
    std::vector<T> n;
    std::vector<int> integer_n;
    std::vector<formulas::CubicMemory<T>> memory;  ///< of n = index + 1

    Inputs(std::span<const double> cosines, std::span<const int> exponents);

    std::size_t size() const { return c.size(); }
};

template <class T>
struct Function {
    std::string_view name;     ///< of a lobe's formula, or of a rival
    std::string_view lobe;     ///< in the registry: the real function it stands for
    std::string_view formula;  ///< as evaluated
    int least_n;               ///< the formula is the lobe from this n on
    /// All inputs, each by itself.
    void (*each)(const Inputs<T>&, T* y);
    /// The last result of y = f(c_i + zero y): with zero = 0, which the compiler does not know, each result is that of
    /// the input alone but waits for the one before. None in batches.
    T (*chain)(const Inputs<T>&, T zero);
};

/// One evaluation at a time, in instructions that every processor of the kind has; T is double or float.
template <class T>
std::vector<Function<T>> scalar_functions();

/// The chain around no function: what a chain costs beyond its function.
template <class T>
Function<T> dependency();

/// Loops for the compiler to vectorize.
template <class T>
std::vector<Function<T>> batch_functions();

/// Loops over the vector functions of the C library, libmvec; their names end with _libmvec. Not in every build.
template <class T>
std::vector<Function<T>> libmvec_functions();

}  // namespace glint::bench
