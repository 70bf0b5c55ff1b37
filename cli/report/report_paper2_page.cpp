#include "cli/report/report_paper2_page.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cli/report/report_html.hpp"
#include "cli/report/report_paper2_cpu_page.hpp"
#include "cli/report/report_paper2_plots.hpp"

namespace glint::cli {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// Where "almost identical" begins: the largest difference as a part of the highlight's greatest value.
constexpr double alike = 0.05;
/// Where "sharply" begins: so much of the fall in two fifths of the axis.
constexpr double sharp = 0.8;

const studies::paper2::TableRow* printed(std::string_view model) {
    const auto rows = studies::paper2::table();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.model == model; });
    return found == rows.end() ? nullptr : &*found;
}

std::string percent(double x, int digits = 0) { return fmt::format("{:.{}f}&nbsp;%", 100.0 * x, digits); }

std::string csv_note(std::string_view name, const std::string& command) {
    return fmt::format("<p>Data: <code>figures/{}.csv</code>. Computed by {}</p>", name, command_html(command));
}

// ---- claims ------------------------------------------------------------------------------------------------------

struct Verdict {
    std::string claim, printed, measured, verdict;
};

/// The printed instructions, from what the full form has: each division and each call as so many instructions that it
/// comes to what is printed, and every other operation as one.
struct Expanded {
    explicit Expanded(const Paper2Data& data)
        : full(data.model("Cook-Torrance").operations), modified(data.model("modified Cook-Torrance").operations) {
        const int heavy = full.divisions + full.calls;
        each = static_cast<double>(printed("Cook-Torrance")->instructions - (studies::paper2::total(full) - heavy)) /
               heavy;
        const int left = modified.divisions + modified.calls;
        of_modified = studies::paper2::total(modified) - left + each * left;
    }

    Operations full, modified;
    double each = 0.0, of_modified = 0.0;

    double counted_ratio() const {
        return static_cast<double>(studies::paper2::total(full)) / studies::paper2::total(modified);
    }
    double ratio() const { return printed("Cook-Torrance")->instructions / of_modified; }
};

double printed_ratio() {
    return static_cast<double>(printed("Cook-Torrance")->instructions) / studies::paper2::printed_modified_instructions;
}

bool near(double ratio, double wanted) { return std::abs(ratio / wanted - 1.0) <= studies::paper::tolerance; }

Verdict instructions(const Paper2Data& data) {
    const Expanded e(data);
    Verdict out{"Fewer instructions",
                fmt::format("{} to about {}", printed("Cook-Torrance")->instructions,
                            studies::paper2::printed_modified_instructions),
                fmt::format("{} to {} operations", studies::paper2::total(e.full), studies::paper2::total(e.modified)),
                "True."};
    if (e.counted_ratio() <= 1.0) {
        out.verdict = "Not true.";
    } else if (!near(e.counted_ratio(), printed_ratio())) {
        out.verdict = fmt::format(
            "True that there are fewer: {:.2f} times, not {:.2f}. The full form has the printed number where each "
            "division and each call is {:.1f} instructions; the modified one then has {:.0f}. {}",
            e.counted_ratio(), printed_ratio(), e.each, e.of_modified,
            near(e.ratio(), printed_ratio()) ? "So the paper seems to have counted." : "The rest is not explained.");
    }
    return out;
}

Verdict speed(const Paper2Data& data) {
    const Expanded e(data);
    const double gap = printed_ratio() / studies::paper2::printed_speedup - 1.0;
    return {
        "77 % faster", fmt::format("{:.2f} times", studies::paper2::printed_speedup),
        fmt::format("{:.2f} times fewer operations", e.counted_ratio()),
        fmt::format("{} with the paper's own instructions, which fall {:.2f} times ({:+.0f}&nbsp;%). {}",
                    std::abs(gap) <= 0.1 ? "Agrees" : "Does not agree", printed_ratio(), 100.0 * gap,
                    e.ratio() >= studies::paper2::printed_speedup
                        ? "The operations of the formula account for it."
                        : fmt::format("The operations of the formula do not account for it, nor do they with {:.1f} "
                                      "instructions for each division and call: {:.2f} times.",
                                      e.each, e.ratio()))};
}

Verdict order(const Paper2Data& data) {
    const int right = studies::paper2::pairs_in_order(data.models);
    const auto rows = studies::paper2::table();
    std::string wrong;
    int pairs = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = i + 1; k < rows.size(); ++k, ++pairs) {
            const int a = studies::paper2::total(data.model(rows[i].model).operations);
            const int b = studies::paper2::total(data.model(rows[k].model).operations);
            if (a != b && (a < b) == (rows[i].instructions < rows[k].instructions)) continue;
            wrong += fmt::format(" {} ({} operations, {} instructions) and {} ({}, {}) stand the other way round.",
                                 rows[i].model, a, rows[i].instructions, rows[k].model, b, rows[k].instructions);
        }
    }
    std::vector<studies::paper2::TableRow> ordered(rows.begin(), rows.end());
    std::sort(ordered.begin(), ordered.end(),
              [](const auto& a, const auto& b) { return a.instructions < b.instructions; });
    std::string names;
    for (const auto& row : ordered) names += fmt::format("{}{}", names.empty() ? "" : " &lt; ", row.model);
    return {"Order of the five models", names, fmt::format("{} of {} pairs in this order", right, pairs),
            wrong.empty() ? "True." : "True but for one step." + wrong};
}

