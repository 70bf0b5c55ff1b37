#include "cli/report/report_paper2_hardware.hpp"

#include <fmt/format.h>

#include "cli/report/report_html.hpp"

namespace glint::cli {
namespace {

constexpr const char* full_form = "cook_torrance";
constexpr const char* modified_form = "cook_torrance_modified";

struct Pair {
    const fpga::Point* full = nullptr;
    const fpga::Point* modified = nullptr;
};

/// The full form's points that the modified one has a point beside.
std::vector<Pair> pairs(const EffectPrices& prices) {
    std::vector<Pair> out;
    for (const fpga::Point& point : prices.points) {
        if (point.effect != full_form) continue;
        for (const fpga::Point& other : prices.points) {
            if (other.effect == modified_form && other.profile == point.profile && other.device == point.device &&
                other.dsp == point.dsp) {
                out.push_back({&point, &other});
            }
        }
    }
    return out;
}

std::vector<Cell> row(const fpga::Point& point) {
    const bool clock = !point.clocks_mhz.empty();
    const std::string unknown = point.routed ? "does not fit" : "–";
    return {{"form", point.effect == full_form ? "full" : "modified", Cell::name},
            {"profile", escaped(point.profile), Cell::name},
            {"device", escaped(point.device), Cell::name},
            {"LUTs", fmt::format("{}", point.resources.luts)},
            {"registers", fmt::format("{}", point.resources.registers)},
            {"DSPs", fmt::format("{}", point.resources.dsps)},
            {"BRAMs", fmt::format("{}", point.resources.brams)},
            {"latency, clocks", fmt::format("{}", point.latency)},
            {"clocks a result", fmt::format("{}", point.interval)},
            {"MHz", clock ? fmt::format("{:.1f}", point.clock_mhz()) : unknown},
            {"latency, ns", clock ? fmt::format("{:.0f}", point.latency_ns()) : unknown},
            {"M results/s", clock ? fmt::format("{:.1f}", 1e-6 * point.results_per_second()) : unknown}};
}

/// "At p12 on xc7 the modified form ..."
std::string verdict(const Pair& pair) {
    const fpga::Point& full = *pair.full;
    const fpga::Point& modified = *pair.modified;
    std::string out = fmt::format(
        "<p>At {} on {}: {:.0f}&nbsp;% of the LUTs of the full form, {:.0f}&nbsp;% of its registers, {} DSPs instead "
        "of "
        "{}, {} clocks of latency instead of {}",
        escaped(full.profile), escaped(full.device), 100.0 * modified.resources.luts / full.resources.luts,
        100.0 * modified.resources.registers / full.resources.registers, modified.resources.dsps, full.resources.dsps,
        modified.latency, full.latency);
    if (full.fits && modified.fits) {
        out += fmt::format("; {:.2f} times the latency in ns, {:.2f} times the results a second",
                           modified.latency_ns() / full.latency_ns(),
                           modified.results_per_second() / full.results_per_second());
    }
    return out + ".</p>\n";
}

}  // namespace

std::string paper2_hardware_section(const std::optional<CostReport>& cost) {
    std::string out = "<h3 id=\"paper-2-hardware\">The two forms as hardware</h3>\n";
    const std::vector<Pair> found = cost && cost->effects ? pairs(*cost->effects) : std::vector<Pair>();
    if (found.empty()) {
        return out + fmt::format(
                         "<p>For this table give the folder of <code>effects.json</code> with "
                         "<code>--cost</code>; {} writes it.</p>\n",
                         command_html("glint cost --fpga --effect cook_torrance,cook_torrance_modified --json "
                                      "cost/data/effects.json"));
    }
    std::vector<std::vector<Cell>> rows;
    std::string verdicts;
    for (const Pair& pair : found) {
        rows.push_back(row(*pair.full));
        rows.push_back(row(*pair.modified));
        verdicts += verdict(pair);
    }
    return out +
           "<p>One light's term per clock, bit for bit the golden models of docs/effects/; how prices are measured "
           "says "
           "docs/cost.md.</p>\n" +
           table_html(rows) + verdicts;
}

}  // namespace glint::cli
