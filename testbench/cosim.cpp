#include "cosim.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/sweep.hpp"
#include "glint/vectors.hpp"

namespace glint::testbench {
namespace {

constexpr std::int64_t burst_length = 4096;
constexpr int axis_latency = 2;  ///< clocks that glint_axis adds

/// The inputs of one burst and where its random stalls start.
struct Stimulus {
    std::vector<std::uint16_t> n;
    std::vector<std::int32_t> cos_code;
    std::uint64_t stall_seed = 0;
    std::uint32_t first_tag = 0;

    Burst burst() const { return {n, cos_code, first_tag}; }
};

/// A seed of its own for each part of a run, so that any part can be run again by itself.
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t part) {
    return Random(seed ^ (part * 0xd134'2543'de82'ef95ULL)).next();
}

/// The first burst that went wrong, by its place in the run, with all that is needed to run it again.
struct Failure {
    Stimulus stimulus;
    Outcome outcome;
    std::vector<std::uint32_t> expected;
    std::vector<std::size_t> wrong;  // indices in the burst
    std::string complaint;
};

/// What the threads of a run add to.
struct Log {
    std::mutex mutex;
    std::uint64_t mismatches = 0;
    std::uint64_t inputs = 0;
    std::uint64_t cycles = 0;
    std::uint64_t span = 0;
    std::uint64_t span_results = 0;
    std::uint64_t intervals = 0, interval_clocks = 0;  // between neighbouring results, without stalls
    int least_latency = 0, most_latency = 0;
    std::map<std::uint64_t, Failure> failures;  // by place; only the first few are kept
};

/// Streams bursts through one unit and compares.
class Checker {
public:
    Checker(const GoldenModel& model, const UnitKind& kind, const Request& request, Log& log)
        : model_(model), request_(request), log_(log), unit_(kind.fast(model.profile().F, request.seed)) {}

    /// Runs a burst; `place` orders the bursts of the run. Returns the unit's own results.
    const std::vector<std::uint32_t>& check(const Stimulus& stimulus, std::uint64_t place) {
        expected_.resize(stimulus.n.size());
        model_.eval_port_batch(stimulus.n, stimulus.cos_code, expected_);
        unit_->run(stimulus.burst(), {request_.stall_probability, stimulus.stall_seed}, outcome_);
        count();

        bool good = outcome_.results == expected_.size() && !outcome_.surplus && !outcome_.unstable &&
                    outcome_.packed == expected_;
        for (std::size_t i = 0; good && i < outcome_.results; ++i) good = outcome_.tags[i] == tag(stimulus, i);
        if (!good) describe(stimulus, place);
        return outcome_.packed;
    }

    /// Full speed, a reset in mid-stream, and then the burst again from a clean start.
    void check_reset(const Stimulus& stimulus, std::uint64_t place) {
        Random random(derived_seed(request_.seed, place));
        const auto at = static_cast<std::uint64_t>(random.between(0, 300));
        const auto length = static_cast<int>(random.between(1, 5));
        const std::string complaint = unit_->interrupt(stimulus.burst(), at, length);
        if (!complaint.empty()) {
            const std::lock_guard lock(log_.mutex);
            ++log_.mismatches;
            log_.failures[place] = {
                stimulus, {}, {}, {}, fmt::format("reset at clock {} for {} clocks: {}\n", at, length, complaint)};
        }
        check(stimulus, place);
    }

private:
    std::uint32_t tag(const Stimulus& stimulus, std::size_t i) const {
        return unit_->expected_tag(stimulus.first_tag + static_cast<std::uint32_t>(i));
    }

    void count() {
        const std::lock_guard lock(log_.mutex);
        log_.inputs += expected_.size();
        log_.cycles += outcome_.cycles;
        if (request_.stall_probability > 0.0 || outcome_.results == 0) return;
        log_.span += outcome_.span;
        log_.span_results += outcome_.results;
        log_.intervals += outcome_.results - 1;
        log_.interval_clocks += outcome_.span - 1;
        if (log_.most_latency == 0) log_.least_latency = outcome_.latency;
        log_.least_latency = std::min(log_.least_latency, outcome_.latency);
        log_.most_latency = std::max(log_.most_latency, outcome_.latency);
    }

    void describe(const Stimulus& stimulus, std::uint64_t place) {
        Failure failure{stimulus, outcome_, expected_, {}, {}};
        for (std::size_t i = 0; i < expected_.size(); ++i) {
            if (i >= outcome_.results || outcome_.packed[i] != expected_[i] || outcome_.tags[i] != tag(stimulus, i)) {
                failure.wrong.push_back(i);
            }
        }
        std::string& text = failure.complaint;
        if (outcome_.results < expected_.size()) {
            text += fmt::format("{} of {} results never came\n", expected_.size() - outcome_.results, expected_.size());
        }
        if (outcome_.surplus) text += "a result came that no input had asked for\n";
        if (outcome_.unstable) text += "a result changed or was withdrawn while it had to wait\n";
        for (const std::size_t i : failure.wrong) {
            if (i >= outcome_.results || text.size() > 200 * request_.shown) break;
            const PortResult got = unpack(outcome_.packed[i]);
            const PortResult want = unpack(expected_[i]);
            text += fmt::format("n {} cos code {}: y {} clamped {} tag {:#x}, golden y {} clamped {} tag {:#x}\n",
                                stimulus.n[i], stimulus.cos_code[i], got.y, got.clamped ? 1 : 0, outcome_.tags[i],
                                want.y, want.clamped ? 1 : 0, tag(stimulus, i));
            text += "  golden:";
            for (const Intermediate& value : model_.trace(stimulus.n[i], stimulus.cos_code[i])) {
                text += fmt::format(" {} {}", value.name, value.code);
            }
            text += '\n';
        }
        const std::lock_guard lock(log_.mutex);
        log_.mismatches += std::max<std::size_t>(failure.wrong.size(), 1);
        log_.failures.try_emplace(place, std::move(failure));
        if (log_.failures.size() > 8) log_.failures.erase(std::prev(log_.failures.end()));
    }

    const GoldenModel& model_;
    const Request& request_;
    Log& log_;
    std::unique_ptr<Unit> unit_;
    std::vector<std::uint32_t> expected_;
    Outcome outcome_;
};

/// Random legal inputs; the corners (legal ones) lead the first burst.
Stimulus random_stimulus(const GoldenModel& model, const Request& request, std::uint64_t place, std::uint64_t length) {
    Stimulus out;
    if (place == 0) {
        for (const TestVector& corner : corner_vectors(model)) {
            if (corner.expected.clamped || out.n.size() == length) continue;
            out.n.push_back(static_cast<std::uint16_t>(corner.n));
            out.cos_code.push_back(corner.cos_code);
        }
    }
    Random random(derived_seed(request.seed, place));
    while (out.n.size() < length) {
        const LegalInput input = random_legal_input(model.profile(), random);
        out.n.push_back(static_cast<std::uint16_t>(input.n));
        out.cos_code.push_back(input.cos_code);
    }
    out.stall_seed = random.next();
    out.first_tag = static_cast<std::uint32_t>(random.next());
    return out;
}

/// The illegal inputs, cut into bursts of one n each.
std::vector<std::pair<int, Range>> illegal_bursts(const Profile& profile) {
    const std::int64_t one = profile.one();
    std::vector<std::pair<int, Range>> out;
    const auto add = [&](int n, std::int64_t first, std::int64_t last) {
        for (; first <= last; first += burst_length) {
            out.emplace_back(n, Range{first, std::min<std::int64_t>(last, first + burst_length - 1), 1});
        }
    };
    add(0, -2 * one, 2 * one - 1);
    for (const int n : {1, 2, 50, 1000, 1023}) {
        add(n, -2 * one, -1);
        add(n, one + 1, 2 * one - 1);
    }
    return out;
}

void run_grid(const GoldenModel& model, const UnitKind& kind, const Request& request, const Progress& progress,
              Log& log, io::RunResult& run) {
    const SweepPlan plan(request.n, request.cos_code);
    std::vector<std::vector<Accuracy>> by_task(plan.tasks(), std::vector<Accuracy>(plan.n().size()));
    parallel_tasks(plan.tasks(), request.threads, progress, [&] {
        return [&, checker = std::make_unique<Checker>(model, kind, request, log)](std::size_t task) {
            Stimulus stimulus;
            stimulus.cos_code = plan.codes(task);
            AccuracyMeter meter(model, stimulus.cos_code);
            for (std::size_t i = 0; i < plan.n().size(); ++i) {
                const std::uint64_t place = task * plan.n().size() + i;
                stimulus.n.assign(stimulus.cos_code.size(), static_cast<std::uint16_t>(plan.n()[i]));
                stimulus.stall_seed = derived_seed(request.seed, place);
                stimulus.first_tag = static_cast<std::uint32_t>(stimulus.stall_seed >> 32);
                meter.add(plan.n()[i], checker->check(stimulus, place), by_task[task][i]);
            }
        };
    });
    run.accuracy = plan.merge(by_task);
    run.exhaustive = plan.inputs() == max_n * (static_cast<std::uint64_t>(model.profile().one()) + 1);
}

void run_illegal(const GoldenModel& model, const UnitKind& kind, const Request& request, const Progress& progress,
                 Log& log) {
    const auto bursts = illegal_bursts(model.profile());
    parallel_tasks(bursts.size(), request.threads, progress, [&] {
        return [&, checker = std::make_unique<Checker>(model, kind, request, log)](std::size_t task) {
            Stimulus stimulus;
            const auto& [n, codes] = bursts[task];
            for (std::int64_t i = 0; i < codes.size(); ++i) {
                stimulus.cos_code.push_back(static_cast<std::int32_t>(codes[i]));
            }
            stimulus.n.assign(stimulus.cos_code.size(), static_cast<std::uint16_t>(n));
            stimulus.stall_seed = derived_seed(request.seed, task);
            checker->check(stimulus, task);
        };
    });
}

void run_random(const GoldenModel& model, const UnitKind& kind, const Request& request, const Progress& progress,
                Log& log) {
    constexpr std::uint64_t whole = burst_length;
    const std::uint64_t tasks = (request.count + whole - 1) / whole;
    parallel_tasks(tasks, request.threads, progress, [&] {
        return [&, checker = std::make_unique<Checker>(model, kind, request, log)](std::size_t task) {
            const std::uint64_t length = std::min<std::uint64_t>(whole, request.count - task * whole);
            checker->check(random_stimulus(model, request, task, length), task);
        };
    });
}

void run_resets(const GoldenModel& model, const UnitKind& kind, const Request& request, const Progress& progress,
                Log& log) {
    parallel_tasks(request.count, request.threads, progress, [&] {
        return [&, checker = std::make_unique<Checker>(model, kind, request, log)](std::size_t task) {
            checker->check_reset(random_stimulus(model, request, task, 512), task);
        };
    });
}

/// Runs the failed burst again in the unit that can draw, and says what it showed.
std::string draw(const UnitKind& kind, int F, const Request& request, const Failure& failure) {
    if (kind.traced == nullptr)
        return "no waveform: this build has none of this unit (the CMake list GLINT_WAVEFORMS says)\n";
    const std::unique_ptr<Unit> unit = kind.traced(F, request.seed);
    const Schedule schedule{request.stall_probability, failure.stimulus.stall_seed};
    constexpr std::uint64_t before = 64;
    constexpr std::uint64_t after = 16;
    Outcome outcome;
    unit->run(failure.stimulus.burst(), schedule, outcome);  // once without drawing, to find the clock
    const std::size_t wrong = failure.wrong.empty() ? 0 : failure.wrong.front();
    const std::uint64_t clock = wrong >= outcome.results          ? outcome.cycles
                                : request.stall_probability > 0.0 ? outcome.clock[wrong]
                                                                  : wrong + static_cast<std::uint64_t>(outcome.latency);
    unit->reset();
    unit->trace(request.trace_file, clock < before ? 0 : clock - before, clock + after);
    unit->run(failure.stimulus.burst(), schedule, outcome);
    const bool same =
        outcome.results == failure.outcome.results &&
        std::equal(outcome.packed.begin(), outcome.packed.begin() + static_cast<std::ptrdiff_t>(outcome.results),
                   failure.outcome.packed.begin());
    return fmt::format("waveform around clock {}: {}{}\n", clock, request.trace_file,
                       same ? "" : " (run again there, the unit gave other results)");
}

}  // namespace

CosimResult cosimulate(const GoldenModel& model, const UnitKind& kind, const Request& request,
                       const Progress& progress) {
    static constexpr std::array names{"stream", "illegal", "reset"};
    CosimResult out{io::run_result(model, std::string(kind.unit), names[static_cast<std::size_t>(request.test)]), {}};
    out.run.architecture = kind.architecture;
    Log log;
    const auto start = std::chrono::steady_clock::now();
    if (request.test == Test::illegal) {
        run_illegal(model, kind, request, progress, log);
    } else if (request.test == Test::reset) {
        run_resets(model, kind, request, progress, log);
    } else if (request.count > 0) {
        run_random(model, kind, request, progress, log);
    } else {
        run_grid(model, kind, request, progress, log, out.run);
    }
    out.run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    out.run.inputs = log.inputs;
    io::HardwareResult hardware;
    hardware.mismatches = log.mismatches;
    hardware.cycles = log.cycles;
    hardware.latency_cycles = log.most_latency;
    hardware.results_per_cycle =
        log.span == 0 ? 0.0 : static_cast<double>(log.span_results) / static_cast<double>(log.span);
    if (log.intervals > 0) {
        hardware.interval_cycles = static_cast<double>(log.interval_clocks) / static_cast<double>(log.intervals);
    }
    hardware.stall_probability = request.stall_probability;
    hardware.seed = request.seed;
    out.run.hardware = hardware;

    if (log.inputs == 0) out.complaint += "0 inputs were tried, which is a failure\n";
    if (log.least_latency != log.most_latency) {
        out.complaint +=
            fmt::format("latency varies without stalls: {} to {} clocks\n", log.least_latency, log.most_latency);
    }
    // One result a clock, but for the iterative divider, which takes the next input when a result leaves the core.
    const std::uint64_t interval =
        kind.architecture.starts_with("iterative")
            ? static_cast<std::uint64_t>(log.most_latency - (kind.unit == "axis" ? axis_latency : 0))
            : 1;
    if (log.mismatches == 0 && log.interval_clocks != log.intervals * interval) {
        out.complaint += fmt::format("{} clocks between {} results without stalls, not {} each\n", log.interval_clocks,
                                     log.intervals + 1, interval);
    }
    if (log.mismatches > 0) {
        const Failure& first = log.failures.begin()->second;
        out.complaint += fmt::format("{} mismatches; the first:\n{}", log.mismatches, first.complaint);
        if (!request.trace_file.empty() && !first.outcome.packed.empty()) {
            out.complaint += draw(kind, model.profile().F, request, first);
        }
    }
    return out;
}

}  // namespace glint::testbench