Verdict look(const Paper2Data& data) {
    const auto [least, most] = std::minmax_element(data.likeness.begin(), data.likeness.end(),
                                                   [](const auto& a, const auto& b) { return a.largest < b.largest; });
    const auto close =
        std::count_if(data.likeness.begin(), data.likeness.end(), [](const auto& l) { return l.largest <= alike; });
    double least_index = cook_torrance::greatest_index;
    for (const auto& l : data.likeness) {
        if (l.largest <= alike) least_index = std::min(least_index, l.index);
    }
    const auto text = [](const studies::paper2::Likeness& l) {
        return fmt::format("{} (m {:g}, index {:g}, light at {:.0f}°)", percent(l.largest, 1), l.m, l.index,
                           degrees * l.light);
    };
    const auto size = static_cast<std::ptrdiff_t>(data.likeness.size());
    return {"Almost identical look", "–", fmt::format("{} to {} of the peak", text(*least), text(*most)),
            fmt::format("{} The two are within {} of the peak in {} of the {} cases below{}. Where F changes with V.H, "
                        "the middle of the highlight is off at normal incidence, and the brightening at grazing angles "
                        "is lost.",
                        close == size ? "True."
                        : close == 0  ? "Not true."
                                      : "True in part.",
                        percent(alike), close, size,
                        close > 0 ? fmt::format(", all of an index of {:g} or more", least_index) : "")};
}

Verdict fall(const Paper2Data& data) {
    std::string measured;
    bool all = true;
    for (const auto& figure : data.reflectances) {
        measured += fmt::format("{}{:g}: {}", measured.empty() ? "" : ", ", figure.index, percent(figure.steep));
        all = all && figure.steep >= sharp;
    }
    return {"F changes sharply only for V.H below 0.4", "–", "of the whole fall, by index: " + measured,
            all ? fmt::format("True: {} of the fall or more lies there.", percent(sharp)) : "Not true of every index."};
}

Verdict constant(const Paper2Data& data) {
    std::string measured;
    std::size_t good = 0;
    for (const auto& figure : data.reflectances) {
        measured += fmt::format("{}{:g}: {}", measured.empty() ? "" : ", ", figure.index, percent(figure.largest));
        if (figure.largest <= 0.1) ++good;
    }
    const std::size_t size = data.reflectances.size();
    return {"A constant does for F from there on", "–", "largest difference from the mean, by index: " + measured,
            good == size ? "True."
            : good == 0  ? "Not true."
                         : fmt::format("True within 10&nbsp;% of {} of {} indices; a small index has a small F at "
                                        "normal incidence, and so a large change relative to it.",
                                       good, size)};
}

Verdict cubic(const Paper2Data& data) {
    std::string measured;
    std::size_t better = 0, ended = 0;
    for (const auto& figure : data.distributions) {
        const double whole =
            cook_torrance::fit_beckmann(figure.m, cook_torrance::Variable::angle, 0.5 * std::numbers::pi)
                .error()
                .largest;
        const double angle = figure.angle.error().largest, half = figure.half.error().largest;
        measured += fmt::format("{}m {:g}: {}, {}, {}", measured.empty() ? "" : "; ", figure.m, percent(whole, 1),
                                percent(angle, 1), percent(half, 1));
        if (angle <= 0.1) ++ended;
        if (half < angle) ++better;
    }
    const std::size_t size = data.distributions.size();
    return {"A cubic does for D", "in the angle",
            "largest difference, in the angle up to 90°, up to the best end, and in N.H: " + measured,
            fmt::format("{} within 10&nbsp;% for {} of {} roughnesses where the cubic ends with the highlight. In N.H, "
                        "which needs no arc cosine, it is closer for {} of them.",
                        ended == size ? "True:" : "True in part:", ended, size, better)};
}

std::string claims_table(const Paper2Data& data) {
    std::vector<std::vector<Cell>> rows;
    for (const Verdict& v :
         {instructions(data), speed(data), order(data), look(data), fall(data), constant(data), cubic(data)}) {
        rows.push_back({{"claim", v.claim, Cell::words},
                        {"printed", v.printed, Cell::words},
                        {"measured", v.measured, Cell::words},
                        {"verdict", v.verdict, Cell::words}});
    }
    return table_html(rows);
}

