#include "cli/report/report_paper_page.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cli/report/report_cpu_page.hpp"
#include "cli/report/report_html.hpp"
#include "cli/report/report_paper_plots.hpp"

namespace glint::cli {
namespace {

using studies::paper::Measure;

constexpr int first = studies::paper::first_n;
constexpr int last = studies::paper::last_n;

Summary summary(const Study& study, Measure measure) {
    return measure == Measure::delta ? study.delta(first, last) : study.absolute(first, last);
}

/// delta in percent, Delta as it is.
std::string value_text(double value, Measure measure) {
    return measure == Measure::delta ? fmt::format("{:.3f}&nbsp;%", 100.0 * value) : fmt::format("{:.5f}", value);
}

std::string difference_text(double difference) { return fmt::format("{:+.1f}&nbsp;%", 100.0 * difference); }

std::string code(std::string_view text) { return fmt::format("<code>{}</code>", escaped(text)); }

/// "a, b and c".
std::string enumeration(const std::vector<std::string>& items) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i) {
        out += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    }
    return out;
}

const Form& form_of(std::string_view lobe) {
    const auto all = forms();
    return *std::find_if(all.begin(), all.end(), [&](const Form& form) { return form.lobe == lobe; });
}

/// The least n from which on the value never exceeds `bound`, and 0 where there is none.
int settles(const Study& study, Measure measure, double bound) {
    int out = 0;
    for (const StudyRow& row : study.rows) {
        if (row.n < first) continue;
        const double value = measure == Measure::delta ? row.delta.value : row.absolute.value;
        if (value > bound) {
            out = 0;
        } else if (out == 0) {
            out = row.n;
        }
    }
    return out;
}

// ---- claims ------------------------------------------------------------------------------------------------------

std::string printed_text(const studies::paper::Claim& claim) {
    return claim.measure == Measure::delta ? fmt::format("{:g}&nbsp;%", 100.0 * claim.printed)
                                           : fmt::format("{:g}", claim.printed);
}

std::string explanation(const studies::paper::Claim& claim, const studies::paper::Check& check, const Study& study) {
    const Summary s = summary(study, claim.measure);
    const std::string rounds = fmt::format("At {} of {} exponents the measured value rounds to the printed one.",
                                           check.n_rounding, check.n_count);
    switch (check.explanation) {
        case studies::paper::Check::agrees:
            return claim.statistic == studies::paper::Statistic::median ? "Agrees, as the median. " + rounds
                                                                        : "Agrees.";
        case studies::paper::Check::stepped: {
            const Summary stepped = study.delta_stepped(first, last);
            const StudyRow& row = study.rows[static_cast<std::size_t>(stepped.n - 1)];
            std::string out;
            if (claim.lobe == "schlick") {
                out = fmt::format("For large n it tends to e<sup>1/2</sup>/1.5&nbsp;−&nbsp;1 = {:.3f}&nbsp;%. ",
                                  100.0 * (std::exp(0.5) / 1.5 - 1.0));
            }
            const double edge = epicentre_angle(stepped.n);
            const bool at_edge = study.rows[static_cast<std::size_t>(s.n - 1)].delta.theta >= epicentre_angle(s.n);
            if (at_edge) out += "Largest at the edge of the zone, where it grows fast. ";
            return out +
                   fmt::format(
                       "Over the angles of the paper's "
                       "data set, {:g} rad apart, up to the first one beyond the edge, it is {} (n = {}, {:.1f} % "
                       "beyond the edge): {} to what is printed. So the paper seems to have measured.",
                       paper_step, value_text(check.explained, claim.measure), stepped.n,
                       100.0 * (row.delta_stepped.theta / edge - 1.0), difference_text(check.explained_difference));
        }
        case studies::paper::Check::most_exponents:
            return fmt::format(
                "True of most n, not of all: the median, {}, is {} from what is printed. {} The largest lies at n = "
                "{}.",
                value_text(check.explained, claim.measure), difference_text(check.explained_difference), rounds, s.n);
        case studies::paper::Check::none:
            break;
    }
    return "Not explained. " + rounds;
}

