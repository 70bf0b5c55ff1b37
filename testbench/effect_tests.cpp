#include "effect_tests.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "glint/error.hpp"
#include "glint/vectors.hpp"
#include "io/files.hpp"

namespace glint::testbench {
namespace {

constexpr std::uint64_t most_corners = std::uint64_t{1} << 22;
constexpr std::uint64_t sampled_corners = std::uint64_t{1} << 18;  // of more than that
constexpr std::uint64_t most_inputs = std::uint64_t{1} << 32;      // of an exhaustive run

/// Bursts by number: how many, and how to make one.
struct Bursts {
    std::uint64_t count = 0;
    std::function<void(std::uint64_t burst, Random&, Stimulus&)> make;
};

void random_row(const EffectModel& model, Random& random, Stimulus& stimulus, std::size_t i) {
    for (std::size_t p = 0; p < model.inputs().size(); ++p)
        stimulus.set(i, p, random_legal_code(model.inputs()[p], random));
}

/// `inputs` in bursts of which row(k, random, stimulus, i) makes the i-th of a burst, the k-th of all.
Bursts bursts_of(std::uint64_t inputs, std::size_t ports, auto row) {
    return {(inputs + burst_length - 1) / burst_length, [=](std::uint64_t burst, Random& random, Stimulus& stimulus) {
                const std::uint64_t first = burst * burst_length;
                const auto count = static_cast<std::size_t>(std::min(burst_length, inputs - first));
                stimulus.resize(ports, count);
                for (std::size_t i = 0; i < count; ++i) row(first + i, random, stimulus, i);
            }};
}

Bursts stream_bursts(const Effect& effect, const EffectModel& model, std::uint64_t count,
                     std::uint64_t& corner_inputs) {
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
    return bursts_of(corner_inputs + count, corners.size(),
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

Bursts exhaustive_bursts(const EffectModel& model) {
    std::uint64_t inputs = 1;
    for (const EffectPort& port : model.inputs()) {
        const std::uint64_t codes = std::uint64_t{1} << port.bits;
        if (codes > most_inputs / inputs) {
            throw Error(fmt::format("--exhaustive is not legal for {} {}: its ports carry more than 2^32 inputs",
                                    model.effect(), model.profile().name));
        }
        inputs *= codes;
    }
    return bursts_of(
        inputs, model.inputs().size(), [&model](std::uint64_t k, Random&, Stimulus& stimulus, std::size_t i) {
            for (std::size_t p = 0; p < model.inputs().size(); ++p) {
                const EffectPort& port = model.inputs()[p];
                stimulus.set(i, p, port.least() + static_cast<std::int64_t>(k & ((1ULL << port.bits) - 1)));
                k >>= port.bits;
            }
        });
}

// A port with few illegal codes, as n with its 0, gets each again: what is wrong with it may show only where the other
// ports ask for it.
Bursts illegal_bursts(const EffectModel& model) {
    constexpr std::int64_t least = 256;
    struct Part {
        std::size_t port;
        std::int64_t first, codes, count;
    };
    std::vector<Part> parts;
    std::uint64_t inputs = 0;
    for (std::size_t p = 0; p < model.inputs().size(); ++p) {
        const EffectPort& port = model.inputs()[p];
        for (const auto& [first, codes] : {std::pair{port.least(), port.low - port.least()},
                                           std::pair{port.high + 1, port.greatest() - port.high}}) {
            if (codes == 0) continue;
            parts.push_back({p, first, codes, std::max(codes, least)});
            inputs += static_cast<std::uint64_t>(parts.back().count);
        }
    }
    if (inputs == 0) throw Error(fmt::format("--illegal is not legal for {}: its ports carry none", model.effect()));
    return bursts_of(inputs, model.inputs().size(),
                     [&model, parts, inputs](std::uint64_t k, Random& random, Stimulus& stimulus, std::size_t i) {
                         random_row(model, random, stimulus, i);
                         auto left = static_cast<std::int64_t>(scattered(k, inputs));
                         for (const Part& part : parts) {
                             if (left < part.count) return stimulus.set(i, part.port, part.first + left % part.codes);
                             left -= part.count;
                         }
                     });
}

// Lengths differ: a counter that is wrong at one number of inputs may be right at all multiples of a power of two.
Bursts reset_bursts(const EffectModel& model, std::uint64_t count) {
    return {count, [&model](std::uint64_t burst, Random& random, Stimulus& stimulus) {
                stimulus.resize(model.inputs().size(), 512 - static_cast<std::size_t>(37 * burst % 256));
                for (std::size_t i = 0; i < stimulus.tags.size(); ++i) random_row(model, random, stimulus, i);
            }};
}

/// The golden model against the real function: the largest error that one thread has seen.
class Meter {
public:
    explicit Meter(const EffectModel& model) : model_(model), in_(model.inputs().size()) {}

    /// Measures a burst; true where it holds a larger error than all before.
    bool measure(const Stimulus& stimulus, const Checker& checker) {
        bool larger = false;
        for (std::size_t i = 0; i < stimulus.tags.size(); ++i) {
            for (std::size_t p = 0; p < in_.size(); ++p) {
                in_[p] = model_.inputs()[p].real(checker.asked().columns[p][i]);
            }
            const std::vector<double> real = model_.reference(in_);
            const double scale = model_.bound_scale(in_);
            for (std::size_t p = 0; p < real.size(); ++p) {
                const EffectPort& port = model_.outputs()[p];
                const double ulp = std::abs(checker.expected()[p][i] - std::ldexp(real[p], port.fraction_bits)) / scale;
                if (!(ulp <= largest_.ulp)) {  // NaN counts as larger
                    largest_ = {ulp, std::string(port.name), stimulus.row(i)};
                    larger = true;
                }
            }
        }
        return larger;
    }
    const EffectError& largest() const { return largest_; }

private:
    const EffectModel& model_;
    std::vector<double> in_;
    EffectError largest_;
};

/// By burst: only those that are the largest so far in their thread.
struct Errors {
    std::mutex mutex;
    std::map<std::uint64_t, EffectError> largest;
};

Plan plan_of(const Bursts& bursts, const EffectModel& model, const Request& request, Errors& errors) {
    return {bursts.count, [&](Checker& checker) {
                return [&, meter = Meter(model), stimulus = Stimulus()](std::uint64_t burst) mutable {
                    Random random(derived_seed(request.seed, burst));
                    bursts.make(burst, random, stimulus);
                    // Tags that have nothing to do with the order, so that a neighbour's does not pass for the right
                    // one.
                    for (std::uint32_t& tag : stimulus.tags) tag = static_cast<std::uint32_t>(random.next());
                    stimulus.stall_seed = random.next();
                    checker.run(stimulus, burst);
                    if (!meter.measure(stimulus, checker)) return;
                    const std::lock_guard lock(errors.mutex);
                    errors.largest[burst] = meter.largest();
                };
            }};
}

}  // namespace

EffectRun test_effect(const Effect& effect, const EffectModel& model, const UnitKind& kind, const Request& request,
                      const Progress& progress) {
    EffectRun run;
    run.effect = effect.name;
    run.lobe = kind.lobe;
    run.profile = model.profile().name;
    run.mask = kind.mask;
    run.test = name(request.test);
    run.request = request;
    for (const EffectPort& port : model.inputs()) run.inputs_of_unit.emplace_back(port.name);
    run.bound_ulp = effect.bound_ulp;

    const Bursts bursts = request.test == Test::stream       ? stream_bursts(effect, model, request.count, run.corners)
                          : request.test == Test::illegal    ? illegal_bursts(model)
                          : request.test == Test::exhaustive ? exhaustive_bursts(model)
                                                             : reset_bursts(model, request.count);
    Log log;
    Errors errors;
    run.seconds = run_plan(plan_of(bursts, model, request, errors), model, kind, request, log, progress);
    run.inputs = log.inputs;
    run.mismatches = log.mismatches;
    run.cycles = log.cycles;
    run.latency_cycles = log.timing.most_latency;
    run.results_per_cycle = log.timing.results_per_cycle();
    for (const auto& [burst, error] : errors.largest) {
        if (!(error.ulp <= run.error.ulp)) run.error = error;
    }
    std::string own;
    if (model.profile().shipped() && !(run.error.ulp <= run.bound_ulp)) {
        own = fmt::format("the golden model is {:.4f} ulp from the real function at {}: {}; the bound is {} ulp\n",
                          run.error.ulp, run.error.output, described(model.inputs(), run.error.in), run.bound_ulp);
    }
    run.complaint = complaint(model, kind, request, log, own);
    return run;
}

nlohmann::ordered_json to_json(const std::vector<EffectRun>& runs, const std::string& command) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const EffectRun& run : runs) {
        nlohmann::ordered_json in = nlohmann::ordered_json::object();
        for (std::size_t p = 0; p < run.error.in.size(); ++p) in[run.inputs_of_unit[p]] = run.error.in[p];
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
