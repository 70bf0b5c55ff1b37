// cost/data/cpu.json and cost/data/cpu-models.json, which bench/run.py writes: what an evaluation of a lobe or of a
// lighting model costs on a processor.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::cost {

/// All times are nanoseconds a result, medians over repetitions.
struct CpuPrice {
    std::string name;       ///< of a form of studies/forms.hpp, a lobe, or a rival: "pow"; or of a lighting model
    std::string type;       ///< "double", "float" or "fixed"
    std::string profile;    ///< of "fixed"
    std::string form;       ///< "scalar" or "batch"
    std::string formula;    ///< as evaluated
    double throughput = 0;  ///< of many independent evaluations
    double q1 = 0, q3 = 0;  ///< its quartiles over the repetitions
    std::optional<double> latency;       ///< each evaluation waits for the one before; scalar only
    std::optional<double> instructions;  ///< a result; none where Valgrind was missing
};

struct CpuPrices {
    std::string command;  ///< the command line that measured them
    std::string cpu, compiler, flags, date;
    std::vector<CpuPrice> prices;

    const CpuPrice* find(std::string_view name, std::string_view type, std::string_view form) const;
};

/// Of lobes. Throws Error, one line with the file, the field and what is legal.
CpuPrices read_cpu_prices(const std::string& path);

/// Of lighting models, each of `names` in double and in float. Throws Error as above.
CpuPrices read_model_prices(const std::string& path, std::span<const std::string_view> names);

}  // namespace glint::cost
