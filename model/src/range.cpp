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

}  // namespace glint
