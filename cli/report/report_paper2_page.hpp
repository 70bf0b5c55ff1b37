// The section of the page that holds paper 2 against what is computed.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>

#include "cost/cpu_prices.hpp"
#include "io/gnuplot.hpp"
#include "studies/report_paper2.hpp"

namespace glint::cli {

/// Claims, operations, times on a processor, figures 1 and 2, Phong against Blinn-Phong, the look of the modified form.
/// `command` is the command line of the report.
std::string paper2_section(const Paper2Data& data, const std::optional<CpuPrices>& prices, const Pictures& pictures,
                           const std::string& command);

}  // namespace glint::cli
