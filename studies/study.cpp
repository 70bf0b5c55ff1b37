#include "studies/study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glint::studies {
namespace {

Summary summary(const std::vector<StudyRow>& rows, int first, int last, auto column) {
    Summary out;
    std::vector<double> values;
    for (const StudyRow& row : rows) {
        if (row.n < first || row.n > last) continue;
        if (std::isnan(column(row))) continue;
        values.push_back(column(row));
        if (values.back() > out.largest) {
            out.largest = values.back();
            out.n = row.n;
        }
    }
    if (values.empty()) return out;
    std::sort(values.begin(), values.end());
    out.median = (values[values.size() / 2] + values[(values.size() - 1) / 2]) / 2.0;
    return out;
}

}  // namespace

Summary Study::delta(int first, int last) const {
    return summary(rows, first, last, [](const StudyRow& row) { return row.delta.value; });
}

Summary Study::delta_stepped(int first, int last) const {
    return summary(rows, first, last, [](const StudyRow& row) { return row.delta_stepped.value; });
}

Summary Study::absolute(int first, int last) const {
    return summary(rows, first, last, [](const StudyRow& row) { return row.absolute.value; });
}

double epicentre_angle(double n) { return std::atan(1.0 / std::sqrt(n - 1.0)); }

Study study(const Lobe& lobe) {
    // A golden model knows the real function of its lobe, for whole spans at once.
    const auto model = lobe.golden(parse_profile("p12"));
    Study out{lobe.name, {}};
    for (int n = 1; n <= 1000; ++n) {
        const double edge = epicentre_angle(n);
        std::vector<double> theta;
        for (int i = 0; i <= 1000; ++i) theta.push_back(edge * i / 1000.0);
        const std::size_t zone = theta.size();
        const double steps = std::ceil(edge / paper_step);
        for (int i = 0; i <= static_cast<int>(steps); ++i) theta.push_back(i * paper_step);
        const std::size_t stepped = theta.size();
        const double far = std::min(std::numbers::pi / 2.0, 16.0 * edge);
        for (int i = 0; i <= 2000; ++i) theta.push_back(far * i / 2000.0);
        for (int i = 0; i <= 100; ++i) theta.push_back(std::numbers::pi / 2.0 * i / 100.0);
        std::vector<double> c(theta.size()), f(theta.size());
        for (std::size_t i = 0; i < c.size(); ++i) c[i] = std::max(0.0, std::cos(theta[i]));
        model->reference(n, c, f);
        StudyRow row{n, {}, {}, {}};
        for (std::size_t i = 0; i < c.size(); ++i) {
            const double exact = std::pow(c[i], n);
            const double error = std::abs(f[i] - exact);
            if (error > row.absolute.value) row.absolute = {error, theta[i]};
            if (i >= stepped) continue;
            Peak& delta = i < zone ? row.delta : row.delta_stepped;
            if (error / exact > delta.value) delta = {error / exact, theta[i]};
        }
        // Where a lobe is cut to 0 its error has a sharp peak: two finer looks around the largest one so far.
        double step = far / 2000.0;
        for (int look = 0; look < 2; ++look) {
            const double centre = row.absolute.theta;
            theta.clear();
            for (int i = -50; i <= 50; ++i) {
                theta.push_back(std::clamp(centre + i * step / 50.0, 0.0, std::numbers::pi / 2.0));
            }
            step /= 50.0;
            c.resize(theta.size());
            f.resize(theta.size());
            for (std::size_t i = 0; i < c.size(); ++i) c[i] = std::max(0.0, std::cos(theta[i]));
            model->reference(n, c, f);
            for (std::size_t i = 0; i < c.size(); ++i) {
                const double error = std::abs(f[i] - std::pow(c[i], n));
                if (error > row.absolute.value) row.absolute = {error, theta[i]};
            }
        }
        if (n == 1) row.delta = row.delta_stepped = {std::numeric_limits<double>::quiet_NaN(), edge};
        out.rows.push_back(row);
    }
    return out;
}

}  // namespace glint::studies
