// The paper's figures 4 to 8 as plots.
#pragma once

#include "cli/report/rooms.hpp"

#include <string>
#include <vector>

#include "io/theme.hpp"
#include "studies/report_paper.hpp"

namespace glint::cli {

inline constexpr Plot figure_4{"figure-4", "png"};
inline constexpr Plot figure_5{"figure-5", "svg"};
inline constexpr Plot figure_6{"figure-6", "png"};
inline constexpr Plot figure_7{"figure-7", "svg"};
inline constexpr Plot figure_8{"figure-8", "png"};

/// Where the colours of figure 6 end; those of figure 8 end at map_scale.
inline constexpr double delta_scale_percent = 1.5;

/// A script for gnuplot, and the names of its pictures.
std::string paper_plots(const PaperData& data, std::vector<std::string>& pictures);

}  // namespace glint::cli
