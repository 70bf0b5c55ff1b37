#include "glint/fit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "glint/error.hpp"
#ifdef GLINT_GLPK
#include <glpk.h>
#endif

namespace glint {
namespace {

/// The fitting problem: P(x) = fixed(x) + sum of coefficient[k] basis_k(x), where the constraints are already built in.
///   none         fixed 0,     basis x^k, k = 0..d
///   f(0) = 0     fixed 0,     basis x^k, k = 1..d
///   f(1) = 1     fixed x^d,   basis x^k - x^d, k = 0..d-1
///   both         fixed x^d,   basis x^k - x^d, k = 1..d-1
struct Problem {
    explicit Problem(const FitRequest& request)
        : degree(request.degree), first(request.zero_at_0 ? 1 : 0), one_at_1(request.one_at_1) {
        for (std::size_t i = 0; i < request.theta.size(); ++i) c.push_back(std::cos(request.theta[i]));
    }

    std::size_t unknowns() const { return static_cast<std::size_t>(degree - first + (one_at_1 ? 0 : 1)); }

    /// The basis at x into phi[0 .. unknowns - 1]; returns the fixed part.
    template <class Real>
    Real basis(Real x, Real* phi) const {
        Real power = first == 1 ? x : Real{1};
        const std::size_t count = unknowns();
        for (std::size_t k = 0; k < count; ++k, power *= x) phi[k] = power;
        if (!one_at_1) return Real{0};
        const Real top = power;  // x^degree
        for (std::size_t k = 0; k < count; ++k) phi[k] -= top;
        return top;
    }

    /// The coefficients of the powers from those of the basis.
    std::vector<double> powers(const std::vector<double>& solution) const {
        std::vector<double> out(static_cast<std::size_t>(degree) + 1, 0.0);
        double sum = 0.0;
        for (std::size_t k = 0; k < solution.size(); ++k) {
            out[k + static_cast<std::size_t>(first)] = solution[k];
            sum += solution[k];
        }
        if (one_at_1) out.back() = 1.0 - sum;
        return out;
    }

    int degree;
    int first;
    bool one_at_1;
    std::vector<double> c;  ///< cos(theta)
};

/// Calls row(n, index of theta, x, y) for every row.
void for_each_row(const FitRequest& request, const Problem& problem, auto row) {
    for (std::int64_t k = 0; k < request.n.size(); ++k) {
        const auto n = static_cast<double>(request.n[k]);
        for (std::size_t i = 0; i < problem.c.size(); ++i) {
            const double c = std::max(0.0, problem.c[i]);
            row(static_cast<int>(request.n[k]), i, variable_value(request.variable, c, n), std::pow(c, n));
        }
    }
}

Error undetermined() { return Error("the rows do not determine the coefficients: more n or theta, or a lower degree"); }

/// Solves a square system by elimination with row exchange.
template <class Real>
std::vector<double> solve(std::vector<std::vector<Real>> a) {
    const std::size_t size = a.size();
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < size; ++i) {
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        }
        std::swap(a[k], a[pivot]);
        if (!(std::abs(a[k][k]) > static_cast<Real>(1e-15) * std::abs(a[0][0]))) throw undetermined();
        for (std::size_t i = k + 1; i < size; ++i) {
            const Real factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j <= size; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    std::vector<double> out(size);
    for (std::size_t k = size; k-- > 0;) {
        Real value = a[k][size];
        for (std::size_t j = k + 1; j < size; ++j) value -= a[k][j] * static_cast<Real>(out[j]);
        out[k] = static_cast<double>(value / a[k][k]);
    }
    return out;
}

std::vector<double> by_normal_equations(const FitRequest& request, const Problem& problem) {
    // Without constraints the sums are those of the powers of x up to twice the degree.
    const std::size_t size = problem.unknowns();
    std::vector<std::vector<long double>> sums(size, std::vector<long double>(size + 1, 0.0L));
    long double phi[16];
    for_each_row(request, problem, [&](int, std::size_t, double x, double y) {
        const long double target = y - problem.basis<long double>(x, phi);
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = i; j < size; ++j) sums[i][j] += phi[i] * phi[j];
            sums[i][size] += phi[i] * target;
        }
    });
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < i; ++j) sums[i][j] = sums[j][i];
    }
    return solve(std::move(sums));
}

