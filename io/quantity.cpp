#include "io/quantity.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::io {

double parse_quantity(std::string_view text, std::string_view option, std::initializer_list<Unit> units, bool zero) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto legal = [&](double x) { return std::isfinite(x) && (x > 0.0 || (zero && number == 0.0)); };
    const bool good = error == std::errc{} && legal(number);
    const std::string_view rest = text.substr(static_cast<std::size_t>(end - text.data()));
    if (good && rest.empty()) return number;
    std::string known;
    for (const Unit& unit : units) {
        const double in_first = number * unit.factor / units.begin()->factor;
        if (good && rest == unit.name && legal(in_first)) return in_first;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", unit.name);
    }
    throw Error(fmt::format("{} '{}' is not legal: a number {}{}{}", option, text, zero ? "of 0 or more" : "above 0",
                            known.empty() ? "" : ", with a unit or without: ", known));
}

}  // namespace glint::io