std::string claims_table(const PaperData& data) {
    std::vector<std::vector<Cell>> rows;
    const auto add = [&](const StudiedLobe& lobe, Measure measure, const studies::paper::Claim* claim) {
        const Summary s = summary(lobe.study, measure);
        std::vector<Cell> row{{"lobe", lobe_html(lobe.lobe->name), Cell::name},
                              {"error", measure == Measure::delta ? "δ" : "Δ", Cell::name},
                              {"largest", value_text(s.largest, measure)},
                              {"at n", fmt::format("{}", s.n)},
                              {"median", value_text(s.median, measure)}};
        if (claim == nullptr) {
            row.push_back({"printed", "–"});
            row.push_back({"difference", "–"});
            row.push_back({"remark", "–", Cell::words});
        } else {
            const studies::paper::Check check = studies::paper::check(*claim, lobe.study);
            row.push_back({"printed", printed_text(*claim) + fmt::format("<small>{}</small>", escaped(claim->source))});
            row.push_back({"difference", difference_text(check.difference)});
            row.push_back({"remark", explanation(*claim, check, lobe.study), Cell::words});
        }
        rows.push_back(std::move(row));
    };
    for (const Measure measure : {Measure::delta, Measure::absolute}) {
        for (const StudiedLobe& lobe : data.lobes) {
            if (lobe.exact()) continue;
            bool claimed = false;
            for (const studies::paper::Claim& claim : studies::paper::claims()) {
                if (claim.lobe != lobe.lobe->name || claim.measure != measure) continue;
                add(lobe, measure, &claim);
                claimed = true;
            }
            if (!claimed) add(lobe, measure, nullptr);
        }
    }
    return table_html(rows);
}

std::string comparison_list(const PaperData& data) {
    std::vector<Study> five;
    std::size_t bps_index = 0;
    for (std::size_t i = 0; i < data.of_paper; ++i) {
        if (data.lobes[i].lobe->name == "bps") bps_index = i;
        five.push_back(data.lobes[i].study);
    }
    const Study& bps = five[bps_index];
    const Study& schlick = data.lobe("schlick").study;
    std::string out = "<ul>\n";
    const int count = last - first + 1;
    const int least_delta = studies::paper::times_best(five, bps_index, Measure::delta);
    const int least_absolute = studies::paper::times_best(five, bps_index, Measure::absolute);
    out += fmt::format(
        "<li>“The least of the five on most of [{}, {}]”: {}. f<sub>bps</sub> has the least δ at {} of the {} "
        "exponents, and "
        "the least Δ at {}.</li>\n",
        first, last, 2 * std::min(least_delta, least_absolute) > count ? "true" : "not true", least_delta, count,
        least_absolute);
    for (const Measure measure : {Measure::delta, Measure::absolute}) {
        const Summary s = summary(schlick, measure);
        const Summary b = summary(bps, measure);
        const double medians = s.median / b.median;
        out += fmt::format(
            "<li>“{:g} times better than f<sub>s</sub>” in {}: {:.2f} times by the medians ({}), {:.2f} by the "
            "largest, of which f<sub>bps</sub> has its own at n = {}.",
            studies::paper::printed_ratio, measure == Measure::delta ? "δ" : "Δ", medians,
            difference_text(medians / studies::paper::printed_ratio - 1.0), s.largest / b.largest, b.n);
        if (measure == Measure::delta &&
            std::abs(medians / studies::paper::printed_ratio - 1.0) > studies::paper::tolerance) {
            const double ratio = schlick.delta_stepped(first, last).largest / b.median;
            if (std::abs(ratio / studies::paper::printed_ratio - 1.0) <= studies::paper::tolerance) {
                out += fmt::format(
                    " The printed ratio is that of f<sub>s</sub> measured beyond the edge, as above, to the median of "
                    "f<sub>bps</sub>: {:.2f}.",
                    ratio);
            } else {
                out += " Not explained.";
            }
        }
        out += "</li>\n";
    }
    return out + "</ul>\n";
}

// ---- figures -----------------------------------------------------------------------------------------------------

std::string csv_note(int figure, const std::string& command) {
    return fmt::format("<p>Data: {}. Computed by {}</p>", code(fmt::format("figures/figure-{}.csv", figure)),
                       command_html(command));
}

std::string place(const Surface& surface) {
    return fmt::format("n = {:.1f}, {:.2f}°", surface.largest_n, surface.largest_theta * 180.0 / std::numbers::pi);
}

