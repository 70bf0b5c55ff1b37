// What a program times: every function in every form. cases.cpp has those of glint-bench, model_cases.cpp those of
// glint-bench-models; main.cpp is that of both.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace glint::bench {

/// So many inputs that the branches of a function do not learn them, and no more than the first-level cache takes.
inline constexpr std::size_t input_count = 2048;

/// So that a result is a lobe's or a model's in the file as well.
struct Program {
    const char* name;
    const char* subject;  ///< "lobe" or "model": what its cases are of
    const char* format;   ///< of the file of results
};
extern const Program program;

struct Case {
    std::string subject;  ///< a lobe of the registry, or a rival; or a lighting model
    std::string type;     ///< "double", "float" or "fixed"
    std::string profile;  ///< of "fixed"
    std::string form;     ///< "scalar" or "batch"
    std::string formula;
    std::function<void()> throughput;  ///< input_count results, each by itself
    std::function<void()> latency;     ///< input_count results, each after the one before; may be empty

    /// "bps/double/scalar", "bps/fixed/p12/batch".
    std::string name() const { return subject + "/" + type + (profile.empty() ? "" : "/" + profile) + "/" + form; }
};

/// The chains around no function, of each type; their subject is "dependency".
std::vector<Case> dependencies();

/// Every lobe of the registry in double, float and fixed (p12), then the rivals; or every model in double and float.
std::vector<Case> cases();

}  // namespace glint::bench
