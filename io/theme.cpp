#include "io/theme.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "glint/profile.hpp"

namespace glint::io {

const Theme light{"light",   "#1f2328", "#6e7781", "#dde2e8",
                  "#8a939d", "#a8328a", "#0067b1", {"#b06f00", "#0067b1", "#1f2328", "#00835f"},
                  "#1b5faa", "#f6f6f4", "#b34700", "#1f2328"};
const Theme dark{"dark",    "#e6edf3", "#8b949e", "#2b323b",
                 "#8b949e", "#f08fd0", "#58b0f0", {"#f0b23c", "#58b0f0", "#ffffff", "#3fcf9f"},
                 "#5aa9f5", "#12161c", "#ff9a4d", "#e6edf3"};

std::string Plot::file(std::string_view theme, std::string_view layout) const {
    return fmt::format("{}-{}-{}.{}", name, theme, layout, extension);
}

double round_down(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {5.0, 2.0}) {
        if (value >= step * decade) return step * decade;
    }
    return decade;
}
double round_up(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (value <= step * decade) return step * decade;
    }
    return 10.0 * decade;
}

std::string log_tics(double low, double high) {
    const bool is_long = high / low > 150.0;
    std::string out = "(";
    for (double tic = low; tic <= high * 1.0001; tic = round_up(tic * 1.5)) {
        const double decades = std::log10(tic);
        if (is_long && std::abs(decades - std::round(decades)) > 1e-6) continue;
        out += fmt::format("{}'{:g}' {:g}", out.size() > 1 ? ", " : "", tic, tic);
    }
    return out + ")";
}

std::string begin_plot(const std::string& file, const Theme& theme, int width, int height) {
    std::string out = "reset\nset encoding utf8\n";
    if (file.ends_with(".png")) {
        out += fmt::format(
            "set terminal pngcairo enhanced transparent font 'sans,11' fontscale 2 linewidth 2 size {},{}\n", 2 * width,
            2 * height);
    } else {
        out += fmt::format("set terminal svg enhanced rounded font 'sans-serif,14' size {},{}\n", width, height);
    }
    out += fmt::format("set output '{}'\n", file);
    out += fmt::format("set border 3 linecolor rgb '{}'\n", theme.axis);
    out += fmt::format("set tics nomirror out scale 0.6 textcolor rgb '{}'\n", theme.text);
    out += fmt::format("set grid linecolor rgb '{}' linewidth 1 linetype 1\n", theme.grid);
    out += fmt::format("set key tmargin horizontal left Left reverse samplen 2 textcolor rgb '{}'\n", theme.text);
    out += fmt::format("set title textcolor rgb '{}'\nset xlabel textcolor rgb '{}'\nset ylabel textcolor rgb '{}'\n",
                       theme.text, theme.text, theme.text);
    return out;
}

std::string end_plot() { return "unset output\n"; }

std::string n_axis(bool wide, int low) {
    std::string tics;
    for (const int n :
         wide ? std::vector{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000} : std::vector{1, 3, 10, 30, 100, 300, 1000}) {
        if (n >= low) tics += fmt::format("{}{}", tics.empty() ? "" : ", ", n);
    }
    return fmt::format(
        "set logscale x 10\nset xrange [{}:{}]\nset xtics ({})\nset mxtics 1\nset xlabel 'specular exponent n'\n", low,
        max_n, tics);
}

std::string key_name(std::string_view name) {
    std::string out;
    for (const char c : name) out += c == '_' ? std::string("\\_") : std::string(1, c);
    return out;
}

std::string multiplot(int rows, int columns) { return fmt::format("set multiplot layout {},{}\n", rows, columns); }

std::string map_frame(const MapRange& range) {
    std::string out = "unset grid\nunset key\nset tics front\n";
    out += fmt::format("set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n", range.log_n[0], range.log_n[1],
                       range.log_degrees[0], range.log_degrees[1]);
    std::string tics;
    for (const int n : {1, 3, 10, 30, 100, 300, 1000}) {
        const double x = std::log10(n);
        if (x >= range.log_n[0]) tics += fmt::format("{}'{}' {:g}", tics.empty() ? "" : ", ", n, x);
    }
    out += fmt::format("set xtics ({})\nset ytics (", tics);
    for (const double degrees : {0.3, 1.0, 3.0, 10.0, 30.0, 90.0}) {
        out += fmt::format("{}'{:g}°' {:g}", degrees == 0.3 ? "" : ", ", degrees, std::log10(degrees));
    }
    return out + ")\nset xlabel 'specular exponent n'\nset ylabel 'angle of normal and half vector' offset 1\n";
}

std::string colour_box() {
    return "set tmargin 4\nset rmargin 5\n"
           "set colorbox horizontal user origin graph 0, graph 1.03 size graph 1, graph 0.03\n";
}

}  // namespace glint::io
