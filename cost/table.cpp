#include "cost/table.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cost/fpga/device.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/page.hpp"

namespace glint::cost {
namespace {

using Json = nlohmann::ordered_json;

/// One configuration in all forms of the table. Units stand in the heading.
struct Column {
    std::string_view name;     ///< in CSV and JSON
    std::string_view heading;  ///< for people
    Metric metric;
};
constexpr Column columns[] = {
    {"error", "error", Metric::error},
    {"rounding_ulp", "rounding/ulp", Metric::rounding},
    {"luts", "LUTs", Metric::luts},
    {"registers", "registers", Metric::registers},
    {"dsps", "DSPs", Metric::dsps},
    {"brams", "BRAMs", Metric::brams},
    {"clock_mhz", "MHz", Metric::clock},
    {"latency_clocks", "clocks", Metric::latency_clocks},
    {"latency_ns", "latency/ns", Metric::latency},
    {"ns_per_result", "ns/result", Metric::ns},
    {"results_per_second", "results/s", Metric::throughput},
};

std::string shown(const Configuration& c, Metric metric) {
    const std::optional<double> x = value(c, metric);
    if (!x) return "-";
    if (metric == Metric::rounding) return c.output_bits == 0 ? "-" : fmt::format("{:.4f}", *x);
    if (metric == Metric::throughput) return short_number(*x / 1e6) + " M";
    return info(metric).is_real ? short_number(*x) : fmt::format("{:.0f}", *x);
}

/// The error of the same integers, or none: that of floating point numbers is not measured here.
std::optional<double> cpu_error(const Prices& data, const CpuPrice& point, const Scope& scope) {
    const AccuracyRecord* record = point.type == "fixed" ? data.find(point.name, point.profile) : nullptr;
    return record == nullptr ? std::nullopt : std::optional(record->error(scope.n, scope.cosine));
}

std::string cpu_table(const Prices& data, const std::vector<CpuPrice>& cpu, const Scope& scope) {
    std::vector<std::vector<std::string>> rows{
        {"CPU", "type", "form", "error", "ns/result", "latency/ns", "instructions"}};
    for (const CpuPrice& price : cpu) {
        rows.push_back({price.name, price.type + (price.profile.empty() ? "" : " " + price.profile), price.form,
                        short_number(cpu_error(data, price, scope)), short_number(price.throughput),
                        short_number(price.latency), short_number(price.instructions)});
    }
    return fmt::format("\n{}measured on {} (docs/cpu-cost.md)\n", io::table(rows), data.cpu->cpu);
}

std::string to_csv(const std::vector<Configuration>& all, const std::vector<bool>& beaten, const Prices& data,
                   const std::vector<CpuPrice>& cpu, const Scope& scope) {
    std::string out = "lobe,profile,architecture,device,dsp,output_bits";
    for (const Column& column : columns) out += fmt::format(",{}", column.name);
    out += ",dominated\n";
    const auto field = [](const std::string& text) {
        return text.find(',') == std::string::npos ? text : '"' + text + '"';
    };
    const auto number = [](std::optional<double> x) { return x ? fmt::format("{:.9g}", *x) : std::string(); };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Configuration& c = all[i];
        out += fmt::format("{},{},{},{},{},{}", c.lobe, field(c.profile), c.architecture, c.device, c.dsp ? 1 : 0,
                           c.output_bits);
        for (const Column& column : columns) out += fmt::format(",{}", number(value(c, column.metric)));
        out += fmt::format(",{}\n", beaten[i] ? 1 : 0);
    }
    // A CPU has no gates: its rows leave those columns empty.
    for (const CpuPrice& p : cpu) {
        out += fmt::format("{},{},{},cpu,,,{},,,,,,,,{},{},{},\n", p.name,
                           field(p.profile.empty() ? p.type : p.profile), p.form, number(cpu_error(data, p, scope)),
                           number(p.latency), number(p.throughput), number(1e9 / p.throughput));
    }
    return out;
}

/// Throws Error where nothing is left.
void keep_only(std::vector<Configuration>& all, const TableOptions& options) {
    const auto drop = [&](const std::vector<std::string>& wanted, std::string Configuration::*field) {
        std::erase_if(all, [&](const Configuration& c) {
            return std::find(wanted.begin(), wanted.end(), c.*field) == wanted.end();
        });
    };
    if (!options.lobe.empty() && options.lobe != "all") drop(io::split_list(options.lobe), &Configuration::lobe);
    if (!options.profile.empty()) drop(io::split_profiles(options.profile), &Configuration::profile);
    if (all.empty()) {
        throw Error(fmt::format("no price on {} is of --lobe '{}' --profile '{}': {} holds those there are",
                                options.device, options.lobe, options.profile, options.data));
    }
}

}  // namespace

Json configuration_json(const Configuration& c) {
    Json out{{"lobe", c.lobe},     {"profile", c.profile}, {"architecture", c.architecture},
             {"device", c.device}, {"dsp", c.dsp},         {"output_bits", c.output_bits}};
    for (const Column& column : columns) {
        const std::optional<double> x = value(c, column.metric);
        const bool count = !info(column.metric).is_real;
        out[std::string(column.name)] = !x ? Json(nullptr) : count ? Json(static_cast<int>(*x)) : Json(*x);
    }
    return out;
}

