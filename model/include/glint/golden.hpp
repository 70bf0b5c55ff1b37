// What every golden model offers: the integers that a lobe's contract prescribes, whoever computes them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "glint/profile.hpp"

namespace glint {

/// What the ports of a unit show for one input.
struct PortResult {
    std::uint32_t y = 0;   ///< code / 2^O
    bool clamped = false;  ///< an argument was out of range and was corrected
    friend bool operator==(const PortResult&, const PortResult&) = default;
};

/// A result as one word: y in the low bits, `clamped` in bit 31, as on the AXI4-Stream port.
constexpr std::uint32_t pack(const PortResult& result) { return result.y | (result.clamped ? 0x8000'0000U : 0U); }
constexpr PortResult unpack(std::uint32_t word) { return {word & 0x7fff'ffffU, (word >> 31) != 0}; }

/// One intermediate value, under the name that it has in docs/contract.md, in the Verilog and in the HLS kernel.
struct Intermediate {
    std::string_view name;
    std::int64_t code = 0;
    int fraction_bits = 0;  ///< value = code / 2^fraction_bits
};

/// A lobe at a profile, bit for bit. Immutable, so safe to share between threads.
class GoldenModel {
public:
    virtual ~GoldenModel() = default;

    std::string_view lobe() const { return lobe_; }
    const Profile& profile() const { return profile_; }

    /// The result for legal arguments: n in 1..1023, cos_code in 0..2^F. Throws Error for others.
    std::uint32_t eval(int n, std::int64_t cos_code) const;

    /// The port semantics: n = 0 counts as 1, cos > 1 as 1, cos < 0 makes the result 0; each raises `clamped`.
    /// Legal: what the ports can carry, n in 0..1023 and cos_code in -2^(F+1) .. 2^(F+1) - 1. Throws Error for others.
    PortResult eval_port(int n, std::int64_t cos_code) const;

    /// eval_port for whole spans of one length, results packed. The caller keeps to what the ports can carry.
    /// Uses the vector lanes of the machine where the lobe has such a form. Throws Error when lengths differ.
    /// Returns whether any input raised `clamped`.
    bool eval_port_batch(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code,
                         std::span<std::uint32_t> packed) const;

    /// Every intermediate value, in the contract's order, for an input that the ports can carry. Throws Error.
    std::vector<Intermediate> trace(int n, std::int64_t cos_code) const;

    /// The real function of the lobe at one n, for every c of a span: what rounding errors are measured against.
    virtual void reference(double n, std::span<const double> c, std::span<double> out) const = 0;

protected:
    GoldenModel(std::string_view lobe, Profile profile) : lobe_(lobe), profile_(std::move(profile)) {}

    /// The corrections that all lobes share (docs/contract.md, "Ports").
    struct Corrected {
        int n = 1;
        std::int32_t cosine = 0;
        bool negative = false;  ///< cos < 0: the result is 0 whatever the lobe says
        bool clamped = false;
    };
    static Corrected correct(int n, std::int32_t cos_code, std::int32_t one) {
        Corrected out{n, cos_code, cos_code < 0, n == 0 || cos_code < 0 || cos_code > one};
        if (n == 0) out.n = 1;
        if (cos_code < 0) out.cosine = 0;
        if (cos_code > one) out.cosine = one;
        return out;
    }

private:
    /// The lobe itself, for corrected arguments.
    virtual std::uint32_t value(int n, std::int32_t cosine) const = 0;
    /// Ends with y.
    virtual std::vector<Intermediate> intermediates(int n, std::int32_t cosine) const = 0;
    /// Lengths are equal and not 0.
    virtual bool batch(std::span<const std::uint16_t> n, std::span<const std::int32_t> cos_code,
                       std::span<std::uint32_t> packed) const = 0;
    void check_port_range(int n, std::int64_t cos_code) const;

    std::string_view lobe_;  // the registry's literal
    Profile profile_;
};

}  // namespace glint
