#include "glint/paper2.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "counted.hpp"

namespace glint::paper2 {
namespace {

using formulas::one;
using std::numbers::pi;

struct Vector {
    Counted x, y, z;
};

Vector vector(const std::array<double, 3>& a) { return {{a[0]}, {a[1]}, {a[2]}}; }
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(Counted k, Vector a) { return {k * a.x, k * a.y, k * a.z}; }
Counted dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector normalised(Vector a) { return (Counted{1.0} / square_root(dot(a, a))) * a; }
Counted square(Counted a) { return a * a; }

/// The formulas of the paper, with the functions that a shader has. Coefficients and intensities are counted as the
/// products that they are.
struct Models {
    explicit Models(const Scene& s, const Material& material)
        : N(vector(s.N)), L(vector(s.L)), V(vector(s.V)), T(vector(s.T)), B(vector(s.B)), m(material) {}

    Vector N, L, V, T, B;
    Material m;
    Counted ambient{0.0}, diffuse{1.0}, specular{1.0};

    Counted phong() const {
        const Counted nl = dot(N, L);
        const Vector R = (Counted{2.0} * nl) * N - L;
        return ambient + diffuse * at_least_0(nl) + specular * power(at_least_0(dot(R, V)), Counted{m.exponent});
    }

    Counted blinn_phong() const {
        const Vector H = normalised(L + V);
        return ambient + diffuse * at_least_0(dot(N, L)) + specular * power(at_least_0(dot(H, N)), Counted{m.exponent});
    }

    struct Cosines {
        Counted nl, nv, nh, vh;
    };
    Cosines cosines() const {
        const Vector H = normalised(L + V);
        return {dot(N, L), dot(N, V), dot(N, H), dot(V, H)};
    }

    Counted cook_torrance(const Cosines& c, Counted F, Counted D) const {
        const Counted edge = Counted{2.0} * c.nh / c.vh;
        const Counted G = lesser(Counted{1.0}, lesser(edge * c.nv, edge * c.nl));
        const Counted Rs = F * D * G / (Counted{pi} * c.nl * c.nv);
        return ambient + c.nl * (specular * Rs + diffuse);
    }

    Counted cook_torrance() const {
        const Cosines c = cosines();
        const Counted g = square_root(Counted{m.index * m.index - 1.0} + square(c.vh));
        const Counted plus = g + c.vh, minus = g - c.vh;
        const Counted F =
            Counted{0.5} * square(minus / plus) * (square((c.vh * plus - one) / (c.vh * minus + one)) + one);
        const Counted square_half = square(c.nh);
        const Counted tangent_square = (Counted{1.0} - square_half) / square_half;
        const Counted D = exponential(Counted{-1.0 / (m.roughness * m.roughness)} * tangent_square) /
                          (Counted{m.roughness * m.roughness} * square(square_half));
        return cook_torrance(c, F, D);
    }

    /// The cubic / m^2 by Horner's rule in its own variable, x in units of its end.
    Counted modified(const cook_torrance::Cubic& cubic, double reflectance) const {
        const Cosines c = cosines();
        const bool angle = cubic.variable == cook_torrance::Variable::angle;
        const Counted variable = angle ? arc_cosine(c.nh) : Counted{1.0} - c.nh;
        const double scale = 1.0 / (m.roughness * m.roughness);
        std::array<double, 4> k = cubic.coefficients;
        for (std::size_t i = 0; i < k.size(); ++i) k[i] *= scale / std::pow(cubic.end, static_cast<double>(i));
        const Counted polynomial =
            Counted{k[0]} + variable * (Counted{k[1]} + variable * (Counted{k[2]} + variable * Counted{k[3]}));
        const Counted D = variable < Counted{cubic.end} ? at_least_0(polynomial) : Counted{0.0};
        return cook_torrance(c, Counted{reflectance}, D);
    }

