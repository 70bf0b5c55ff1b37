// What the lighting models of paper 2 cost on a processor, and which of its claims that bears out.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>

#include "cost/cpu_prices.hpp"
#include "studies/report_paper2.hpp"

namespace glint::cli {

/// Claims of speed, then the models in double and in float. `prices` have every model of `data` in both.
std::string models_on_processor(const Paper2Data& data, const std::optional<CpuPrices>& prices);

}  // namespace glint::cli
