// Numbers with units on the command line: 48MHz, 200ns, 50M.
#pragma once

#include <initializer_list>
#include <string_view>

namespace glint::io {

struct Unit {
    std::string_view name;
    double factor;
};

/// A number above 0 (with `zero`, or 0), with one of the units after it or with none, which counts as the first.
/// Throws Error with the option, the text and what is legal.
double parse_quantity(std::string_view text, std::string_view option, std::initializer_list<Unit> units,
                      bool zero = false);

}  // namespace glint::io
