#include "cost/fpga/cost.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "cost/fpga/flow.hpp"
#include "cost/fpga/table.hpp"
#include "cost/fpga/units.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "io/command.hpp"

namespace glint::fpga {
namespace {

std::vector<int> parse_seeds(const std::string& text) {
    std::vector<int> out;
    for (const std::string& seed : io::split_list(text)) {
        out.push_back(static_cast<int>(io::parse_integer(seed, "--seeds", 1, INT32_MAX)));
        if (std::count(out.begin(), out.end(), out.back()) > 1) {
            throw Error(fmt::format("--seeds '{}' is not legal: each seed once", text));
        }
    }
    return out;
}

/// The devices of a list whose tools are there. A line says which others are left out.
std::vector<const Device*> usable_devices(Flow& flow, const std::string& text) {
    std::vector<const Device*> out;
    std::string left_out;
    for (const std::string& name : io::split_list(text)) {
        const Device& device = find_device(name);
        const std::string missing = flow.missing(device);
        if (missing.empty()) {
            out.push_back(&device);
        } else {
            left_out += fmt::format("{}{}: {}", left_out.empty() ? "" : "; ", name, missing);
        }
    }
    if (out.empty()) throw Error(left_out);
    if (!left_out.empty()) fmt::print(stderr, "left out: {}\n", left_out);
    return out;
}

/// With and without DSPs, where the device has any.
std::vector<bool> dsp_choices(const Device& device, const std::string& text) {
    if (text != "on" && text != "off" && text != "both") {
        throw Error(fmt::format("--dsp '{}' is not legal: on, off or both", text));
    }
    if (!device.has_dsps || text == "off") return {false};
    if (text == "on") return {true};
    return {false, true};
}

/// A unit on a device.
struct Request {
    std::shared_ptr<const PricedUnit> what;
    const Device* device = nullptr;
    bool dsp = false;
};

std::vector<Request> requests(const Options& options, Flow& flow) {
    const std::vector<const Device*> devices = usable_devices(flow, options.device);
    std::vector<Request> out;
    for (PricedUnit& unit : priced_units(options)) {
        const auto what = std::make_shared<const PricedUnit>(std::move(unit));
        for (const Device* device : devices) {
            if (!what->family.empty() && what->family != device->blocks) continue;
            if (!what->family.empty()) {  // its blocks are named in the Verilog
                out.push_back({what, device, device->has_dsps});
                continue;
            }
            for (const bool dsp : dsp_choices(*device, options.dsp)) out.push_back({what, device, dsp});
        }
    }
    if (out.empty())
        throw Error(fmt::format("architecture '{}' is of no device of '{}'", options.architecture, options.device));
    return out;
}

Products products_of(const PricedUnit& unit, bool dsp) {
    if (!unit.family.empty()) return unit.deep ? Products::deep_blocks : Products::blocks;
    return dsp ? Products::dsps : Products::gates;
}

Point price(Flow& flow, const Request& request, const std::vector<Source>& sources, const std::string& rtl,
            const std::vector<int>& seeds) {
    const Device& device = *request.device;
    const Unit& unit = request.what->unit;
    Point out = request.what->point;
    out.device = device.name;
    out.dsp = request.dsp;
    if (const GoldenModel* rival = request.what->rival.get()) {
        const std::vector<Source>& files = request.what->design.generated;
        out.error = flow.cached("error" + files.front().text + files.back().text, [&] { return table_error(*rival); });
    }
    std::vector<Source> simulated = read_models(rtl, request.what->design);
    simulated.insert(simulated.end(), sources.begin(), sources.end());
    const Clocks clocks = flow.count_clocks(simulated, unit, request.what->burst);
    out.latency = clocks.latency;
    out.interval = clocks.interval;

    const Products products = products_of(*request.what, request.dsp);
    std::vector<Source> with_harness = sources;
    with_harness.push_back({"glint_harness.v", harness(unit)});
    Flow::Netlist whole(flow, with_harness, device, products);
    Flow::Netlist alone(flow, {{"glint_harness.v", harness_alone(unit)}}, device, products);
    const Resources all = whole.resources();
    const Resources around = alone.resources();
    out.resources = {all.luts - around.luts, all.registers - around.registers, all.carries - around.carries,
                     all.dsps - around.dsps, all.brams - around.brams};

    out.routed = !device.family->router.empty();
    out.fits = out.routed;
    for (const int seed : out.routed ? seeds : std::vector<int>()) {
        const Routing routing = whole.route(seed);
        if (!routing.fits) {
            out.fits = false;
            out.why = routing.why;
            out.clocks_mhz.clear();
            out.paths.clear();
            break;
        }
        if (!routing.routed) {
            out.unrouted_seeds.push_back(seed);
            continue;
        }
        out.clocks_mhz.push_back(routing.clock_mhz);
        out.paths.push_back(routing.path);
        out.harness_limits |= routing.harness_limits;
        out.cells = routing.cells - alone.route(seed).cells;
    }
    if (out.fits && out.clocks_mhz.empty()) {
        out.fits = false;
        out.why = fmt::format("no seed is routed in {} s of processor time", router_cpu_seconds);
    }
    out.hash = price_hash(with_harness, device, products);
    return out;
}

/// Of the tools that these need, Yosys by one name whoever packs it. Throws Error: one file would hold two versions.
ToolVersions versions(Flow& flow, const std::vector<Request>& all) {
    ToolVersions out;
    for (const Request& request : all) {
        const Family& family = *request.device->family;
        const std::string& yosys = flow.version(std::string(family.yosys));
        if (out.try_emplace("yosys", yosys).first->second != yosys) {
            throw Error(fmt::format("device '{}' takes Yosys {}, another one Yosys {}: price them apart",
                                    request.device->name, yosys, out["yosys"]));
        }
        out["iverilog"] = flow.version("iverilog");
        if (!family.router.empty()) out[std::string(family.router)] = flow.version(std::string(family.router));
    }
    return out;
}

void measure(const Options& options) {
    Flow flow(options.cache);
    const std::vector<int> seeds = parse_seeds(options.seeds);
    io::check_writable(options.json);
    const std::vector<Request> all = requests(options, flow);
    const ToolVersions tools = versions(flow, all);
    const PriceFile file = options.shell            ? PriceFile::shells
                           : options.effect.empty() ? PriceFile::lobes
                                                    : PriceFile::effects;
    if (!options.json.empty()) merged(options.json, file, tools, {});  // what can be refused is, before the work
    std::vector<std::vector<Source>> sources;
    for (const Request& request : all) sources.push_back(read_sources(options.rtl, request.what->design));

    std::vector<Point> points(all.size());
    parallel_tasks(all.size(), options.jobs, io::progress_bar("cost"), [&] {
        return [&](std::size_t i) { points[i] = price(flow, all[i], sources[i], options.rtl, seeds); };
    });
    if (!options.json.empty()) {
        const io::FolderLock lock(options.json);
        io::write_file(options.json, merged(options.json, file, tools, points));
    }
    fmt::print("{}", points_table(points, file));
}

/// Whether the price is one of the Verilog in the folder `rtl`.
bool is_current(const Point& point, const std::string& rtl) {
    Options options;
    options.effect = point.effect;
    if (!point.lobe.empty()) options.lobe = point.lobe;
    if (point.mask) options.mask = std::to_string(*point.mask);
    options.profile = point.profile;
    options.architecture = point.architecture;
    options.shell = !point.unit.empty();
    options.lanes = point.lanes;
    const std::vector<PricedUnit> units = priced_units(options);
    const PricedUnit& priced = units[point.unit == "lanes" ? 2 : point.unit == "axis" ? 1 : 0];
    std::vector<Source> sources = read_sources(rtl, priced.design);
    sources.push_back({"glint_harness.v", harness(priced.unit)});
    const Device& device = find_device(point.device);
    return price_hash(sources, device, products_of(priced, point.dsp)) == point.hash;
}

/// A line for every lobe or effect that the file has no price of, or not at every shipped profile, listed architecture
/// without registers in its products or rows, and device of the file.
std::vector<std::string> not_priced(const std::vector<Point>& points) {
    std::set<std::array<std::string, 4>> there;
    std::set<std::string> devices, priced_effects;
    for (const Point& p : points) {
        if (!p.unit.empty()) return {};  // a file of shells is a sample
        if (p.effect.empty()) devices.insert(p.device);
        if (!p.effect.empty()) priced_effects.insert(p.effect);
        there.insert({p.lobe, p.profile, p.architecture, p.device});
    }
    std::vector<std::string> out;
    for (const Lobe& lobe : lobes()) {
        std::size_t all = 0, missing = 0;
        for (const Architecture& architecture : listed_architectures(lobe)) {
            if (architecture.name.find(':') != std::string::npos) continue;
            for (const Profile& profile : shipped_profiles()) {
                for (const std::string& device : devices) {
                    ++all;
                    missing += 1 - there.count({std::string(lobe.name), profile.name, architecture.name, device});
                }
            }
        }
        if (missing > 0) {
            out.push_back(
                fmt::format("not priced: {} at {} of {} profiles, architectures and devices", lobe.name, missing, all));
        }
    }
    for (const Effect& effect : effects()) {
        if (!priced_effects.empty() && priced_effects.count(std::string(effect.name)) == 0)
            out.push_back(fmt::format("not priced: effect {}", effect.name));
    }
    return out;
}

int check_file(const std::string& path, const Options& options) {
    const std::vector<Point> points = named_points(path);
    std::vector<char> current(points.size());
    parallel_tasks(points.size(), options.jobs, io::progress_bar("check"),
                   [&] { return [&](std::size_t i) { current[i] = is_current(points[i], options.rtl); }; });
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!current[i]) fmt::print("of other Verilog: {}\n", name_of(points[i]));
    }
    for (const std::string& line : not_priced(points)) fmt::print("{}\n", line);
    const auto stale = std::count(current.begin(), current.end(), 0);
    fmt::print("{}: {} prices, {} of other Verilog or options\n", path, points.size(), stale);
    return stale == 0 ? io::success : io::check_failed;
}

}  // namespace

int run_price_check(const Options& options) {
    if (!options.json.empty()) return check_file(options.json, options);
    const int status = check_file("cost/data/fpga.json", options);
    const std::string newer = "cost/data/fpga-yowasp.json";
    if (!std::filesystem::is_regular_file(newer)) return status;
    return std::max(status, check_file(newer, options));
}

int run_fpga(const Options& options) {
    try {
        measure(options);
    } catch (const ToolFailure& failure) {
        fmt::print(stderr, "glint: {}\n", failure.what());
        return io::check_failed;
    }
    return io::success;
}

}  // namespace glint::fpga
