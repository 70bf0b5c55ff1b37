#include "glint/fit.hpp"

#include <cmath>
#include <numeric>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/reference.hpp"

using namespace glint;

namespace {

double at(const Fit& f, double x) {
    double out = 0.0;
    for (std::size_t k = f.coefficients.size(); k-- > 0;) out = out * x + f.coefficients[k];
    return out;
}

}  // namespace

TEST_CASE("the published coefficients of f_bps come out to their printed digits, by the normal equations and by QR") {
    for (const FitMethod method : {FitMethod::normal_equations, FitMethod::qr}) {
        const Fit f = fit({.method = method});
        CHECK(f.rows == 1000 * 1571);
        const auto& published = reference::bps_constants;
        REQUIRE(f.coefficients.size() == 4);
        CHECK(std::round(f.coefficients[0] * 1e6) == std::round(published.d0 * 1e6));  // 2.737e-3
        CHECK(std::round(f.coefficients[1] * 1e3) == std::round(published.c1 * 1e3));
        CHECK(std::round(f.coefficients[2] * 1e3) == std::round(published.b * 1e3));
        CHECK(std::round(f.coefficients[3] * 1e3) == std::round(published.a * 1e3));
    }
}

TEST_CASE("both ways to the least squares agree, and no neighbour is better") {
    for (const Variable variable : {Variable::schlick, Variable::symmetric}) {
        for (const bool constrained : {false, true}) {
            FitRequest request{.variable = variable, .degree = 4, .n = {8, 200, 8}, .theta = {0.0, 1.57, 0.01}};
            request.zero_at_0 = request.one_at_1 = constrained;
            const Fit sums = fit(request);
            request.method = FitMethod::qr;
            const Fit rotations = fit(request);
            for (std::size_t k = 0; k < 5; ++k) {
                CHECK(std::abs(sums.coefficients[k] - rotations.coefficients[k]) < 1e-6);
            }
            // Along x^2 - x^3, which keeps both constraints, the sum of squares is least at 0.
            const auto squares = [&](double along) {
                double sum = 0.0;
                for (std::int64_t i = 0; i < request.n.size(); ++i) {
                    for (std::size_t j = 0; j < request.theta.size(); ++j) {
                        const double c = std::cos(request.theta[j]);
                        const auto n = static_cast<double>(request.n[i]);
                        const double x = variable_value(variable, c, n);
                        const double error = at(rotations, x) + along * (x * x - x * x * x) - std::pow(c, n);
                        sum += error * error;
                    }
                }
                return sum;
            };
            CHECK(squares(0.0) < squares(1e-4));
            CHECK(squares(0.0) < squares(-1e-4));
            if (constrained) {
                CHECK(rotations.coefficients[0] == 0.0);
                CHECK(std::abs(std::accumulate(rotations.coefficients.begin(), rotations.coefficients.end(), -1.0)) <
                      1e-12);
            }
        }
    }
}

TEST_CASE("what a polynomial can do exactly is found: n = 1, where the variable of Schlick is the cosine") {
    for (const FitMethod method : {FitMethod::normal_equations, FitMethod::qr, FitMethod::minimax}) {
        if (method == FitMethod::minimax && !has_minimax()) continue;
        const Fit f = fit({.degree = 2, .method = method, .n = {1, 1, 1}, .theta = {0.0, 1.57, 0.01}});
        CHECK(std::abs(f.coefficients[0]) < 1e-6);
        CHECK(std::abs(f.coefficients[1] - 1.0) < 1e-6);
        CHECK(std::abs(f.coefficients[2]) < 1e-6);
        CHECK(f.largest < 1e-6);
    }
}

TEST_CASE("minimax: the error alternates, and is below that of the least squares") {
    if (!has_minimax()) return;
    // One n: the classical problem, where the best of degree 3 takes its largest error, with changing sign, 5 times.
    FitRequest request{.n = {50, 50, 1}, .theta = {0.0, 1.57, 0.0005}};
    const Fit squares = fit(request);
    request.method = FitMethod::minimax;
    const Fit best = fit(request);
    CHECK(best.largest < squares.largest);
    int alternations = 0;
    double last = 0.0;
    for (std::size_t j = 0; j < request.theta.size(); ++j) {
        const double c = std::cos(request.theta[j]);
        const double error = at(best, variable_value(Variable::schlick, c, 50)) - std::pow(c, 50);
        if (std::abs(error) < best.largest * (1.0 - 1e-4)) continue;
        if (last == 0.0 || std::signbit(error) != std::signbit(last)) ++alternations;
        last = error;
    }
    CHECK(alternations == 5);
}

TEST_CASE("fits that make no sense are refused") {
    CHECK_THROWS_AS(fit({.degree = 0}), Error);
    CHECK_THROWS_AS(fit({.degree = 9}), Error);
    CHECK_THROWS_AS(fit({.degree = 1, .zero_at_0 = true, .one_at_1 = true}), Error);
    for (const FitMethod method : {FitMethod::normal_equations, FitMethod::qr}) {
        CHECK_THROWS_AS(fit({.degree = 3, .method = method, .n = {5, 5, 1}, .theta = {0.5, 0.5, 1.0}}), Error);
    }
    CHECK_THROWS_AS(parse_variable("phong"), Error);
    CHECK_THROWS_AS(parse_fit_method("remez"), Error);
    for (const char* text : {"", "a", "0:1", "0:1:0", "0:1:-1", "1:0:1", "0:1:1e-9", "0:2:1", "-1:1:1", "nan",
                             "0:1:1:1", "0:nan:1", "inf"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_real_range(text, "--theta", 0.0, 1.6), Error);
    }
    CHECK(parse_real_range("0:1.57:0.001", "--theta", 0.0, 1.6).size() == 1571);
    CHECK(parse_real_range("0.5", "--theta", 0.0, 1.6).size() == 1);
}
