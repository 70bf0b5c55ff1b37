#include "cosim.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>

#include <fmt/format.h>

#include "glint/vectors.hpp"
#include "waveform.hpp"

namespace glint::testbench {

namespace {

/// Ends a run that asks for no more than its first mismatch.
struct Ended {};

}  // namespace

std::string_view name(Test test) {
    static constexpr std::array<std::string_view, 4> names{"stream", "exhaustive", "illegal", "reset"};
    return names[static_cast<std::size_t>(test)];
}

std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t part) {
    return Random(seed ^ (part * 0xd134'2543'de82'ef95ULL)).next();
}

std::uint64_t scattered(std::uint64_t i, std::uint64_t count) {
    std::uint64_t step = count / 2 + count / 8 + 1;
    while (std::gcd(step, count) != 1) ++step;
    return i * step % count;
}

void Stimulus::resize(std::size_t ports, std::size_t count) {
    columns.resize(ports);
    for (auto& column : columns) column.resize(count);
    tags.resize(count);
}

std::vector<std::int64_t> Stimulus::row(std::size_t i) const {
    std::vector<std::int64_t> out;
    for (const auto& column : columns) out.push_back(column[i]);
    return out;
}

std::vector<const std::int32_t*> Stimulus::pointers() const {
    std::vector<const std::int32_t*> out;
    for (const auto& column : columns) out.push_back(column.data());
    return out;
}

std::string described(std::span<const EffectPort> ports, const std::vector<std::int64_t>& codes) {
    std::string out;
    for (std::size_t p = 0; p < ports.size(); ++p) {
        out += fmt::format("{}{} {}", p == 0 ? "" : " ", ports[p].name, codes[p]);
    }
    return out;
}

Checker::Checker(const EffectModel& model, const UnitKind& kind, const Request& request, Log& log)
    : model_(model),
      request_(request),
      log_(log),
      mask_(kind.mask),
      unit_(kind.make(input_widths(model), request.seed)),
      expected_(model.outputs().size()) {}

const Outcome& Checker::check(const Stimulus& stimulus, std::uint64_t place) {
    const std::size_t count = stimulus.tags.size();
    asked_ = &stimulus;
    if (mask_ >= 0) {  // what is not built counts as not asked for
        masked_ = stimulus;
        for (std::int32_t& code : masked_.columns[0]) code &= mask_;
        asked_ = &masked_;
    }
    std::vector<std::int32_t*> outputs;
    for (auto& column : expected_) {
        column.resize(count);
        outputs.push_back(column.data());
    }
    clamped_.resize(count);
    model_.eval_port_batch(asked_->pointers(), outputs, clamped_);
    unit_->run({stimulus.pointers(), stimulus.tags}, {request_.stall_probability, stimulus.stall_seed}, outcome_);
    this->count();
    if (all_right(stimulus)) return outcome_;

    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < count; ++i) {
        if (!right(stimulus, i)) wrong.push_back(i);
    }
    const std::lock_guard lock(log_.mutex);
    log_.mismatches += std::max<std::size_t>(wrong.size(), 1);
    fail(place, {stimulus, outcome_, wrong.empty() ? 0 : wrong.front(), description(stimulus, wrong)});
    return outcome_;
}

void Checker::check_reset(const Stimulus& stimulus, std::uint64_t place) {
    Random random(derived_seed(request_.seed, ~place));
    const auto at = static_cast<std::uint64_t>(random.between(0, 300));
    const auto length = static_cast<int>(random.between(1, 5));
    const std::string complaint = unit_->interrupt({stimulus.pointers(), stimulus.tags}, at, length);
    if (!complaint.empty()) {
        const std::lock_guard lock(log_.mutex);
        ++log_.mismatches;
        fail(place, {{}, {}, 0, fmt::format("reset at clock {} for {} clocks: {}\n", at, length, complaint)});
    }
    check(stimulus, place);
}

void Checker::run(const Stimulus& stimulus, std::uint64_t place) {
    if (request_.test == Test::reset) {
        check_reset(stimulus, place);
    } else {
        check(stimulus, place);
    }
}

bool Checker::right(const Stimulus& stimulus, std::size_t i) const {
    if (i >= outcome_.results || outcome_.tags[i] != unit_->expected_tag(stimulus.tags[i])) return false;
    if (outcome_.clamped[i] != clamped_[i]) return false;
    for (std::size_t p = 0; p < expected_.size(); ++p) {
        if (outcome_.values[p][i] != expected_[p][i]) return false;
    }
    return true;
}

bool Checker::all_right(const Stimulus& stimulus) const {
    if (outcome_.results != stimulus.tags.size() || outcome_.surplus || outcome_.unstable) return false;
    if (outcome_.clamped != clamped_ || outcome_.values != expected_) return false;
    for (std::size_t i = 0; i < outcome_.results; ++i) {
        if (outcome_.tags[i] != unit_->expected_tag(stimulus.tags[i])) return false;
    }
    return true;
}

void Checker::count() {
    const std::lock_guard lock(log_.mutex);
    log_.inputs += clamped_.size();
    log_.cycles += outcome_.cycles;
    if (request_.stall_probability > 0.0 || outcome_.results == 0) return;
    log_.timing.merge(
        {outcome_.latency, outcome_.latency, outcome_.span, outcome_.results, outcome_.results - 1, outcome_.span - 1});
}

void Checker::fail(std::uint64_t place, Failure failure) {
    log_.failures.try_emplace(place, std::move(failure));
    if (log_.failures.size() > 8) log_.failures.erase(std::prev(log_.failures.end()));
    if (request_.to_first_mismatch) throw Ended();
}

std::string Checker::description(const Stimulus& stimulus, const std::vector<std::size_t>& wrong) const {
    constexpr std::size_t shown = 4;
    std::string text;
    const std::size_t count = stimulus.tags.size();
    if (outcome_.results < count) text += fmt::format("{} of {} results never came\n", count - outcome_.results, count);
    if (outcome_.surplus) text += "a result came that no input had asked for\n";
    if (outcome_.unstable) text += "a result changed or was withdrawn while it had to wait\n";
    for (std::size_t k = 0; k < wrong.size() && k < shown && wrong[k] < outcome_.results; ++k) {
        const std::size_t i = wrong[k];
        std::vector<std::int64_t> got, want;
        for (std::size_t p = 0; p < expected_.size(); ++p) {
            got.push_back(outcome_.values[p][i]);
            want.push_back(expected_[p][i]);
        }
        const auto in = asked_->row(i);
        text += fmt::format(
            "{}: {} clamped {} tag {:#x}, golden {} clamped {} tag {:#x}\n  golden:", described(model_.inputs(), in),
            described(model_.outputs(), got), outcome_.clamped[i], outcome_.tags[i], described(model_.outputs(), want),
            clamped_[i], unit_->expected_tag(stimulus.tags[i]));
        for (const Intermediate& value : model_.trace(in)) text += fmt::format(" {} {}", value.name, value.code);
        text += '\n';
    }
    return text;
}

double run_plan(const Plan& plan, const EffectModel& model, const UnitKind& kind, const Request& request, Log& log,
                const Progress& progress) {
    request.shard.check(plan.tasks);
    const std::uint64_t first = request.shard.first(plan.tasks);
    const auto start = std::chrono::steady_clock::now();
    try {
        parallel_tasks(request.shard.end(plan.tasks) - first, request.threads, progress, [&] {
            auto checker = std::make_shared<Checker>(model, kind, request, log);
            return [checker, first, worker = plan.worker(*checker)](std::uint64_t task) { worker(first + task); };
        });
    } catch (const Ended&) {
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string complaint(const EffectModel& model, const UnitKind& kind, const Request& request, const Log& log,
                      const std::string& own) {
    std::string text;
    if (log.inputs == 0) text += "0 inputs were tried, which is a failure\n";
    text += log.timing.complaint() + own;
    if (log.mismatches == 0) return text;
    const Failure& first = log.failures.begin()->second;
    text += fmt::format("{} mismatches; the first:\n{}", log.mismatches, first.complaint);
    if (request.trace_file.empty() || first.stimulus.tags.empty()) return text;
    return text + draw_waveform(model, kind, request, first);
}

}  // namespace glint::testbench
