// The lobe `cubic`: docs/lobes/cubic.md.

#include <cmath>

#include "lobe.hpp"

namespace glint {
namespace {

using Real = long double;

/// The cubic in t = n (1 - c) through 1 at c = 1, 1/2 and 1/18 at the cosines where c^n is that, and 0 at c = 0:
/// 1 + t (g1 + t (g2 + t g3)), and the t of its local minimum, from which on the lobe is 0.
struct Coefficients {
    Real g1 = 0, g2 = 0, g3 = 0;
    Real minimum = 0;  ///< infinite for n <= 3, where the cubic is c^n itself
};

Coefficients coefficients(Real n) {
    if (n <= 3) {
        return {-1.0L, n == 1 ? 0.0L : n == 2 ? 0.25L : 1.0L / 3.0L, n == 3 ? -1.0L / 27.0L : 0.0L, HUGE_VALL};
    }
    // Divided differences over the nodes 0, a, b, n; a and b are n (1 - 2^(-1/n)) and n (1 - 18^(-1/n)).
    const Real a = -n * std::expm1(-std::log(2.0L) / n);
    const Real b = -n * std::expm1(-std::log(18.0L) / n);
    const Real first = -0.5L / a;
    const Real second = (1.0L / 18.0L - 0.5L) / (b - a);
    const Real third = (-1.0L / 18.0L) / (n - b);
    const Real first_second = (second - first) / b;
    const Real second_third = (third - second) / (n - a);
    Coefficients k;
    k.g3 = (second_third - first_second) / n;
    k.g2 = first_second - k.g3 * (a + b);
    k.g1 = first - first_second * a + k.g3 * a * b;
    // The smaller root of g1 + 2 g2 t + 3 g3 t^2; g1 and g3 are below 0, g2 above.
    k.minimum = -k.g1 / (k.g2 + std::sqrt(k.g2 * k.g2 - 3.0L * k.g1 * k.g3));
    return k;
}

/// What real(), which is called for every input, needs, for every integer n.
struct RealTable {
    double g1[max_n + 1], g2[max_n + 1], g3[max_n + 1], minimum[max_n + 1];
};
const RealTable& real_table() {
    static const RealTable table = [] {
        RealTable out{};
        for (int n = 1; n <= max_n; ++n) {
            const Coefficients k = coefficients(n);
            out.g1[n] = static_cast<double>(k.g1);
            out.g2[n] = static_cast<double>(k.g2);
            out.g3[n] = static_cast<double>(k.g3);
            out.minimum[n] = static_cast<double>(k.minimum / n);
        }
        return out;
    }();
    return table;
}

double cubic_at(double d, double n, double g1, double g2, double g3, double minimum) {
    if (d >= minimum) return 0.0;
    const double t = n * d;
    return std::max(0.0, 1.0 + t * (g1 + t * (g2 + t * g3)));
}

/// For any n >= 1. Between 1, 2 and 3 there is no such cubic in the paper's sense; the formula serves all the same.
double cubic_reference(double c, double n) {
    return reference::with_domain(c, n, [](double x, double m) {
        if (std::isinf(m)) return x == 1.0 ? 1.0 : 0.0;
        const Coefficients k = coefficients(m);
        return cubic_at(1.0 - x, m, static_cast<double>(k.g1), static_cast<double>(k.g2), static_cast<double>(k.g3),
                        static_cast<double>(k.minimum / m));
    });
}

struct Row {
    std::int64_t cut = 0, g1 = 0, g2 = 0, g3 = 0;
};

struct CubicFormat {
    static constexpr std::string_view lobe = "cubic";
    int F = 0;              ///< fraction bits of the cosine
    int S = 0;              ///< fraction bits of T
    int K = 0;              ///< fraction bits of the coefficients
    int O = 0;              ///< fraction bits of the output
    std::vector<Row> rows;  ///< by n

    struct Steps {
        std::int64_t X = 0, T = 0, h2 = 0, h1 = 0, y = 0;
    };

