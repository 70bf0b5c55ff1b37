#include "cli/report/report_paper2_plots.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace glint::cli {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr std::size_t step = 5;  // of the points of a figure, as many as a plot can show

std::string data_blocks(const Paper2Data& data) {
    std::string out;
    for (std::size_t i = 0; i < data.distributions.size(); ++i) {
        const auto& figure = data.distributions[i];
        out += fmt::format("$distribution{} << EOD\n", i);
        for (std::size_t k = 0; k < figure.x.size(); k += step) {
            out += fmt::format("{:.2f} {:.5f} {:.5f} {:.5f}\n", degrees * figure.x[k], figure.distribution[k],
                               figure.angle_cubic[k], figure.half_cubic[k]);
        }
        out += "EOD\n";
    }
    for (std::size_t i = 0; i < data.reflectances.size(); ++i) {
        const auto& figure = data.reflectances[i];
        out += fmt::format("$reflectance{} << EOD\n", i);
        for (std::size_t k = 0; k < figure.x.size(); k += step) {
            out += fmt::format("{:.4f} {:.5f}\n", figure.x[k], figure.reflectance[k]);
        }
        out += "EOD\n";
    }
    const auto& h = data.highlight;
    out += "$highlight << EOD\n";
    for (std::size_t k = 0; k < h.x.size(); k += step) {
        out += fmt::format("{:.2f} {:.5f} {:.5f} {:.5f}\n", degrees * h.x[k], h.phong[k], h.blinn_phong[k],
                           h.blinn_phong_4n[k]);
    }
    return out + "EOD\n";
}

std::string curve(const std::string& block, int column, double width, std::string_view dash, std::string_view colour,
                  std::string_view title) {
    return fmt::format("${} using 1:{} with lines linewidth {:g} dashtype {} linecolor rgb '{}' title '{}'", block,
                       column, width, dash, colour, title);
}

std::string distribution_panel(const Paper2Data& data, const Theme& theme, std::size_t i) {
    const auto& figure = data.distributions[i];
    double top = 1.0;
    for (const auto* values : {&figure.distribution, &figure.angle_cubic, &figure.half_cubic}) {
        top = std::max(top, *std::max_element(values->begin(), values->end()));
    }
    std::string out =
        fmt::format("set xrange [0:90]\nset yrange [0:{:g}]\nset xtics 30\nset format x '%g°'\n", 1.02 * top);
    out += "set ytics 0.2\nset tmargin 6\nset key vertical maxcols 1\n";
    out += fmt::format("set title 'm = {:g}'\nset xlabel 'angle of N and H'\nset ylabel 'm^2 D' offset 1\n", figure.m);
    const std::string block = fmt::format("distribution{}", i);
    return out + "plot " + curve(block, 2, 5, "solid", theme.target, "Beckmann") + ", " +
           curve(block, 3, 2, "(12,5)", theme.schlick, "cubic in the angle") + ", " +
           curve(block, 4, 2, "solid", theme.bps, "cubic in N.H") + "\n";
}

std::string reflectance_panel(const Paper2Data& data, const Theme& theme) {
    std::string out =
        "set xrange [0:1]\nset yrange [0:1]\nset xtics 0.2\nset ytics 0.2\nset xlabel 'V.H'\n"
        "set ylabel 'reflectance F' offset 1\n";
    std::string curves;
    for (std::size_t i = 0; i < data.reflectances.size(); ++i) {
        const auto& figure = data.reflectances[i];
        const std::string_view colour = theme.runs[i % std::size(theme.runs)];
        curves += (curves.empty() ? "plot " : ", ") +
                  curve(fmt::format("reflectance{}", i), 2, 2, "solid", colour, fmt::format("{:g}", figure.index));
        curves += fmt::format(", [0.4:1] {:g} with lines linewidth 1.5 dashtype (5,5) linecolor rgb '{}' notitle",
                              figure.mean, colour);
    }
    return out + curves + "\n";
}

std::string highlight_panel(const Paper2Data& data, const Theme& theme) {
    const double n = data.highlight.n;
    std::string out =
        "set xrange [0:45]\nset yrange [0:1]\nset xtics 15\nset format x '%g°'\nset ytics 0.2\nset key vertical "
        "maxcols 1\nset xlabel 'angle of viewer and mirrored light'\nset ylabel 'highlight' offset 1\n";
    return out + "plot " + curve("highlight", 2, 5, "solid", theme.target, fmt::format("Phong, n = {:g}", n)) + ", " +
           curve("highlight", 3, 2, "(12,5)", theme.schlick, fmt::format("Blinn-Phong, n = {:g}", n)) + ", " +
           curve("highlight", 4, 2, "solid", theme.bps, fmt::format("Blinn-Phong, n = {:g}", 4.0 * n)) + "\n";
}

}  // namespace

std::string paper2_plots(const Paper2Data& data, std::vector<std::string>& pictures) {
    std::string out = data_blocks(data);
    const int panels = static_cast<int>(data.distributions.size());
    for (const Theme* theme : {&light, &dark}) {
        for (const Layout& layout : {wide, narrow}) {
            const auto start = [&](const Plot& plot, int height) {
                pictures.push_back(plot.file(theme->name, layout.name));
                return begin_plot(pictures.back(), *theme, layout.width, height);
            };
            const bool is_wide = layout.is_wide();
            out += start(distribution_plot, is_wide ? 380 : 340 * panels);
            out += multiplot(is_wide ? 1 : panels, is_wide ? panels : 1);
            for (std::size_t i = 0; i < data.distributions.size(); ++i) out += distribution_panel(data, *theme, i);
            out += "unset multiplot\n" + end_plot();
            out += start(reflectance_plot, is_wide ? 400 : 340) + reflectance_panel(data, *theme) + end_plot();
            out += start(highlight_plot, is_wide ? 440 : 380) + highlight_panel(data, *theme) + end_plot();
        }
    }
    return out;
}

}  // namespace glint::cli
