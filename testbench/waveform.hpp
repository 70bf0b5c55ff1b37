// Waveforms of mismatches.
#pragma once

#include <string>

#include "cosim.hpp"

namespace glint::testbench {

/// Builds the unit that can draw, in the build that this program comes from, runs the failed burst in it and writes
/// request.trace_file. Returns a line for people: what was drawn, or why nothing was.
std::string draw_waveform(const EffectModel& model, const UnitKind& kind, const Request& request,
                          const Failure& failure);

}  // namespace glint::testbench
