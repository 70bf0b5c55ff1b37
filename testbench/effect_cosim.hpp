// Cosimulation of effects: a unit's results against the golden model, bit for bit, and the golden model against the
// real function.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "effect_unit.hpp"
#include "glint/effect.hpp"
#include "glint/parallel.hpp"

namespace glint::testbench {

enum class EffectTest {
    stream,      ///< the products of the corners of all inputs, then random inputs
    exhaustive,  ///< everything that the ports can carry
    illegal,     ///< every illegal code of every input, with the others random
    reset        ///< resets in mid-stream, at random clocks and of random lengths
};

struct EffectRequest {
    EffectTest test = EffectTest::stream;
    std::uint64_t count = 0;  ///< random inputs (stream) or resets (reset)
    double stall_probability = 0.0;
    std::uint64_t seed = 1;
    unsigned threads = 0;
    std::string trace_file;  ///< waveform of the first mismatch's neighbourhood; empty: none
};

/// The largest difference of the golden model and the real function, in the units of Effect::bound_ulp, and where it
/// was seen.
struct EffectError {
    double ulp = -1.0;  ///< -1: nothing seen
    std::string output;
    std::vector<std::int64_t> in;
};

struct EffectRun {
    std::string effect, lobe, profile, test;
    int mask = -1;  ///< of shade; -1: all
    std::uint64_t inputs = 0;
    std::uint64_t corners = 0;  ///< of them products of corners
    std::uint64_t mismatches = 0;
    std::uint64_t cycles = 0;
    int latency_cycles = 0;          ///< measured without stalls
    double results_per_cycle = 0.0;  ///< measured without stalls
    EffectRequest request;
    EffectError error;
    double bound_ulp = 0.0;
    double seconds = 0.0;
    std::string complaint;  ///< what went wrong, for people; empty when all is well
};

/// Runs one test of one unit. Throws Error when the test does not fit the effect.
EffectRun cosimulate_effect(const Effect& effect, const EffectModel& model, const EffectUnitKind& kind,
                            const EffectRequest& request, const Progress& progress);

nlohmann::ordered_json to_json(const std::vector<EffectRun>& runs, const std::string& command);

/// One line a run.
std::string effect_table(const std::vector<EffectRun>& runs);

}  // namespace glint::testbench
