#include "functions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "glint/lobes.hpp"

using namespace glint;
using namespace glint::bench;

namespace {

/// Every n of `exponents` with cosines that lie the denser the nearer they are to 1; no multiple of the lanes.
struct Grid {
    std::vector<double> c;
    std::vector<int> n;

    Grid() {
        for (const int exponent : {1, 2, 3, 7, 8, 9, 10, 50, 255, 256, 999, 1000, 1023}) {
            for (int i = 0; i <= 200; ++i) {
                // What float has, too, so that the input is no part of the error.
                c.push_back(static_cast<float>(1.0 - i * i / 40000.0));
                n.push_back(exponent);
            }
        }
    }
};

/// The largest magnitude that the function adds up: with values of 0 to 1 at the end, what cancels costs digits.
double scale(std::string_view lobe, int n) {
    if (lobe != "cubic") return n + 4.0;
    const formulas::CubicMemory<double> memory(n);
    return std::abs(memory.A) + std::abs(memory.B) + std::abs(memory.C);
}

template <class T>
std::vector<T> values(const Function<T>& function, const Inputs<T>& in) {
    std::vector<T> y(in.size(), T{-1});
    function.each(in, y.data());
    return y;
}

template <class T>
void check_values(const std::vector<Function<T>>& functions) {
    const Grid grid;
    const Inputs<T> in(grid.c, grid.n);
    REQUIRE(!functions.empty());
    for (const Function<T>& function : functions) {
        const Lobe& lobe = find_lobe(function.lobe);
        const std::vector<T> y = values(function, in);
        std::size_t compared = 0;
        for (std::size_t i = 0; i < y.size(); ++i) {
            if (grid.n[i] < function.least_n) continue;
            const double exact = lobe.reference(grid.c[i], grid.n[i]);
            const double tolerance = 2.0 * scale(function.lobe, grid.n[i]) * std::numeric_limits<T>::epsilon();
            if (!(std::abs(y[i] - exact) <= tolerance))
                FAIL(function.name << " n " << grid.n[i] << " c " << grid.c[i] << ": " << y[i] << " is not " << exact
                                   << " within " << tolerance);
            ++compared;
        }
        CHECK(compared >= 8 * 201);
    }
}

template <class T>
void check_chains() {
    const Grid grid;
    const Inputs<T> in(grid.c, grid.n);
    // c = 1 at first, so that the result before is never 0; then a cosine where every lobe rises.
    const Inputs<T> two(std::vector<double>{1.0, 0.984375}, std::vector<int>{50, 50});
    for (const Function<T>& function : scalar_functions<T>()) {
        INFO(function.name);
        CHECK(function.chain(in, T{0}) == values(function, in).back());
        const T by_itself = function.chain(two, T{0});
        const T waited = function.chain(two, T{1} / 1024);
        CHECK(by_itself > T{0});
        CHECK(waited > by_itself);
    }
    CHECK(dependency<T>().chain(two, T{0}) == two.c.back());
    CHECK(dependency<T>().chain(two, T{1} / 1024) > two.c.back());
}

template <class T>
std::vector<std::string_view> names(const std::vector<Function<T>>& functions) {
    std::vector<std::string_view> out;
    for (const Function<T>& function : functions) out.push_back(function.name);
    return out;
}

}  // namespace

TEST_CASE("bench: scalar functions have the values of their lobes") {
    check_values(scalar_functions<double>());
    check_values(scalar_functions<float>());
}

TEST_CASE("bench: batches have the values of their lobes") {
    check_values(batch_functions<double>());
    check_values(batch_functions<float>());
}

#ifdef GLINT_BENCH_LIBMVEC
TEST_CASE("bench: the vector functions of the C library have the values of their lobes") {
    check_values(libmvec_functions<double>());
    check_values(libmvec_functions<float>());
}
#endif

TEST_CASE("bench: what cancels in float, and what does not") {
    const Grid grid;
    const Inputs<float> in(grid.c, grid.n);
    const auto error = [&](std::string_view name) {
        double worst = 0.0;
        for (const Function<float>& function : scalar_functions<float>()) {
            if (function.name != name) continue;
            const std::vector<float> y = values(function, in);
            for (std::size_t i = 0; i < y.size(); ++i) {
                const double exact = find_lobe(function.lobe).reference(grid.c[i], grid.n[i]);
                worst = std::max(worst, std::abs(y[i] - exact));
            }
        }
        return worst;
    };
    // Coefficients of 4e5 that cancel to 1: the lobe of the paper that float cannot evaluate.
    CHECK(error("cubic") > 1e-3);
    CHECK(error("cubic_horner") > 1e-3);
    // n - n c + c with n = 1000, against n (1 - c), where 1 - c is exact.
    CHECK(error("bps") > 1e-6);
    CHECK(error("bps") < 1e-4);
    CHECK(error("polynomial") < 1e-6);
}

TEST_CASE("bench: in a chain every result reaches the next cosine") {
    check_chains<double>();
    check_chains<float>();
}

TEST_CASE("bench: every lobe of the registry is there in every form") {
    const auto all = names(scalar_functions<double>());
    CHECK(names(scalar_functions<float>()) == all);
    CHECK(names(batch_functions<double>()) == all);
    CHECK(names(batch_functions<float>()) == all);
    for (const Lobe& lobe : lobes()) {
        INFO(lobe.name);
        CHECK(std::count(all.begin(), all.end(), lobe.name) == 1);
    }
}
