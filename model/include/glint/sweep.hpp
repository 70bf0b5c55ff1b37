// Sweeps of a golden model over ranges of n and of the cosine code.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <vector>

#include "glint/accuracy.hpp"
#include "glint/parallel.hpp"
#include "glint/range.hpp"

namespace glint {

/// The accuracy at one n.
struct AccuracyRow {
    int n = 0;
    Accuracy accuracy;
};

struct SweepResult {
    std::vector<AccuracyRow> rows;  ///< one per n, ascending
    Accuracy total;
};

/// A sweep cut into tasks: each is a block of neighbouring cosine codes, to be run through every n. Shared by the sweep
/// of the model and the cosimulation.
class SweepPlan {
public:
    /// Legal: n within 1..1023, codes within 0..2^F of the profile meant. Throws Error when there is no input.
    SweepPlan(Range n, Range cos_code);

    std::size_t tasks() const { return tasks_; }
    std::vector<std::int32_t> codes(std::size_t task) const;
    const std::vector<int>& n() const { return n_; }
    std::uint64_t inputs() const { return n_.size() * static_cast<std::uint64_t>(cos_code_.size()); }

    /// Room for what one thread measures: an accuracy by n. A reference stays good while others are asked for.
    std::vector<Accuracy>& part();
    /// All parts as one result. It does not depend on which thread measured what.
    SweepResult result() const;

private:
    Range cos_code_;
    std::vector<int> n_;
    std::size_t tasks_;
    std::mutex mutex_;
    std::deque<std::vector<Accuracy>> parts_;
};

/// Evaluates the model at every (n, cos_code) of the ranges and measures it; with a shard only at that part of the
/// codes. Throws Error as SweepPlan does, and for more shards than tasks.
SweepResult sweep(const GoldenModel& model, Range n, Range cos_code, unsigned threads = 0,
                  const Progress& progress = {}, Shard shard = {});

}  // namespace glint
