// Sweeps of a golden model over ranges of n and of the cosine code.
#pragma once

#include <cstddef>
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

    /// The tasks' accuracies, each a list by n, as one result. Added in the order of the tasks, so that the sums do not
    /// depend on the threads.
    SweepResult merge(const std::vector<std::vector<Accuracy>>& by_task) const;

private:
    Range cos_code_;
    std::vector<int> n_;
    std::size_t tasks_;
};

/// Evaluates the model at every (n, cos_code) of the ranges and measures it. Throws Error as SweepPlan does.
SweepResult sweep(const GoldenModel& model, Range n, Range cos_code, unsigned threads = 0,
                  const Progress& progress = {});

}  // namespace glint
