// What calls the C library, with its vector functions: compilers call those in relaxed arithmetic only
// (CMakeLists.txt).

#include "loops.hpp"
#include "rivals.hpp"

namespace glint::bench {

template <class T>
std::vector<Function<T>> libmvec_functions() {
    return {array_function<Pow, T>("pow_libmvec"), array_function<ExpLog, T>("exp_log_libmvec"),
            array_function<formulas::SphericalGaussian, T>("spherical_gaussian_libmvec"),
            array_function<formulas::Gauss, T>("gauss_libmvec")};
}

template std::vector<Function<double>> libmvec_functions();
template std::vector<Function<float>> libmvec_functions();

}  // namespace glint::bench
