// The sections of the page that hold paper 1 against what is measured.
#pragma once

#include <optional>
#include <string>

#include "cpu_prices.hpp"
#include "report_paper.hpp"
#include "report_plots.hpp"

namespace glint::cli {

/// Where f_bps is good, where not, and what else there is: for the engineer who has to choose.
/// Times stand in it where `cpu` holds them.
std::string choosing_section(const PaperData& data, const std::optional<CpuPrices>& cpu);

/// Claims, figures 4 to 8, and Table 1. `command` is the command line of the report.
std::string paper_sections(const PaperData& data, const std::optional<CpuPrices>& cpu, const Pictures& pictures,
                           const std::string& command);

}  // namespace glint::cli
