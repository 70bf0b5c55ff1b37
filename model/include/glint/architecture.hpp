// How a unit of Verilog is built. Every architecture of a unit gives the same bits; they differ in clocks and area.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glint {

struct HardwareUnit;
struct Lobe;

/// A divider: a module behind glint_divider.v.
struct Divider {
    std::string_view name;  ///< of its architecture, and behind "glint_divider_" of its module
    std::string_view module;
    bool rows;                                 ///< of its rows, some may share a clock
    bool pipeline;                             ///< takes operands every clock
    int (*clocks)(int Q, int R, int M);        ///< for Q quotient bits, R rows in a clock, products of M clocks
    std::vector<std::string_view> parts = {};  ///< modules that it contains
};

/// All dividers, in the order of the parameter DIVIDER: this is the one list of them in C++, and rtl/units.json has it
/// for others. glint_divider.v and glint_ports.v (the same clocks) are the Verilog of it.
std::span<const Divider> dividers();

/// "0 restoring, 1 ...", each divider with its number.
std::string numbered_dividers();

struct Architecture {
    std::string name;  ///< canonical: what is as in the default is left out, e.g. "restoring", "iterative:m3"
    /// Of the unit and of its wrappers, as in docs/rtl.md: DIVIDER (an index of dividers()) and REGISTER_EVERY for a
    /// lobe with a divider, MULTIPLIER_STAGES for all, DEEP (0 or 1) where the lobe has it.
    std::vector<std::pair<std::string, int>> parameters;
    std::string family = {};  ///< devices whose own blocks it is built of, a name of families(); empty: any device
    bool block = false;       ///< its tables ask for block memory

    /// The value of a parameter; `otherwise` where the architecture has none of that name.
    int parameter(std::string_view name_of_it, int otherwise) const;

    friend bool operator==(const Architecture&, const Architecture&) = default;
};

/// For a lobe with a divider "DIVIDER[:rN][:mN][:FAMILY]" with DIVIDER a name of dividers(); for others
/// "pipelined[:deep][:block][:mN][:FAMILY]". rN, of dividers with rows: a register after every N rows of the divider,
/// 1 to 32; mN: a product takes N clocks, 1 to 4. Both are 1 where they are left out. deep, of `decay`: a
/// register after each step of glint_normalise, and one more after each table. block, where Lobe::block is: the tables
/// ask for block memory, which a tool does not give to small ones of its own. FAMILY: ecp5, up5k or ice40. Throws
/// Error.
Architecture parse_architecture(const Lobe& lobe, std::string_view text);

/// For the unit of an effect "default[:block][:mN][:FAMILY]", with block where it has tables, mN where it has the
/// parameter MULTIPLIER_STAGES; its name is empty where nothing is as in the default. Throws Error.
Architecture parse_architecture(const HardwareUnit& unit, std::string_view text);

/// "restoring", or "pipelined" for a lobe without a divider.
Architecture default_architecture(const Lobe& lobe);

/// Those that documents, prices and the manifest list, the default first: each divider with products of one clock and
/// of two, or "pipelined" so; an example of rows; "pipelined:deep".
std::vector<Architecture> listed_architectures(const Lobe& lobe);

/// The clocks of a division of so many quotient bits; 0 bits are none.
int division_clocks(const Architecture& architecture, int quotient_bits);

/// Whether the unit accepts an input while another one is inside.
bool takes_one_a_clock(const Architecture& architecture);

}  // namespace glint
