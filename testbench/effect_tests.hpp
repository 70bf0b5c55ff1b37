// The tests of the unit of an effect. Those without stalls and resets also hold the golden model against the real
// function.
//
// Test::stream sends the hard cases, the products of the corners of all inputs, then Request::count random inputs (with
// stalls: no more corners than random inputs); Test::illegal every illegal code of every input, with the others random;
// a port with few of them gets each again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cosim.hpp"

namespace glint::testbench {

/// The largest difference of the golden model and the real function, in the units of Effect::bound_ulp, and where it
/// was seen.
struct EffectError {
    double ulp = -1.0;  ///< -1: not measured
    std::string output;
    std::vector<std::int64_t> in;
};

struct EffectRun {
    std::string effect, lobe, profile, test;
    int mask = -1;                            ///< of shade; -1: all
    std::vector<std::string> inputs_of_unit;  ///< names of its ports
    std::uint64_t inputs = 0;
    std::uint64_t corners = 0;  ///< of them hard cases and products of corners
    std::uint64_t mismatches = 0;
    std::uint64_t cycles = 0;
    int latency_cycles = 0;          ///< measured without stalls
    double results_per_cycle = 0.0;  ///< measured without stalls
    Request request;
    EffectError error;
    double bound_ulp = 0.0;
    double seconds = 0.0;
    std::string complaint;  ///< what went wrong, for people; empty when all is well
};

/// Runs one test of one unit. Throws Error when the test does not fit the effect.
EffectRun test_effect(const Effect& effect, const EffectModel& model, const UnitKind& kind, const Request& request,
                      const Progress& progress);

nlohmann::ordered_json to_json(const std::vector<EffectRun>& runs, const std::string& command);

/// One line a run.
std::string effect_table(const std::vector<EffectRun>& runs);

}  // namespace glint::testbench
