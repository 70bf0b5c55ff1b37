#include "cost/fpga/points.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "cost/fpga/flow.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/process.hpp"

namespace glint::fpga {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double x) { return std::round(100.0 * x) / 100.0; }

Json to_json(const Point& point) {
    Json out;
    if (!point.effect.empty()) out["effect"] = point.effect;
    if (point.mask) out["mask"] = *point.mask;
    if (!point.lobe.empty()) out["lobe"] = point.lobe;
    out["profile"] = point.profile;
    if (!point.architecture.empty()) out["architecture"] = point.architecture;
    if (!point.unit.empty()) out["unit"] = point.unit;
    if (point.lanes > 1) out["lanes"] = point.lanes;
    out["device"] = point.device;
    out["dsp"] = point.dsp;
    out["luts"] = point.resources.luts;
    out["registers"] = point.resources.registers;
    out["carries"] = point.resources.carries;
    out["dsps"] = point.resources.dsps;
    out["brams"] = point.resources.brams;
    if (point.routed) {
        out["fits"] = point.fits;
        if (point.fits) out["cells"] = point.cells;
        if (!point.fits) out["why"] = point.why;
        if (point.harness_limits) out["harness_limits"] = true;
    }
    out["clock_mhz"] = nullptr;
    if (!point.clocks_mhz.empty()) out["clock_mhz"] = rounded(point.clock_mhz());
    out["clock_mhz_seeds"] = Json::array();
    for (const double clock : point.clocks_mhz) out["clock_mhz_seeds"].push_back(rounded(clock));
    if (const CriticalPath* path = point.path()) {
        out["path"] = {{"from", path->from},
                       {"to", path->to},
                       {"logic_ns", rounded(path->logic_ns)},
                       {"routing_ns", rounded(path->routing_ns)}};
    }
    if (!point.unrouted_seeds.empty()) out["unrouted_seeds"] = point.unrouted_seeds;
    out["latency"] = point.latency;
    out["interval"] = point.interval;
    if (!point.error.is_null()) out["error"] = point.error;
    out["hash"] = point.hash;
    return out;
}

[[noreturn]] void refuse(const std::filesystem::path& path, PriceFile file) {
    throw Error(
        fmt::format("file '{}' is not of the format {}: name another, or remove it", path.string(), format_of(file)));
}

/// What tells two points apart, in the order of the file.
using Identity = std::tuple<std::string, std::string, int, std::string, std::string, bool, std::string>;

/// Throws the exceptions of Json.
Identity identity(const Json& point, PriceFile file) {
    const auto text = [&](const char* key) { return point.at(key).get<std::string>(); };
    const bool dsp = point.at("dsp").get<bool>();
    if (file == PriceFile::lobes)
        return {text("lobe"), text("profile"), 0, text("architecture"), text("device"), dsp, ""};
    if (file == PriceFile::shells) {
        return {point.value("effect", "") + " " + point.value("lobe", ""),
                text("profile"),
                point.value("mask", 0),
                point.value("architecture", ""),
                text("device"),
                dsp,
                fmt::format("{} {:2}", text("unit"), point.value("lanes", 1))};
    }
    return {text("effect"),
            point.value("lobe", ""),
            point.value("mask", 0),
            text("profile"),
            text("device"),
            dsp,
            point.value("architecture", "")};
}

Json read_points(const std::filesystem::path& path, PriceFile file) {
    if (!std::filesystem::is_regular_file(path)) {
        return Json{{"format", format_of(file)}, {"tools", Json::object()}, {"points", Json::array()}};
    }
    const Json out = Json::parse(io::read_file(path), nullptr, false);
    if (!out.is_object() || out.value("format", Json()) != format_of(file)) refuse(path, file);
    return out;
}

/// Columns of a table that names the units.
std::vector<std::string> names_of(const Point& point, PriceFile file) {
    if (file == PriceFile::lobes) return {point.lobe, point.profile, point.architecture};
    std::vector<std::string> out{
        point.effect, point.mask ? std::to_string(*point.mask) : "-", point.lobe.empty() ? "-" : point.lobe,
        point.architecture.empty() ? point.profile : fmt::format("{} {}", point.profile, point.architecture)};
    if (file == PriceFile::shells) {
        if (point.effect.empty()) out[0] = "-";
        out.push_back(point.lanes > 1 ? fmt::format("{} lanes", point.lanes) : point.unit);
    }
    return out;
}

}  // namespace

std::string_view format_of(PriceFile file) {
    return file == PriceFile::lobes     ? "glint-cost-fpga-1"
           : file == PriceFile::effects ? "glint-cost-effects-1"
                                        : "glint-cost-shell-1";
}

double Point::clock_mhz() const {
    if (clocks_mhz.empty()) return 0.0;
    std::vector<double> sorted = clocks_mhz;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t half = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2.0;
}

const CriticalPath* Point::path() const {
    std::vector<double> sorted = clocks_mhz;
    std::sort(sorted.begin(), sorted.end());
    const double middle = sorted.empty() ? 0.0 : sorted[(sorted.size() - 1) / 2];
    const auto at = std::find(clocks_mhz.begin(), clocks_mhz.end(), middle) - clocks_mhz.begin();
    const auto i = static_cast<std::size_t>(at);
    return i < paths.size() && !paths[i].from.empty() ? &paths[i] : nullptr;
}

double Point::latency_ns() const { return clocks_mhz.empty() ? 0.0 : 1e3 * latency / clock_mhz(); }

double Point::results_per_second() const { return 1e6 * clock_mhz() / interval; }