    // X < cut means n X <= 3 2^F, so T <= 3 2^S: T < 4, h2 in 0 .. 0.34, h1 in -1 .. 0, 1 + h1 T in -0.01 .. 1.
    // The largest product is h1 T, below 2^(K + S + 2) <= 2^62.
    Steps steps(int n, std::int64_t C) const {
        Steps x;
        const Row& row = rows[static_cast<std::size_t>(n)];
        x.X = (std::int64_t{1} << F) - C;
        const bool cut = x.X >= row.cut;
        x.T = cut ? 0 : rnd(n * x.X, F - S);
        x.h2 = row.g2 + rnd(row.g3 * x.T, S);
        x.h1 = row.g1 + rnd(x.h2 * x.T, S);
        const std::int64_t one = std::int64_t{1} << (K + S);
        x.y = cut ? 0 : std::max<std::int64_t>(0, rnd(one + x.h1 * x.T, K + S - O));
        return x;
    }

    std::vector<Intermediate> named(std::int64_t C, const Steps& x) const {
        return {{"C", C, F}, {"X", x.X, F}, {"T", x.T, S}, {"h2", x.h2, K}, {"h1", x.h1, K}, {"y", x.y, O}};
    }

    double real(double c, double n) const {
        const RealTable& k = real_table();
        const auto i = static_cast<std::size_t>(n);
        return cubic_at(1.0 - c, n, k.g1[i], k.g2[i], k.g3[i], k.minimum[i]);
    }
};

std::vector<int> cubic_numbers(int F, int O) { return {F, O + 4, O + 6, O}; }

CubicFormat cubic_format(const Profile& profile) {
    CubicFormat f{.F = profile.F, .O = profile.O, .rows = {}};
    if (!profile.shipped()) check_custom(profile, "cubic", "F,S,K,O");
    const std::vector<int> numbers = profile.shipped() ? cubic_numbers(profile.F, profile.O) : profile.custom;
    f.S = in_range("cubic", "S", numbers[1], f.O, f.F);
    f.K = in_range("cubic", "K", numbers[2], f.O, 30);
    const auto code = [&](Real x) { return static_cast<std::int64_t>(std::round(std::ldexp(x, f.K))); };
    for (int n = 0; n <= max_n; ++n) {
        const Coefficients k = coefficients(std::max(n, 1));
        Row row{(std::int64_t{1} << f.F) + 1, code(k.g1), code(k.g2), code(k.g3)};
        if (n > 3) row.cut = static_cast<std::int64_t>(std::ceil(std::ldexp(k.minimum / n, f.F)));
        f.rows.push_back(row);
    }
    return f;
}

std::vector<GeneratedFile> emit_cubic(const Profile& profile, const Architecture& architecture) {
    const CubicFormat f = cubic_format(profile);
    Table table{"row",
                {{"cut", f.F + 1}, {"g1", f.K + 1}, {"g2", f.K}, {"g3", f.K - 3}},
                {},
                fmt::format("cubic_{}_{}", f.F, f.K)};
    for (const Row& row : f.rows) table.rows.push_back({row.cut, row.g1, row.g2, row.g3});
    const auto text = [](int x) { return std::to_string(x); };
    auto files = generated_sources(
        "cubic", profile, architecture,
        {{block::ports(), block::rounded(), block::rounded(), block::rounded(), block::rounded()}, {"glint_delay"}},
        {{"F", text(f.F), ""}, {"S", text(f.S), ""}, {"K", text(f.K), ""}, {"O", text(f.O), ""}},
        {{"int F", text(f.F), "fraction bits of the cosine"},
         {"int S", text(f.S), "fraction bits of T"},
         {"int K", text(f.K), "fraction bits of the coefficients"},
         {"int O", text(f.O), "fraction bits of the output"}},
        {table});
    files.push_back(gappa_script("cubic", profile, fmt::format("F, S, K, O: {}, {}, {}, {}", f.F, f.S, f.K, f.O),
                                 fmt::format(R"(
# A name here has the meaning of docs/lobes/cubic.md, but stands for the value, not the code: t is n X / 2^F, T its
# rounding to S bits, g1 .. g3 are the coefficients of some n, g1_K .. g3_K their roundings to K bits; y is before the
# cut of what is below 0, which brings no two numbers further apart. Where X >= cut, y and the real function are both 0.
# The ranges of the coefficients, and that t <= 3 where it counts, are those of the table: a unit test reads them there.
#@-Wno-null-denominator

@rnd_S = fixed<-{S}, nu>;
@rnd_K = fixed<-{K}, nu>;
@rnd_O = fixed<-{O}, nu>;

g1_K = rnd_K(g1);
g2_K = rnd_K(g2);
g3_K = rnd_K(g3);

T = rnd_S(t);
product_1 = g3_K * T;
h2 = g2_K + rnd_K(product_1);
product_2 = h2 * T;
h1 = g1_K + rnd_K(product_2);
product_3 = h1 * T;
sum_3 = 1 + product_3;
y = rnd_O(sum_3);

# The real function, at t and at T.
P = ((g3 * t + g2) * t + g1) * t + 1;
h2_real = g3 * T + g2;
h1_real = h2_real * T + g1;
P_T = h1_real * T + 1;
error = (y - P) * 1b{O};

{{ t in [0, 3] /\ g1 in [-1, -0.84] /\ g2 in [0, 0.3334] /\ g3 in [-0.0371, 0] ->
  T in [0, 3] /\ product_1 in [-0.2, 0] /\ h2 in [-0.25, 0.5] /\ product_2 in [-0.75, 1.25] /\ h1 in [-1.75, 0.25] /\
  product_3 in [-6, 1] /\ sum_3 in [-6, 2] /\
  T in ? /\ product_1 in ? /\ h2 in ? /\ product_2 in ? /\ h1 in ? /\ product_3 in ? /\ sum_3 in ? /\ error in ? }}

# One term for each rounding.
y - P -> (y - sum_3) + (h1 - h1_real) * T + (P_T - P);
h1 - h1_real -> (rnd_K(product_2) - product_2) + (g1_K - g1) + (h2 - h2_real) * T;
h2 - h2_real -> (rnd_K(product_1) - product_1) + (g2_K - g2) + (g3_K - g3) * T;
P_T - P -> (T - t) * (g3 * (T * T + T * t + t * t) + g2 * (T + t) + g1);

error $ t in 64;
)",
                                             fmt::arg("S", f.S), fmt::arg("K", f.K), fmt::arg("O", f.O))));
    return files;
}

std::vector<HardCase> cubic_hard_cases(const GoldenModel& model) {
    std::vector<HardCase> cases = common_hard_cases(model);
    const int one = model.profile().one();
    const CubicFormat f = cubic_format(model.profile());
    for (const int n : {4, 50, 1023}) {
        const auto cut = static_cast<std::int32_t>(f.rows[static_cast<std::size_t>(n)].cut);
        cases.push_back({fmt::format("last before the cut, n = {}", n), n, one - cut + 1,
                         "next to the local minimum, which is above 0: the result jumps to 0"});
        cases.push_back({fmt::format("first in the cut, n = {}", n), n, one - cut,
                         "beyond it the cubic grows again, to 3.6e5 at n = 1000"});
    }
    cases.push_back({"n = 3, c = 1 ulp", 3, 1, "no cut for n <= 3: t reaches 3 and the result 0 by itself"});
    return cases;
}

}  // namespace

Lobe cubic_lobe() {
    return {"cubic",
            "A c^3 + B c^2 + C c through 1, 1/2 and 1/18 where c^n is that; 0 from its minimum on",
            "F,S,K,O",
            cubic_reference,
            make_plain<cubic_format>,
            emit_cubic,
            cubic_hard_cases,
            cubic_numbers};
}

}  // namespace glint
