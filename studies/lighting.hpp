// The lighting models of paper 2 as formulas over any number type, with the functions that a shader has: counted in
// paper2.cpp, timed in double and in float in bench/. Every intensity of a light and every coefficient is a factor or a
// summand of its own, as in a shader.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>

#include "glint/cook_torrance.hpp"
#include "studies/formulas.hpp"
#include "studies/paper2.hpp"

namespace glint::lighting {

using formulas::arc_cosine, formulas::at_least_0, formulas::exponential, formulas::greater, formulas::lesser,
    formulas::power, formulas::sine, formulas::square_root, formulas::tangent;
using formulas::number, formulas::one, formulas::square;

template <class Number>
struct Vector {
    Number x, y, z;

    friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector operator*(Number k, const Vector& a) { return {k * a.x, k * a.y, k * a.z}; }
    friend Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend Vector normalised(const Vector& a) { return (Number{1.0} / square_root(dot(a, a))) * a; }
};

/// Unit vectors, which differ from pixel to pixel. Legal: N.L > 0, N.V > 0; L, V and N no two alike.
template <class Number>
struct Pixel {
    Vector<Number> N, L, V;
    Vector<Number> T, B;  ///< tangents

    explicit Pixel(const studies::paper2::Scene& s) : N(of(s.N)), L(of(s.L)), V(of(s.V)), T(of(s.T)), B(of(s.B)) {}

private:
    static Vector<Number> of(const std::array<double, 3>& a) {
        return {number<Number>(a[0]), number<Number>(a[1]), number<Number>(a[2])};
    }
};

/// A cubic for D by Horner's rule in its own variable, with the factor 1 / m^2.
template <class Number>
struct Distribution {
    std::array<Number, 4> coefficients;
    Number end;

    explicit Distribution(const cook_torrance::Cubic& cubic) : end(number<Number>(cubic.end)) {
        for (std::size_t i = 0; i < coefficients.size(); ++i) {
            coefficients[i] = number<Number>(cubic.coefficients[i] / (cubic.m * cubic.m) /
                                             std::pow(cubic.end, static_cast<double>(i)));
        }
    }
    Number operator()(Number variable) const {
        const auto& k = coefficients;
        const Number polynomial = k[0] + variable * (k[1] + variable * (k[2] + variable * k[3]));
        return variable < end ? at_least_0(polynomial) : Number{0.0};
    }
};

/// What is the same for all pixels: intensities of the light, and what depends on the material alone.
template <class Number>
struct Uniforms {
    Number ambient{0.0}, diffuse{1.0}, specular{1.0};
    Number exponent;                         ///< of Phong and Blinn-Phong
    Number square_m, minus_inverse, excess;  ///< of Cook-Torrance: m^2, -1 / m^2, Ni^2 - 1
    Number reflectance;                      ///< of the modified form
    Distribution<Number> angle, half;        ///< of the modified form, in the angle and in 1 - N.H
    Number inverse_x, inverse_y, scale;      ///< of Ward: 1 / ax, 1 / ay, 4 pi ax ay
    Number A, B;                             ///< of Oren-Nayar

    /// Throws Error unless the material is legal for Cook-Torrance.
    explicit Uniforms(const studies::paper2::Material& m)
        : exponent(number<Number>(m.exponent)),
          square_m(number<Number>(m.roughness * m.roughness)),
          minus_inverse(number<Number>(-1.0 / (m.roughness * m.roughness))),
          excess(number<Number>(m.index * m.index - 1.0)),
          reflectance(number<Number>(cook_torrance::mean_fresnel(m.index))),
          angle(cook_torrance::fit_beckmann(m.roughness, cook_torrance::Variable::angle)),
          half(cook_torrance::fit_beckmann(m.roughness, cook_torrance::Variable::half)),
          inverse_x(number<Number>(1.0 / m.alpha_x)),
          inverse_y(number<Number>(1.0 / m.alpha_y)),
          scale(number<Number>(4.0 * std::numbers::pi * m.alpha_x * m.alpha_y)),
          A(number<Number>(1.0 - 0.5 * m.roughness * m.roughness / (m.roughness * m.roughness + 0.33))),
          B(number<Number>(0.45 * m.roughness * m.roughness / (m.roughness * m.roughness + 0.09))) {}
};

// ---- the models --------------------------------------------------------------------------------------------------
// `name` is an identifier, `title` for people and as in studies::paper2::table(), `text` what is evaluated.

struct Lambert {
    static constexpr std::string_view name = "lambert", title = "Lambert", text = "kd N.L";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        return u.ambient + u.diffuse * at_least_0(dot(p.N, p.L));
    }
};

struct Phong {
    static constexpr std::string_view name = "phong", title = "Phong", text = "kd N.L + ks (R.V)^n";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Number nl = dot(p.N, p.L);
        const Vector<Number> R = (Number{2.0} * nl) * p.N - p.L;
        return u.ambient + u.diffuse * at_least_0(nl) + u.specular * power(at_least_0(dot(R, p.V)), u.exponent);
    }
};

