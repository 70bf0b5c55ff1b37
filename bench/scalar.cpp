// One evaluation at a time: compiled without vectorization (CMakeLists.txt).

#include "loops.hpp"
#include "rivals.hpp"

namespace glint::bench {
namespace {

template <class Formula, class T>
T chain(const Inputs<T>& in, T zero) {
    using Argument = typename Formula::template Argument<T>;
    const T* c = in.c.data();
    const T* n = in.n.data();
    const int* integer_n = in.integer_n.data();
    const auto* memory = in.memory.data();
    const std::size_t count = in.size();
    T y{0};
    for (std::size_t i = 0; i < count; ++i) {
        y = Formula{}(c[i] + zero * y, argument<Argument>(n, integer_n, memory, i));
    }
    return y;
}

struct Dependency : formulas::OfExponent {
    static constexpr std::string_view name = "dependency", lobe = "", text = "c + zero y";
    template <class T>
    T operator()(T c, T) const {
        return c;
    }
};

template <class Formula, class T>
Function<T> function() {
    auto out = array_function<Formula, T>();
    out.chain = chain<Formula, T>;
    return out;
}

}  // namespace

template <class T>
std::vector<Function<T>> scalar_functions() {
    return std::apply([](auto... formula) { return std::vector<Function<T>>{function<decltype(formula), T>()...}; },
                      Timed{});
}

template <class T>
Function<T> dependency() {
    return function<Dependency, T>();
}

template std::vector<Function<double>> scalar_functions();
template std::vector<Function<float>> scalar_functions();
template Function<double> dependency();
template Function<float> dependency();

}  // namespace glint::bench