    Counted ward() const {
        const Vector H = normalised(L + V);
        const Counted nl = dot(N, L), nv = dot(N, V);
        const Counted x = dot(H, T) * Counted{1.0 / m.alpha_x}, y = dot(H, B) * Counted{1.0 / m.alpha_y};
        const Counted exponent = Counted{-2.0} * (square(x) + square(y)) / (dot(H, N) + one);
        const Counted spec = exponential(exponent) / (Counted{4.0 * pi * m.alpha_x * m.alpha_y} * square_root(nl * nv));
        return nl * (diffuse + specular * spec);
    }

    double A() const { return 1.0 - 0.5 * m.roughness * m.roughness / (m.roughness * m.roughness + 0.33); }
    double B_() const { return 0.45 * m.roughness * m.roughness / (m.roughness * m.roughness + 0.09); }

    Counted oren_nayar() const {
        const Counted nl = dot(N, L), nv = dot(N, V);
        const Counted incident = arc_cosine(nl), reflected = arc_cosine(nv);
        const Counted azimuth = dot(normalised(V - nv * N), normalised(L - nl * N));
        const Counted product =
            at_least_0(azimuth) * sine(greater(incident, reflected)) * tangent(lesser(incident, reflected));
        return diffuse * nl * (Counted{A()} + Counted{B_()} * product);
    }

    Counted oren_nayar_without_trigonometry() const {
        const Counted nl = dot(N, L), nv = dot(N, V);
        const Counted q = dot(L, V) - nl * nv;
        const Counted product = at_least_0(q) / greater(nl, nv);
        return diffuse * nl * (Counted{A()} + Counted{B_()} * product);
    }
};

template <class Evaluate>
CountedModel counted(std::string_view model, std::string_view form, bool printed, Evaluate evaluate) {
    CountedModel out{model, form, printed, {}, 0.0};
    out.operations = count([&] { out.value = evaluate().x; });
    return out;
}

}  // namespace

std::span<const TableRow> table() {
    static const std::vector<TableRow> rows{
        {"Phong", 32, 640e6}, {"Blinn-Phong", 30, 640e6}, {"Cook-Torrance", 113, 200e6},
        {"Ward", 62, 320e6},  {"Oren-Nayar", 86, 320e6},
    };
    return rows;
}

std::vector<CountedModel> counted_models(const Scene& scene, const Material& material) {
    const Models models(scene, material);
    const auto angle = cook_torrance::fit_beckmann(material.roughness, cook_torrance::Variable::angle);
    const auto half = cook_torrance::fit_beckmann(material.roughness, cook_torrance::Variable::half);
    const double reflectance = cook_torrance::mean_fresnel(material.index);
    return {
        counted("Phong", "kd N.L + ks (R.V)^n", true, [&] { return models.phong(); }),
        counted("Blinn-Phong", "kd N.L + ks (N.H)^n", true, [&] { return models.blinn_phong(); }),
        counted("Cook-Torrance", "N.L (s F D G / (pi N.L N.V) + d)", true, [&] { return models.cook_torrance(); }),
        counted("Ward", "N.L (d + s exp(...) / (4 pi ax ay sqrt(N.L N.V)))", true, [&] { return models.ward(); }),
        counted("Oren-Nayar", "N.L (A + B max(0, cos phi) sin alpha tan beta)", true,
                [&] { return models.oren_nayar(); }),
        counted("Oren-Nayar, no trigonometry", "N.L (A + B max(0, q) / max(N.L, N.V))", false,
                [&] { return models.oren_nayar_without_trigonometry(); }),
        counted("modified Cook-Torrance", "D a cubic of the angle, F a constant", false,
                [&] { return models.modified(angle, reflectance); }),
        counted("modified Cook-Torrance, N.H", "D a cubic of N.H, F a constant", false,
                [&] { return models.modified(half, reflectance); }),
    };
}

int total(const Operations& o) {
    return o.multiplications + o.divisions + o.additions + o.increments + o.comparisons + o.calls;
}

int pairs_in_order(std::span<const CountedModel> models) {
    const auto count_of = [&](std::string_view name) {
        const auto found = std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.model == name; });
        return found == models.end() ? 0 : total(found->operations);
    };
    const auto rows = table();
    int out = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = i + 1; k < rows.size(); ++k) {
            const int a = count_of(rows[i].model), b = count_of(rows[k].model);
            if (a != b && (a < b) == (rows[i].instructions < rows[k].instructions)) ++out;
        }
    }
    return out;
}

