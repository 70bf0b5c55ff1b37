// How a stream looks at the ports of a Verilated model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace glint::testbench {

/// The number that the low bits of a port hold in two's complement.
constexpr std::int32_t sign_extended(std::uint32_t code, int bits) {
    return static_cast<std::int32_t>(code << (32 - bits)) >> (32 - bits);
}

/// The names that all streams but AXI4-Stream share (docs/rtl.md). Tags have 31 bits.
struct StreamPins {
    static constexpr int reset_latency = 0;  ///< clocks until valid and ready have fallen
    static constexpr std::uint32_t tag(std::uint32_t tag) { return tag & 0x7fff'ffffU; }

    static void clock(auto& m, bool level) { m.clk_i = level; }
    static void reset(auto& m, bool active) { m.rst_ni = !active; }
    static void input_valid(auto& m, bool valid) { m.valid_i = valid; }
    static bool input_ready(const auto& m) { return m.ready_o; }
    static bool output_valid(const auto& m) { return m.valid_o; }
    static void output_ready(auto& m, bool ready) { m.ready_i = ready; }
    static std::uint32_t output_tag(const auto& m) { return m.tag_o; }
    static bool clamped(const auto& m) { return m.clamped_o; }
    /// The low bits of a code, those of `mask`.
    template <class Pin>
    static void set(Pin& pin, std::int32_t code, std::uint32_t mask) {
        pin = static_cast<Pin>(static_cast<std::uint32_t>(code) & mask);
    }
};

/// Ports of an AXI4-Stream unit. A word of 32 bits holds each number; where `Packed`, one holds them all (docs/rtl.md).
/// tuser carries the tag; the other sidebands and tlast bits of a mix of it, so that neither a stuck nor a shifted one
/// goes unseen. Of `Lanes` side by side, one after the other gets the input and shows the result; the others get junk.
template <std::size_t Inputs, std::size_t Outputs, bool Packed, bool Sidebands, std::size_t Lanes>
struct AxisPins {
    static constexpr std::size_t inputs = Inputs, outputs = Outputs;
    static constexpr int reset_latency = 1;  ///< every output is a register
    static constexpr std::uint32_t mixed(std::uint32_t tag) { return tag * 0x9e37'79b9U; }
    static constexpr std::uint32_t last(std::uint32_t tag) { return mixed(tag) >> 31; }
    static constexpr std::uint32_t kept(std::uint32_t tag) { return mixed(tag) >> 30 & 1; }
    static constexpr std::uint32_t id(std::uint32_t tag) { return mixed(tag) >> 25 & 0x1f; }
    static constexpr std::uint32_t dest(std::uint32_t tag) { return mixed(tag) >> 21 & 0xf; }
    static constexpr std::uint32_t packed(std::uint32_t user, std::uint32_t last, std::uint32_t keep, std::uint32_t id,
                                          std::uint32_t dest) {
        return user | last << 16 | keep << 17 | id << 21 | dest << 26;
    }
    static constexpr std::uint32_t tag(std::uint32_t tag) {
        if (!Sidebands) return packed(tag & 0xffffU, last(tag), 0, 0, 0);
        return packed(tag & 0xffffU, last(tag), kept(tag) * 0xf, id(tag), dest(tag));
    }

    static constexpr std::size_t lane(std::uint32_t tag) { return (tag & 0xffffU) % Lanes; }
    static constexpr std::size_t words_in = Packed ? 1 : Inputs;  ///< of a lane

    /// The k-th 32 bits of a port.
    template <class Pin>
    static void set_word(Pin& pin, std::size_t k, std::uint32_t word) {
        if constexpr (std::is_integral_v<Pin>) {
            pin = static_cast<Pin>((pin & ~(std::uint64_t{0xffff'ffff} << 32 * k)) | std::uint64_t{word} << 32 * k);
        } else {
            pin[k] = word;
        }
    }
    template <class Pin>
    static std::uint32_t word(const Pin& pin, std::size_t k) {
        if constexpr (std::is_integral_v<Pin>) {
            return static_cast<std::uint32_t>(pin >> 32 * k);
        } else {
            return pin[k];
        }
    }

    static void clock(auto& m, bool level) { m.aclk = level; }
    static void reset(auto& m, bool active) { m.aresetn = !active; }
    static void input(auto& m, const std::int32_t* const* in, std::size_t i, const std::uint32_t* mask,
                      std::uint32_t tag) {
        // The bits between the fields are ignored by contract: fill them with what would show if they were not.
        const std::uint32_t junk = tag * 0x85eb'ca6bU;
        if constexpr (Lanes > 1) {
            for (std::size_t k = 0; k < Lanes * words_in; ++k) {
                set_word(m.s_axis_tdata, k, junk * static_cast<std::uint32_t>(2 * k + 3));
            }
        }
        if constexpr (Packed) {  // n and cos
            const std::uint32_t fields = static_cast<std::uint32_t>(in[0][i]) | static_cast<std::uint32_t>(in[1][i])
                                                                                    << 10;
            const std::uint32_t used = mask[0] | mask[1] << 10;
            set_word(m.s_axis_tdata, lane(tag), (fields & used) | (junk & ~used));
        } else {
            for (std::size_t k = 0; k < Inputs; ++k) {
                set_word(m.s_axis_tdata, lane(tag) * Inputs + k,
                         (static_cast<std::uint32_t>(in[k][i]) & mask[k]) | (junk & ~mask[k]));
            }
        }
        m.s_axis_tuser = static_cast<std::uint16_t>(tag);
        m.s_axis_tlast = last(tag) != 0;
        if constexpr (Sidebands) {
            // A byte of the lane's word, or none; the other lanes have theirs.
            const std::uint32_t own = 0xfU << 4 * lane(tag);
            m.s_axis_tkeep = static_cast<std::remove_reference_t<decltype(m.s_axis_tkeep)>>(
                (kept(tag) << (junk >> 30) << 4 * lane(tag)) | (Lanes > 1 ? junk >> 8 & ~own : 0));
            m.s_axis_tid = static_cast<std::uint8_t>(id(tag));
            m.s_axis_tdest = static_cast<std::uint8_t>(dest(tag));
        }
    }
    static void input_valid(auto& m, bool valid) { m.s_axis_tvalid = valid; }
    static bool input_ready(const auto& m) { return m.s_axis_tready; }
    static bool output_valid(const auto& m) { return m.m_axis_tvalid; }
    static void output_ready(auto& m, bool ready) { m.m_axis_tready = ready; }
    static bool clamped(const auto& m) { return result(m, 0) >> 31; }
    /// The k-th word of the result.
    static std::uint32_t result(const auto& m, std::size_t k) {
        return word(m.m_axis_tdata, lane(m.m_axis_tuser) * Outputs + k);
    }
    static std::uint32_t output_tag(const auto& m) {
        if constexpr (Sidebands) {
            const std::uint32_t keep = m.m_axis_tkeep >> 4 * lane(m.m_axis_tuser) & 0xf;
            return packed(m.m_axis_tuser, m.m_axis_tlast, keep, m.m_axis_tid, m.m_axis_tdest);
        } else {
            return packed(m.m_axis_tuser, m.m_axis_tlast, 0, 0, 0);
        }
    }
};

}  // namespace glint::testbench
