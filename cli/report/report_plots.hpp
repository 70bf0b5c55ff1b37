// The plots of the report.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/report/report_results.hpp"
#include "cost/plots.hpp"
#include "io/gnuplot.hpp"
#include "io/theme.hpp"
#include "studies/report_data.hpp"
#include "studies/report_paper.hpp"
#include "studies/report_paper2.hpp"

namespace glint::cli {

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
    PaperData paper;
    Paper2Data paper2;
    std::optional<cost::PlotData> cost;  ///< none: no plots of cost
};

/// All pictures by file name. Throws Error as run_gnuplot does.
Pictures draw(const PlotData& data);

}  // namespace glint::cli
