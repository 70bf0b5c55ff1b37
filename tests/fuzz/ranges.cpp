// A text as a range, of integers and of reals, as a shard, a quantity, an integer and a list.
#include <cmath>

#include <fmt/format.h>

#include "check.hpp"
#include "glint/fit.hpp"
#include "glint/range.hpp"
#include "io/command.hpp"
#include "io/quantity.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static void check_range(const std::string& text, std::int64_t low, std::int64_t high) {
    may_refuse([&] {
        const Range r = parse_range(text, "--n", low, high);
        require(r.first >= low && r.last <= high && r.first <= r.last && r.step >= 1, "a range is within its limits");
        const std::int64_t end = r[r.size() - 1];
        require(r.size() >= 1 && r[0] == r.first && end <= r.last && end > r.last - r.step, "all values are in it");
        const Range again = parse_range(fmt::format("{}:{}:{}", r.first, r.last, r.step), "--n", low, high);
        require(again.first == r.first && again.last == r.last && again.step == r.step, "a range, written, is itself");
    });
}

static const Registration ranges("ranges", [](const std::string& text) {
    if (text.size() > 300) return;
    check_range(text, 1, max_n);
    check_range(text, 0, std::int64_t{1} << 30);
    may_refuse([&] {
        constexpr double high = 1.5707963267948966;
        const RealRange r = parse_real_range(text, "--theta", 0.0, high);
        require(r.size() >= 1 && r.size() <= 1'000'001, "a range of reals has values, and not too many");
        const double end = r[r.size() - 1];
        require(r.first >= 0.0 && end >= r.first && end <= high + 1e-9, "a range of reals is within its limits");
    });
    may_refuse([&] {
        const Shard shard = parse_shard(text);
        for (const std::uint64_t tasks : {std::uint64_t{1}, std::uint64_t{17}, std::uint64_t{1} << 40}) {
            require(shard.first(tasks) <= shard.end(tasks) && shard.end(tasks) <= tasks, "a shard is a part");
            if (shard.count <= tasks) require(shard.first(tasks) < shard.end(tasks), "a shard has a task");
        }
    });
    for (const bool zero : {false, true}) {
        may_refuse([&] {
            const double x = io::parse_quantity(text, "--clock", {{"MHz", 1e6}, {"GHz", 1e9}, {"Hz", 1.0}}, zero);
            require(std::isfinite(x) && (zero ? x >= 0.0 : x > 0.0), "a quantity is a number");
        });
    }
    may_refuse([&] {
        const std::int64_t x = io::parse_integer(text, "--seed", -5, INT64_MAX);
        require(x >= -5 && std::to_string(x).size() <= text.size(), "an integer is within its limits");
    });
    require(fmt::format("{}", fmt::join(io::split_list(text), ",")) == text, "a list, joined, is itself");
    require(!io::split_profiles(text).empty(), "there is always a profile");
});

}  // namespace glint::fuzz
