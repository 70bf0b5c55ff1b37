// What holds of every input of a parser: a usable result, or one line.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "glint/error.hpp"

namespace glint::fuzz {

inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

inline void check_line(std::string_view line) {
    require(!line.empty() && line.find_first_of("\n\r") == line.npos, "a message is one line");
    require(line.size() < 2100, "a message is short");
}

/// Runs a parser and what is done with its result. It may refuse the input, by an Error and by nothing else.
void may_refuse(auto parse) {
    try {
        parse();
    } catch (const Error& error) {
        require(error.what()[0] != '\0', "a refusal says something");
    }
}

/// "a|b" -> a; b. There is always one.
inline std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> out{""};
    for (const char c : text) {
        if (c == separator) {
            out.emplace_back();
        } else {
            out.back() += c;
        }
    }
    return out;
}

/// Inputs of several files: between two stands a record separator, which no legal JSON contains.
inline constexpr char separator = '\x1e';

}  // namespace glint::fuzz
