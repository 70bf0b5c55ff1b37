// Ranges of integers, as the command line writes them.
#pragma once

#include <cstdint>
#include <string_view>

namespace glint {

/// first, first + step, ... up to last at most; both ends included.
struct Range {
    std::int64_t first = 0;
    std::int64_t last = 0;
    std::int64_t step = 1;

    std::int64_t size() const { return last < first ? 0 : (last - first) / step + 1; }
    std::int64_t operator[](std::int64_t i) const { return first + i * step; }
};

/// "7", "1:1000", "0:262144:16" or "all", which is low:high. Every value has to lie in low..high and the step has to be
/// positive. `what` names the argument in the error. Throws Error.
Range parse_range(std::string_view text, std::string_view what, std::int64_t low, std::int64_t high);

/// Part `index` of `count` of a list of tasks: neighbours, and every task is in one part.
struct Shard {
    std::uint64_t index = 1;
    std::uint64_t count = 1;

    std::uint64_t first(std::uint64_t tasks) const { return tasks * (index - 1) / count; }
    std::uint64_t end(std::uint64_t tasks) const { return tasks * index / count; }
    /// Throws Error where some part would be empty.
    void check(std::uint64_t tasks) const;
    friend bool operator==(const Shard&, const Shard&) = default;
};

/// "3/16": the third of 16 parts; at most 10^6. Throws Error.
Shard parse_shard(std::string_view text);

}  // namespace glint
