#include "studies/curves.hpp"

#include <cmath>
#include <numbers>

#include "glint/fixed_point.hpp"
#include "glint/lobes.hpp"
#include "glint/reference.hpp"

namespace glint::studies {
namespace {

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }

void widen(AngleError& worst, double error, double degrees) {
    if (std::abs(error) > worst.value) worst = {std::abs(error), degrees};
}

}  // namespace

Curves curves(int n) {
    Curves out;
    out.n = n;
    for (int i = 0; i < angles; ++i) {
        const double degrees = i * degrees_per_angle;
        const double c = cosine(degrees);
        const Curves::Point point{degrees, reference::blinn_phong(c, n), reference::schlick(c, n),
                                  reference::bps(c, n)};
        widen(out.schlick, point.schlick - point.blinn_phong, degrees);
        widen(out.bps, point.bps - point.blinn_phong, degrees);
        out.points.push_back(point);
    }
    return out;
}

std::vector<AngleError> schlick_errors() {
    std::vector<AngleError> out(max_n);
    for (int i = 0; i < angles; ++i) {
        const double degrees = i * degrees_per_angle;
        const double c = cosine(degrees);
        for (int n = 1; n <= max_n; ++n) {
            widen(out[static_cast<std::size_t>(n - 1)], reference::schlick(c, n) - reference::blinn_phong(c, n),
                  degrees);
        }
    }
    return out;
}

double ErrorMap::log_n(std::size_t column) const {
    return std::log10(max_n) * static_cast<double>(column) / static_cast<double>(columns - 1);
}

double ErrorMap::log_degrees(std::size_t row) const {
    const double low = std::log10(least_degrees);
    return low + (std::log10(90.0) - low) * static_cast<double>(row) / static_cast<double>(rows - 1);
}

ErrorMap error_map(std::string_view profile) {
    ErrorMap out;
    out.profile = parse_profile(profile);
    out.error.resize(out.columns * out.rows);
    const auto model = find_lobe("bps").golden(out.profile);
    int last_n = 0;
    for (std::size_t column = 0; column < out.columns; ++column) {
        const int n = static_cast<int>(std::lround(std::pow(10.0, out.log_n(column))));
        if (n != last_n) out.inputs += out.rows;
        last_n = n;
        for (std::size_t row = 0; row < out.rows; ++row) {
            const double degrees = std::pow(10.0, out.log_degrees(row));
            const std::int32_t code = quantize_cosine(cosine(degrees), out.profile.F);
            const double y = std::ldexp(model->eval(n, code), -out.profile.O);
            const double error = y - reference::blinn_phong(std::ldexp(code, -out.profile.F), n);
            out.error[row * out.columns + column] = error;
            out.worst.merge({std::abs(error), n, code});
        }
    }
    return out;
}

}  // namespace glint::studies