std::string figures(const PaperData& data, const Pictures& pictures, const std::string& command) {
    const std::string log_axes =
        "The axes are logarithmic, where the paper has linear ones: on those the highlight is a line along the edge. "
        "The broken line is the edge of the epicentre zone.";
    std::string out = fmt::format(
        "<h2 id=\"figures\">The paper's figures</h2>\n<p>All are of the real functions, in double. Figure 3 is <a "
        "href=\"#shape\">the highlight at n = 50</a>; its data: {}. The grids of figures 4, 6 and 8 have {} × {} "
        "points; those of 4 and 8 begin at {:g}°.</p>\n",
        code("figures/figure-3.csv"), data.highlight.columns, data.highlight.rows, map_least_degrees);
    out += "<h3>Figure 4: f<sub>bps</sub> over n and the angle</h3>\n";
    out += figure_html(pictures, figure_4,
                       "Map of f_bps over the exponent and the angle: full at small angles, falling to 0 along a band "
                       "that narrows as the exponent grows.",
                       fmt::format("<p>f<sub>bps</sub>; the largest value is {:.4f}. {}</p>{}", data.highlight.largest,
                                   log_axes, csv_note(4, command)));
    std::vector<std::string> exact;
    for (const StudiedLobe& lobe : data.lobes) {
        if (lobe.exact()) exact.push_back(code(lobe.lobe->name));
    }
    const std::string left_out =
        exact.empty() ? std::string()
                      : fmt::format(" Without {}, whose real function is c<sup>n</sup>.", enumeration(exact));
    const auto caption = [&](std::string_view what, int figure) {
        return fmt::format(
            "<p>{} for every n of {} to {}; both axes are logarithmic, where the paper has linear ones, since the "
            "lobes are two orders of magnitude apart and change most for small n.{} A lobe that is exact at an n "
            "leaves the plot there.</p>{}",
            what, first, last, left_out, csv_note(figure, command));
    };
    out += "<h3>Figure 5: the largest δ in the epicentre</h3>\n";
    out +=
        figure_html(pictures, figure_5,
                    "Largest relative error in the epicentre zone over the exponent, for the five lobes of the paper "
                    "and for the others beside bps.",
                    caption("Largest relative error in the epicentre zone,", 5));
    out += "<h3>Figure 6: δ of f<sub>bps</sub> in the epicentre</h3>\n";
    out += figure_html(
        pictures, figure_6,
        "Map of the relative error of f_bps over the exponent and the part of the epicentre zone: bands "
        "at fixed parts of the zone, and the largest errors at its edge for small exponents.",
        fmt::format("<p>Relative error of f<sub>bps</sub> against c<sup>n</sup>; n is logarithmic, the "
                    "angle linear from 0 to the edge of the zone at each n. Colours end at {:g} %; the "
                    "largest on the grid is {:.3f} % at {}.</p>{}",
                    delta_scale_percent, 100.0 * data.delta.largest, place(data.delta), csv_note(6, command)));
    out += "<h3>Figure 7: the largest Δ</h3>\n";
    out += figure_html(pictures, figure_7,
                       "Largest absolute error over the exponent, for the five lobes of the paper and for the others "
                       "beside bps.",
                       caption("Largest absolute error over all angles,", 7));
    out += "<h3>Figure 8: Δ of f<sub>bps</sub></h3>\n";
    out += figure_html(
        pictures, figure_8,
        "Map of the absolute error of f_bps over the exponent and the angle: bands along the width of the highlight.",
        fmt::format(
            "<p>Absolute error of f<sub>bps</sub> against c<sup>n</sup>. {} Colours end at {:g}; the largest on "
            "the grid is {:.4f} at {}.</p>{}",
            log_axes, map_scale, data.absolute.largest, place(data.absolute), csv_note(8, command)));
    return out;
}

// ---- choosing ----------------------------------------------------------------------------------------------------

double largest_below_first(const Study& study) { return study.absolute(1, first - 1).largest; }

std::string lobes_table(const PaperData& data, const std::optional<CpuPrices>& cpu) {
    std::vector<const StudiedLobe*> order;
    for (const StudiedLobe& lobe : data.lobes) order.push_back(&lobe);
    std::stable_sort(order.begin(), order.end(), [](const StudiedLobe* a, const StudiedLobe* b) {
        return a->study.absolute(first, last).largest < b->study.absolute(first, last).largest;
    });
    std::vector<std::vector<Cell>> rows;
    for (const StudiedLobe* lobe : order) {
        const Summary absolute = lobe->study.absolute(first, last);
        std::string zero = "none";
        if (lobe->zero) {
            zero = fmt::format("{:.1f}° to {:.0f}°", lobe->zero->from, lobe->zero->to);
            if (lobe->zero->drop >= 1e-3) zero += fmt::format("<small>falls from {:.4f}</small>", lobe->zero->drop);
        }
        const Operations counted = form_of(lobe->lobe->name).count();
        std::vector<Cell> row{
            {"lobe", lobe_html(lobe->lobe->name), Cell::name},
            {"Δ, n from 8", fmt::format("{:.5f}", absolute.largest) +
                                (lobe->exact() ? "" : fmt::format("<small>n = {}</small>", absolute.n))},
            {"Δ, n below 8", fmt::format("{:.5f}", largest_below_first(lobe->study))},
            {"δ, n from 8", value_text(lobe->study.delta(first, last).largest, Measure::delta)},
            {"at c = 1", fmt::format("{:.4f}", lobe->peak)},
            {"at c = 0", fmt::format("{:.4f}", lobe->floor)},
            {"0 at", zero},
            {"cycles, Zen 4 double", counted.calls == 0 ? fmt::format("{}", counted.cycles(zen4_double)) : "–"}};
        if (cpu) {
            const CpuPrice* price = cpu->find(lobe->lobe->name, "double", "scalar");
            const bool latency = price != nullptr && price->latency;
            row.push_back({"latency, ns", latency ? fmt::format("{:.2f}", *price->latency) : "–"});
            row.push_back({"throughput, ns", price != nullptr ? fmt::format("{:.2f}", price->throughput) : "–"});
        }
        rows.push_back(std::move(row));
    }
    return table_html(rows);
}

