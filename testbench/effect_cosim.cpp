#include "effect_cosim.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/vectors.hpp"
#include "io/command.hpp"

namespace glint::testbench {
namespace {

constexpr std::uint64_t burst_length = 4096;
constexpr std::uint64_t most_corners = std::uint64_t{1} << 22;
constexpr std::uint64_t sampled_corners = std::uint64_t{1} << 18;  // of more than that
constexpr std::uint64_t most_inputs = std::uint64_t{1} << 32;      // of an exhaustive run

/// A seed of its own for each part of a run, so that any part can be run again by itself.
std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t part) {
    return Random(seed ^ (part * 0xd134'2543'de82'ef95ULL)).next();
}

/// The inputs of one burst, a column per port, and where its random stalls start.
struct Stimulus {
    std::vector<std::vector<std::int32_t>> columns;
    std::vector<std::uint32_t> tags;
    std::uint64_t stall_seed = 0;

    std::vector<const std::int32_t*> pointers() const {
        std::vector<const std::int32_t*> out;
        for (const auto& column : columns) out.push_back(column.data());
        return out;
    }
    std::vector<std::int64_t> row(std::size_t i) const {
        std::vector<std::int64_t> out;
        for (const auto& column : columns) out.push_back(column[i]);
        return out;
    }
    void resize(std::size_t ports, std::size_t count) {
        columns.resize(ports);
        for (auto& column : columns) column.resize(count);
        tags.resize(count);
    }
    void set(std::size_t i, std::size_t port, std::int64_t code) { columns[port][i] = static_cast<std::int32_t>(code); }
};

/// Bursts by number: how many, and how to make one.
struct Plan {
    std::uint64_t bursts = 0;
    std::function<void(std::uint64_t burst, Random&, Stimulus&)> make;
};

struct Failure {
    Stimulus stimulus;
    ColumnOutcome outcome;
    std::size_t wrong = 0;  ///< index in the burst of the first wrong result
    std::string complaint;
};

/// What the threads of a run add to.
struct Log {
    std::mutex mutex;
    std::uint64_t inputs = 0, mismatches = 0, cycles = 0, span = 0, span_results = 0;
    int least_latency = 0, most_latency = 0;
    std::map<std::uint64_t, Failure> failures;    // by burst; only the first few are kept
    std::map<std::uint64_t, EffectError> errors;  // by burst: only those that are the largest so far in their thread
};

std::string described(std::span<const EffectPort> ports, const std::vector<std::int64_t>& codes) {
    std::string out;
    for (std::size_t p = 0; p < ports.size(); ++p) {
        out += fmt::format("{}{} {}", p == 0 ? "" : " ", ports[p].name, codes[p]);
    }
    return out;
}

/// Streams bursts through one unit and compares.
class Checker {
public:
    Checker(const EffectModel& model, const EffectUnitKind& kind, const EffectRequest& request, Log& log)
        : model_(model), request_(request), log_(log), mask_(kind.mask), unit_(kind.fast(request.seed)) {}

    void check(const Stimulus& stimulus, std::uint64_t burst) {
        const std::size_t count = stimulus.tags.size();
        const auto inputs = stimulus.pointers();
        // What is not built counts as not asked for.
        asked_ = stimulus;
        if (mask_ >= 0) {
            for (std::int32_t& code : asked_.columns[0]) code &= mask_;
        }
        const auto asked = asked_.pointers();
        expected_.resize(model_.outputs().size());
        std::vector<std::int32_t*> outputs;
        for (auto& column : expected_) {
            column.resize(count);
            outputs.push_back(column.data());
        }
        clamped_.resize(count);
        model_.eval_port_batch(asked, outputs, clamped_);
        unit_->run({inputs, stimulus.tags}, {request_.stall_probability, stimulus.stall_seed}, outcome_);
        measure(stimulus, burst);

        std::vector<std::size_t> wrong;
        for (std::size_t i = 0; i < count; ++i) {
            if (!right(stimulus, i)) wrong.push_back(i);
        }
        const std::lock_guard lock(log_.mutex);
        log_.inputs += count;
        log_.cycles += outcome_.cycles;
        if (request_.stall_probability == 0.0 && outcome_.results > 0) {
            log_.span += outcome_.span;
            log_.span_results += outcome_.results;
            if (log_.most_latency == 0) log_.least_latency = outcome_.latency;
            log_.least_latency = std::min(log_.least_latency, outcome_.latency);
            log_.most_latency = std::max(log_.most_latency, outcome_.latency);
        }
        if (wrong.empty() && !outcome_.surplus && !outcome_.unstable) return;
        log_.mismatches += std::max<std::size_t>(wrong.size(), 1);
        fail(burst, {stimulus, outcome_, wrong.empty() ? 0 : wrong.front(), description(stimulus, wrong)});
    }

    /// Full speed, a reset in mid-stream, and then the burst again from a clean start.
    void check_reset(const Stimulus& stimulus, std::uint64_t burst) {
        Random random(derived_seed(request_.seed, ~burst));
        const auto at = static_cast<std::uint64_t>(random.between(0, 300));
        const auto length = static_cast<int>(random.between(1, 5));
        const auto inputs = stimulus.pointers();
        const std::string complaint = unit_->interrupt({inputs, stimulus.tags}, at, length);
        if (!complaint.empty()) {
            const std::lock_guard lock(log_.mutex);
            ++log_.mismatches;
            fail(burst, {{}, {}, 0, fmt::format("reset at clock {} for {} clocks: {}\n", at, length, complaint)});
        }
        check(stimulus, burst);
    }

private:
    bool right(const Stimulus& stimulus, std::size_t i) const {
        if (i >= outcome_.results || outcome_.tags[i] != unit_->expected_tag(stimulus.tags[i])) return false;
        if (outcome_.clamped[i] != clamped_[i]) return false;
        for (std::size_t p = 0; p < expected_.size(); ++p) {
            if (outcome_.values[p][i] != expected_[p][i]) return false;
        }
        return true;
    }

    void fail(std::uint64_t burst, Failure failure) {
        log_.failures.try_emplace(burst, std::move(failure));
        if (log_.failures.size() > 8) log_.failures.erase(std::prev(log_.failures.end()));
    }

    std::string description(const Stimulus& stimulus, const std::vector<std::size_t>& wrong) const {
        std::string text;
        const std::size_t count = stimulus.tags.size();
        if (outcome_.results < count) {
            text += fmt::format("{} of {} results never came\n", count - outcome_.results, count);
        }
        if (outcome_.surplus) text += "a result came that no input had asked for\n";
        if (outcome_.unstable) text += "a result changed or was withdrawn while it had to wait\n";
        for (std::size_t k = 0; k < wrong.size() && k < 4 && wrong[k] < outcome_.results; ++k) {
            const std::size_t i = wrong[k];
            std::vector<std::int64_t> got, want;
            for (std::size_t p = 0; p < expected_.size(); ++p) {
                got.push_back(outcome_.values[p][i]);
                want.push_back(expected_[p][i]);
            }
            const auto in = asked_.row(i);
            text += fmt::format("{}: {} clamped {} tag {:#x}, golden {} clamped {} tag {:#x}\n  golden:",
                                described(model_.inputs(), in), described(model_.outputs(), got), outcome_.clamped[i],
                                outcome_.tags[i], described(model_.outputs(), want), clamped_[i],
                                unit_->expected_tag(stimulus.tags[i]));
            for (const Intermediate& value : model_.trace(in)) text += fmt::format(" {} {}", value.name, value.code);
            text += '\n';
        }
        return text;
    }

    /// The golden model against the real function.
    void measure(const Stimulus& stimulus, std::uint64_t burst) {
        const auto ports = model_.inputs();
        std::vector<double> in(ports.size());
        bool larger = false;
        for (std::size_t i = 0; i < stimulus.tags.size(); ++i) {
            for (std::size_t p = 0; p < in.size(); ++p) in[p] = ports[p].real(asked_.columns[p][i]);
            const std::vector<double> real = model_.reference(in);
            const double scale = model_.bound_scale(in);
            for (std::size_t p = 0; p < real.size(); ++p) {
                const EffectPort& port = model_.outputs()[p];
                const double ulp = std::abs(expected_[p][i] - std::ldexp(real[p], port.fraction_bits)) / scale;
                if (!(ulp <= largest_.ulp)) {  // NaN counts as larger
                    largest_ = {ulp, std::string(port.name), stimulus.row(i)};
                    larger = true;
                }
            }
        }
        if (!larger) return;
        const std::lock_guard lock(log_.mutex);
        log_.errors[burst] = largest_;
    }

    const EffectModel& model_;
    const EffectRequest& request_;
    Log& log_;
    int mask_;
    Stimulus asked_;
    std::unique_ptr<EffectUnit> unit_;
    std::vector<std::vector<std::int32_t>> expected_;
    std::vector<std::uint8_t> clamped_;
    ColumnOutcome outcome_;
    EffectError largest_;
};

/// The codes at which an input could go wrong: 0, 1 ulp, small, 1/2, 1 - 1 ulp, 1, the ends of what is legal and of
/// what the port carries, and one beyond.
std::vector<std::int64_t> corner_codes(const EffectPort& port) {
    const std::int64_t one = std::int64_t{1} << port.fraction_bits;
    std::vector<std::int64_t> codes{
        port.least(), port.low - 1, port.low,      -one,           -1, 0, 1, one / 64 + 1, one / 2, one - 1,
        one,          port.high,    port.high + 1, port.greatest()};
    if (port.fraction_bits == 0) codes.push_back((port.low + port.high) / 20);
    std::sort(codes.begin(), codes.end());
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    std::erase_if(codes, [&](std::int64_t code) { return code < port.least() || code > port.greatest(); });
    return codes;
}

/// Legal: one half uniform, one quarter near 0, one quarter near the top, at every distance alike.
std::int64_t random_code(const EffectPort& port, Random& random) {
    const auto kind = random.between(0, 3);
    if (kind < 2) return random.between(port.low, port.high);
    const std::int64_t distance = random.between(0, (std::int64_t{1} << random.between(0, port.bits)) - 1);
    if (kind == 3) return std::clamp(port.high - distance, port.low, port.high);
    const bool negative = port.low < 0 && random.between(0, 1) == 1;
    return std::clamp(negative ? -distance : distance, port.low, port.high);
}

void random_row(const EffectModel& model, Random& random, Stimulus& stimulus, std::size_t i) {
    for (std::size_t p = 0; p < model.inputs().size(); ++p) stimulus.set(i, p, random_code(model.inputs()[p], random));
}

/// `inputs` in bursts of which row(k, random, stimulus, i) makes the i-th of a burst, the k-th of all.
template <class Row>
Plan plan_of(std::uint64_t inputs, std::size_t ports, Row row) {
    return {(inputs + burst_length - 1) / burst_length, [=](std::uint64_t burst, Random& random, Stimulus& stimulus) {
                const std::uint64_t first = burst * burst_length;
                const auto count = static_cast<std::size_t>(std::min(burst_length, inputs - first));
                stimulus.resize(ports, count);
                for (std::size_t i = 0; i < count; ++i) row(first + i, random, stimulus, i);
            }};
}

Plan stream_plan(const Effect& effect, const EffectModel& model, std::uint64_t count, std::uint64_t& corner_inputs) {
    const std::vector<EffectCase> cases = effect.hard_cases(model);
    std::vector<std::vector<std::int64_t>> corners;
    double products = 1.0;
    for (const EffectPort& port : model.inputs()) {
        corners.push_back(corner_codes(port));
        products *= static_cast<double>(corners.back().size());
    }
    const bool all = products <= static_cast<double>(most_corners);
    corner_inputs = cases.size() + (all ? static_cast<std::uint64_t>(products) : sampled_corners);
    const std::uint64_t first_random = corner_inputs;
    return plan_of(corner_inputs + count, corners.size(),
                   [&model, cases, corners, all, first_random](std::uint64_t k, Random& random, Stimulus& stimulus,
                                                               std::size_t i) {
                       if (k >= first_random) return random_row(model, random, stimulus, i);
                       if (k < cases.size()) {
                           for (std::size_t p = 0; p < corners.size(); ++p) stimulus.set(i, p, cases[k].in[p]);
                           return;
                       }
                       k -= cases.size();
                       for (std::size_t p = 0; p < corners.size(); ++p) {
                           const std::uint64_t size = corners[p].size();
                           const std::uint64_t chosen = all ? k % size : random.next() % size;
                           stimulus.set(i, p, corners[p][chosen]);
                           k /= size;
                       }
                   });
}

Plan exhaustive_plan(const EffectModel& model) {
    std::uint64_t inputs = 1;
    for (const EffectPort& port : model.inputs()) {
        const std::uint64_t codes = std::uint64_t{1} << port.bits;
        if (codes > most_inputs / inputs) {
            throw Error(fmt::format("--exhaustive is not legal for {} {}: its ports carry more than 2^32 inputs",
                                    model.effect(), model.profile().name));
        }
        inputs *= codes;
    }
    return plan_of(inputs, model.inputs().size(),
                   [&model](std::uint64_t k, Random&, Stimulus& stimulus, std::size_t i) {
                       for (std::size_t p = 0; p < model.inputs().size(); ++p) {
                           const EffectPort& port = model.inputs()[p];
                           stimulus.set(i, p, port.least() + static_cast<std::int64_t>(k & ((1ULL << port.bits) - 1)));
                           k >>= port.bits;
                       }
                   });
}

Plan illegal_plan(const EffectModel& model) {
    struct Part {
        std::size_t port;
        std::int64_t first, count;
    };
    std::vector<Part> parts;
    std::uint64_t inputs = 0;
    for (std::size_t p = 0; p < model.inputs().size(); ++p) {
        const EffectPort& port = model.inputs()[p];
        for (const Part& part :
             {Part{p, port.least(), port.low - port.least()}, Part{p, port.high + 1, port.greatest() - port.high}}) {
            if (part.count == 0) continue;
            parts.push_back(part);
            inputs += static_cast<std::uint64_t>(part.count);
        }
    }
    if (inputs == 0) throw Error(fmt::format("--illegal is not legal for {}: its ports carry none", model.effect()));
    return plan_of(inputs, model.inputs().size(),
                   [&model, parts](std::uint64_t k, Random& random, Stimulus& stimulus, std::size_t i) {
                       random_row(model, random, stimulus, i);
                       auto left = static_cast<std::int64_t>(k);
                       for (const Part& part : parts) {
                           if (left < part.count) return stimulus.set(i, part.port, part.first + left);
                           left -= part.count;
                       }
                   });
}

Plan reset_plan(const EffectModel& model, std::uint64_t count) {
    return {count, [&model](std::uint64_t, Random& random, Stimulus& stimulus) {
                stimulus.resize(model.inputs().size(), 512);
                for (std::size_t i = 0; i < stimulus.tags.size(); ++i) random_row(model, random, stimulus, i);
            }};
}

/// Runs the failed burst again in the unit that can draw, and says what it showed.
std::string draw(const EffectUnitKind& kind, const EffectRequest& request, const Failure& failure) {
    if (kind.traced == nullptr)
        return "no waveform: this build has none of this unit (the CMake list GLINT_WAVEFORMS says)\n";
    const auto unit = kind.traced(request.seed);
    const Schedule schedule{request.stall_probability, failure.stimulus.stall_seed};
    const auto inputs = failure.stimulus.pointers();
    const ColumnBurst burst{inputs, failure.stimulus.tags};
    constexpr std::uint64_t before = 64;
    constexpr std::uint64_t after = 16;
    ColumnOutcome outcome;
    unit->run(burst, schedule, outcome);  // once without drawing, to find the clock
    const std::uint64_t clock = failure.wrong >= outcome.results ? outcome.cycles
                                : request.stall_probability > 0.0
                                    ? outcome.clock[failure.wrong]
                                    : failure.wrong + static_cast<std::uint64_t>(outcome.latency);
    unit->reset();
    unit->trace(request.trace_file, clock < before ? 0 : clock - before, clock + after);
    unit->run(burst, schedule, outcome);
    const bool same = outcome.results == failure.outcome.results && outcome.values == failure.outcome.values;
    return fmt::format("waveform around clock {}: {}{}\n", clock, request.trace_file,
                       same ? "" : " (run again there, the unit gave other results)");
}

}  // namespace

EffectRun cosimulate_effect(const Effect& effect, const EffectModel& model, const EffectUnitKind& kind,
                            const EffectRequest& request, const Progress& progress) {
    static constexpr std::string_view names[] = {"stream", "exhaustive", "illegal", "reset"};
    EffectRun run;
    run.effect = effect.name;
    run.lobe = kind.lobe;
    run.profile = model.profile().name;
    run.mask = kind.mask;
    run.test = names[static_cast<std::size_t>(request.test)];
    run.request = request;
    run.bound_ulp = effect.bound_ulp;

    Plan plan;
    switch (request.test) {
        case EffectTest::stream:
            plan = stream_plan(effect, model, request.count, run.corners);
            break;
        case EffectTest::exhaustive:
            plan = exhaustive_plan(model);
            break;
        case EffectTest::illegal:
            plan = illegal_plan(model);
            break;
        case EffectTest::reset:
            plan = reset_plan(model, request.count);
            break;
    }
    Log log;
    const auto start = std::chrono::steady_clock::now();
    parallel_tasks(plan.bursts, request.threads, progress, [&] {
        return [&, checker = std::make_unique<Checker>(model, kind, request, log),
                stimulus = Stimulus()](std::size_t burst) mutable {
            Random random(derived_seed(request.seed, burst));
            plan.make(burst, random, stimulus);
            // Tags that have nothing to do with the order, so that a tag of a neighbour does not pass for the right
            // one.
            for (std::uint32_t& tag : stimulus.tags) tag = static_cast<std::uint32_t>(random.next());
            stimulus.stall_seed = random.next();
            if (request.test == EffectTest::reset) {
                checker->check_reset(stimulus, burst);
            } else {
                checker->check(stimulus, burst);
            }
        };
    });
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.inputs = log.inputs;
    run.mismatches = log.mismatches;
    run.cycles = log.cycles;
    run.latency_cycles = log.most_latency;
    run.results_per_cycle = log.span == 0 ? 0.0 : static_cast<double>(log.span_results) / static_cast<double>(log.span);
    for (const auto& [burst, error] : log.errors) {
        if (!(error.ulp <= run.error.ulp)) run.error = error;
    }

    if (run.inputs == 0) run.complaint += "0 inputs were tried, which is a failure\n";
    if (log.least_latency != log.most_latency) {
        run.complaint +=
            fmt::format("latency varies without stalls: {} to {} clocks\n", log.least_latency, log.most_latency);
    }
    if (model.profile().shipped() && !(run.error.ulp <= run.bound_ulp)) {
        run.complaint +=
            fmt::format("the golden model is {:.4f} ulp from the real function at {}: {}; the bound is {} ulp\n",
                        run.error.ulp, run.error.output, described(model.inputs(), run.error.in), run.bound_ulp);
    }
    if (run.mismatches > 0) {
        const Failure& first = log.failures.begin()->second;
        run.complaint += fmt::format("{} mismatches; the first:\n{}", run.mismatches, first.complaint);
        if (!request.trace_file.empty() && !first.stimulus.tags.empty()) run.complaint += draw(kind, request, first);
    }
    return run;
}

nlohmann::ordered_json to_json(const std::vector<EffectRun>& runs, const std::string& command) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const EffectRun& run : runs) {
        nlohmann::ordered_json in = nlohmann::ordered_json::object();
        const auto model = find_effect(run.effect).golden(parse_profile(run.profile), run.lobe);
        for (std::size_t p = 0; p < run.error.in.size(); ++p) {
            in[std::string(model->inputs()[p].name)] = run.error.in[p];
        }
        nlohmann::ordered_json one{
            {"effect", run.effect},
            {"lobe", run.lobe},
            {"profile", run.profile},
            {"mask", run.mask},
            {"test", run.test},
            {"inputs", run.inputs},
            {"corners", run.corners},
            {"mismatches", run.mismatches},
            {"cycles", run.cycles},
            {"stall_probability", run.request.stall_probability},
            {"seed", run.request.seed},
            {"seconds", run.seconds},
            {"rounding_error",
             {{"ulp", run.error.ulp}, {"bound_ulp", run.bound_ulp}, {"output", run.error.output}, {"inputs", in}}}};
        if (run.request.stall_probability == 0.0) {
            one["latency_cycles"] = run.latency_cycles;
            one["results_per_cycle"] = run.results_per_cycle;
        }
        list.push_back(std::move(one));
    }
    return {{"tool", "glint-cosim"}, {"command", command}, {"runs", list}};
}

std::string effect_table(const std::vector<EffectRun>& runs) {
    std::vector<std::vector<std::string>> rows{{"effect", "lobe", "profile", "test", "inputs", "mismatches", "latency",
                                                "per clock", "error, ulp", "bound", "at"}};
    for (const EffectRun& run : runs) {
        const bool timed = run.request.stall_probability == 0.0;
        std::string at = run.error.output + ":";
        for (const std::int64_t code : run.error.in) at += fmt::format(" {}", code);
        rows.push_back({run.mask < 0 ? run.effect : fmt::format("{} MASK {}", run.effect, run.mask),
                        run.lobe.empty() ? "-" : run.lobe, run.profile, run.test, fmt::format("{}", run.inputs),
                        fmt::format("{}", run.mismatches), timed ? fmt::format("{}", run.latency_cycles) : "-",
                        timed ? fmt::format("{:.4f}", run.results_per_cycle) : "-",
                        fmt::format("{:.4f}", run.error.ulp), fmt::format("{:.4f}", run.bound_ulp), at});
    }
    return io::table(rows);
}

}  // namespace glint::testbench
