// The Verilog around a unit that is priced: the harness that place and route sees, and the bench that counts clocks.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glint/profile.hpp"

namespace glint::fpga {

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

/// A unit with the handshake of docs/rtl.md around these ports of data. Its last result is `clamped_o`.
Unit stream_unit(std::string module, const std::vector<Port>& inputs, const std::vector<Port>& results, int tag_w);

/// A lobe's unit.
Unit lobe_unit(std::string module, const Profile& profile, int tag_w);

/// The module `glint_harness`, four pins wide: every input of the unit is a register of a shift chain, every output
/// goes to a register and from there to a second chain. Both chains stand in one, so that no register of it is ever
/// unused.
std::string harness(const Unit& unit);

/// The same harness without the unit: wires in its place.
std::string harness_alone(const Unit& unit);

/// An input of a stream_unit and what it answers, by the contract.
struct Exchange {
    std::vector<std::int64_t> in;   ///< a code per port of data
    std::vector<std::int64_t> out;  ///< a value, not negative, per port of results, then `clamped`
};

/// The ports of a stream_unit but for those of the handshake: those of `Exchange::in` and `Exchange::out`.
std::vector<Port> data_ports(const Unit& unit);
std::vector<Port> result_ports(const Unit& unit);

/// The module `glint_clocks`, a bench for a stream_unit. It sends the first input alone, then all without a pause, and
/// prints "latency L" and for each result of the burst "result CLOCK" and the values of the exchange; "no result" where
/// one does not come.
std::string clocks_bench(const Unit& unit, std::span<const Exchange> burst);

}  // namespace glint::fpga
