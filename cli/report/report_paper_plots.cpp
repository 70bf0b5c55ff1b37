#include "cli/report/report_paper_plots.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace glint::cli {
namespace {

std::string surface_block(std::string_view name, const Surface& surface, double scale) {
    std::string out = fmt::format("${} << EOD\n", name);
    for (std::size_t i = 0; i < surface.value.size(); ++i) {
        out += fmt::format("{:.4g}{}", scale * surface.value[i], (i + 1) % surface.columns == 0 ? '\n' : ' ');
    }
    return out + "EOD\n";
}

std::string data_blocks(const PaperData& data) {
    std::string out = surface_block("highlight", data.highlight, 1.0);
    out += surface_block("delta", data.delta, 100.0);
    out += surface_block("absolute", data.absolute, 1.0);
    for (std::size_t i = 0; i < data.lobes.size(); ++i) {
        out += fmt::format("$lobe{} << EOD\n", i);
        double last = 0.0;
        for (const StudyRow& row : data.lobes[i].study.rows) {
            // As many as the axis can show.
            const double place = std::floor(100.0 * std::log10(row.n));
            if (row.n < studies::paper::first_n || (place == last && row.n != studies::paper::last_n)) continue;
            last = place;
            out += fmt::format("{} {:.5g} {:.5g}\n", row.n, 100.0 * row.delta.value, row.absolute.value);
        }
        out += "EOD\n";
    }
    return out;
}

/// Two panels over n: the paper's five, and ours beside f_bps. Lobes that are c^n itself have no place there.
class ErrorPlot {
public:
    ErrorPlot(const PaperData& data, studies::paper::Measure measure)
        : data_(data), delta_(measure == studies::paper::Measure::delta) {
        double least = 1.0;
        int of_paper = 0;
        int own = 1;  // f_bps
        for (const StudiedLobe& lobe : data.lobes) {
            if (lobe.exact()) continue;
            ++(&lobe - data.lobes.data() < static_cast<std::ptrdiff_t>(data.of_paper) ? of_paper : own);
            const Summary s = delta_ ? lobe.study.delta(studies::paper::first_n, studies::paper::last_n)
                                     : lobe.study.absolute(studies::paper::first_n, studies::paper::last_n);
            least = std::min(least, unit() * s.median);
            high_ = std::max(high_, unit() * s.largest);
        }
        // A lobe that is exact at one n falls to 0 there, and out of the plot.
        low_ = round_down(least / 3.0);
        high_ *= 1.3;
        key_lines_ = std::max(of_paper, own);
    }

    int key_lines() const { return key_lines_; }

    std::string panel(const Theme& theme, bool own) const {
        std::string out = n_axis(false, studies::paper::first_n);
        // A name a line, and both panels of one height.
        out += fmt::format("set tmargin {}\nset key vertical maxcols 1\n", key_lines_ + 3);
        out += fmt::format("set logscale y 10\nset yrange [{:g}:{:g}]\nset ytics {}\nset mytics 1\n", low_, high_,
                           log_tics(low_, high_));
        out += fmt::format("set ylabel '{}' offset 1\n", delta_ ? "largest δ in the epicentre, percent" : "largest Δ");
        out += fmt::format("set title '{}'\n", own ? "lobes beyond the paper, beside bps" : "the five of the paper");
        std::string curves;
        const auto add = [&](std::size_t lobe, double width, std::string_view colour, std::string_view dash) {
            curves +=
                fmt::format("{}$lobe{} using 1:{} with lines linewidth {:g} dashtype {} linecolor rgb '{}' title '{}'",
                            curves.empty() ? "plot " : ", ", lobe, delta_ ? 2 : 3, width, dash, colour,
                            key_name(data_.lobes[lobe].lobe->name));
        };
        const std::string_view paper_colours[] = {theme.schlick, theme.runs[0], theme.target, theme.runs[3], theme.bps};
        const std::string_view own_colours[] = {theme.runs[0], theme.runs[3], theme.schlick, theme.runs[2],
                                                theme.target};
        std::size_t drawn = 0;
        for (std::size_t i = 0; i < data_.lobes.size(); ++i) {
            const bool bps = data_.lobes[i].lobe->name == "bps";
            if (bps) add(i, 3.0, theme.bps, "solid");
            if (bps || data_.lobes[i].exact() || own != (i >= data_.of_paper)) continue;
            const std::size_t colours = std::size(own_colours);
            add(i, 2.0, own ? own_colours[drawn % colours] : paper_colours[i % std::size(paper_colours)],
                own && drawn >= colours ? "(8,4)" : "solid");
            ++drawn;
        }
        return out + curves + "\n";
    }

private:
    double unit() const { return delta_ ? 100.0 : 1.0; }

