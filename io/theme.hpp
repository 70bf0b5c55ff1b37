// What the plots of the report have in common: every one comes in a light and a dark version, for wide and for narrow
// screens.
#pragma once

#include <string>
#include <string_view>

namespace glint::io {

inline constexpr std::string_view themes[] = {"light", "dark"};
inline constexpr std::string_view layouts[] = {"wide", "narrow"};

/// One plot of the page. Its pictures are called "<name>-<theme>-<layout>.<extension>".
struct Plot {
    std::string_view name;
    std::string_view extension;

    std::string file(std::string_view theme, std::string_view layout) const;
};

/// Colours that stay apart for colour-blind readers and have a contrast of at least 3 : 1 to the page.
struct Theme {
    std::string_view name;
    std::string_view text, axis, grid;
    std::string_view target, schlick, bps;  // f_b, f_s, f_bps
    std::string_view runs[4];
    std::string_view negative, zero, positive, outside;  // of the map
};
extern const Theme light;
extern const Theme dark;

struct Layout {
    std::string_view name;
    int width;
    bool is_wide() const { return name == "wide"; }
};
inline constexpr Layout wide{"wide", 800};
inline constexpr Layout narrow{"narrow", 400};

/// 1, 2 or 5 times a power of ten: the nearest one at most (or at least) `value`.
double round_down(double value);
double round_up(double value);

/// Tics at 1, 2, 5, 10, ... within a range of a logarithmic axis that begins at one of them; at powers of ten alone
/// when it is long.
std::string log_tics(double low, double high);

/// The terminal, and what all plots have in common.
std::string begin_plot(const std::string& file, const Theme& theme, int width, int height);
std::string end_plot();

/// `low` <= n <= max_n on a logarithmic axis.
std::string n_axis(bool wide, int low = 1);

/// A name in the key: '_' would start a subscript.
std::string key_name(std::string_view name);

std::string multiplot(int rows, int columns);

/// The frame of a map of colours whose axes are plotted as logarithms: n, and the angle in degrees. The first of each
/// pair is the low end.
struct MapRange {
    double log_n[2];
    double log_degrees[2];
};
std::string map_frame(const MapRange& range);

/// The scale of colours above a map.
std::string colour_box();

}  // namespace glint::io
