// Loops over arrays: compiled for the lanes of the processor (CMakeLists.txt), in strict arithmetic.

#include "loops.hpp"
#include "rivals.hpp"

namespace glint::bench {

template <class T>
std::vector<Function<T>> batch_functions() {
    return std::apply(
        [](auto... formula) { return std::vector<Function<T>>{array_function<decltype(formula), T>()...}; }, Timed{});
}

template std::vector<Function<double>> batch_functions();
template std::vector<Function<float>> batch_functions();

}  // namespace glint::bench
