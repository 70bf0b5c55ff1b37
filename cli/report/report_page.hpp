// The page of the report, as one HTML text that refers to nothing outside itself.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>
#include <vector>

#include "cli/report/cost_page.hpp"
#include "cli/report/report_plots.hpp"
#include "cost/cpu_prices.hpp"

namespace glint::cli {

struct PageData {
    const std::vector<ResultFile>& files;
    const std::optional<ProofsFile>& proofs;
    const std::optional<CpuPrices>& cpu;
    const std::optional<CpuPrices>& models;  ///< prices of lighting models
    const std::optional<CostReport>& cost;
    std::vector<MeasuredRun> measured;
    const PlotData& plots;
    const Pictures& pictures;
    std::string command;  ///< the command line of the report itself
};

std::string page(const PageData& data);

}  // namespace glint::cli
