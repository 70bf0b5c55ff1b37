#include "cost/plots.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/gnuplot.hpp"

namespace glint::cost {

using namespace io;

namespace {

struct Axis {
    Metric metric;
    std::string_view label;
};
constexpr Axis ns_axis{Metric::ns, "ns a result"};
constexpr Axis latency_axis{Metric::latency, "latency in ns"};
constexpr Axis luts_axis{Metric::luts, "LUTs"};

/// A point that cannot stand on a logarithmic axis, or has no place on it, is left out.
std::optional<double> place(const Configuration& c, Metric metric) {
    const std::optional<double> x = value(c, metric);
    return x && *x > 0.0 ? x : std::nullopt;
}

struct Limits {
    double low = HUGE_VAL, high = 0.0;
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

/// The colour of a shipped profile; custom ones share the last.
std::size_t colour(const Configuration& c) {
    const auto all = shipped_profiles();
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(), [&](const Profile& p) { return p.name == c.profile; }) - all.begin());
}

std::string panel(const PlotData& data, const Axis& axis, const Theme& theme) {
    const bool with_cpu = axis.metric == Metric::ns;
    Limits x_limits;
    Limits y_limits;
    std::vector<Configuration> all;
    for (const Configuration& c : data.configurations) {
        const std::optional<double> x = place(c, axis.metric);
        if (!x || c.error <= 0.0) continue;
        all.push_back(c);
        x_limits.add(*x);
        y_limits.add(c.error);
    }
    for (const PlotData::Cpu& point : data.cpu) {
        if (with_cpu) x_limits.add(point.ns);
    }
    // Half a step of air on either side; the high end has room for a name.
    const double x_low = round_down(x_limits.low * 0.9);
    const double x_high = x_limits.high * 1.6;
    const double y_low = round_down(y_limits.low * 0.8);
    const double y_high = y_limits.high * 1.5;

    const Metric axes[] = {Metric::error, axis.metric};
    const std::vector<bool> beaten = dominated(all, axes);
    std::vector<Configuration> front;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!beaten[i]) front.push_back(all[i]);
    }
    std::sort(front.begin(), front.end(),
              [&](const Configuration& a, const Configuration& b) { return better(axis.metric, a, b); });
    // Of equal ones, as architectures that differ elsewhere, one name is enough.
    const auto same = [&](const Configuration& a, const Configuration& b) {
        return a.error == b.error && value(a, axis.metric) == value(b, axis.metric);
    };
    front.erase(std::unique(front.begin(), front.end(), same), front.end());

    std::string out =
        fmt::format("set logscale xy 10\nset mxtics 1\nset mytics 1\nset xrange [{:g}:{:g}]\n", x_low, x_high);
    out += fmt::format("set yrange [{:g}:{:g}]\nset xtics {}\nset ytics {}\n", y_low, y_high, log_tics(x_low, x_high),
                       log_tics(y_low, y_high));
    out += fmt::format("set xlabel '{}'\nset ylabel 'largest absolute error against c^n' offset 1\n", axis.label);
    out += "unset label\n";
    // Below and to the left of a point of the front there is no other. The first one's name has no room there.
    const double name_height = std::pow(y_low / y_high, 0.045);  // as the ratio of two errors
    double named = HUGE_VAL;
    for (std::size_t i = 0; i < front.size(); ++i) {
        if (front[i].error > name_height * named) continue;  // it would lie on the name before
        named = front[i].error;
        out += fmt::format("set label '{} {}' at {:g},{:g} {} font ',11' textcolor rgb '{}' front\n",
                           key_name(front[i].lobe), key_name(front[i].profile), *place(front[i], axis.metric),
                           front[i].error, i == 0 ? "left offset 0.4,0.5" : "right offset -0.6,-0.5", theme.text);
    }
    out += "$front << EOD\n";
    for (const Configuration& c : front) out += fmt::format("{:g} {:g}\n", *place(c, axis.metric), c.error);
    out += fmt::format("{:g} {:g}\nEOD\n", x_high, front.back().error);
    std::string plot = fmt::format(
        "plot $front using 1:2 with steps linewidth 2 linecolor rgb '{}' title 'best for its cost'", theme.axis);

    constexpr std::string_view names[] = {"p8", "p12", "p16", "custom"};
    for (std::size_t k = 0; k < std::size(names); ++k) {
        std::string block;
        for (const Configuration& c : all) {
            if (colour(c) == k) block += fmt::format("{:g} {:g}\n", *place(c, axis.metric), c.error);
        }
        if (block.empty()) continue;
        out += fmt::format("$points{} << EOD\n{}EOD\n", k, block);
        plot += fmt::format(
            ", $points{} using 1:2 with points pointtype {} pointsize 0.7 linewidth 1.5 linecolor rgb '{}' title '{}'",
            k, k == 3 ? 6 : 7, theme.runs[k], names[k]);
    }
    if (with_cpu && !data.cpu.empty()) {
        out += "$cpu << EOD\n";
        for (const PlotData::Cpu& point : data.cpu) out += fmt::format("{:g} {:g}\n", point.ns, point.error);
        out += "EOD\n";
        plot += fmt::format(
            ", $cpu using 1:2 with points pointtype 2 pointsize 0.7 linewidth 1.5 linecolor rgb '{}' title 'on a CPU'",
            theme.schlick);
    }
    return out + plot + "\n";
}

}  // namespace

std::string pareto_file(std::string_view theme) { return fmt::format("pareto-{}.svg", theme); }

PlotData cost_plot_data(const Prices& data, const Scope& scope, const std::string& device) {
    PlotData out{join(data, scope, device), {}};
    if (out.configurations.empty()) throw Error(fmt::format("no price on {} has an error: nothing to plot", device));
    if (!data.cpu) return out;
    for (const CpuPrice& price : data.cpu->prices) {
        const AccuracyRecord* record = price.type == "fixed" ? data.find(price.name, price.profile) : nullptr;
        if (record != nullptr) out.cpu.push_back({price.throughput, record->error(scope.n, scope.cosine)});
    }
    return out;
}

std::string cost_plots(const PlotData& data, std::vector<std::string>& pictures) {
    std::string out;
    for (const Theme* theme : {&light, &dark}) {
        for (const Layout& layout : {wide, narrow}) {
            for (const auto& [plot, axis] :
                 {std::pair(cost_ns_plot, ns_axis), std::pair(cost_latency_plot, latency_axis),
                  std::pair(cost_luts_plot, luts_axis)}) {
                pictures.push_back(plot.file(theme->name, layout.name));
                out += begin_plot(pictures.back(), *theme, layout.width, 440);
                out += panel(data, axis, *theme) + end_plot();
            }
        }
        pictures.push_back(pareto_file(theme->name));
        out += begin_plot(pictures.back(), *theme, 960, 440) + multiplot(1, 2);
        out += panel(data, luts_axis, *theme) + panel(data, latency_axis, *theme);
        out += "unset multiplot\n" + end_plot();
    }
    return out;
}

void write_cost_plots(const std::string& folder, const PlotData& data) {
    std::vector<std::string> pictures;
    const std::string script = cost_plots(data, pictures);
    const Pictures drawn = run_gnuplot(script, pictures);
    make_folder(folder);
    for (const auto& [name, bytes] : drawn) {
        write_file(std::filesystem::path(folder) / name, bytes);
        fmt::print("{}\n", (std::filesystem::path(folder) / name).string());
    }
}

}  // namespace glint::cost
