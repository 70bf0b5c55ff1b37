// What the effects bps_vectors and blinn_phong_vectors have in common.
#pragma once

#include <vector>

#include "cosine.hpp"
#include "effect.hpp"

namespace glint {

/// a_x .. b_z of W bits, and n.
std::vector<EffectPort> vector_ports(int W);

/// n = 0 becomes 1. Whether it was, or a vector is 0: `clamped`.
bool correct_vectors(std::int64_t* in);

/// The cosine of real vectors a and b, at most 1; -1 where one of them is 0, which has no highlight either.
double vectors_cosine(const double* in);

/// Hard cases of such an effect.
std::vector<EffectCase> vectors_cases(const EffectModel& model);

}  // namespace glint
