// The Verilog around a unit that is priced: the harness that place and route sees, and the bench that counts clocks.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "glint/profile.hpp"

namespace glint::cli {

struct Port {
    std::string name;
    int width = 1;
};

/// A module with the clock `clk_i` and no other port than these.
struct Unit {
    std::string module;
    std::string parameters;  ///< ".TAG_W(1)", or empty
    std::vector<Port> inputs;
    std::vector<Port> outputs;
};

/// A lobe's unit: the ports of docs/rtl.md.
Unit lobe_unit(std::string module, const Profile& profile, int tag_w);

/// The module `glint_harness`, four pins wide: every input of the unit is a register of a shift chain, every output
/// goes to a register and from there to a second chain. Both chains stand in one, so that no register of it is ever
/// unused.
std::string harness(const Unit& unit);

/// The same harness without the unit: wires in its place.
std::string harness_alone(const Unit& unit);

struct Stimulus {
    int n = 0;
    std::int64_t cos_code = 0;
};

/// The module `glint_clocks`, a bench for a lobe's unit. It sends the first input alone, then all without a pause, and
/// prints "latency L" and for each result of the burst "result CLOCK y clamped"; "no result" where one does not come.
std::string clocks_bench(const Unit& unit, const Profile& profile, std::span<const Stimulus> burst);

}  // namespace glint::cli
