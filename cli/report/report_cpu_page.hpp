// The sections of the page on what an evaluation costs on a processor, and what a simulated one does.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/report/report_results.hpp"
#include "cost/cpu_prices.hpp"

namespace glint::cli {

/// What measured them, on which processor.
std::string measured_by(const CpuPrices& cpu);

/// Instead of a table: how `program` of bench/ writes the file for the option `option` of `glint report`.
std::string missing_cpu_prices(std::string_view program = "glint-bench", std::string_view option = "cpu");

/// A lobe's name, with the paper's symbol below it where it has one: f_kv as f with an index.
std::string lobe_html(std::string_view lobe);

/// The paper's Table 1: operations, cycles, and what is measured.
std::string costs_section(const std::optional<CpuPrices>& cpu);

/// Every lobe and every rival on a processor; vectors per second of golden models and cosimulations.
std::string speed_section(const std::optional<CpuPrices>& cpu, const std::vector<ResultFile>& files);

}  // namespace glint::cli