std::string operations_table(const Paper2Data& data) {
    std::vector<std::vector<Cell>> rows;
    for (const auto& counted : data.models) {
        const Operations& o = counted.operations;
        const auto* row = printed(counted.model);
        rows.push_back(
            {{"model", fmt::format("{}<small>{}</small>", counted.model, escaped(counted.form)), Cell::words},
             {"instructions, printed", row != nullptr ? fmt::format("{}", row->instructions) : "–"},
             {"pixels/s, printed", row != nullptr ? fmt::format("{:.0f}&nbsp;M", row->pixels_per_second / 1e6) : "–"},
             {"operations", fmt::format("{}", studies::paper2::total(o))},
             {"multiplications", fmt::format("{}", o.multiplications)},
             {"divisions", fmt::format("{}", o.divisions)},
             {"additions", fmt::format("{}", o.additions + o.increments)},
             {"comparisons", fmt::format("{}", o.comparisons)},
             {"calls", fmt::format("{}", o.calls)}});
    }
    return table_html(rows);
}

std::string likeness_table(const Paper2Data& data) {
    std::vector<std::vector<Cell>> rows;
    for (const auto& l : data.likeness) {
        rows.push_back({{"index", fmt::format("{:g}", l.index), Cell::name},
                        {"m", fmt::format("{:g}", l.m)},
                        {"light at", fmt::format("{:.0f}°", degrees * l.light)},
                        {"largest", percent(l.largest, 1)},
                        {"viewer at", fmt::format("{:.0f}°", degrees * l.largest_angle)},
                        {"RMS", percent(l.rms, 2)}});
    }
    return table_html(rows);
}

std::string figures(const Paper2Data& data, const Pictures& pictures, const std::string& command) {
    std::string out = "<h3>Figure 1: Beckmann's distribution and its cubics</h3>\n";
    out += figure_html(pictures, distribution_plot,
                       "m squared times Beckmann's distribution over the angle for three roughnesses, with a cubic in "
                       "the angle and one in N.H: close to it but for the largest roughness.",
                       "<p>The distribution over its value at the normal, with the cubics of "
                       "docs/effects/cook_torrance_modified.md.</p>" +
                           csv_note("paper-2-figure-1", command));
    out += "<h3>Figure 2: Fresnel's reflectance</h3>\n";
    out += figure_html(pictures, reflectance_plot,
                       "Fresnel's reflectance over V.H for several indices of refraction: it falls steeply up to 0.4 "
                       "and is nearly level from there, at its mean for large indices.",
                       "<p>By index of refraction; broken, the mean over V.H from 0.4 to 1, which stands for it in the "
                       "modified form.</p>" +
                           csv_note("paper-2-figure-2", command));
    const auto& h = data.highlight;
    out += "<h3>Phong and Blinn-Phong at one exponent</h3>\n";
    out += figure_html(
        pictures, highlight_plot,
        "Phong's highlight over the angle of viewer and mirrored light; that of Blinn-Phong with the same exponent is "
        "twice as wide, with four times the exponent it lies on Phong's.",
        fmt::format("<p>In the plane of incidence N.H is the cosine of half the angle, so with the same n the "
                    "highlight of Blinn-Phong is twice as wide: at n = {:g} it is 1/2 at {:.2f}°, Phong's at {:.2f}°. "
                    "With 4 n they differ by {:.5f} at most; equally wide they are with {:.3f} n.</p>",
                    h.n, degrees * h.blinn_phong_width, degrees * h.phong_width, h.largest, h.equal_width / h.n) +
            csv_note("paper-2-phong", command));
    return out;
}

}  // namespace

std::string paper2_section(const Paper2Data& data, const std::optional<CpuPrices>& prices, const Pictures& pictures,
                           const std::string& command) {
    std::string out =
        "<h2 id=\"paper-2\">Paper 2</h2>\n<p>Khlebnikov, Yurov 2010: five lighting models as shaders, and a "
        "Cook-Torrance that is faster by a cubic for the distribution D of the microfacets and a constant for the "
        "reflectance F. Its times are of a graphics processor of its day and cannot be measured again; what they rest "
        "on can be counted and computed, and is, in double. What the models cost on a processor of today is measured "
        "below.</p>\n";
    out += claims_table(data);
    out +=
        "<h3>Operations</h3>\n<p>Counted in the formulas as code, from unit vectors to the intensity in one channel; "
        "a call of exp, pow, acos or a root is one. What depends on the material alone is at hand.</p>\n";
    out += operations_table(data) + models_on_processor(data, prices) + figures(data, pictures, command);
    out +=
        "<h3>How far the modified form is from the full one</h3>\n<p>Over viewers in the plane of incidence, as a "
        "part of the full form's greatest value; the cubic is that in N.H.</p>\n";
    return out + likeness_table(data) + fmt::format("<p>Computed by {}</p>\n", command_html(command));
}

}  // namespace glint::cli
