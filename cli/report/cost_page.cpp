#include "cli/report/cost_page.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "cost/fpga/device.hpp"
#include "cost/table.hpp"

namespace glint::cli {
namespace {

constexpr std::string_view plotted_device = "hx8k";

std::string figure(const CostReport& cost, const Pictures& pictures, const Plot& plot, const std::string& over) {
    return figure_html(
        pictures, plot,
        fmt::format("Largest error of each configuration against {}; a line joins those that no other beats in both.",
                    over),
        fmt::format("<p>Error against {}, on {}: every point is a lobe at a profile in an architecture. The line joins "
                    "those that no other beats in both.</p>",
                    over, escaped(cost.device)));
}

std::vector<Cell> row(const Configuration& c) {
    const auto number = [&](Metric metric) { return short_number(value(c, metric)); };
    return {{"lobe", escaped(fmt::format("{} {}", c.lobe, c.profile)), Cell::name},
            {"architecture", escaped(c.architecture), Cell::name},
            {"error", short_number(c.error), Cell::number},
            {"LUTs", fmt::format("{}", c.luts), Cell::number},
            {"registers", fmt::format("{}", c.registers), Cell::number},
            {"DSPs", fmt::format("{}", c.dsps), Cell::number},
            {"BRAMs", fmt::format("{}", c.brams), Cell::number},
            {"MHz", number(Metric::clock), Cell::number},
            {"latency, clocks", fmt::format("{}", c.latency), Cell::number},
            {"latency, ns", number(Metric::latency), Cell::number},
            {"ns a result", number(Metric::ns), Cell::number}};
}

/// What no other beats in everything, of one device.
std::string front_table(const CostReport& cost, const std::string& device) {
    std::vector<Configuration> all = join(cost.data, cost.scope, device);
    if (all.empty()) return {};
    sort_by(all, Metric::error);
    const std::vector<bool> beaten = dominated(all, common_axes);
    std::vector<std::vector<Cell>> rows;
    bool with_dsps = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (beaten[i]) continue;
        rows.push_back(row(all[i]));
        with_dsps |= all[i].clock_mhz && all[i].dsps > 0;
    }
    const std::string note = with_dsps ? fpga::dsp_clock_notes({device}) : "";
    return fmt::format("<h3>{}</h3>\n<p>{} of {} configurations:</p>\n", escaped(device), rows.size(), all.size()) +
           table_html(rows) + (note.empty() ? "" : fmt::format("<p>{}</p>\n", escaped(note)));
}

}  // namespace

CostReport read_cost_report(const std::string& folder) {
    CostReport out;
    out.folder = folder;
    out.data = read_cost_data(folder);
    const std::filesystem::path effects = std::filesystem::path(folder) / "effects.json";
    if (std::filesystem::is_regular_file(effects)) out.effects = read_effect_prices(effects.string());
    const std::vector<std::string> known = priced_devices(out.data);
    out.device = std::find(known.begin(), known.end(), plotted_device) != known.end() ? std::string(plotted_device)
                                                                                      : known.front();
    out.plots = cost_plot_data(out.data, out.scope, out.device);
    return out;
}

std::string cost_section(const std::optional<CostReport>& cost, const Pictures& pictures) {
    std::string out = "<h2 id=\"cost\">What accuracy costs</h2>\n";
    if (!cost) {
        return out +
               "<p>For this section give the folder of <code>accuracy.json</code> and <code>fpga.json</code> with "
               "<code>--cost</code>; <code>glint cost --accuracy</code> and <code>glint cost --fpga</code> write "
               "them.</p>\n";
    }
    out += fmt::format(
        "<p>The largest error against c<sup>n</sup> for {}, measured over every legal input, beside what a unit takes "
        "of an FPGA: cells after synthesis, the median clock after place and route ({}). All are shown that no other "
        "on the same device beats: one that is no worse in error, LUTs, DSPs, block RAMs, latency and time a result, "
        "and better in one of them. {} shows the others; {} finds the cheapest for a given error, clock and "
        "latency.</p>\n",
        to_text(cost->scope), escaped(cost->data.tools), command_html("glint cost --device all --n 8:1000"),
        command_html("glint choose --max-error 0.002 --n 8:1000"));
    for (const auto& [plot, over] : {std::pair(cost_luts_plot, "LUTs"), std::pair(cost_latency_plot, "latency"),
                                     std::pair(cost_ns_plot, "the time between two results")}) {
        out += figure(*cost, pictures, plot, over);
    }
    for (const std::string& device : priced_devices(cost->data)) out += front_table(*cost, device);
    return out;
}

}  // namespace glint::cli