std::string small_n_table(const PaperData& data) {
    const Study& bps = data.lobe("bps").study;
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < first; ++i) {
        const StudyRow& row = bps.rows[i];
        const StudiedLobe* least = nullptr;
        for (const StudiedLobe& lobe : data.lobes) {
            if (lobe.exact()) continue;
            if (least == nullptr || lobe.study.rows[i].absolute.value < least->study.rows[i].absolute.value)
                least = &lobe;
        }
        rows.push_back({{"n", fmt::format("{}", row.n), Cell::name},
                        {"δ of bps", std::isnan(row.delta.value) ? "–" : value_text(row.delta.value, Measure::delta)},
                        {"Δ of bps", fmt::format("{:.5f}", row.absolute.value)},
                        {"Δ of schlick", fmt::format("{:.5f}", data.lobe("schlick").study.rows[i].absolute.value)},
                        {"the least Δ", fmt::format("{:.5f}<small>{}</small>", least->study.rows[i].absolute.value,
                                                    least->lobe->name)}});
    }
    return table_html(rows);
}

/// Than f_bps, one evaluation at a time in double.
bool no_slower(const CpuPrices& cpu, std::string_view lobe) {
    const CpuPrice* own = cpu.find(lobe, "double", "scalar");
    const CpuPrice* bps = cpu.find("bps", "double", "scalar");
    const double most = 1.0 + studies::paper::tolerance;
    return own != nullptr && bps != nullptr && own->throughput <= most * bps->throughput && own->latency &&
           bps->latency && *own->latency <= most * *bps->latency;
}

/// What is cheaper than f_bps, and what is better, by the numbers of the table.
std::string verdicts(const PaperData& data, const std::optional<CpuPrices>& cpu) {
    const StudiedLobe& bps = data.lobe("bps");
    const int bps_cycles = form_of("bps").count().cycles(zen4_double);
    const Summary bps_absolute = bps.study.absolute(first, last);
    const Summary bps_delta = bps.study.delta(first, last);
    std::vector<std::string> cheaper, closer, closer_in_zone, both;
    for (const StudiedLobe& lobe : data.lobes) {
        if (&lobe == &bps || lobe.exact()) continue;
        const double absolute = lobe.study.absolute(first, last).largest;
        const double delta = lobe.study.delta(first, last).largest;
        const std::string name = code(lobe.lobe->name);
        const bool is_closer = absolute < bps_absolute.largest;
        if (is_closer) closer.push_back(fmt::format("{} {:.1f} times", name, bps_absolute.largest / absolute));
        if (delta < bps_delta.largest) {
            closer_in_zone.push_back(fmt::format("{} {:.1f} times", name, bps_delta.largest / delta));
        }
        if (is_closer && cpu && no_slower(*cpu, lobe.lobe->name)) both.push_back(name);
        const Operations counted = form_of(lobe.lobe->name).count();
        if (counted.calls > 0 || counted.cycles(zen4_double) >= bps_cycles) continue;
        cheaper.push_back(fmt::format("{} ({} cycles, Δ {:.1f} times as large)", name, counted.cycles(zen4_double),
                                      absolute / bps_absolute.largest));
    }
    const auto item = [](const std::string& what, const std::vector<std::string>& names) {
        return fmt::format("<li>{}: {}.</li>\n", what, names.empty() ? "none" : enumeration(names));
    };
    return "<ul>\n" + item(fmt::format("Cheaper than f<sub>bps</sub> with its {} cycles", bps_cycles), cheaper) +
           item(fmt::format("Of a smaller largest Δ than its {:.4f}", bps_absolute.largest), closer) +
           item(fmt::format("Of a smaller largest δ than its {}", value_text(bps_delta.largest, Measure::delta)),
                closer_in_zone) +
           (cpu ? item(fmt::format("Of a smaller largest Δ, and neither in latency nor in throughput more than {:g} % "
                                   "slower on this processor",
                                   100.0 * studies::paper::tolerance),
                       both)
                : std::string()) +
           "</ul>\n";
}

}  // namespace

