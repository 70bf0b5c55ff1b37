#include "studies/report_paper2.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace glint::studies {
namespace {

constexpr int points = 901;
constexpr double degree = std::numbers::pi / 180.0;

/// The light at 0.5 rad, the viewer at 0.4, neither in a plane with the other: no branch of the formulas is cut off.
paper2::Scene scene() {
    const auto at = [](double polar, double azimuth) {
        return std::array{std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
    };
    return {{0, 0, 1}, at(0.5, 0.2), at(0.4, 3.0), {1, 0, 0}, {0, 1, 0}};
}

}  // namespace

const paper2::CountedModel& Paper2Data::model(std::string_view name) const {
    return *std::find_if(models.begin(), models.end(), [&](const auto& m) { return m.model == name; });
}

Paper2Data paper2_data() {
    Paper2Data out;
    out.models = paper2::counted_models(scene(), {});
    for (const double m : {0.2, 0.4, 0.8}) out.distributions.push_back(paper2::figure_1(m, points));
    for (const double index : {1.33, 1.5, 2.5, 4.0}) out.reflectances.push_back(paper2::figure_2(index, points));
    out.highlight = paper2::highlight_figure(50.0, points);
    for (const double index : {1.5, 2.5, 4.0}) {
        for (const double m : {0.2, 0.4}) {
            for (const double light : {0.0, 30.0, 60.0}) {
                out.likeness.push_back(paper2::likeness(m, index, light * degree));
            }
        }
    }
    return out;
}

std::vector<FigureCsv> paper2_csvs(const Paper2Data& data) {
    std::string distributions = "theta_rad";
    for (const auto& figure : data.distributions) {
        distributions += fmt::format(",m2D_m{0:g},cubic_angle_m{0:g},cubic_half_m{0:g}", figure.m);
    }
    std::string reflectances = "vh";
    for (const auto& figure : data.reflectances) reflectances += fmt::format(",F_index{:g}", figure.index);
    std::string highlights = fmt::format("theta_rad,phong_n{0:g},blinn_phong_n{0:g},blinn_phong_n{1:g}\n",
                                         data.highlight.n, 4.0 * data.highlight.n);
    distributions += '\n';
    reflectances += '\n';
    for (std::size_t k = 0; k < points; ++k) {
        distributions += fmt::format("{:.6f}", data.distributions.front().x[k]);
        for (const auto& figure : data.distributions) {
            distributions += fmt::format(",{:.6f},{:.6f},{:.6f}", figure.distribution[k], figure.angle_cubic[k],
                                         figure.half_cubic[k]);
        }
        distributions += '\n';
        reflectances += fmt::format("{:.6f}", data.reflectances.front().x[k]);
        for (const auto& figure : data.reflectances) reflectances += fmt::format(",{:.6f}", figure.reflectance[k]);
        reflectances += '\n';
        const auto& h = data.highlight;
        highlights +=
            fmt::format("{:.6f},{:.6f},{:.6f},{:.6f}\n", h.x[k], h.phong[k], h.blinn_phong[k], h.blinn_phong_4n[k]);
    }
    return {{"paper-2-figure-1.csv", distributions},
            {"paper-2-figure-2.csv", reflectances},
            {"paper-2-phong.csv", highlights}};
}

}  // namespace glint::studies
