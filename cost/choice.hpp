// Which configuration of a lobe to build: prices beside errors, and the best under constraints.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::cost {

/// One way to build a lobe on a device: its error and its price.
struct Configuration {
    std::string lobe, profile, architecture, device;
    bool dsp = false;       ///< synthesized with leave to use DSP blocks
    int output_bits = 0;    ///< O
    double error = 0.0;     ///< largest absolute error against c^n over the exponents in question
    double rounding = 0.0;  ///< largest rounding error, in ulp of the output
    int luts = 0, registers = 0, carries = 0, dsps = 0, brams = 0;
    std::optional<double> clock_mhz;  ///< that it reaches; none: only synthesized, not placed and routed
    std::optional<double> asked_mhz;  ///< that it is run at where it reaches it; none: it is run as fast as it can
    int latency = 0;                  ///< clocks from an input to its result
    int interval = 1;                 ///< clocks between two results

    /// The clock that it is run at.
    std::optional<double> run_mhz() const;
};

/// What configurations are compared by.
enum class Metric {
    error,
    rounding,
    output_bits,
    luts,
    registers,
    dsps,
    brams,
    clock,    ///< MHz
    latency,  ///< ns
    latency_clocks,
    ns,          ///< between two results
    throughput,  ///< results a second
};

struct MetricInfo {
    Metric metric;
    std::string_view name;  ///< as on the command line
    std::string_view unit;  ///< as after a number; may be empty
    bool more_is_better;
    bool is_real;  ///< no count
    std::optional<double> (*value)(const Configuration&);
};

std::span<const MetricInfo> metrics();
const MetricInfo& info(Metric metric);

/// "latency-ns", as the option is called, is the latency. Throws Error with the list of the known names.
const MetricInfo& find_metric(std::string_view name);

/// Nothing where it is not known, as the clock of what was only synthesized.
std::optional<double> value(const Configuration& configuration, Metric metric);

/// Whether `a` is better than `b`; any value is better than an unknown one.
bool better(Metric metric, const Configuration& a, const Configuration& b);

/// What decides between configurations unless something else is asked for: none of these gets worse for nothing.
inline constexpr Metric common_axes[] = {Metric::error, Metric::luts,    Metric::dsps,
                                         Metric::brams, Metric::latency, Metric::ns};

/// For each configuration whether another one on the same device is at least as good on every axis, and better on one.
std::vector<bool> dominated(std::span<const Configuration> all, std::span<const Metric> axes);

/// A metric at most the bound; where more is better, at least.
struct Constraint {
    Metric metric;
    double bound = 0.0;

    bool holds(const Configuration& configuration) const;
};

/// How far one constraint has to give way, all others kept, for a solution to appear.
struct Relaxation {
    std::size_t constraint = 0;     ///< its index
    std::size_t configuration = 0;  ///< the index of the one that it lets in
    double bound = 0.0;             ///< its value of the metric: the new bound
};

struct Choice {
    /// The indices of all that meet every constraint, the best first: by the metric to be best in, then by the common
    /// axes in their order, then by name.
    std::vector<std::size_t> feasible;
    /// Those of them that no other of them dominates on the metric and the common axes, in the same order: the best,
    /// and those that win something for what they give up.
    std::vector<std::size_t> worthwhile;
    /// Where nothing is feasible: for each constraint that by itself stands in the way, the smallest step back.
    std::vector<Relaxation> relaxations;
};

Choice choose(std::span<const Configuration> all, std::span<const Constraint> constraints, Metric best_in);

}  // namespace glint::cost
