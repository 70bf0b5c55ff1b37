// The figures of paper 2 as plots.
#pragma once

#include "cli/report/rooms.hpp"

#include <string>
#include <vector>

#include "io/theme.hpp"
#include "studies/report_paper2.hpp"

namespace glint::cli {

inline constexpr Plot distribution_plot{"paper-2-figure-1", "svg"};
inline constexpr Plot reflectance_plot{"paper-2-figure-2", "svg"};
inline constexpr Plot highlight_plot{"paper-2-phong", "svg"};

/// A script for gnuplot, and the names of its pictures.
std::string paper2_plots(const Paper2Data& data, std::vector<std::string>& pictures);

}  // namespace glint::cli
