// How a stream looks at the ports of a Verilated model.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glint::testbench {

/// The names that all streams but AXI4-Stream share (docs/rtl.md). Tags have 31 bits.
struct StreamPins {
    static constexpr int reset_latency = 0;  ///< clocks until valid and ready have fallen
    static constexpr std::uint32_t tag(std::uint32_t tag) { return tag & 0x7fff'ffffU; }

    template <class Model>
    static void clock(Model& m, bool level) {
        m.clk_i = level;
    }
    template <class Model>
    static void reset(Model& m, bool active) {
        m.rst_ni = !active;
    }
    template <class Model>
    static void input_valid(Model& m, bool valid) {
        m.valid_i = valid;
    }
    template <class Model>
    static bool input_ready(const Model& m) {
        return m.ready_o;
    }
    template <class Model>
    static bool output_valid(const Model& m) {
        return m.valid_o;
    }
    template <class Model>
    static void output_ready(Model& m, bool ready) {
        m.ready_i = ready;
    }
    template <class Model>
    static std::uint32_t output_tag(const Model& m) {
        return m.tag_o;
    }
    template <class Model>
    static bool clamped(const Model& m) {
        return m.clamped_o;
    }
    /// The low bits of a code, those of `mask`.
    template <class Pin>
    static void set(Pin& pin, std::int32_t code, std::uint32_t mask) {
        pin = static_cast<Pin>(static_cast<std::uint32_t>(code) & mask);
    }
};

/// Ports of the AXI4-Stream unit of a lobe. tuser carries the tag; tlast one bit of a mix of it, so that neither a
/// stuck nor a shifted tlast goes unseen.
struct AxisPins {
    static constexpr std::size_t inputs = 2, outputs = 1;
    static constexpr int reset_latency = 1;  ///< every output is a register
    static constexpr std::uint32_t last(std::uint32_t tag) { return (tag * 0x9e37'79b9U) >> 31; }
    static constexpr std::uint32_t tag(std::uint32_t tag) { return (tag & 0xffffU) | last(tag) << 16; }

    template <class Model>
    static void clock(Model& m, bool level) {
        m.aclk = level;
    }
    template <class Model>
    static void reset(Model& m, bool active) {
        m.aresetn = !active;
    }
    template <class Model>
    static void input(Model& m, const std::int32_t* const* in, std::size_t i, const std::uint32_t*, std::uint32_t tag) {
        // The bits between the fields are ignored by contract: fill them with what would show if they were not.
        const std::uint32_t low = static_cast<std::uint32_t>(in[0][i]) | (tag * 0x85eb'ca6bU & ~0x3ffU);
        m.s_axis_tdata = std::uint64_t{static_cast<std::uint32_t>(in[1][i])} << 32 | low;
        m.s_axis_tuser = static_cast<std::uint16_t>(tag);
        m.s_axis_tlast = last(tag) != 0;
    }
    template <class Model>
    static void input_valid(Model& m, bool valid) {
        m.s_axis_tvalid = valid;
    }
    template <class Model>
    static bool input_ready(const Model& m) {
        return m.s_axis_tready;
    }
    template <class Model>
    static bool output_valid(const Model& m) {
        return m.m_axis_tvalid;
    }
    template <class Model>
    static void output_ready(Model& m, bool ready) {
        m.m_axis_tready = ready;
    }
    template <class Model>
    static void output(const Model& m, std::int32_t* values) {
        values[0] = static_cast<std::int32_t>(m.m_axis_tdata & 0x7fff'ffffU);
    }
    template <class Model>
    static bool clamped(const Model& m) {
        return m.m_axis_tdata >> 31;
    }
    template <class Model>
    static std::uint32_t output_tag(const Model& m) {
        return m.m_axis_tuser | static_cast<std::uint32_t>(m.m_axis_tlast) << 16;
    }
};

}  // namespace glint::testbench