std::vector<double> by_qr(const FitRequest& request, const Problem& problem) {
    // R, with the transformed right side as its last column; each row is rotated into it.
    const std::size_t size = problem.unknowns();
    std::vector<std::vector<double>> r(size, std::vector<double>(size + 1, 0.0));
    double row[16];
    for_each_row(request, problem, [&](int, std::size_t, double x, double y) {
        row[size] = y - problem.basis<double>(x, row);
        for (std::size_t k = 0; k < size; ++k) {
            if (row[k] == 0.0) continue;
            const double length = std::hypot(r[k][k], row[k]);
            const double cosine = r[k][k] / length;
            const double sine = row[k] / length;
            for (std::size_t j = k; j <= size; ++j) {
                const double upper = cosine * r[k][j] + sine * row[j];
                row[j] = cosine * row[j] - sine * r[k][j];
                r[k][j] = upper;
            }
        }
    });
    return solve(std::move(r));
}

double value(const Problem& problem, const std::vector<double>& solution, double x) {
    double phi[16];
    double out = problem.basis<double>(x, phi);
    for (std::size_t k = 0; k < solution.size(); ++k) out += solution[k] * phi[k];
    return out;
}

#ifdef GLINT_GLPK

struct Row {
    double x, y;
};

/// Minimize e such that |P(x) - y| <= e for all rows.
std::vector<double> linear_programme(const Problem& problem, const std::vector<Row>& rows, double& bound) {
    glp_prob* lp = glp_create_prob();
    const int unknowns = static_cast<int>(problem.unknowns());
    const int error = unknowns + 1;
    glp_set_obj_dir(lp, GLP_MIN);
    glp_add_cols(lp, error);
    for (int k = 1; k <= unknowns; ++k) glp_set_col_bnds(lp, k, GLP_FR, 0.0, 0.0);
    glp_set_col_bnds(lp, error, GLP_LO, 0.0, 0.0);
    glp_set_obj_coef(lp, error, 1.0);
    glp_add_rows(lp, 2 * static_cast<int>(rows.size()));
    double phi[16];
    int index[18];
    double entry[18];
    for (int k = 1; k <= error; ++k) index[k] = k;
    int number = 0;
    for (const Row& row : rows) {
        const double target = row.y - problem.basis<double>(row.x, phi);
        for (int k = 1; k <= unknowns; ++k) entry[k] = phi[k - 1];
        entry[error] = -1.0;  // P - y <= e
        glp_set_mat_row(lp, ++number, error, index, entry);
        glp_set_row_bnds(lp, number, GLP_UP, 0.0, target);
        entry[error] = 1.0;  // P - y >= -e
        glp_set_mat_row(lp, ++number, error, index, entry);
        glp_set_row_bnds(lp, number, GLP_LO, target, 0.0);
    }
    glp_smcp parameters;
    glp_init_smcp(&parameters);
    parameters.msg_lev = GLP_MSG_OFF;
    parameters.tol_bnd = parameters.tol_dj = 1e-10;
    const bool solved = glp_simplex(lp, &parameters) == 0 && glp_get_status(lp) == GLP_OPT;
    std::vector<double> out;
    for (int k = 1; k <= unknowns; ++k) out.push_back(glp_get_col_prim(lp, k));
    bound = glp_get_col_prim(lp, error);
    glp_delete_prob(lp);
    if (!solved) throw undetermined();
    return out;
}

std::vector<double> by_minimax(const FitRequest& request, const Problem& problem) {
    // A programme of all rows would be large; only a few bind. So: solve for some, add the worst of the others, until
    // none exceeds the optimum of the rows at hand, which is a lower bound of that of all.
    constexpr std::size_t added = 32;
    constexpr double tolerance = 1e-6;  // relative
    struct Candidate {
        double excess;
        Row row;
    };
    std::vector<std::vector<Row>> all;  // by n
    int last_n = -1;
    for_each_row(request, problem, [&](int n, std::size_t, double x, double y) {
        if (n != last_n) all.emplace_back();
        last_n = n;
        all.back().push_back({x, y});
    });
    std::vector<Row> rows;  // at first some that are spread out, so that the programme is well posed
    for (std::size_t k = 0; k < all.size(); k += std::max<std::size_t>(1, all.size() / 8)) {
        for (std::size_t i = 0; i < all[k].size(); i += std::max<std::size_t>(1, all[k].size() / 64)) {
            rows.push_back(all[k][i]);
        }
    }
    double bound = 0.0;
    std::vector<double> solution = linear_programme(problem, rows, bound);
    for (int round = 0; round < 100; ++round) {
        std::vector<Candidate> worst;  // of each n, above and below
        for (const std::vector<Row>& of_n : all) {
            Candidate above{0.0, {}}, below{0.0, {}};
            for (const Row& row : of_n) {
                const double error = value(problem, solution, row.x) - row.y;
                if (error > above.excess) above = {error, row};
                if (-error > below.excess) below = {-error, row};
            }
            worst.push_back(above);
            worst.push_back(below);
        }
        const std::size_t count = std::min(worst.size(), added);
        std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(count), worst.end(),
                          [](const Candidate& a, const Candidate& b) { return a.excess > b.excess; });
        if (worst[0].excess <= bound * (1.0 + tolerance)) return solution;
        for (std::size_t i = 0; i < count; ++i) rows.push_back(worst[i].row);
        solution = linear_programme(problem, rows, bound);
    }
    throw Error("minimax did not converge in 100 rounds");
}

