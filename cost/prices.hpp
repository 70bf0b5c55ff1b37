// The files of cost/ joined: errors, prices on FPGAs, prices on a CPU.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cost/accuracy.hpp"
#include "cost/choice.hpp"
#include "cost/cpu_prices.hpp"

namespace glint::cost {

/// No price of a file is larger: LUTs, registers, clocks.
inline constexpr int largest_count = 100'000'000;

/// A price of cost/data/fpga.json or fpga-yowasp.json: `configuration` without its error.
struct Price {
    Configuration configuration;
    bool fits = true;  ///< false: too large for its device; then it has no clock, and perhaps no more than its name
    /// What is no lobe of the registry brings its own error, at the rounded cosine: over all n, and from 8 on.
    std::optional<double> error, error_from_8;
};

struct Prices {
    std::vector<AccuracyRecord> accuracy;
    std::vector<Price> fpga;
    std::optional<CpuPrices> cpu;
    std::vector<Price> hls;  ///< of hls.json: architecture "hls", or "hls:FORM" by the form of its divider
    std::string tools;       ///< of each file: "yosys 0.23, nextpnr-ice40 0.4; yosys 0.70"

    const AccuracyRecord* find(const std::string& lobe, const std::string& profile) const;
};

/// accuracy.json and fpga.json of a folder, and fpga-yowasp.json, cpu.json and hls.json where they are there. Throws
/// Error: what is missing or not legal in which file, and what writes it.
Prices read_cost_data(const std::string& folder);

/// What a comparison is about.
struct Scope {
    Range n{1, max_n, 1};
    Cosine cosine = Cosine::rounded;
    std::optional<double> asked_mhz;  ///< the clock that a configuration is run at, where it reaches it
    bool hls = false;                 ///< what a high-level synthesis tool made of the kernels, too
};

/// The prices of a device, or of all for an empty name, each with its error. Left out are those that do not fit their
/// device, and those without a known error: their lobe and profile go into `unknown`, once.
std::vector<Configuration> join(const Prices& data, const Scope& scope, const std::string& device,
                                std::vector<std::string>* unknown = nullptr);

/// Whether it is a kernel's, not a unit's of the Verilog.
bool is_hls(const Configuration& configuration);

/// The command that writes it: `glint emit --lobe ...`.
std::string emit_line(const Configuration& configuration);

/// The devices that there are prices for, in the order of fpga::devices().
std::vector<std::string> priced_devices(const Prices& data);

/// The name of a device that there are prices for: itself, or the first of a family, such as ecp5-25k for ecp5. Throws
/// Error.
std::string priced_device(const Prices& data, const std::string& name);

/// "rounded" or "exact". Throws Error.
Cosine parse_cosine(const std::string& text);

/// "n 8 to 1000, at the rounded cosine"
std::string to_text(const Scope& scope);

/// Three significant digits.
std::string short_number(double x);
/// "-" for what is not known.
std::string short_number(std::optional<double> x);

}  // namespace glint::cost
