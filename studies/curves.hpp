// What the plots show beside the measured results: computed here, from the real functions and the golden model.
#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

#include "glint/accuracy.hpp"
#include "glint/profile.hpp"

namespace glint::studies {

/// The angles at which real functions are compared: 0 to 90 degrees, a hundred to the degree.
inline constexpr int angles = 9001;
inline constexpr double degrees_per_angle = 0.01;
inline constexpr double degree = std::numbers::pi / 180.0;  ///< in radians

/// The largest absolute error over all `angles`, against c^n, and where it lies.
struct AngleError {
    double value = 0.0;
    double degrees = 0.0;
};

/// f_b, f_s and f_bps over the angle at one n, in double.
struct Curves {
    struct Point {
        double degrees, blinn_phong, schlick, bps;
    };
    int n = 0;
    std::vector<Point> points;  ///< one per angle
    AngleError schlick;
    AngleError bps;
};
Curves curves(int n);

/// The largest absolute error of the real function f_s against c^n over all `angles`, for n = 1 .. max_n.
std::vector<AngleError> schlick_errors();

/// The least angle of maps whose angles are even in their logarithm.
inline constexpr double map_least_degrees = 0.25;

/// The signed error of golden `bps` against c^n at the rounded cosine, on a grid even in log n and in log angle.
struct ErrorMap {
    Profile profile;
    double least_degrees = map_least_degrees;
    std::size_t columns = 360;  ///< n from 1 to max_n, each rounded to an integer
    std::size_t rows = 240;     ///< angles from least_degrees to 90
    std::vector<double> error;  ///< row after row
    Worst worst;                ///< the largest absolute error in the map
    std::size_t inputs = 0;     ///< different pairs of n and angle

    double log_n(std::size_t column) const;
    double log_degrees(std::size_t row) const;
};
ErrorMap error_map(std::string_view profile);

}  // namespace glint::studies
