// The sections of the page that hold paper 1 against what is measured.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>

#include "cli/report/report_plots.hpp"
#include "cost/cpu_prices.hpp"
#include "studies/report_paper.hpp"

namespace glint::cli {

/// Where f_bps is good, where not, and what else there is: for the engineer who has to choose.
/// Times stand in it where `cpu` holds them.
std::string choosing_section(const PaperData& data, const std::optional<CpuPrices>& cpu);

/// Claims, figures 4 to 8, and Table 1. `command` is the command line of the report.
std::string paper_sections(const PaperData& data, const std::optional<CpuPrices>& cpu, const Pictures& pictures,
                           const std::string& command);

}  // namespace glint::cli
