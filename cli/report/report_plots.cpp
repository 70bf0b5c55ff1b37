#include "cli/report/report_plots.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "cli/report/report_paper2_plots.hpp"
#include "cli/report/report_paper_plots.hpp"

namespace glint::cli {
namespace {

/// The data, once, as blocks that every plot refers to.
std::string data_blocks(const PlotData& data) {
    std::string out = "$curves << EOD\n";
    for (std::size_t i = 0; i < data.curves.points.size(); i += 10) {
        const Curves::Point& p = data.curves.points[i];
        out += fmt::format("{:.2f} {:.6f} {:.6f} {:.6f}\n", p.degrees, p.blinn_phong, p.schlick, p.bps);
    }
    out += "EOD\n$map << EOD\n";
    for (std::size_t row = 0; row < data.map.rows; ++row) {
        for (std::size_t column = 0; column < data.map.columns; ++column) {
            out += fmt::format("{:.6f} ", data.map.error[row * data.map.columns + column]);
        }
        out += '\n';
    }
    out += "EOD\n$schlick << EOD\n";
    for (std::size_t i = 0; i < data.schlick.size(); ++i) {
        out += fmt::format("{} {:.6g}\n", i + 1, data.schlick[i].value);
    }
    out += "EOD\n";
    for (std::size_t i = 0; i < data.measured.size(); ++i) {
        out += fmt::format("$run{} << EOD\n", i);
        for (const AccuracyRow& row : data.measured[i].accuracy().rows) {
            out += fmt::format("{} {:.6g} {:.6g} {:.6g}\n", row.n, row.accuracy.approximation.value,
                               row.accuracy.approximation_exact.value, row.accuracy.rounding.value);
        }
        out += "EOD\n";
    }
    return out;
}

/// One column of a measured run over n. When colours come round again they are dotted. A few rows are shown as points
/// too, since a single one has no line.
std::string run_curve(const PlotData& data, const Theme& theme, std::size_t run, int column, double width,
                      std::string_view dash) {
    const std::size_t colours = std::size(theme.runs);
    const std::size_t rows = data.measured[run].accuracy().rows.size();
    return fmt::format(", $run{} using 1:{} with {} linewidth {:.2g} dashtype {} linecolor rgb '{}' title '{}'", run,
                       column, rows < 50 ? "linespoints pointtype 7 pointsize 0.6" : "lines", width,
                       run < colours ? dash : "(3,5)", theme.runs[run % colours], key_name(data.measured[run].name()));
}

std::string curves_panel(const Theme& theme, bool wide) {
    std::string out = fmt::format("set xrange [0:45]\nset yrange [0:1]\nset xtics {}\n", wide ? 5 : 10);
    out += "set format x '%g°'\nset ytics 0.2\n";
    out += "set xlabel 'angle of normal and half vector'\nset ylabel 'highlight' offset 1\n";
    out += fmt::format(
        "plot $curves using 1:3 with lines linewidth 2 dashtype (12,5) linecolor rgb '{}' title 'f_s, Schlick', "
        "$curves using 1:2 with lines linewidth 5 linecolor rgb '{}' title 'c^n, Blinn-Phong', "
        "$curves using 1:4 with lines linewidth 2 linecolor rgb '{}' title 'f_{{bps}}'\n",
        theme.schlick, theme.target, theme.bps);
    return out;
}

/// Column 2: at the rounded cosine, 3: at the exact one.
std::string approximation_panel(const PlotData& data, const Theme& theme, int column) {
    double low = 0.1;
    double high = 0.2;
    for (const AngleError& error : data.schlick) high = std::max(high, error.value);
    for (const MeasuredRun& measured : data.measured) {
        for (const AccuracyRow& row : measured.accuracy().rows) {
            // A logarithmic axis has no place for 0; f_s at n = 1 is such a point, and left out.
            if (row.accuracy.approximation.value > 0) low = std::min(low, row.accuracy.approximation.value);
            high = std::max(high, row.accuracy.approximation_exact.value);
        }
    }
    low = round_down(low);
    high *= 1.2;
    std::string out = n_axis(false);
    out += fmt::format("set logscale y 10\nset yrange [{:g}:{:g}]\nset ytics {}\nset mytics 1\n", low, high,
                       log_tics(low, high));
    out += "set ylabel 'largest absolute error against c^n' offset 1\n";
    out += fmt::format("plot $schlick using 1:2 with lines linewidth 2 dashtype (12,5) linecolor rgb '{}' title 'f_s'",
                       theme.schlick);
    // Curves of one lobe lie almost on each other: wide, narrow, and broken on top, all of them can be seen.
    const std::size_t last = data.measured.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const double width = last == 0 ? 2.0 : 4.5 - 3.0 * static_cast<double>(i) / static_cast<double>(last);
        out += run_curve(data, theme, i, column, width, i > 0 && i == last ? "(5,7)" : "solid");
    }
    return out + "\n";
}

std::string rounding_panel(const PlotData& data, const Theme& theme, bool wide) {
    double low = 0.5;
    double high = 1.0;
    for (const MeasuredRun& measured : data.measured) {
        for (const AccuracyRow& row : measured.accuracy().rows) {
            low = std::min(low, row.accuracy.rounding.value);
            high = std::max(high, row.accuracy.rounding.value);
        }
    }
    std::string out = n_axis(wide);
    out += fmt::format("set yrange [{:g}:{:g}]\n", std::floor(10 * low) / 10, high + 0.1);
    out += "set ylabel 'largest rounding error in ulp' offset 1\n";
    out += fmt::format("plot 1 with lines linewidth 2 dashtype (12,5) linecolor rgb '{}' title '1 ulp'", theme.axis);
    for (std::size_t i = 0; i < data.measured.size(); ++i) {
        out += run_curve(data, theme, i, 4, 1.2, "solid");
    }
    return out + "\n";
}

std::string map_panel(const ErrorMap& map, const Theme& theme, bool wide) {
    const double x_step = map.log_n(1);
    const double y_low = map.log_degrees(0);
    const double y_step = map.log_degrees(1) - y_low;
    const double x_high = map.log_n(map.columns - 1);
    const double y_high = map.log_degrees(map.rows - 1);
    std::string out = map_frame({{0.0, x_high}, {y_low, y_high}});
    out += fmt::format("set palette defined (-1 '{}', 0 '{}', 1 '{}')\n", theme.negative, theme.zero, theme.positive);
    out += fmt::format("set cbrange [-{0:g}:{0:g}]\n", map_scale);
    // Narrow screens have room for three labels.
    out += fmt::format("set cbtics ('≤ −{0:g}' -{0:g}, '0' 0, '≥ +{0:g}' {0:g}) offset 0,2.6 scale 0\n", map_scale);
    if (wide) out += fmt::format("set cbtics add ('−{0:g}' -{0:g}, '+{0:g}' {0:g})\n", map_scale / 2);
    out += colour_box();
    out += fmt::format(
        "plot $map matrix using ({:g}*$1):({:g}+{:g}*$2):3 with image, "
        "log10(atan(1 / sqrt(10**x - 1)) * 180 / pi) with lines linewidth 1.5 dashtype (12,5) linecolor rgb '{}'\n",
        x_step, y_low, y_step, theme.outside);
    return out;
}

std::string page_plots(const PlotData& data, const Theme& theme, const Layout& layout,
                       std::vector<std::string>& pictures) {
    const auto start = [&](const Plot& plot, int height) {
        pictures.push_back(plot.file(theme.name, layout.name));
        return begin_plot(pictures.back(), theme, layout.width, height);
    };
    const bool is_wide = layout.is_wide();
    std::string out = start(curves_plot, is_wide ? 400 : 340) + curves_panel(theme, is_wide) + end_plot();
    out += start(map_plot, is_wide ? 480 : 380) + map_panel(data.map, theme, is_wide) + end_plot();
    if (data.measured.empty()) return out;
    out += start(approximation_plot, is_wide ? 440 : 760) + multiplot(is_wide ? 1 : 2, is_wide ? 2 : 1);
    out += "set title 'at the rounded cosine'\n" + approximation_panel(data, theme, 2);
    out += "set title 'at the exact cosine'\n" + approximation_panel(data, theme, 3);
    out += "unset multiplot\n" + end_plot();
    out += start(rounding_plot, is_wide ? 400 : 340) + rounding_panel(data, theme, is_wide) + end_plot();
    return out;
}

std::string overview(const PlotData& data, const Theme& theme, std::vector<std::string>& pictures) {
    pictures.push_back(overview_file(theme.name));
    std::string out = begin_plot(pictures.back(), theme, 960, 400) + multiplot(1, 2);
    out += fmt::format("set title 'The highlight at n = {}'\n", data.curves.n) + curves_panel(theme, false);
    out += "set format x\nset title 'Approximation error at the rounded cosine'\n";
    out += approximation_panel(data, theme, 2);
    return out + "unset multiplot\n" + end_plot();
}

}  // namespace

std::string overview_file(std::string_view theme) { return fmt::format("overview-{}.svg", theme); }

Pictures draw(const PlotData& data) {
    std::string script = data_blocks(data);
    std::vector<std::string> pictures;
    for (const Theme& theme : {light, dark}) {
        for (const Layout& layout : {wide, narrow}) script += page_plots(data, theme, layout, pictures);
        if (!data.measured.empty()) script += overview(data, theme, pictures);
    }
    script += paper_plots(data.paper, pictures);
    script += paper2_plots(data.paper2, pictures);
    if (data.cost) script += cost_plots(*data.cost, pictures);
    return run_gnuplot(script, pictures);
}

}  // namespace glint::cli
