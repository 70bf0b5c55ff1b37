#include "studies/paper2.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/counted.hpp"
#include "studies/lighting.hpp"

namespace glint::studies::paper2 {
namespace {

using std::numbers::pi;

using Pixel = lighting::Pixel<Counted>;
using Uniforms = lighting::Uniforms<Counted>;

template <class Model>
CountedModel counted(const Pixel& pixel, const Uniforms& uniforms) {
    CountedModel out{Model::name, Model::title, Model::text, {}, 0.0};
    out.operations = count([&] { out.value = Model{}(pixel, uniforms).x; });
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

const TableRow* printed(std::string_view model) {
    const auto rows = table();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const TableRow& row) { return row.model == model; });
    return found == rows.end() ? nullptr : &*found;
}

std::vector<std::string_view> model_names() {
    return std::apply([](auto... model) { return std::vector<std::string_view>{decltype(model)::name...}; },
                      lighting::All{});
}

std::vector<CountedModel> counted_models(const Scene& scene, const Material& material) {
    const Pixel pixel(scene);
    const Uniforms uniforms(material);
    return std::apply(
        [&](auto... model) { return std::vector<CountedModel>{counted<decltype(model)>(pixel, uniforms)...}; },
        lighting::All{});
}

int total(const Operations& o) {
    return o.multiplications + o.divisions + o.additions + o.increments + o.comparisons + o.calls;
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

}  // namespace glint::studies::paper2
