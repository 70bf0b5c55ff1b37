// A simulated stream unit, whatever its ports are called: what goes in, what comes out, and when. A lobe is a unit with
// two inputs, n and cos, and one output, y.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {
class EffectModel;
}

namespace glint::testbench {

/// Inputs of one burst: inputs[p][i] is what input port p gets with the i-th tag.
struct Burst {
    std::span<const std::int32_t* const> inputs;
    std::span<const std::uint32_t> tags;

    std::size_t size() const { return tags.size(); }
};

/// With this probability a clock has a bubble at the input, and, drawn apart, a stall at the output.
struct Schedule {
    double stall_probability = 0.0;
    std::uint64_t seed = 0;
};

/// What a burst gave. Vectors are as long as the burst; entries past `results` are meaningless.
struct Outcome {
    std::vector<std::vector<std::int32_t>> values;  ///< values[p][i]: what output port p showed for the i-th input
    std::vector<std::uint8_t> clamped;
    std::vector<std::uint32_t> tags;   ///< with tlast above it where the unit has one
    std::vector<std::uint64_t> clock;  ///< of each result, from the start of the burst; with stalls only
    std::size_t results = 0;           ///< how many came before the unit fell silent; more than the burst: `surplus`
    bool surplus = false;              ///< a result came that no input had asked for
    bool unstable = false;             ///< a result changed or was withdrawn while it had to wait
    std::uint64_t cycles = 0;          ///< clocks of the burst, from the first input to the last result
    int latency = 0;                   ///< clocks from the first accepted input to the first result
    std::uint64_t span = 0;            ///< clocks from the first result to the last, both counted
};

class Unit {
public:
    virtual ~Unit() = default;

    /// Holds reset for some clocks.
    virtual void reset() = 0;

    /// Sends a whole burst and waits until its results are out or the unit has been silent for long.
    virtual void run(const Burst& burst, const Schedule& schedule, Outcome& outcome) = 0;

    /// Sends the burst at full speed and stops it by a reset of `length` clocks at clock `at`. Returns a complaint if
    /// the unit answers during reset, or shows after it anything of what was in flight; else an empty text.
    virtual std::string interrupt(const Burst& burst, std::uint64_t at, int length) = 0;

    /// The tag that the result of the input with this tag has to carry.
    virtual std::uint32_t expected_tag(std::uint32_t tag) const = 0;

    /// Writes a waveform of the clocks first..last of the next burst. Only a unit built for it can; others do nothing.
    virtual void trace(const std::string& file, std::uint64_t first, std::uint64_t last) = 0;
};

/// The widths of a model's inputs.
std::vector<int> input_widths(const EffectModel& model);

/// Makes a unit with a seed for what its registers hold at first; `bits`: input_widths of its model.
using MakeUnit = std::unique_ptr<Unit> (*)(std::span<const int> bits, std::uint64_t seed);

/// A unit that this build contains.
struct UnitKind {
    std::string_view effect;   ///< empty for the unit of a lobe
    std::string_view lobe;     ///< of effects that are made of none: empty
    std::string_view profile;  ///< its name, e.g. "p12" or "18_14_14_12"
    std::string_view unit;  ///< "core", "axis"; with words of 32 bits and all sidebands "axis32", three of it "lanes"
    std::string_view architecture;  ///< of a lobe: its canonical name, e.g. "restoring"
    int mask = -1;  ///< MASK of shade, the bits of its port `effects` that are built; -1: all, as of every other effect
    std::string_view id;       ///< of the build: the target waveform-<id> is the same unit, made to draw
    std::string_view verilog;  ///< a hash of its Verilog
    MakeUnit make = nullptr;

    /// "bps p8 core restoring", "phong bps p8", "shade bps p12 MASK 3", "tint p12 axis".
    std::string name() const;
};

/// Every unit is one file of the build (register_unit.cpp), which adds itself before main() starts.
struct Registration {
    explicit Registration(const UnitKind& kind);
};

/// All units of this build.
std::span<const UnitKind> unit_kinds();

/// The unit of an effect. The lobe does not matter for effects that take none. Throws Error with what this build has.
const UnitKind& find_effect_unit(std::string_view effect, std::string_view lobe, std::string_view profile,
                                 int mask = -1, std::string_view unit = "core");

}  // namespace glint::testbench