Json table_json(const std::vector<Configuration>& all, std::span<const Metric> axes, const Prices& data,
                const std::vector<CpuPrice>& cpu, const Scope& scope) {
    Json out{{"n", {{"first", scope.n.first}, {"last", scope.n.last}, {"step", scope.n.step}}},
             {"cosine", scope.cosine == Cosine::rounded ? "rounded" : "exact"},
             {"pareto", Json::array()},
             {"configurations", Json::array()},
             {"cpu", Json::array()}};
    for (const Metric axis : axes) out["pareto"].push_back(info(axis).name);
    const std::vector<bool> beaten = dominated(all, axes);
    for (std::size_t i = 0; i < all.size(); ++i) {
        out["configurations"].push_back(configuration_json(all[i]));
        out["configurations"].back()["dominated"] = static_cast<bool>(beaten[i]);
    }
    for (const CpuPrice& p : cpu) {
        const auto number = [](std::optional<double> x) { return x ? Json(*x) : Json(nullptr); };
        out["cpu"].push_back({{"lobe", p.name},
                              {"type", p.type},
                              {"profile", p.profile},
                              {"form", p.form},
                              {"error", number(cpu_error(data, p, scope))},
                              {"ns_per_result", p.throughput},
                              {"latency_ns", number(p.latency)},
                              {"instructions", number(p.instructions)}});
    }
    return out;
}

std::string name_of(const Configuration& c) { return fmt::format("{} {} {}", c.lobe, c.profile, c.architecture); }

std::vector<Metric> parse_axes(const std::string& text) {
    std::vector<Metric> out;
    for (const std::string& name : io::split_list(text)) out.push_back(find_metric(name).metric);
    return out;
}

void sort_by(std::vector<Configuration>& all, Metric metric) {
    std::vector<Configuration> sorted;
    for (const std::size_t i : choose(all, {}, metric).feasible) sorted.push_back(std::move(all[i]));
    all = std::move(sorted);
}

std::string configurations_table(const std::vector<Configuration>& all, const std::vector<std::string>& marks) {
    std::vector<std::vector<std::string>> rows{{"lobe", "profile", "architecture", "device", "DSP"}};
    for (const Column& column : columns) rows[0].emplace_back(column.heading);
    if (!marks.empty()) rows[0].emplace_back();
    std::set<std::string> with_dsps;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Configuration& c = all[i];
        if (c.clock_mhz && c.dsps > 0) with_dsps.insert(c.device);
        std::vector<std::string> row{c.lobe, c.profile, c.architecture, c.device, c.dsp ? "yes" : "no"};
        for (const Column& column : columns) row.push_back(shown(c, column.metric));
        if (!marks.empty()) row.push_back(marks[i]);
        rows.push_back(std::move(row));
    }
    return io::table(rows) + fpga::dsp_clock_notes(with_dsps);
}

int run_cost_table(TableOptions options, const std::string& command) {
    io::check_writable(options.csv, options.json);
    const Metric by = find_metric(options.sort).metric;
    const std::vector<Metric> axes = parse_axes(options.pareto);
    const Scope scope{parse_range(options.n, "--n", 1, max_n), parse_cosine(options.cosine), {}, options.hls};
    const Prices data = read_cost_data(options.data);
    if (options.device != "all") options.device = priced_device(data, options.device);
    if (options.device == "all" && !options.plots.empty()) {
        throw Error("--plots with --device all is not legal: a plot shows one device");
    }

    std::vector<CpuPrice> cpu;  // beside the FPGAs, where all are asked for
    if (options.device == "all" && data.cpu) cpu = data.cpu->prices;

    std::vector<std::string> unknown;
    std::vector<Configuration> all = join(data, scope, options.device == "all" ? "" : options.device, &unknown);
    keep_only(all, options);
    sort_by(all, by);
    const std::vector<bool> beaten = dominated(all, axes);

    if (!options.csv.empty()) io::write_file(options.csv, to_csv(all, beaten, data, cpu, scope));
    if (!options.json.empty()) {
        Json out{{"tool", "glint cost"}, {"version", GLINT_VERSION}, {"command", command}};
        out.update(table_json(all, axes, data, cpu, scope));
        io::write_json(options.json, out);
    }
    if (!options.plots.empty()) {
        const std::vector<CpuPrice> beside = data.cpu ? data.cpu->prices : cpu;
        io::run_page_script("stills.py", io::json_text(table_json(all, axes, data, beside, scope)), options.plots);
    }

    std::vector<std::string> marks;
    for (const bool is_beaten : beaten) marks.emplace_back(is_beaten ? "dominated" : "");
    fmt::print("{}", configurations_table(all, marks));
    fmt::print("error: largest against c^n for {}; clock: median of place and route ({}); energy is not measured\n",
               to_text(scope), data.tools);
    fmt::print("dominated: another one on the same device is no worse in {}, and better in one of them\n",
               options.pareto);
    for (const Price& point : data.fpga) {
        const Configuration& c = point.configuration;
        if (!point.fits && (options.device == "all" || c.device == options.device)) {
            fmt::print("does not fit {}: {}{}\n", c.device, name_of(c), c.dsp ? " with DSPs" : "");
        }
    }
    if (!unknown.empty()) {
        fmt::print("no error in accuracy.json, left out: {}\n", fmt::join(unknown, "; "));
    }
    if (!cpu.empty()) fmt::print("{}", cpu_table(data, cpu, scope));
    return io::success;
}

}  // namespace glint::cost
