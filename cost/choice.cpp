#include "cost/choice.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::cost {
namespace {

using Value = std::optional<double>;
using C = const Configuration&;

/// The time of so many clocks.
Value in_ns(C c, int clocks) {
    const Value mhz = c.run_mhz();
    return mhz ? Value(1e3 * clocks / *mhz) : std::nullopt;
}

constexpr std::array<MetricInfo, 12> table{{
    {Metric::error, "error", "", false, true, [](C c) -> Value { return c.error; }},
    {Metric::rounding, "rounding", "ulp", false, true, [](C c) -> Value { return c.rounding; }},
    {Metric::output_bits, "output-bits", "bits", true, false, [](C c) -> Value { return c.output_bits; }},
    {Metric::luts, "luts", "LUTs", false, false, [](C c) -> Value { return c.luts; }},
    {Metric::registers, "registers", "registers", false, false, [](C c) -> Value { return c.registers; }},
    {Metric::dsps, "dsps", "DSPs", false, false, [](C c) -> Value { return c.dsps; }},
    {Metric::brams, "brams", "BRAMs", false, false, [](C c) -> Value { return c.brams; }},
    {Metric::clock, "clock", "MHz", true, true, [](C c) { return c.clock_mhz; }},
    {Metric::latency, "latency", "ns", false, true, [](C c) { return in_ns(c, c.latency); }},
    {Metric::latency_clocks, "latency-clocks", "clocks", false, false, [](C c) -> Value { return c.latency; }},
    {Metric::ns, "ns", "ns", false, true, [](C c) { return in_ns(c, c.interval); }},
    {Metric::throughput, "throughput", "results/s", true, true,
     [](C c) {
         const Value mhz = c.run_mhz();
         return mhz ? Value(1e6 * *mhz / c.interval) : std::nullopt;
     }},
}};

bool dominates(const Configuration& a, const Configuration& b, std::span<const Metric> axes) {
    bool wins = false;
    for (const Metric axis : axes) {
        if (better(axis, b, a)) return false;
        wins = wins || better(axis, a, b);
    }
    return wins;
}

auto names(const Configuration& c) { return std::tie(c.lobe, c.profile, c.architecture, c.device, c.dsp); }

}  // namespace

std::optional<double> Configuration::run_mhz() const {
    if (!clock_mhz || !asked_mhz) return clock_mhz;
    return std::min(*clock_mhz, *asked_mhz);
}

std::span<const MetricInfo> metrics() { return table; }

const MetricInfo& info(Metric metric) {
    return *std::find_if(table.begin(), table.end(), [=](const MetricInfo& entry) { return entry.metric == metric; });
}

const MetricInfo& find_metric(std::string_view name) {
    std::string known;
    for (const MetricInfo& entry : table) {
        if (entry.name == name || (name == "latency-ns" && entry.metric == Metric::latency)) return entry;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.name);
    }
    throw Error(fmt::format("metric '{}' is not known: {}", name, known));
}

std::optional<double> value(const Configuration& c, Metric metric) { return info(metric).value(c); }

bool better(Metric metric, const Configuration& a, const Configuration& b) {
    const std::optional<double> x = value(a, metric);
    const std::optional<double> y = value(b, metric);
    if (!x || !y) return x.has_value() && !y.has_value();
    return info(metric).more_is_better ? *x > *y : *x < *y;
}

std::vector<bool> dominated(std::span<const Configuration> all, std::span<const Metric> axes) {
    std::vector<bool> out;
    for (const Configuration& one : all) {
        out.push_back(std::any_of(all.begin(), all.end(), [&](const Configuration& other) {
            return other.device == one.device && dominates(other, one, axes);
        }));
    }
    return out;
}

bool Constraint::holds(const Configuration& configuration) const {
    const std::optional<double> x = value(configuration, metric);
    if (!x) return false;
    return info(metric).more_is_better ? *x >= bound : *x <= bound;
}

Choice choose(std::span<const Configuration> all, std::span<const Constraint> constraints, Metric best_in) {
    std::vector<Metric> axes{best_in};
    axes.insert(axes.end(), std::begin(common_axes), std::end(common_axes));

    Choice out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto holds = [&](const Constraint& constraint) { return constraint.holds(all[i]); };
        if (std::all_of(constraints.begin(), constraints.end(), holds)) out.feasible.push_back(i);
    }
    std::sort(out.feasible.begin(), out.feasible.end(), [&](std::size_t a, std::size_t b) {
        for (const Metric axis : axes) {
            if (better(axis, all[a], all[b])) return true;
            if (better(axis, all[b], all[a])) return false;
        }
        return names(all[a]) < names(all[b]);
    });
    for (const std::size_t i : out.feasible) {
        const bool beaten = std::any_of(out.feasible.begin(), out.feasible.end(),
                                        [&](std::size_t other) { return dominates(all[other], all[i], axes); });
        if (!beaten) out.worthwhile.push_back(i);
    }
    if (!out.feasible.empty()) return out;

    for (std::size_t k = 0; k < constraints.size(); ++k) {
        const Metric metric = constraints[k].metric;
        std::optional<std::size_t> nearest;
        for (std::size_t i = 0; i < all.size(); ++i) {
            bool others_hold = value(all[i], metric).has_value();
            for (std::size_t other = 0; other < constraints.size(); ++other) {
                others_hold = others_hold && (other == k || constraints[other].holds(all[i]));
            }
            if (others_hold && (!nearest || better(metric, all[i], all[*nearest]))) nearest = i;
        }
        if (nearest) out.relaxations.push_back({k, *nearest, *value(all[*nearest], metric)});
    }
    return out;
}

}  // namespace glint::cost
