// One Verilated unit, compiled once for each: what it is and the names of its ports are macros that the build takes
// from rtl/units.json. With GLINT_DRAWS it is a library of its own that glint-cosim loads to draw a waveform
// (waveform.hpp). With GLINT_LOADED it is such a library that does not draw (tests/mutants).
//
// Verilator's own C++ is part of this file, for headers cost more than a small unit. Sanitizers watch the rest of it:
// they would take minutes to compile generated functions of a thousand lines.
#if defined(GLINT_SANITIZERS) && defined(__clang__)
#pragma clang attribute push(__attribute__((no_sanitize("address", "undefined"))), apply_to = function)
#endif
#include GLINT_VERILATED
#if defined(GLINT_SANITIZERS) && defined(__clang__)
#pragma clang attribute pop
#endif

#include <string_view>

#include "pins.hpp"
#include "simulated_unit.hpp"

namespace glint::testbench {
namespace {

#define GLINT_PIN(name) +1
#define GLINT_SIGNED_PIN(name, bits) +1
constexpr std::size_t inputs_of_unit = 0 GLINT_INPUTS, outputs_of_unit = 0 GLINT_OUTPUTS;
#undef GLINT_PIN
#undef GLINT_SIGNED_PIN

#ifdef GLINT_STREAM
struct Pins : StreamPins {
    static constexpr std::size_t inputs = inputs_of_unit, outputs = outputs_of_unit;

    static void input(auto& m, const std::int32_t* const* in, std::size_t i, const std::uint32_t* mask,
                      std::uint32_t tag) {
#define GLINT_PIN(name) set(m.name, (*in++)[i], *mask++);
        GLINT_INPUTS
        m.tag_i = StreamPins::tag(tag);
#undef GLINT_PIN
    }
    static void output(const auto& m, std::int32_t* values) {
#define GLINT_PIN(name) *values++ = static_cast<std::int32_t>(m.name);
#define GLINT_SIGNED_PIN(name, bits) *values++ = sign_extended(static_cast<std::uint32_t>(m.name), bits);
        GLINT_OUTPUTS
#undef GLINT_PIN
#undef GLINT_SIGNED_PIN
    }
};
#else
constexpr bool has_lanes = std::string_view(GLINT_UNIT) == "lanes";
constexpr bool is_packed = has_lanes || std::string_view(GLINT_UNIT) == "axis32";
struct Pins : AxisPins<inputs_of_unit, outputs_of_unit, is_packed, is_packed, has_lanes ? 3 : 1> {
    static void output(const auto& m, std::int32_t* values) {
        std::size_t k = 0;
#define GLINT_PIN(name) values[k] = static_cast<std::int32_t>(result(m, k) & 0x7fff'ffffU), ++k;
#define GLINT_SIGNED_PIN(name, bits) values[k] = sign_extended(result(m, k), bits), ++k;
        GLINT_OUTPUTS
#undef GLINT_PIN
#undef GLINT_SIGNED_PIN
    }
};
#endif

}  // namespace

#if defined(GLINT_DRAWS) || defined(GLINT_LOADED)
extern "C" Unit* glint_make_unit(const int* bits, std::size_t count, std::uint64_t seed);

extern "C" Unit* glint_make_unit(const int* bits, std::size_t count, std::uint64_t seed) {
    return std::make_unique<SimulatedUnit<GLINT_MODEL, Pins>>(std::span(bits, count), seed).release();
}
#else
namespace {

std::unique_ptr<Unit> make(std::span<const int> bits, std::uint64_t seed) {
    return std::make_unique<SimulatedUnit<GLINT_MODEL, Pins>>(bits, seed);
}

const Registration registration({.effect = GLINT_EFFECT_NAME,
                                 .lobe = GLINT_LOBE_NAME,
                                 .profile = GLINT_PROFILE,
                                 .unit = GLINT_UNIT,
                                 .architecture = GLINT_ARCHITECTURE,
                                 .mask = GLINT_MASK,
                                 .id = GLINT_ID,
                                 .verilog = GLINT_VERILOG,
                                 .make = make});

}  // namespace
#endif

}  // namespace glint::testbench
