// Plots of accuracy against cost, of one device: every configuration a point, the best ones joined by a line.
#pragma once

#include <string>
#include <vector>

#include "cost/prices.hpp"
#include "io/theme.hpp"

namespace glint::cost {

inline constexpr io::Plot cost_ns_plot{"cost-ns", "svg"};
inline constexpr io::Plot cost_latency_plot{"cost-latency", "svg"};
inline constexpr io::Plot cost_luts_plot{"cost-luts", "svg"};

/// The picture for a README: error against LUTs and against latency.
std::string pareto_file(std::string_view theme);

struct PlotData {
    std::vector<Configuration> configurations;  ///< of one device; not empty
    struct Cpu {
        double ns, error;
    };
    std::vector<Cpu> cpu;  ///< the golden models in software, for the plot over ns a result
};
/// Throws Error: no price on the device.
PlotData cost_plot_data(const Prices& data, const Scope& scope, const std::string& device);

/// The gnuplot script of all of them; adds the pictures' names.
std::string cost_plots(const PlotData& data, std::vector<std::string>& pictures);

/// Writes them to a folder. Throws Error, as run_gnuplot does too.
void write_cost_plots(const std::string& folder, const PlotData& data);

}  // namespace glint::cost
