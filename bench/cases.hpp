// What glint-bench times: every function in every form.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace glint::bench {

/// So many inputs that the branches of a function do not learn them, and no more than the first-level cache takes.
inline constexpr std::size_t input_count = 2048;

struct Case {
    std::string lobe;     ///< of the registry, or a rival
    std::string type;     ///< "double", "float" or "fixed"
    std::string profile;  ///< of "fixed"
    std::string form;     ///< "scalar" or "batch"
    std::string formula;
    std::function<void()> throughput;  ///< input_count results, each by itself
    std::function<void()> latency;     ///< input_count results, each after the one before; may be empty

    /// "bps/double/scalar", "bps/fixed/p12/batch".
    std::string name() const;
};

/// The chains around no function, of each type; their lobe is "dependency".
std::vector<Case> dependencies();

/// Every lobe of the registry in double, float and fixed (p12), then the rivals.
std::vector<Case> cases();

}  // namespace glint::bench
