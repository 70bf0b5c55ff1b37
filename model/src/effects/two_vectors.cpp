#include "two_vectors.hpp"

#include <algorithm>
#include <cmath>

namespace glint {

std::vector<EffectPort> vector_ports(int W) {
    return {component_port("a_x", W), component_port("a_y", W), component_port("a_z", W), component_port("b_x", W),
            component_port("b_y", W), component_port("b_z", W), exponent_port()};
}

bool correct_vectors(std::int64_t* in) {
    const auto none = [](const std::int64_t* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; };
    const bool below = in[6] == 0;
    if (below) in[6] = 1;
    return below || none(in) || none(in + 3);
}

double vectors_cosine(const double* in) {
    const auto dot = [](const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const double squares = dot(in, in) * dot(in + 3, in + 3);
    return squares > 0 ? std::min(1.0, dot(in, in + 3) / std::sqrt(squares)) : -1.0;
}

std::vector<EffectCase> vectors_cases(const EffectModel& model) {
    std::vector<EffectCase> cases = common_effect_cases(model);
    const std::int64_t high = model.inputs()[0].high, low = model.inputs()[0].low, half = (high + 1) / 2;
    const auto add = [&](std::string of, std::vector<std::int64_t> in, std::string risk) {
        cases.push_back({std::move(of), std::move(in), std::move(risk)});
    };
    add("a vector with itself", {high, 1, -3, high, 1, -3, 1023}, "the peak, at any n");
    add("parallel, lengths 1 and the greatest", {1, 1, 1, high, high, high, 1023},
        "the peak, for lengths far apart whose root is not whole");
    add("parallel, the least root", {half, 0, 0, half, 0, 0, 1023}, "the least root there is");
    add("nearly parallel, the least root", {half, 0, 0, half, 1, 0, 1023}, "the steepest place, at the coarsest root");
    add("in the highlight", {20000 % (high + 1), half / 2, half, 20001 % (high + 1), half / 2 - 1, half + 3, 1000},
        "neither 0 nor the peak");
    add("opposite", {high, 1, -3, -high, -1, 3, 50}, "p is negative: 0, and not clamped");
    add("just behind", {high, high, 0, high, -high, -1, 1}, "p = 0 or next to it");
    add("p = -1", {high, 1, 0, -1, high - 1, 0, 1}, "the greatest p that is negative: 0, not the value at c = 0");
    add("perpendicular", {high, high, 0, high, -high, 0, 1}, "p = 0: the lobe's value at c = 0");
    add("perpendicular, the greatest D", {low, low, 0, low, high, high, 1023},
        "the greatest divisor, or the greatest logarithm");
    add("the longest vectors", {low, low, low, low, low, low, 1}, "p, the squares and s at their tops");
    add("the longest vectors, opposite", {low, low, low, high, high, high, 1023}, "the most negative p");
    add("the shortest vectors", {1, 0, 0, 1, 0, 0, 1023}, "s = 1: moved up as far as it can be");
    add("the shortest vectors, a diagonal", {1, 0, 0, 1, 1, 0, 3}, "s = 2: an irrational root of the least digits");
    add("the shortest and the longest", {1, 0, 0, low, low, low, 50}, "lengths at both ends: negative");
    add("s just below a power of 16", {half - 1, 0, 0, half, 0, 0, 1023}, "one more nibble to move");
    add("the first vector is 0", {0, 0, 0, 1, 2, 3, 50}, "0 / 0: 0, and clamped");
    add("the second vector is 0", {1, 2, 3, 0, 0, 0, 50}, "0 / 0: 0, and clamped");
    add("both vectors and n are 0", {0, 0, 0, 0, 0, 0, 0}, "three corrections at once");
    return cases;
}

}  // namespace glint
