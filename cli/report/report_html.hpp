// Pieces of the report's page.
#pragma once

#include "cli/report/rooms.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/gnuplot.hpp"
#include "io/theme.hpp"

namespace glint::cli {

std::string escaped(std::string_view text);

/// A command line, which breaks between its words only.
std::string command_html(std::string_view command);

/// 268174335 as 268,174,335.
std::string grouped(std::uint64_t number);

/// What a table's row is made of. The label stands in the heading, and before the value on narrow screens.
struct Cell {
    std::string_view label;
    std::string html;
    enum Kind { name, number, words } kind = number;
};

std::string table_html(const std::vector<std::vector<Cell>>& rows);

/// The browser shows one of the plot's four versions: dark or light, narrow or wide.
std::string figure_html(const Pictures& pictures, const Plot& plot, const std::string& alternative,
                        const std::string& caption);

}  // namespace glint::cli
