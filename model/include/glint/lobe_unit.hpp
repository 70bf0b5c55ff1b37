// A lobe as a unit like any other: two inputs, n and cos, and one output, y.
#pragma once

#include <memory>

#include "glint/effect.hpp"
#include "glint/golden.hpp"

namespace glint {

/// The same bits as `model`, which has to outlive it, with ports of Kind: n (parameter, 10 bits, legal 1..1023), cos
/// (dot, F + 2 bits with the sign, legal 0..2^F) and y (term, O + 1 bits). A cosine below 0 gives 0, not the lobe of 0.
std::unique_ptr<EffectModel> lobe_unit(const GoldenModel& model);

}  // namespace glint
