// The prices that `glint cost --fpga` finds: one point a unit and device, and the file that holds them.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cost/fpga/device.hpp"

namespace glint::fpga {

struct Point {
    std::string effect;       ///< empty for a lobe's unit
    std::optional<int> mask;  ///< of the effect shade: what is built
    std::string lobe;         ///< with its options; of an effect the one that it is made of, or empty
    std::string profile;
    std::string architecture;  ///< of an effect's unit empty where it is the default
    std::string unit;  ///< of a file of shells: "core"; "axis": the AXI4-Stream unit around it; "lanes": many of these
    int lanes = 1;     ///< how many
    std::string device;
    bool dsp = false;     ///< products may use DSPs
    Resources resources;  ///< of the unit: those of the harness are taken off
    int cells = 0;        ///< of the unit, after packing (Family::cell); 0: it was not placed
    bool routed = false;  ///< the device has a router; else what follows is not known
    bool fits = false;
    std::string why;                  ///< it does not fit
    std::vector<double> clocks_mhz;   ///< after place and route, one a seed
    std::vector<CriticalPath> paths;  ///< with each of these seeds
    std::vector<int> unrouted_seeds;  ///< without one: the router found no end
    bool harness_limits = false;      ///< with one of the seeds the critical path is in the harness alone
    int latency = 0;                  ///< clocks
    int interval = 0;                 ///< clocks between two results
    nlohmann::ordered_json error;     ///< of a rival: against c^n; null for the lobes
    std::string hash;                 ///< price_hash of fpga_flow.hpp

    double clock_mhz() const;  ///< the median; 0 when there is none
    double latency_ns() const;
    const CriticalPath* path() const;  ///< with the seed in the middle; null where no name is known
    double results_per_second() const;
};

/// By tool: the version.
using ToolVersions = std::map<std::string, std::string>;

/// What a file holds, or a table: points of lobes' units, of effects', or of units without and with the shell.
enum class PriceFile { lobes, effects, shells };

/// "glint-cost-fpga-1", "glint-cost-effects-1", "glint-cost-shell-1"
std::string_view format_of(PriceFile file);

/// The text of the file `path` with these points in it: those of the same unit and device are replaced, the others
/// stay. A file that is not there is empty. Throws Error: it is no such file, or its prices come from another version
/// of a tool.
std::string merged(const std::filesystem::path& path, PriceFile file, const ToolVersions& tools,
                   const std::vector<Point>& points);

/// What the points of a file are called, and their hashes; nothing else of a point is filled in. Throws Error: there is
/// no such file, or it is of no such format.
std::vector<Point> named_points(const std::filesystem::path& path);

/// "bps p12 restoring hx8k", "shade 10 bps p12 xc7 no DSPs"
std::string name_of(const Point& point);

/// One line a point.
std::string points_table(const std::vector<Point>& points, PriceFile file);

}  // namespace glint::fpga