std::string choosing_section(const PaperData& data, const std::optional<CpuPrices>& cpu) {
    const StudiedLobe& bps = data.lobe("bps");
    const Summary delta = bps.study.delta(first, last);
    const Summary absolute = bps.study.absolute(first, last);
    const double near_median = 1.1 * delta.median;
    std::string out =
        "<h2 id=\"choosing\">Choosing a lobe</h2>\n<p>For the engineer: what the published f<sub>bps</sub> keeps of "
        "its promise, and what else there is. All numbers here are of the real functions; what fixed point adds is in "
        "<a href=\"#accuracy\">Errors</a>. δ is the largest relative error in the epicentre zone, Δ the largest "
        "absolute error over all angles, both against c<sup>n</sup>.</p>\n<ul>\n";
    out += fmt::format(
        "<li>The paper is right for most n of {} to {}: median δ {}, median Δ {:.4f}; <a href=\"#paper\">claim by "
        "claim</a>.</li>\n",
        first, last, value_text(delta.median, Measure::delta), absolute.median);
    const int from = settles(bps.study, Measure::delta, near_median);
    out += fmt::format(
        "<li>It is not right for small n. The largest δ is {} at n = {}, the largest Δ {:.4f} at n = {}; {}below n = "
        "{} Δ reaches {:.4f}.</li>\n",
        value_text(delta.largest, Measure::delta), delta.n, absolute.largest, absolute.n,
        from > 0 ? fmt::format("δ is within a tenth of its median from n = {} on; ", from) : std::string(), first,
        largest_below_first(bps.study));
    out += fmt::format("<li>The middle of a highlight is {:.4f} at every n, not 1: {:.2f} % too dark.</li>\n", bps.peak,
                       100.0 * (1.0 - bps.peak));
    out += fmt::format("<li>Far from it, at c = 0, {:.4f} is left at every n, not 0.", bps.floor);
    if (bps.zero) {
        const double c = std::cos(bps.zero->from * std::numbers::pi / 180.0);
        out += fmt::format(
            " Between them is a stretch of zero: at n = {} it begins at {:.1f}°, where c<sup>n</sup> is still {:.5f}, "
            "and ends at {:.1f}°, from where the value rises again: a faint veil around the dark ring.",
            shape_n, bps.zero->from, std::pow(c, shape_n), bps.zero->to);
    }
    out += "</li>\n</ul>\n<h3>All lobes</h3>\n";
    out += fmt::format(
        "<p>By their largest Δ. The value at c = 0 and the angles where the lobe is 0 are those at n = {}; where it "
        "falls to 0 in a step of 0.001 or more, the table says from which value. Cycles and times are those of <a "
        "href=\"#costs\">software</a> in double; in hardware a division is a pipeline, a multiplication by a constant "
        "a few "
        "adders, and docs/rtl.md has the clocks.</p>\n",
        shape_n);
    out += lobes_table(data, cpu) + verdicts(data, cpu);
    out += "<h3>Small exponents</h3>\n";
    return out + small_n_table(data);
}

std::string paper_sections(const PaperData& data, const std::optional<CpuPrices>& cpu, const Pictures& pictures,
                           const std::string& command) {
    std::string out = fmt::format(
        "<h2 id=\"paper\">The paper's claims</h2>\n<p>Zavalniuk, Romanyuk, Satsiuk 2024, which proposed "
        "f<sub>bps</sub>, compares it with four others for n of {} to {}. Measured here at each of these n, over "
        "angles 1/1000 of the epicentre zone apart for δ, and 1/125 of it for Δ, finer around the largest. A "
        "difference of more than {:g} % to what is printed has a remark, which was tested by measuring. Without a "
        "printed value: what the paper does not have.</p>\n",
        first, last, 100.0 * studies::paper::tolerance);
    out += claims_table(data) + comparison_list(data);
    out += fmt::format("<p>Computed by {}</p>\n", command_html(command));
    return out + figures(data, pictures, command) + costs_section(cpu);
}

}  // namespace glint::cli