DistributionFigure figure_1(double m, int points) {
    DistributionFigure out;
    out.m = m;
    out.angle = cook_torrance::fit_beckmann(m, cook_torrance::Variable::angle);
    out.half = cook_torrance::fit_beckmann(m, cook_torrance::Variable::half);
    for (int k = 0; k < points; ++k) {
        const double angle = 0.5 * pi * k / (points - 1);
        const double nh = std::cos(angle);
        out.x.push_back(angle);
        out.distribution.push_back(m * m * cook_torrance::beckmann(nh, m));
        out.angle_cubic.push_back(out.angle(nh));
        out.half_cubic.push_back(out.half(nh));
    }
    return out;
}

ReflectanceFigure figure_2(double index, int points) {
    ReflectanceFigure out;
    out.index = index;
    out.mean = cook_torrance::mean_fresnel(index);
    double least = 1.0;
    for (int k = 0; k < points; ++k) {
        const double vh = static_cast<double>(k) / (points - 1);
        const double reflectance = cook_torrance::fresnel(vh, index);
        out.x.push_back(vh);
        out.reflectance.push_back(reflectance);
        least = std::min(least, reflectance);
        if (vh >= 0.4 && out.mean > 0.0) out.largest = std::max(out.largest, std::abs(reflectance / out.mean - 1.0));
    }
    const double fall = out.reflectance.front() - least;
    if (fall > 0.0) out.steep = (out.reflectance.front() - cook_torrance::fresnel(0.4, index)) / fall;
    return out;
}

HighlightFigure highlight_figure(double n, int points) {
    HighlightFigure out;
    out.n = n;
    out.phong_width = std::acos(std::pow(0.5, 1.0 / n));
    out.blinn_phong_width = 2.0 * out.phong_width;
    out.equal_width = std::log(0.5) / std::log(std::cos(0.5 * out.phong_width));
    for (int k = 0; k < points; ++k) {
        const double angle = 0.5 * pi * k / (points - 1);
        const double rv = std::max(0.0, std::cos(angle)), nh = std::cos(0.5 * angle);
        out.x.push_back(angle);
        out.phong.push_back(std::pow(rv, n));
        out.blinn_phong.push_back(std::pow(nh, n));
        out.blinn_phong_4n.push_back(std::pow(nh, 4.0 * n));
        out.largest = std::max(out.largest, std::abs(out.blinn_phong_4n.back() - out.phong.back()));
    }
    return out;
}

Likeness likeness(double m, double index, double light) {
    Likeness out{m, index, light};
    const auto cubic = cook_torrance::fit_beckmann(m, cook_torrance::Variable::half);
    const double reflectance = cook_torrance::mean_fresnel(index);
    constexpr int steps = 1000;
    double peak = 0.0, sum = 0.0;
    for (int k = 1; k < steps; ++k) {
        // In the plane of incidence the half vector is halfway: the viewer at -light sees the mirror's highlight.
        const double viewer = pi * k / steps - 0.5 * pi;
        const double nl = std::cos(light), nv = std::cos(viewer);
        const double nh = std::cos(0.5 * (light + viewer)), vh = std::cos(0.5 * (light - viewer));
        const double full = cook_torrance::term(nl, nv, nh, vh, m, index);
        const double difference = std::abs(cook_torrance::modified_term(nl, nv, nh, vh, cubic, reflectance) - full);
        peak = std::max(peak, full);
        sum += difference * difference;
        if (difference > out.largest) {
            out.largest = difference;
            out.largest_angle = viewer;
        }
    }
    if (peak == 0.0) return out;
    out.largest /= peak;
    out.rms = std::sqrt(sum / (steps - 1)) / peak;
    return out;
}

}  // namespace glint::paper2
