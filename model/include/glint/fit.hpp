// Polynomials in a rational variable, fitted to Blinn-Phong c^n: how f_bps was found, and how to find others.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "glint/range.hpp"

namespace glint {

/// The variable that the polynomial is in.
enum class Variable {
    schlick,   ///< s = c / (n - n c + c)
    symmetric  ///< t = (1 + c) / ((1 + c) + 2 n (1 - c))
};

/// "schlick" or "symmetric". Throws Error.
Variable parse_variable(std::string_view text);
std::string_view name(Variable variable);

/// Its value, in [0, 1]. Legal: 0 <= c <= 1, n >= 1.
double variable_value(Variable variable, double c, double n);

enum class FitMethod {
    normal_equations,  ///< least squares by power sums, in extended precision; as Zavalniuk, Romanyuk, Satsiuk 2024
    qr,                ///< least squares by Givens rotations, which do not square the condition
    minimax            ///< the least largest error, by linear programmes over a growing set of rows (needs GLPK)
};

/// "least-squares" (the normal equations), "qr" or "minimax". Throws Error.
FitMethod parse_fit_method(std::string_view text);
std::string_view name(FitMethod method);

/// first, first + step, ... up to last at most, as real numbers; both ends included.
struct RealRange {
    double first = 0.0;
    double last = 0.0;
    double step = 1.0;

    std::size_t size() const;
    double operator[](std::size_t i) const { return first + static_cast<double>(i) * step; }
};

/// "0:1.57:0.001" or "0.5", within low .. high, at most 10^6 values. `what` names the argument. Throws Error.
RealRange parse_real_range(std::string_view text, std::string_view what, double low, double high);

/// What to fit. The rows are all pairs of n and theta (radians): the variable at cos(theta), and cos(theta)^n.
struct FitRequest {
    Variable variable = Variable::schlick;
    int degree = 3;  ///< 1..8
    FitMethod method = FitMethod::normal_equations;
    Range n{1, 1000, 1};
    RealRange theta{0.0, 1.57, 0.001};
    bool zero_at_0 = false;  ///< the polynomial is 0 at 0
    bool one_at_1 = false;   ///< the polynomial is 1 at 1
};

struct Fit {
    std::vector<double> coefficients;  ///< of the powers 0, 1, ..., degree
    std::size_t rows = 0;
    double rms = 0.0;      ///< over the rows, of the polynomial itself, not cut at 0
    double largest = 0.0;  ///< error over the rows, absolute
    int largest_n = 0;     ///< where it is
    double largest_theta = 0.0;
};

/// Throws Error: for a degree out of range, when the constraints leave no coefficient free, when the rows do not
/// determine the coefficients, and for minimax in a build without GLPK.
Fit fit(const FitRequest& request);

/// Whether this build has minimax.
bool has_minimax();

}  // namespace glint
