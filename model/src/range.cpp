#include "glint/range.hpp"

#include <charconv>
#include <vector>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {

Range parse_range(std::string_view text, std::string_view what, std::int64_t low, std::int64_t high) {
    if (text == "all") return {low, high, 1};
    const auto refuse = [&] {
        return Error(fmt::format("{} '{}' is not legal: a number, first:last, first:last:step or all, within {} to {}",
                                 what, text, low, high));
    };
    std::vector<std::int64_t> numbers;
    for (std::string_view rest = text;;) {
        const std::string_view field = rest.substr(0, rest.find(':'));
        std::int64_t number = 0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
        if (error != std::errc{} || end != field.data() + field.size() || numbers.size() == 3) throw refuse();
        numbers.push_back(number);
        if (field.size() == rest.size()) break;
        rest.remove_prefix(field.size() + 1);
    }
    Range out{numbers[0], numbers.size() > 1 ? numbers[1] : numbers[0], numbers.size() > 2 ? numbers[2] : 1};
    if (out.first < low || out.last > high || out.last < out.first || out.step < 1) throw refuse();
    return out;
}

void Shard::check(std::uint64_t tasks) const {
    if (count > tasks) {
        throw Error(fmt::format("--shard {}/{} is not legal: this run has {} parts at most", index, count, tasks));
    }
}

Shard parse_shard(std::string_view text) {
    constexpr std::uint64_t most = 1'000'000;
    Shard out;
    const char* const end = text.data() + text.size();
    const auto index = std::from_chars(text.data(), end, out.index);
    if (index.ec == std::errc{} && index.ptr != end && *index.ptr == '/') {
        const auto count = std::from_chars(index.ptr + 1, end, out.count);
        if (count.ec == std::errc{} && count.ptr == end && out.index >= 1 && out.index <= out.count &&
            out.count <= most) {
            return out;
        }
    }
    throw Error(fmt::format("--shard '{}' is not legal: i/N with 1 <= i <= N <= {}", text, most));
}

}  // namespace glint
