#include "glint/sweep.hpp"

#include "glint/error.hpp"

namespace glint {
namespace {

/// Codes in a task: the working set of a block (some ten doubles a code) stays in the second-level cache.
constexpr std::int64_t codes_of_task = 4096;

}  // namespace

SweepPlan::SweepPlan(Range n, Range cos_code)
    : cos_code_(cos_code), tasks_(static_cast<std::size_t>((cos_code.size() + codes_of_task - 1) / codes_of_task)) {
    for (std::int64_t i = 0; i < n.size(); ++i) n_.push_back(static_cast<int>(n[i]));
    if (inputs() == 0) throw Error("sweep of 0 inputs is not legal: at least 1");
}

std::vector<std::int32_t> SweepPlan::codes(std::size_t task) const {
    std::vector<std::int32_t> out;
    const std::int64_t first = static_cast<std::int64_t>(task) * codes_of_task;
    for (std::int64_t i = first; i < std::min(first + codes_of_task, cos_code_.size()); ++i) {
        out.push_back(static_cast<std::int32_t>(cos_code_[i]));
    }
    return out;
}

std::vector<Accuracy>& SweepPlan::part() {
    const std::lock_guard lock(mutex_);
    return parts_.emplace_back(n_.size());
}

SweepResult SweepPlan::result() const {
    SweepResult out;
    for (std::size_t i = 0; i < n_.size(); ++i) {
        AccuracyRow row{n_[i], {}};
        for (const auto& part : parts_) row.accuracy.merge(part[i]);
        out.total.merge(row.accuracy);
        out.rows.push_back(row);
    }
    return out;
}

SweepResult sweep(const GoldenModel& model, Range n, Range cos_code, unsigned threads, const Progress& progress,
                  Shard shard) {
    SweepPlan plan(n, cos_code);
    shard.check(plan.tasks());
    const auto first = static_cast<std::size_t>(shard.first(plan.tasks()));
    const auto count = static_cast<std::size_t>(shard.end(plan.tasks())) - first;
    parallel_tasks(count, threads, progress, [&] {
        return [&, &part = plan.part()](std::size_t task) {
            const std::vector<std::int32_t> codes = plan.codes(first + task);
            std::vector<std::uint16_t> exponents(codes.size());
            std::vector<std::uint32_t> packed(codes.size());
            AccuracyMeter meter(model, codes);
            for (std::size_t i = 0; i < plan.n().size(); ++i) {
                exponents.assign(codes.size(), static_cast<std::uint16_t>(plan.n()[i]));
                model.eval_port_batch(exponents, codes, packed);
                meter.add(plan.n()[i], packed, part[i]);
            }
        };
    });
    return plan.result();
}

}  // namespace glint
