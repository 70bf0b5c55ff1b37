// "What accuracy costs": a section of the report, from the files of cost/.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>

#include "cli/report/report_html.hpp"
#include "cost/effect_prices.hpp"
#include "cost/plots.hpp"
#include "cost/prices.hpp"

namespace glint::cli {

/// What the section shows: the prices with their errors, and the plots of one device.
struct CostReport {
    std::string folder;
    cost::Prices data;
    std::optional<EffectPrices> effects;             ///< where the folder has effects.json
    Scope scope{{8, 1000, 1}, Cosine::rounded, {}};  ///< the exponents that the papers speak of
    std::string device;
    cost::PlotData plots;
};

/// Throws Error: files that are missing or cannot be used.
CostReport read_cost_report(const std::string& folder);

std::string cost_section(const std::optional<CostReport>& cost, const Pictures& pictures);

}  // namespace glint::cli
