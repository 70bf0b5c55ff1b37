#include "studies/paper_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "glint/reference.hpp"
#include "studies/curves.hpp"

namespace glint::studies {
namespace {

StudiedLobe studied(const Lobe& lobe) {
    StudiedLobe out{&lobe, study(lobe), lobe.reference(1.0, shape_n), lobe.reference(0.0, shape_n), {}};
    double before = 0.0;
    for (int i = 0; i < angles; ++i) {
        const double degrees = i * degrees_per_angle;
        const double f = i + 1 == angles ? out.floor : lobe.reference(std::cos(degrees * degree), shape_n);
        // At 90 degrees alone a lobe may well be 0.
        if (f == 0.0 && (out.zero || i + 1 < angles)) {
            if (!out.zero) out.zero = StudiedLobe::Zero{degrees, degrees, before};
            out.zero->to = degrees;
        }
        before = f;
    }
    return out;
}

/// `row_theta(n, fraction)` is the angle of a row, `fraction` being 0 at the first and 1 at the last one.
Surface surface(double first_n, const std::function<double(double, double)>& row_theta,
                const std::function<double(double, double)>& value) {
    Surface out;
    out.first_n = first_n;
    for (std::size_t column = 0; column < out.columns; ++column) {
        const double part = static_cast<double>(column) / static_cast<double>(out.columns - 1);
        out.n.push_back(first_n * std::pow(paper::last_n / first_n, part));
    }
    for (std::size_t row = 0; row < out.rows; ++row) {
        for (const double n : out.n) {
            const double theta = row_theta(n, static_cast<double>(row) / static_cast<double>(out.rows - 1));
            const double c = std::max(0.0, std::cos(theta));
            out.theta.push_back(theta);
            out.value.push_back(value(c, n));
            if (out.value.back() > out.largest) {
                out.largest = out.value.back();
                out.largest_n = n;
                out.largest_theta = theta;
            }
        }
    }
    return out;
}

/// From map_least_degrees to 90 degrees.
double log_row(double, double fraction) {
    return std::pow(90.0 / map_least_degrees, fraction) * map_least_degrees * degree;
}

double bps_error(double c, double n) { return std::abs(reference::bps(c, n) - std::pow(c, n)); }

}  // namespace

bool StudiedLobe::exact() const { return study.absolute(1, paper::last_n).largest < 1e-9; }

const StudiedLobe& PaperData::lobe(std::string_view name) const {
    return *std::find_if(lobes.begin(), lobes.end(), [&](const StudiedLobe& l) { return l.lobe->name == name; });
}

PaperData paper_data() {
    PaperData out;
    for (const paper::TableRow& row : paper::table_1()) out.lobes.push_back(studied(find_lobe(row.lobe)));
    out.of_paper = out.lobes.size();
    std::vector<const Lobe*> others;
    for (const Lobe& lobe : lobes()) {
        if (std::none_of(out.lobes.begin(), out.lobes.end(),
                         [&](const StudiedLobe& l) { return l.lobe->name == lobe.name; }))
            others.push_back(&lobe);
    }
    std::sort(others.begin(), others.end(), [](const Lobe* a, const Lobe* b) { return a->name < b->name; });
    for (const Lobe* lobe : others) out.lobes.push_back(studied(*lobe));

    out.highlight = surface(1.0, log_row, reference::bps);
    out.delta = surface(
        paper::first_n, [](double n, double fraction) { return fraction * epicentre_angle(n); },
        [](double c, double n) { return bps_error(c, n) / std::pow(c, n); });
    out.absolute = surface(paper::first_n, log_row, bps_error);
    return out;
}

}  // namespace glint::studies
