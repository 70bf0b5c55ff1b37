// The blocks of rtl/: what each contains, and the clocks it takes. This is the one place that states a block's latency;
// a unit's is the sum over its way.
#pragma once

#include <string_view>
#include <vector>

#include "glint/architecture.hpp"
#include "glint/manifest.hpp"

namespace glint {

/// A part of the way from a unit's inputs to its results.
struct Block {
    std::string_view module = {};  ///< empty: registers of the unit's own
    int clocks = 0;                ///< with products of one clock, without a division
    int products = 0;              ///< of glint_multiplier, one after the other
    int quotient_bits = 0;         ///< of its division; 0: there is none
    int deep = 0;                  ///< clocks that the architecture "deep" adds

    /// The clocks of the modules that follow one another, as a block of that name.
    Block named(std::string_view name) const { return {name, clocks, products, quotient_bits, deep}; }
    friend Block operator+(const Block& a, const Block& b) {
        return {a.module, a.clocks + b.clocks, a.products + b.products, a.quotient_bits + b.quotient_bits,
                a.deep + b.deep};
    }
};

namespace block {

/// Registers: clocks that belong to no block.
constexpr Block step(int clocks = 1) { return {{}, clocks}; }
inline Block product() { return {"glint_multiplier", 1, 1}; }
/// A product, and a register after its sum or rounding.
inline Block rounded() { return product() + step(); }
/// The frames: the first clock corrects the ports of a lobe; an effect corrects its own.
inline Block ports() { return {"glint_ports", 1}; }
inline Block stream() { return {"glint_stream"}; }

inline Block divider(int quotient_bits) { return {"glint_divider", 0, 0, quotient_bits}; }
inline Block ratio(int S) { return (rounded() + divider(S + 1)).named("glint_ratio"); }
inline Block square() { return rounded().named("glint_square"); }
inline Block power(int squares) {
    Block out{"glint_power"};
    for (int i = 0; i <= squares; ++i) out = out + square();
    return out;
}
inline Block horner(int degree) {
    Block out{"glint_horner"};
    for (int i = 0; i < degree; ++i) out = out + rounded();
    return out;
}
inline Block parabola() { return (rounded() + rounded()).named("glint_parabola"); }
inline Block log2() { return (step(3) + parabola() + step()).named("glint_log2"); }
inline Block exp2() { return (step() + parabola() + step(2)).named("glint_exp2"); }
inline Block sqrt(int root_bits) { return {"glint_sqrt", root_bits}; }
/// Two products one after the other, and shifts.
inline Block vectors() { return (product() + step(2) + product() + step(6)).named("glint_vectors"); }
/// A root of F + 2 bits; a quotient of F + 1 bits, by its own divider.
inline Block cosine(int F) { return (vectors() + sqrt(F + 2) + step(F + 2)).named("glint_cosine"); }
/// H, then its cosines; the plain dot products are shorter.
inline Block frame(int F) { return (step() + cosine(F)).named("glint_frame"); }
inline Block attenuation() { return (log2() + step(2)).named("glint_attenuation"); }
inline Block normalise(int shift_bits) { return {"glint_normalise", 2, 0, 0, shift_bits - 2}; }
/// Registers that the architecture "deep" alone has.
inline Block deep() { return {{}, 0, 0, 0, 1}; }
/// A table's entry.
inline Block entry() { return step() + deep(); }
/// From its factor, which comes five clocks after z; and from z.
inline Block scaled_power_factor() { return step(3).named("glint_scaled_power"); }
inline Block scaled_power() { return (step() + parabola() + scaled_power_factor()).named("glint_scaled_power"); }
/// A register slice at each end.
inline Block axis() { return {"glint_axis", 2}; }
/// Around the slowest term: the memories, the sum, the tint, the total.
inline Block shade() { return {"glint_effect_shade", 10}; }
/// Around the slowest lobe: the end of the line, the memory.
inline Block lobe_select() { return {"glint_effect_lobe_select", 3}; }

}  // namespace block

/// How a unit is made: its module by hand, the blocks on the way of its numbers, and modules beside it.
struct Hardware {
    std::vector<Block> way;
    std::vector<std::string_view> beside = {};

    Block sum() const;
};

/// The modules by hand that units share: what each contains does not depend on a unit.
std::vector<std::string_view> shared_modules();

/// The files of a module of rtl/ and of all that it contains: `way` and `beside`, or what the table of blocks says.
std::vector<HardwareUnit::File> files_of(std::string_view module, const Hardware& hardware = {});

/// Adds those that are not there yet.
void add_files(std::vector<HardwareUnit::File>& files, const std::vector<HardwareUnit::File>& more);

/// Clock, reset, handshake and tag of every unit but the AXI4-Stream ones, around ports of its own.
std::vector<HardwareUnit::Port> stream_ports(const std::vector<HardwareUnit::Port>& inputs,
                                             const std::vector<HardwareUnit::Port>& outputs);

/// The architecture's clocks for a way: those of its blocks, of the division, of products of several clocks.
HardwareUnit::Architecture timed(const Architecture& architecture, const Block& way);

}  // namespace glint
