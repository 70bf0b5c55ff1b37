#include "studies/paper2_data.hpp"

#include <algorithm>
#include <cmath>

#include "studies/curves.hpp"

namespace glint::studies {
namespace {

constexpr int points = 901;

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

}  // namespace glint::studies