#endif

}  // namespace

Variable parse_variable(std::string_view text) {
    if (text == "schlick") return Variable::schlick;
    if (text == "symmetric") return Variable::symmetric;
    throw Error(fmt::format("variable '{}' is not legal: schlick or symmetric", text));
}

std::string_view name(Variable variable) { return variable == Variable::schlick ? "schlick" : "symmetric"; }

double variable_value(Variable variable, double c, double n) {
    return variable == Variable::schlick ? c / (c + n * (1.0 - c)) : (1.0 + c) / ((1.0 + c) + 2.0 * n * (1.0 - c));
}

FitMethod parse_fit_method(std::string_view text) {
    if (text == "least-squares") return FitMethod::normal_equations;
    if (text == "qr") return FitMethod::qr;
    if (text == "minimax") return FitMethod::minimax;
    throw Error(fmt::format("method '{}' is not legal: least-squares, qr or minimax", text));
}

std::string_view name(FitMethod method) {
    switch (method) {
        case FitMethod::normal_equations:
            return "least-squares";
        case FitMethod::qr:
            return "qr";
        case FitMethod::minimax:
            return "minimax";
    }
    return "";
}

std::size_t RealRange::size() const {
    // A last value that the step reaches but for rounding is in.
    return last < first ? 0 : static_cast<std::size_t>(std::floor((last - first) / step * (1.0 + 1e-12) + 1e-9)) + 1;
}

RealRange parse_real_range(std::string_view text, std::string_view what, double low, double high) {
    const auto refuse = [&] {
        return Error(
            fmt::format("{} '{}' is not legal: a number or first:last:step, within {} to {}", what, text, low, high));
    };
    std::vector<double> numbers;
    for (std::string_view rest = text;;) {
        const std::string_view field = rest.substr(0, rest.find(':'));
        double number = 0.0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
        if (error != std::errc{} || end != field.data() + field.size() || numbers.size() == 3) throw refuse();
        numbers.push_back(number);
        if (field.size() == rest.size()) break;
        rest.remove_prefix(field.size() + 1);
    }
    if (numbers.size() == 2) throw refuse();
    const RealRange out{numbers[0], numbers.size() > 1 ? numbers[1] : numbers[0],
                        numbers.size() > 1 ? numbers[2] : 1.0};
    // Written so that NaN is refused.
    const bool legal = out.first >= low && out.last <= high && out.last >= out.first && out.step > 0.0;
    if (!legal || !((out.last - out.first) / out.step <= 1e6)) throw refuse();
    return out;
}

bool has_minimax() {
#ifdef GLINT_GLPK
    return true;
#else
    return false;
#endif
}

Fit fit(const FitRequest& request) {
    if (request.degree < 1 || request.degree > 8) {
        throw Error(fmt::format("degree {} is not legal: 1 to 8", request.degree));
    }
    const Problem problem(request);
    if (problem.unknowns() == 0) throw Error("degree 1 with both constraints leaves nothing to fit: at least 2");
    if (request.n.size() == 0 || request.theta.size() == 0) throw Error("fit of 0 rows is not legal: at least 1");
    std::vector<double> solution;
    switch (request.method) {
        case FitMethod::normal_equations:
            solution = by_normal_equations(request, problem);
            break;
        case FitMethod::qr:
            solution = by_qr(request, problem);
            break;
        case FitMethod::minimax:
#ifdef GLINT_GLPK
            solution = by_minimax(request, problem);
            break;
#else
            throw Error("method 'minimax' is not in this build: it needs GLPK (package libglpk-dev)");
#endif
    }
    Fit out;
    out.coefficients = problem.powers(solution);
    double squares = 0.0;
    for_each_row(request, problem, [&](int n, std::size_t i, double x, double y) {
        const double error = std::abs(value(problem, solution, x) - y);
        squares += error * error;
        ++out.rows;
        if (error > out.largest) {
            out.largest = error;
            out.largest_n = n;
            out.largest_theta = request.theta[i];
        }
    });
    out.rms = std::sqrt(squares / static_cast<double>(out.rows));
    return out;
}

}  // namespace glint
