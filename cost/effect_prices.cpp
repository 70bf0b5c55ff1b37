#include "cost/effect_prices.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "cost/prices.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"
#include "io/json_node.hpp"

namespace glint::cost {
namespace {

fpga::Point read_point(const io::JsonNode& node) {
    fpga::Point out;
    out.effect = node.word("effect");
    if (node.has("mask")) out.mask = node.integer("mask", 0, largest_count);
    if (node.has("lobe")) out.lobe = node.text("lobe");
    out.profile = node.text("profile");
    if (node.has("architecture")) out.architecture = node.text("architecture");
    out.device = node.word("device");
    out.dsp = node.boolean("dsp");
    out.resources.luts = node.integer("luts", 0, largest_count);
    out.resources.registers = node.integer("registers", 0, largest_count);
    out.resources.carries = node.integer("carries", 0, largest_count);
    out.resources.dsps = node.integer("dsps", 0, largest_count);
    out.resources.brams = node.integer("brams", 0, largest_count);
    out.routed = node.has("fits");
    out.fits = out.routed && node.boolean("fits");
    if (out.fits) out.cells = node.integer("cells", 0, largest_count);
    if (out.routed && !out.fits) out.why = node.text("why");
    out.harness_limits = node.has("harness_limits") && node.boolean("harness_limits");
    out.clocks_mhz = node.numbers("clock_mhz_seeds");
    if (out.fits == out.clocks_mhz.empty()) node.fail("clock_mhz_seeds", "clocks where the unit fits, else none");
    if (std::count(out.clocks_mhz.begin(), out.clocks_mhz.end(), 0.0) > 0) node.fail("clock_mhz_seeds", "above 0");
    if (node.has("unrouted_seeds")) {
        for (const double seed : node.numbers("unrouted_seeds")) out.unrouted_seeds.push_back(static_cast<int>(seed));
    }
    out.latency = node.integer("latency", 1, largest_count);
    out.interval = node.integer("interval", 1, largest_count);
    out.hash = node.word("hash");
    return out;
}

/// Whether a list, which may be empty or "all", holds the value.
bool named(const std::string& list, const std::string& value) {
    if (list.empty() || list == "all") return true;
    const std::vector<std::string> names = io::split_list(list);
    return std::find(names.begin(), names.end(), value) != names.end();
}

}  // namespace

EffectPrices read_effect_prices(const std::string& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw Error(
            fmt::format("file '{0}' is not there: `glint cost --fpga --effect all --json {0}` writes it", path));
    }
    const std::string name = fmt::format("price file '{}'", path);
    const nlohmann::json json = io::read_json(path, name);
    const io::JsonNode top(json, name);
    const std::string_view format = fpga::format_of(fpga::PriceFile::effects);
    if (top.text("format") != format) top.fail("format", format);
    EffectPrices out;
    const io::JsonNode tools = top.node("tools");
    for (const auto& [tool, version] : json["tools"].items()) out.tools[tool] = tools.text(tool.c_str());
    for (const io::JsonNode& node : top.nodes("points")) out.points.push_back(read_point(node));
    if (out.points.empty()) throw Error(name + " holds no points");
    return out;
}

int run_effect_table(const EffectTableOptions& options) {
    const std::string path = (std::filesystem::path(options.data) / "effects.json").string();
    EffectPrices prices = read_effect_prices(path);
    const std::vector<std::string> profiles = io::split_profiles(options.profile);
    std::erase_if(prices.points, [&](const fpga::Point& point) {
        const bool profile =
            options.profile.empty() || std::find(profiles.begin(), profiles.end(), point.profile) != profiles.end();
        const bool mask = options.mask.empty() || (point.mask && named(options.mask, std::to_string(*point.mask)));
        return !(profile && mask && named(options.effect, point.effect) && named(options.device, point.device) &&
                 (options.lobe.empty() || point.lobe == options.lobe));
    });
    if (prices.points.empty()) {
        throw Error(fmt::format("price file '{}' has no such point: effect {}, mask {}, profile {}, device {}", path,
                                options.effect, options.mask.empty() ? "any" : options.mask,
                                options.profile.empty() ? "any" : options.profile,
                                options.device.empty() ? "any" : options.device));
    }
    if (!options.json.empty()) {
        io::write_file(options.json, merged({}, fpga::PriceFile::effects, prices.tools, prices.points));
    }
    fmt::print("{}", points_table(prices.points, fpga::PriceFile::effects));
    return io::success;
}

}  // namespace glint::cost
