#include "fpga_cost.hpp"

#include <algorithm>
#include <random>
#include <set>

#include <fmt/format.h>

#include "common.hpp"
#include "fpga_flow.hpp"
#include "fpga_table.hpp"
#include "glint/architecture.hpp"
#include "glint/error.hpp"

namespace glint::cli {
namespace {

constexpr int tag_w = 1;  // the least: each further bit is a register, or a part of one, a clock of latency
constexpr std::size_t burst_length = 64;

using Json = nlohmann::ordered_json;

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        out.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

std::vector<int> parse_seeds(const std::string& text) {
    std::vector<int> out;
    for (const std::string& seed : split(text)) {
        out.push_back(static_cast<int>(parse_integer(seed, "--seeds", 1, INT32_MAX)));
        if (std::count(out.begin(), out.end(), out.back()) > 1) {
            throw Error(fmt::format("--seeds '{}' is not legal: each seed once", text));
        }
    }
    return out;
}

/// The devices of a list that a router is there for. Of the others a line says that they are left out.
std::vector<const Device*> usable_devices(Flow& flow, const std::string& text) {
    std::vector<const Device*> out;
    std::string left_out;
    for (const std::string& name : split(text)) {
        const Device& device = find_device(name);
        const std::string router(device.family->router);
        if (router != "nextpnr-ecp5" || flow.has(router)) {
            out.push_back(&device);
        } else {
            left_out = fmt::format("{}: {} is not there; scripts/ecp5.sh puts one into build/venv", name, router);
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

constexpr std::string_view all_architectures =
    "restoring,radix4,iterative,reciprocal,restoring:m2,radix4:m2,iterative:m2,reciprocal:m2,pipelined,pipelined:m2";

/// Those of a list that the lobe can have: one with a divider and one without have none in common. Throws Error when
/// there is none.
std::vector<Architecture> architectures(const Lobe& lobe, const std::string& text) {
    if (text.empty()) return {default_architecture(lobe)};
    std::vector<Architecture> out;
    std::string refused;
    for (const std::string& name : split(text == "all" ? std::string(all_architectures) : text)) {
        try {
            const Architecture architecture = parse_architecture(lobe, name);
            if (std::find(out.begin(), out.end(), architecture) == out.end()) out.push_back(architecture);
        } catch (const Error& error) {
            refused = error.what();
        }
    }
    if (out.empty()) throw Error(refused);
    return out;
}

/// Throws Error for an architecture of a list that none of the lobes can have.
void check_architectures(const std::vector<LobeChoice>& lobes, const std::string& text) {
    if (text.empty() || text == "all") return;
    for (const std::string& name : split(text)) {
        std::string refused;
        const bool legal = std::any_of(lobes.begin(), lobes.end(), [&](const LobeChoice& choice) {
            try {
                parse_architecture(*choice.lobe, name);
                return true;
            } catch (const Error& error) {
                refused = error.what();
                return false;
            }
        });
        if (!legal) throw Error(refused);
    }
}

/// A unit: its wrapper, and what it computes.
struct Priced {
    std::string lobe;
    Architecture architecture;  // its parameters are set where the unit is instantiated
    std::shared_ptr<const GoldenModel> model;
    std::vector<Source> files;  // the last is the module
    Json error;                 // of a rival
};

/// A unit on a device.
struct Request {
    std::shared_ptr<const Priced> what;
    const Device* device = nullptr;
    bool dsp = false;
};

constexpr std::string_view rival = "table";

std::vector<Priced> lobe_units(const FpgaOptions& options, const std::string& lobes) {
    std::vector<Priced> out;
    const std::vector<LobeChoice> choices = split_lobes(lobes);
    check_architectures(choices, options.architecture);
    for (const LobeChoice& choice : choices) {
        const Lobe& lobe = *choice.lobe;
        const std::string name = std::string(lobe.name) + (choice.options.empty() ? "" : ":" + choice.options);
        for (const std::string& text : split_profiles(options.profile)) {
            const Profile profile = choice.profile(text);
            const std::shared_ptr<const GoldenModel> model = lobe.golden(profile);
            for (const Architecture& architecture : architectures(lobe, options.architecture)) {
                const GeneratedFile wrapper = lobe.emit(profile, architecture).front();
                Architecture parameters = architecture;
                if (architecture == default_architecture(lobe)) parameters.parameters.clear();  // the wrapper's own
                out.push_back({name, parameters, model, {{wrapper.name, wrapper.text}}, nullptr});
            }
        }
    }
    return out;
}

std::vector<Priced> tables(const FpgaOptions& options, Flow& flow) {
    std::vector<Priced> out;
    for (const std::string& text : split_profiles(options.profile)) {
        const Profile profile = parse_profile(text);
        if (!profile.shipped())
            throw Error(fmt::format("profile '{}' is not legal for {}: p8, p12 or p16", text, rival));
        const TableFormat format = TableFormat::best(profile);
        const std::shared_ptr<const GoldenModel> model = table_model(profile, format);
        const std::vector<Source> unit = table_unit(profile, format);
        const Json error =
            flow.cached("error" + unit.front().text + unit.back().text, [&] { return table_error(*model); });
        out.push_back({std::string(rival), {"pipelined", {}}, model, unit, error});
    }
    return out;
}

std::vector<Request> requests(const FpgaOptions& options, Flow& flow) {
    const std::vector<const Device*> devices = usable_devices(flow, options.device);
    std::string lobes;
    bool with_rival = false;
    for (const std::string& name : split(options.lobe)) {
        if (name == rival) {
            with_rival = true;
        } else {
            lobes += (lobes.empty() ? "" : ",") + name;
        }
    }
    std::vector<Priced> units;
    if (!lobes.empty() || !with_rival) units = lobe_units(options, lobes);
    if (with_rival) {
        for (Priced& unit : tables(options, flow)) units.push_back(std::move(unit));
    }
    std::vector<Request> out;
    for (const Priced& unit : units) {
        const auto what = std::make_shared<const Priced>(unit);
        for (const Device* device : devices) {
            for (const bool dsp : dsp_choices(*device, options.dsp)) out.push_back({what, device, dsp});
        }
    }
    return out;
}

/// Legal inputs, their ends among them, and some that are corrected.
std::vector<Stimulus> stimuli(const Profile& profile) {
    std::vector<Stimulus> out{{1, 0},   {max_n, profile.one()}, {1, profile.one()}, {0, 1},
                              {50, -1}, {50, profile.one() + 1}};
    std::mt19937 random;
    while (out.size() < burst_length) {
        const int n = 1 + static_cast<int>(random() % max_n);
        out.push_back({n, static_cast<std::int64_t>(random() % static_cast<unsigned>(profile.one() + 1))});
    }
    return out;
}

FpgaPoint price(Flow& flow, const Request& request, const std::vector<Source>& sources, const std::vector<int>& seeds) {
    const Profile& profile = request.what->model->profile();
    const Device& device = *request.device;
    FpgaPoint out;
    out.lobe = request.what->lobe;
    out.profile = profile.argument();
    out.architecture = request.what->architecture.name;
    out.device = device.name;
    out.dsp = request.dsp;
    out.error = request.what->error;

    Unit unit = lobe_unit(std::filesystem::path(request.what->files.back().name).stem(), profile, tag_w);
    for (const auto& [name, value] : request.what->architecture.parameters) {
        unit.parameters += fmt::format(", .{}({})", name, value);
    }
    const std::vector<Stimulus> burst = stimuli(profile);
    std::vector<PortResult> expected;
    for (const Stimulus& in : burst) expected.push_back(request.what->model->eval_port(in.n, in.cos_code));
    const Clocks clocks = flow.count_clocks(sources, unit, profile, burst, expected);
    out.latency = clocks.latency;
    out.interval = clocks.interval;

    std::vector<Source> with_harness = sources;
    with_harness.push_back({"glint_harness.v", harness(unit)});
    Flow::Netlist whole(flow, with_harness, device, request.dsp);
    Flow::Netlist alone(flow, {{"glint_harness.v", harness_alone(unit)}}, device, request.dsp);
    const Resources all = whole.resources();
    const Resources around = alone.resources();
    out.resources = {all.luts - around.luts, all.registers - around.registers, all.carries - around.carries,
                     all.dsps - around.dsps, all.brams - around.brams};

    std::string key = whole.key();
    for (const std::string& argument : device.arguments) key += " " + argument;
    out.routed = !device.family->router.empty();
    out.fits = out.routed;
    for (const int seed : out.routed ? seeds : std::vector<int>()) {
        const Routing routing = whole.route(seed);
        key += fmt::format(" {}", seed);
        if (!routing.fits) {
            out.fits = false;
            out.why = routing.why;
            out.clocks_mhz.clear();
            break;
        }
        if (!routing.routed) {
            out.unrouted_seeds.push_back(seed);
            continue;
        }
        out.clocks_mhz.push_back(routing.clock_mhz);
        out.harness_limits |= routing.harness_limits;
        out.cells = routing.cells - alone.route(seed).cells;
    }
    if (out.fits && out.clocks_mhz.empty()) {
        out.fits = false;
        out.why = fmt::format("no seed is routed in {} s of processor time", router_cpu_seconds);
    }
    out.hash = hash(key);
    return out;
}

void measure(const FpgaOptions& options) {
    Flow flow(options.cache);
    const std::vector<int> seeds = parse_seeds(options.seeds);
    check_writable(options.json);
    const std::vector<Request> all = requests(options, flow);
    ToolVersions tools;
    for (const Request& request : all) {
        for (const std::string& tool :
             {std::string("yosys"), std::string("iverilog"), std::string(request.device->family->router)}) {
            if (!tool.empty()) tools[tool] = flow.version(tool);
        }
    }
    if (!options.json.empty()) merged(options.json, tools, {});  // what can be refused is, before the work
    std::vector<std::vector<Source>> sources;
    for (const Request& request : all) sources.push_back(with_dependencies(options.rtl, request.what->files));

    std::vector<FpgaPoint> points(all.size());
    parallel_tasks(all.size(), options.jobs, progress_bar("cost"),
                   [&] { return [&](std::size_t i) { points[i] = price(flow, all[i], sources[i], seeds); }; });
    if (!options.json.empty()) write_file(options.json, merged(options.json, tools, points));
    fmt::print("{}", points_table(points));
}

}  // namespace

int run_fpga(const FpgaOptions& options) {
    try {
        measure(options);
    } catch (const ToolFailure& failure) {
        fmt::print(stderr, "glint: {}\n", failure.what());
        return check_failed;
    }
    return success;
}

}  // namespace glint::cli