std::string merged(const std::filesystem::path& path, PriceFile file, const ToolVersions& tools,
                   const std::vector<Point>& points) {
    Json prices = read_points(path, file);
    std::map<Identity, Json> all;
    try {
        for (const auto& [tool, version] : tools) {
            const std::string there = prices.at("tools").value(tool, version);
            if (there != version) {
                throw Error(fmt::format("file '{}' has prices of {} {}, and here is {}: name another, or remove it",
                                        path.string(), tool, there, version));
            }
            prices["tools"][tool] = version;
        }
        for (const Json& point : prices.at("points")) all[identity(point, file)] = point;
    } catch (const Json::exception&) {
        refuse(path, file);
    }
    for (const Point& point : points) {
        const Json json = to_json(point);
        all[identity(json, file)] = json;
    }
    std::string out =
        fmt::format("{{\n\"format\": \"{}\",\n\"tools\": {},\n\"points\": [", format_of(file), prices["tools"].dump());
    std::string_view separator = "\n";
    for (const auto& [key, point] : all) {
        out += fmt::format("{}{}", separator, point.dump());
        separator = ",\n";
    }
    return out + "\n]\n}\n";
}

std::vector<Point> named_points(const std::filesystem::path& path) {
    const Json prices = Json::parse(io::read_file(path), nullptr, false);
    try {
        const bool of_shells = prices.at("format") == format_of(PriceFile::shells);
        const bool of_lobes = prices.at("format") == format_of(PriceFile::lobes);
        if (!of_lobes && !of_shells && prices.at("format") != format_of(PriceFile::effects))
            throw Error("another format");
        std::vector<Point> out;
        for (const Json& point : prices.at("points")) {
            Point named;
            if (!of_lobes) named.effect = of_shells ? point.value("effect", "") : point.at("effect").get<std::string>();
            if (point.contains("mask")) named.mask = point["mask"].get<int>();
            named.lobe = of_lobes ? point.at("lobe").get<std::string>() : point.value("lobe", "");
            named.profile = point.at("profile");
            named.architecture =
                of_lobes ? point.at("architecture").get<std::string>() : point.value("architecture", "");
            if (of_shells) named.unit = point.at("unit");
            named.lanes = point.value("lanes", 1);
            named.device = point.at("device");
            named.dsp = point.at("dsp");
            named.hash = point.at("hash");
            out.push_back(std::move(named));
        }
        return out;
    } catch (const std::exception&) {
        throw Error(fmt::format("file '{}' is not of the format {}, {} or {}", path.string(),
                                format_of(PriceFile::lobes), format_of(PriceFile::effects),
                                format_of(PriceFile::shells)));
    }
}

std::string name_of(const Point& point) {
    const PriceFile file = !point.unit.empty()     ? PriceFile::shells
                           : !point.effect.empty() ? PriceFile::effects
                                                   : PriceFile::lobes;
    return fmt::format("{} {}{}", fmt::join(names_of(point, file), " "), point.device,
                       find_device(point.device).has_dsps && !point.dsp ? " no DSPs" : "");
}

std::string points_table(const std::vector<Point>& points, PriceFile file) {
    std::vector<std::vector<std::string>> rows;
    if (file == PriceFile::lobes) {
        rows.push_back({"lobe", "profile", "architecture"});
    } else {
        rows.push_back({"effect", "mask", "lobe", "profile"});
        if (file == PriceFile::shells) rows[0].emplace_back("unit");
    }
    for (const char* heading : {"device", "dsp", "LUTs", "registers", "carries", "DSPs", "BRAMs", "MHz", "latency",
                                "interval", "ns", "M results/s"}) {
        rows[0].emplace_back(heading);
    }
    std::string notes;
    std::set<std::string> with_dsps;
    for (const Point& point : points) {
        const bool clock = !point.clocks_mhz.empty();
        std::string mhz = clock ? fmt::format("{:.1f}", point.clock_mhz()) : point.routed ? "does not fit" : "-";
        if (point.harness_limits) mhz += "*";
        std::vector<std::string> row = names_of(point, file);
        std::string what = fmt::format("{} {}", fmt::join(row, " "), point.device);
        for (std::string& cell : std::vector<std::string>{
                 point.device, point.dsp ? "on" : "off", std::to_string(point.resources.luts),
                 std::to_string(point.resources.registers), std::to_string(point.resources.carries),
                 std::to_string(point.resources.dsps), std::to_string(point.resources.brams), mhz,
                 std::to_string(point.latency), std::to_string(point.interval),
                 clock ? fmt::format("{:.1f}", point.latency_ns()) : "-",
                 clock ? fmt::format("{:.1f}", 1e-6 * point.results_per_second()) : "-"}) {
            row.push_back(std::move(cell));
        }
        rows.push_back(std::move(row));
        if (point.routed && !point.fits) notes += fmt::format("{} does not fit: {}\n", what, point.why);
        for (const int seed : point.unrouted_seeds) {
            notes +=
                fmt::format("{}: seed {} is not routed in {} s of processor time\n", what, seed, router_cpu_seconds);
        }
        if (point.harness_limits) notes += fmt::format("{}*: the critical path is in the harness\n", what);
        if (const CriticalPath* path = point.path()) {
            notes += fmt::format("{}: {} to {}: {:.1f} ns of logic, {:.1f} of wires\n", what, path->from, path->to,
                                 path->logic_ns, path->routing_ns);
        }
        if (clock && point.resources.dsps > 0) with_dsps.insert(point.device);
    }
    return io::table(rows) + notes + dsp_clock_notes(with_dsps);
}

}  // namespace glint::fpga