    const PaperData& data_;
    bool delta_;
    double low_ = 0.0;
    double high_ = 0.0;
    int key_lines_ = 0;
};

/// Rows are even in the log of the angle, or with `zone` in the fraction of the epicentre zone.
std::string map_panel(const Theme& theme, std::string_view block, const Surface& surface, bool zone, double top,
                      std::string_view top_label) {
    const double low_n = std::log10(surface.n.front());
    const double high_n = std::log10(surface.n.back());
    const double low = zone ? 0.0 : std::log10(map_least_degrees);
    const double high = zone ? 1.0 : std::log10(90.0);
    std::string out = map_frame({{low_n, high_n}, {low, high}});
    if (zone) out += "set ytics 0.2\nset ylabel 'angle as a part of the epicentre zone' offset 1\n";
    out += fmt::format("set palette defined (0 '{}', 1 '{}')\n", theme.zero, theme.positive);
    out += fmt::format("set cbrange [0:{0:g}]\nset cbtics ('0' 0, '{1:g}' {1:g}, '{2}' {0:g}) offset 0,2.6 scale 0\n",
                       top, top / 2.0, top_label);
    out += colour_box();
    const double x_step = (high_n - low_n) / static_cast<double>(surface.columns - 1);
    const double y_step = (high - low) / static_cast<double>(surface.rows - 1);
    out += fmt::format("plot ${} matrix using ({:g}+{:g}*$1):({:g}+{:g}*$2):3 with image", block, low_n, x_step, low,
                       y_step);
    if (!zone) {
        out += fmt::format(
            ", [{}:{:g}] log10(atan(1 / sqrt(10**x - 1)) * 180 / pi) with lines linewidth 1.5 dashtype (12,5) "
            "linecolor rgb '{}'",
            low_n > 0 ? fmt::format("{:g}", low_n) : std::string("0.001"), high_n, theme.outside);
    }
    return out + "\n";
}

}  // namespace

std::string paper_plots(const PaperData& data, std::vector<std::string>& pictures) {
    std::string out = data_blocks(data);
    const ErrorPlot delta(data, studies::paper::Measure::delta);
    const ErrorPlot absolute(data, studies::paper::Measure::absolute);
    for (const Theme* theme : {&light, &dark}) {
        for (const Layout& layout : {wide, narrow}) {
            const auto start = [&](const Plot& plot, int height) {
                pictures.push_back(plot.file(theme->name, layout.name));
                return begin_plot(pictures.back(), *theme, layout.width, height);
            };
            const bool is_wide = layout.is_wide();
            const int map_height = is_wide ? 440 : 360;
            const int panel_height = 380 + 18 * delta.key_lines();
            const int panels_height = is_wide ? panel_height : 2 * panel_height;
            const std::string panels = multiplot(is_wide ? 1 : 2, is_wide ? 2 : 1);
            out += start(figure_4, map_height) + map_panel(*theme, "highlight", data.highlight, false, 1.0, "1");
            out += end_plot();
            for (const auto& [plot, errors] : {std::pair{figure_5, &delta}, std::pair{figure_7, &absolute}}) {
                out += start(plot, panels_height) + panels + errors->panel(*theme, false) + errors->panel(*theme, true);
                out += "unset multiplot\n" + end_plot();
            }
            out += start(figure_6, map_height);
            out += map_panel(*theme, "delta", data.delta, true, delta_scale_percent,
                             fmt::format("≥ {:g} %%", delta_scale_percent));
            out += end_plot() + start(figure_8, map_height);
            out += map_panel(*theme, "absolute", data.absolute, false, map_scale, fmt::format("≥ {:g}", map_scale));
            out += end_plot();
        }
    }
    return out;
}

}  // namespace glint::cli
