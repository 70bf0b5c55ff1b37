// Generated sources: the constants of a lobe on their way to rtl/ and hls/.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/manifest.hpp"

namespace glint {

struct GeneratedFile {
    enum class Target { verilog, hls, proof };
    Target target = Target::verilog;
    std::string name;  ///< file name without a folder
    std::string text;
    std::optional<HardwareUnit> unit{};  ///< where it is the top module of one
};

/// What an AXI4-Stream unit has beside tdata, tuser and tlast.
struct Sidebands {
    bool keep = false, id = false, dest = false;
};

/// Of a list of keep, id, dest; an empty one has none. Throws Error.
Sidebands parse_sidebands(std::string_view list);

/// What Lobe::emit or Effect::emit gave, and behind its unit, the first file, the AXI4-Stream unit around it.
std::vector<GeneratedFile> with_axi_stream(std::vector<GeneratedFile> files, const Sidebands& sidebands = {});

/// What with_axi_stream gave, and behind that unit one of so many of it side by side, 2 to 64 (docs/rtl.md, "Lanes").
/// Throws Error.
std::vector<GeneratedFile> with_lanes(std::vector<GeneratedFile> files, int lanes);

/// The tables of these units in block memory: other modules in their place, glint_table_..._block, which ask for it by
/// the attribute rom_style. The same ports, bits and clocks.
void use_block_tables(std::vector<GeneratedFile>& files);

/// The Verilog that is committed in rtl/generated: the units of all lobes and effects at the shipped profiles, effects
/// made of a lobe with the first one, AXI4-Stream units at p12; and what they are made of. Each file once.
std::vector<GeneratedFile> committed_verilog();

/// The units among these files.
std::vector<HardwareUnit> units_of(const std::vector<GeneratedFile>& files);

}  // namespace glint
