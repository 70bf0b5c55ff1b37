// A simulated stream unit, whatever its ports are called: what goes in, what comes out, and when.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::testbench {

/// Inputs of one burst; the i-th carries the tag first_tag + i.
struct Burst {
    std::span<const std::uint16_t> n;
    std::span<const std::int32_t> cos_code;
    std::uint32_t first_tag = 0;

    std::size_t size() const { return n.size(); }
};

/// Inputs of one burst for a unit with any ports: inputs[p][i] is what input port p gets with the i-th tag.
struct ColumnBurst {
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
struct StreamOutcome {
    std::vector<std::uint32_t> tags;   ///< with tlast above it where the unit has one
    std::vector<std::uint64_t> clock;  ///< of each result, from the start of the burst; with stalls only
    std::size_t results = 0;           ///< how many came before the unit fell silent; more than the burst: `surplus`
    bool surplus = false;              ///< a result came that no input had asked for
    bool unstable = false;             ///< a result changed or was withdrawn while it had to wait
    std::uint64_t cycles = 0;          ///< clocks of the burst, from the first input to the last result
    int latency = 0;                   ///< clocks from the first accepted input to the first result
    std::uint64_t span = 0;            ///< clocks from the first result to the last, both counted
};

struct Outcome : StreamOutcome {
    std::vector<std::uint32_t> packed;  ///< y, and clamped in bit 31
};

/// values[p][i]: what output port p showed for the i-th input.
struct ColumnOutcome : StreamOutcome {
    std::vector<std::vector<std::int32_t>> values;
    std::vector<std::uint8_t> clamped;
};

template <class Burst, class Outcome>
class StreamUnit {
public:
    virtual ~StreamUnit() = default;

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

/// The unit of a lobe, and the unit of an effect.
using Unit = StreamUnit<Burst, Outcome>;
using EffectUnit = StreamUnit<ColumnBurst, ColumnOutcome>;

/// A unit that this build contains. Made with F, the fraction bits of its cosine, and a seed for what its registers
/// hold at first.
struct UnitKind {
    std::string_view lobe;
    std::string_view profile;       ///< its name, e.g. "p12" or "18_14_14_12"
    std::string_view unit;          ///< "core" or "axis"
    std::string_view architecture;  ///< its canonical name, e.g. "restoring"
    std::unique_ptr<Unit> (*fast)(int F, std::uint64_t seed);
    std::unique_ptr<Unit> (*traced)(int F, std::uint64_t seed);  ///< the same Verilog, built for waveforms; may be null
};

/// All units of this build; written by CMake from GLINT_PROFILES and GLINT_ARCHITECTURES.
std::span<const UnitKind> unit_kinds();

}  // namespace glint::testbench
