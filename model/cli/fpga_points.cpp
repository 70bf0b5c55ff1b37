#include "fpga_points.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "common.hpp"
#include "fpga_flow.hpp"
#include "glint/error.hpp"
#include "process.hpp"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view format = "glint-cost-fpga-1";

double rounded(double x) { return std::round(100.0 * x) / 100.0; }

Json to_json(const FpgaPoint& point) {
    Json out;
    out["lobe"] = point.lobe;
    out["profile"] = point.profile;
    out["architecture"] = point.architecture;
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
    if (!point.unrouted_seeds.empty()) out["unrouted_seeds"] = point.unrouted_seeds;
    out["latency"] = point.latency;
    out["interval"] = point.interval;
    if (!point.error.is_null()) out["error"] = point.error;
    out["hash"] = point.hash;
    return out;
}

[[noreturn]] void refuse(const std::filesystem::path& path) {
    throw Error(fmt::format("file '{}' is not of the format {}: name another, or remove it", path.string(), format));
}

/// What tells two points apart, in the order of the file. Throws the exceptions of Json.
std::vector<std::string> identity(const Json& point) {
    return {point.at("lobe").get<std::string>(), point.at("profile").get<std::string>(),
            point.at("architecture").get<std::string>(), point.at("device").get<std::string>(),
            point.at("dsp").get<bool>() ? "dsp" : ""};
}

Json read_points(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        return Json{{"format", format}, {"tools", Json::object()}, {"points", Json::array()}};
    }
    const Json file = Json::parse(read_file(path), nullptr, false);
    if (!file.is_object() || file.value("format", Json()) != format) refuse(path);
    return file;
}

}  // namespace

double FpgaPoint::clock_mhz() const {
    if (clocks_mhz.empty()) return 0.0;
    std::vector<double> sorted = clocks_mhz;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t half = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2.0;
}

double FpgaPoint::latency_ns() const { return clocks_mhz.empty() ? 0.0 : 1e3 * latency / clock_mhz(); }

double FpgaPoint::results_per_second() const { return 1e6 * clock_mhz() / interval; }

std::string merged(const std::filesystem::path& path, const ToolVersions& tools, const std::vector<FpgaPoint>& points) {
    Json file = read_points(path);
    std::map<std::vector<std::string>, Json> all;
    try {
        for (const auto& [tool, version] : tools) {
            const std::string there = file.at("tools").value(tool, version);
            if (there != version) {
                throw Error(fmt::format("file '{}' has prices of {} {}, and here is {}: name another, or remove it",
                                        path.string(), tool, there, version));
            }
            file["tools"][tool] = version;
        }
        for (const Json& point : file.at("points")) all[identity(point)] = point;
    } catch (const Json::exception&) {
        refuse(path);
    }
    for (const FpgaPoint& point : points) {
        const Json json = to_json(point);
        all[identity(json)] = json;
    }
    std::string out =
        fmt::format("{{\n\"format\": \"{}\",\n\"tools\": {},\n\"points\": [", format, file["tools"].dump());
    std::string_view separator = "\n";
    for (const auto& [key, point] : all) {
        out += fmt::format("{}{}", separator, point.dump());
        separator = ",\n";
    }
    return out + "\n]\n}\n";
}

std::string points_table(const std::vector<FpgaPoint>& points) {
    std::vector<std::vector<std::string>> rows{{"lobe", "profile", "architecture", "device", "dsp", "LUTs", "registers",
                                                "carries", "DSPs", "BRAMs", "MHz", "latency", "interval", "ns",
                                                "M results/s"}};
    std::string notes;
    for (const FpgaPoint& point : points) {
        const bool clock = !point.clocks_mhz.empty();
        std::string mhz = clock ? fmt::format("{:.1f}", point.clock_mhz()) : point.routed ? "does not fit" : "-";
        if (point.harness_limits) mhz += "*";
        rows.push_back({point.lobe, point.profile, point.architecture, point.device, point.dsp ? "on" : "off",
                        std::to_string(point.resources.luts), std::to_string(point.resources.registers),
                        std::to_string(point.resources.carries), std::to_string(point.resources.dsps),
                        std::to_string(point.resources.brams), mhz, std::to_string(point.latency),
                        std::to_string(point.interval), clock ? fmt::format("{:.1f}", point.latency_ns()) : "-",
                        clock ? fmt::format("{:.1f}", 1e-6 * point.results_per_second()) : "-"});
        const std::string what =
            fmt::format("{} {} {} {}", point.lobe, point.profile, point.architecture, point.device);
        if (point.routed && !point.fits) notes += fmt::format("{} does not fit: {}\n", what, point.why);
        for (const int seed : point.unrouted_seeds) {
            notes +=
                fmt::format("{}: seed {} is not routed in {} s of processor time\n", what, seed, router_cpu_seconds);
        }
        if (point.harness_limits) notes += fmt::format("{}*: the critical path is in the harness\n", what);
    }
    return table(rows) + notes;
}

}  // namespace glint::cli