struct BlinnPhong {
    static constexpr std::string_view name = "blinn_phong", title = "Blinn-Phong", text = "kd N.L + ks (N.H)^n";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Vector<Number> H = normalised(p.L + p.V);
        return u.ambient + u.diffuse * at_least_0(dot(p.N, p.L)) +
               u.specular * power(at_least_0(dot(H, p.N)), u.exponent);
    }
};

template <class Number>
struct Cosines {
    Number nl, nv, nh, vh;

    explicit Cosines(const Pixel<Number>& p) : Cosines(p, normalised(p.L + p.V)) {}

    /// The whole model with its reflectance F and distribution D.
    Number model(const Uniforms<Number>& u, Number F, Number D) const {
        const Number edge = Number{2.0} * nh / vh;
        const Number G = lesser(Number{1.0}, lesser(edge * nv, edge * nl));
        const Number Rs = F * D * G / (number<Number>(std::numbers::pi) * nl * nv);
        return u.ambient + nl * (u.specular * Rs + u.diffuse);
    }

private:
    Cosines(const Pixel<Number>& p, const Vector<Number>& H)
        : nl(dot(p.N, p.L)), nv(dot(p.N, p.V)), nh(dot(p.N, H)), vh(dot(p.V, H)) {}
};

struct CookTorrance {
    static constexpr std::string_view name = "cook_torrance", title = "Cook-Torrance",
                                      text = "N.L (s F D G / (pi N.L N.V) + d)";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Cosines<Number> c(p);
        const Number g = square_root(u.excess + square(c.vh));
        const Number plus = g + c.vh, minus = g - c.vh;
        const Number F =
            Number{0.5} * square(minus / plus) * (square((c.vh * plus - one) / (c.vh * minus + one)) + one);
        const Number square_half = square(c.nh);
        const Number tangent_square = (Number{1.0} - square_half) / square_half;
        const Number D = exponential(u.minus_inverse * tangent_square) / (u.square_m * square(square_half));
        return c.model(u, F, D);
    }
};

struct Ward {
    static constexpr std::string_view name = "ward", title = "Ward",
                                      text = "N.L (d + s exp(...) / (4 pi ax ay sqrt(N.L N.V)))";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Vector<Number> H = normalised(p.L + p.V);
        const Number nl = dot(p.N, p.L), nv = dot(p.N, p.V);
        const Number x = dot(H, p.T) * u.inverse_x, y = dot(H, p.B) * u.inverse_y;
        const Number exponent = Number{-2.0} * (square(x) + square(y)) / (dot(H, p.N) + one);
        const Number spec = exponential(exponent) / (u.scale * square_root(nl * nv));
        return nl * (u.diffuse + u.specular * spec);
    }
};

struct OrenNayar {
    static constexpr std::string_view name = "oren_nayar", title = "Oren-Nayar",
                                      text = "N.L (A + B max(0, cos phi) sin alpha tan beta)";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Number nl = dot(p.N, p.L), nv = dot(p.N, p.V);
        const Number incident = arc_cosine(nl), reflected = arc_cosine(nv);
        const Number azimuth = dot(normalised(p.V - nv * p.N), normalised(p.L - nl * p.N));
        const Number product =
            at_least_0(azimuth) * sine(greater(incident, reflected)) * tangent(lesser(incident, reflected));
        return u.diffuse * nl * (u.A + u.B * product);
    }
};

struct OrenNayarWithoutTrigonometry {
    static constexpr std::string_view name = "oren_nayar_no_trigonometry", title = "Oren-Nayar, no trigonometry",
                                      text = "N.L (A + B max(0, q) / max(N.L, N.V))";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Number nl = dot(p.N, p.L), nv = dot(p.N, p.V);
        const Number q = dot(p.L, p.V) - nl * nv;
        const Number product = at_least_0(q) / greater(nl, nv);
        return u.diffuse * nl * (u.A + u.B * product);
    }
};

struct ModifiedAngle {
    static constexpr std::string_view name = "modified_angle", title = "modified Cook-Torrance",
                                      text = "D a cubic of the angle, F a constant";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Cosines<Number> c(p);
        return c.model(u, u.reflectance, u.angle(arc_cosine(c.nh)));
    }
};

struct ModifiedHalf {
    static constexpr std::string_view name = "modified_half", title = "modified Cook-Torrance, N.H",
                                      text = "D a cubic of N.H, F a constant";
    template <class Number>
    Number operator()(const Pixel<Number>& p, const Uniforms<Number>& u) const {
        const Cosines<Number> c(p);
        return c.model(u, u.reflectance, u.half(Number{1.0} - c.nh));
    }
};

/// Lambert, to which the others are compared; the five of the paper's table; then variants.
using All = std::tuple<Lambert, Phong, BlinnPhong, CookTorrance, Ward, OrenNayar, OrenNayarWithoutTrigonometry,
                       ModifiedAngle, ModifiedHalf>;

}  // namespace glint::lighting
