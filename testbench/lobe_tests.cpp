#include "lobe_tests.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "glint/lobe_unit.hpp"
#include "glint/sweep.hpp"
#include "glint/vectors.hpp"

namespace glint::testbench {
namespace {

constexpr int axis_latency = 2;  ///< clocks that glint_axis adds
constexpr std::size_t n_port = 0, cos_port = 1;

/// Tags in order from a random first one; where random stalls start.
void number(Stimulus& stimulus, std::uint64_t seed) {
    stimulus.stall_seed = seed;
    std::iota(stimulus.tags.begin(), stimulus.tags.end(), static_cast<std::uint32_t>(seed >> 32));
}

/// Random legal inputs; the corners (legal ones) lead the first burst.
Stimulus random_stimulus(const GoldenModel& model, const Request& request, std::uint64_t place, std::uint64_t length) {
    Stimulus out;
    out.resize(2, length);
    std::size_t i = 0;
    if (place == 0) {
        for (const TestVector& corner : corner_vectors(model)) {
            if (corner.expected.clamped || i == length) continue;
            out.set(i, n_port, corner.n);
            out.set(i++, cos_port, corner.cos_code);
        }
    }
    Random random(derived_seed(request.seed, place));
    for (; i < length; ++i) {
        const LegalInput input = random_legal_input(model.profile(), random);
        out.set(i, n_port, input.n);
        out.set(i, cos_port, input.cos_code);
    }
    number(out, random.next());
    return out;
}

Plan random_plan(const GoldenModel& model, const Request& request, std::uint64_t inputs, std::uint64_t length) {
    return {(inputs + length - 1) / length, [&model, &request, inputs, length](Checker& checker) {
                return [&, inputs, length](std::uint64_t task) {
                    const std::uint64_t count = std::min(length, inputs - task * length);
                    checker.run(random_stimulus(model, request, task, count), task);
                };
            }};
}

/// The illegal inputs, each once: of each n a first code and how many follow.
struct IllegalInputs {
    struct Part {
        int n;
        std::int64_t first, count;
    };
    explicit IllegalInputs(const Profile& profile) {
        const std::int64_t one = profile.one();
        parts.push_back({0, -2 * one, 4 * one});
        for (const int n : {1, 2, 50, 1000, 1023}) {
            parts.push_back({n, -2 * one, 2 * one});
            parts.push_back({n, one + 1, one - 1});
        }
        for (const Part& part : parts) count += static_cast<std::uint64_t>(part.count);
    }
    std::pair<int, std::int64_t> operator[](std::uint64_t i) const {
        auto left = static_cast<std::int64_t>(scattered(i, count));
        auto part = parts.begin();
        for (; left >= part->count; ++part) left -= part->count;
        return {part->n, part->first + left};
    }
    std::vector<Part> parts;
    std::uint64_t count = 0;
};

Plan illegal_plan(const GoldenModel& model, const Request& request) {
    const IllegalInputs inputs(model.profile());
    return {(inputs.count + burst_length - 1) / burst_length, [&request, inputs](Checker& checker) {
                return [&, inputs](std::uint64_t task) {
                    const std::uint64_t first = task * burst_length;
                    Stimulus stimulus;
                    stimulus.resize(2, static_cast<std::size_t>(std::min(burst_length, inputs.count - first)));
                    for (std::size_t i = 0; i < stimulus.tags.size(); ++i) {
                        const auto& [n, code] = inputs[first + i];
                        stimulus.set(i, n_port, n);
                        stimulus.set(i, cos_port, code);
                    }
                    number(stimulus, derived_seed(request.seed, task));
                    checker.run(stimulus, task);
                };
            }};
}

Plan grid_plan(const GoldenModel& model, const Request& request, SweepPlan& sweep) {
    return {sweep.tasks(), [&](Checker& checker) {
                return [&, &part = sweep.part()](std::uint64_t task) {
                    const std::vector<int>& n = sweep.n();
                    const std::vector<std::int32_t> codes = sweep.codes(task);
                    AccuracyMeter meter(model, codes);
                    Stimulus stimulus;
                    stimulus.resize(2, codes.size());
                    stimulus.columns[cos_port] = codes;
                    std::vector<std::uint32_t> packed(codes.size());
                    for (std::size_t k = 0; k < n.size(); ++k) {
                        const std::uint64_t place = task * n.size() + k;
                        stimulus.columns[n_port].assign(codes.size(), n[k]);
                        number(stimulus, derived_seed(request.seed, place));
                        const Outcome& outcome = checker.check(stimulus, place);
                        for (std::size_t i = 0; i < packed.size(); ++i) {
                            packed[i] = static_cast<std::uint32_t>(outcome.values[0][i]) |
                                        std::uint32_t{outcome.clamped[i]} << 31;
                        }
                        meter.add(n[k], packed, part[k]);
                    }
                };
            }};
}

}  // namespace

std::string key_of(const UnitKind& kind, const Request& request, const Grid& grid) {
    std::string inputs = fmt::format("count {} seed {}", request.count, request.seed);
    if (request.test == Test::stream && request.count == 0) {
        inputs = fmt::format("n {}:{}:{} cos {}:{}:{} seed {}", grid.n.first, grid.n.last, grid.n.step,
                             grid.cos_code.first, grid.cos_code.last, grid.cos_code.step, request.seed);
    }
    return fmt::format("{} {} {} stalls {} verilog {}", kind.name(), name(request.test), inputs,
                       request.stall_probability, kind.verilog);
}

io::RunResult test_lobe(const GoldenModel& model, const UnitKind& kind, const Request& request, const Grid& grid,
                        const Progress& progress) {
    const std::unique_ptr<EffectModel> unit = lobe_unit(model);
    io::RunResult out = io::run_result(model, std::string(kind.unit), std::string(name(request.test)));
    out.architecture = kind.architecture;
    out.key = key_of(kind, request, grid);
    Log log;
    if (request.test == Test::illegal) {
        out.seconds = run_plan(illegal_plan(model, request), *unit, kind, request, log, progress);
    } else if (request.test == Test::reset) {
        constexpr std::uint64_t length = 512;
        const Plan plan = random_plan(model, request, request.count * length, length);
        out.seconds = run_plan(plan, *unit, kind, request, log, progress);
    } else if (request.count > 0) {
        const Plan plan = random_plan(model, request, request.count, burst_length);
        out.seconds = run_plan(plan, *unit, kind, request, log, progress);
    } else {
        SweepPlan sweep(grid.n, grid.cos_code);
        out.seconds = run_plan(grid_plan(model, request, sweep), *unit, kind, request, log, progress);
        out.accuracy = sweep.result();
    }
    out.set_inputs(log.inputs);
    out.hardware = {log.mismatches, log.cycles, log.timing, request.stall_probability, request.seed};

    // One result a clock, but for the iterative divider, which takes the next input when a result leaves the core.
    const std::uint64_t interval =
        kind.architecture.starts_with("iterative")
            ? static_cast<std::uint64_t>(log.timing.most_latency - (kind.unit == "core" ? 0 : axis_latency))
            : 1;
    std::string own;
    if (log.mismatches == 0 && log.timing.interval_clocks != log.timing.intervals * interval) {
        own = fmt::format("{} clocks between {} results without stalls, not {} each\n", log.timing.interval_clocks,
                          log.timing.intervals + 1, interval);
    }
    out.complaint = complaint(*unit, kind, request, log, own);
    return out;
}

}  // namespace glint::testbench
