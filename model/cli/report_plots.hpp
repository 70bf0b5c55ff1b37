// The plots of the report: every one in a light and a dark version, for wide and for narrow screens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report_data.hpp"
#include "report_gnuplot.hpp"
#include "report_results.hpp"

namespace glint::cli {

inline constexpr std::string_view themes[] = {"light", "dark"};
inline constexpr std::string_view layouts[] = {"wide", "narrow"};

/// One plot of the page. Its pictures are called "<name>-<theme>-<layout>.<extension>".
struct Plot {
    std::string_view name;
    std::string_view extension;

    std::string file(std::string_view theme, std::string_view layout) const;
};
inline constexpr Plot curves_plot{"curves", "svg"};
inline constexpr Plot map_plot{"map", "png"};
inline constexpr Plot approximation_plot{"approximation", "svg"};
inline constexpr Plot rounding_plot{"rounding", "svg"};

/// The name of the picture for a README: the curves beside the approximation error.
std::string overview_file(std::string_view theme);

struct PlotData {
    Curves curves;
    ErrorMap map;
    std::vector<AngleError> schlick;    ///< for n = 1 .. max_n
    std::vector<MeasuredRun> measured;  ///< with rows; empty: no plots over n
};

/// All pictures by file name. Throws Error as run_gnuplot does.
Pictures draw(const PlotData& data);

}  // namespace glint::cli
