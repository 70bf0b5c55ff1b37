// Inputs of `bps` next to a rounding boundary, found by solving for them.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

#include "exact.hpp"

namespace glint::wide {

struct Input {
    int n = 0;
    std::int64_t C = 0;
    auto operator<=>(const Input&) const = default;
};

/// Every C with C 2^S = k D + r for an integer k, so with a remainder of r, or of D + r for r < 0. Legal: n >= 2,
/// |r| < 2^(F-1). Ascending.
///
/// With m = n - 1, E = 2^S + k m and D = n 2^F - m C, the equation says E D = n 2^(F+S) - m r: D and E divide a number
/// that is known beforehand. Of its divisors those are wanted that give an integer C in 0..2^F and an integer k.
std::vector<Input> at_remainder(const Exact& exact, int n, std::int64_t r);

/// The inputs at one n next to where the quotient becomes `quotient` and where it becomes `quotient` + 1: the least and
/// the largest C of that quotient and their neighbours. None when no C has it.
std::vector<Input> of_quotient(const Exact& exact, int n, std::int64_t quotient);

/// The `size` least keys seen, and what has them; of equal keys the least values. The order of adding does not matter.
class Least {
public:
    explicit Least(std::size_t size) : size_(size) {}

    void add(std::int64_t key, std::int64_t value) {
        if (key > limit_) return;
        entries_.emplace_back(key, value);
        if (entries_.size() >= 4 * size_) cut();
    }
    void merge(const Least& other) {
        for (const auto& [key, value] : other.entries_) add(key, value);
    }
    const std::vector<std::pair<std::int64_t, std::int64_t>>& entries() {
        cut();
        return entries_;
    }

private:
    void cut() {
        std::sort(entries_.begin(), entries_.end());
        if (entries_.size() < size_) return;
        entries_.resize(size_);
        limit_ = entries_.back().first;
    }

    std::size_t size_;
    std::int64_t limit_ = INT64_MAX;
    std::vector<std::pair<std::int64_t, std::int64_t>> entries_;
};

}  // namespace glint::wide
