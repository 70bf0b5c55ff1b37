// `glint cost`: what accuracy costs, as one table.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cost/prices.hpp"

namespace glint::cost {

struct TableOptions {
    std::string data = "cost/data";  ///< the folder of the files
    std::string lobe, profile;       ///< lists; empty: all
    std::string device = "hx8k";     ///< or "all"
    std::string n = "all";
    std::string cosine = "rounded";
    std::string sort = "error";
    std::string pareto = "error,luts,dsps,brams,latency,ns";
    bool hls = false;              ///< kernels through a high-level synthesis tool, too
    std::string csv, json, plots;  ///< empty: not written
};

/// Throws Error.
int run_cost_table(TableOptions options, const std::string& command);

/// The order of a table by a metric, the best first; of equals, by the common axes, then by name.
void sort_by(std::vector<Configuration>& all, Metric metric);

/// "error,luts" as metrics. Throws Error.
std::vector<Metric> parse_axes(const std::string& text);

/// One line each, with all metrics, and with a mark each at its end unless `marks` is empty.
std::string configurations_table(const std::vector<Configuration>& all, const std::vector<std::string>& marks = {});

/// What `glint cost --json` writes: every configuration with all metrics and whether another one beats it on `axes`,
/// and what the same costs on a processor. Of the scope, the exponents and the cosine.
nlohmann::ordered_json table_json(const std::vector<Configuration>& all, std::span<const Metric> axes,
                                  const Prices& data, const std::vector<CpuPrice>& cpu, const Scope& scope);

/// All metrics; null where one is not known.
nlohmann::ordered_json configuration_json(const Configuration& configuration);

/// What a configuration is called: "cayley p12 iterative".
std::string name_of(const Configuration& configuration);

}  // namespace glint::cost
