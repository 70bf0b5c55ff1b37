#include "cli/report/report_paper2_cpu_page.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/report/report_cpu_page.hpp"
#include "cli/report/report_html.hpp"

namespace glint::cli {
namespace {

constexpr std::string_view types[] = {"double", "float"};
constexpr std::string_view base = "Lambert", full = "Cook-Torrance";
constexpr std::string_view modified[] = {"modified Cook-Torrance", "modified Cook-Torrance, N.H"};

/// How far from the printed ratio a measured one may be to count as the same.
constexpr double tolerance = 0.1;

struct Cost {
    std::string_view name;
    std::optional<double> (*of)(const CpuPrice&);
};
constexpr Cost throughput{"throughput", [](const CpuPrice& p) { return std::optional(p.throughput); }};
constexpr Cost latency{"latency", [](const CpuPrice& p) { return p.latency; }};
constexpr Cost instructions{"instructions", [](const CpuPrice& p) { return p.instructions; }};

/// The models' prices by the names that people read.
struct Models {
    const Paper2Data& data;
    const CpuPrices& prices;

    const CpuPrice& price(std::string_view model, std::string_view type) const {
        return *prices.find(data.model(model).name, type, "scalar");
    }
    std::optional<double> cost(const Cost& cost, std::string_view model, std::string_view type) const {
        return cost.of(price(model, type));
    }
    /// How many times as dear as `other`.
    std::optional<double> ratio(const Cost& what, std::string_view model, std::string_view other,
                                std::string_view type) const {
        const auto own = cost(what, model, type), of_other = cost(what, other, type);
        return own && of_other ? std::optional(*own / *of_other) : std::nullopt;
    }
};

std::string number(const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : "–";
}

const studies::paper2::TableRow* printed(std::string_view model) {
    const auto rows = studies::paper2::table();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.model == model; });
    return found == rows.end() ? nullptr : &*found;
}

// ---- claims ------------------------------------------------------------------------------------------------------

std::string_view variant(std::string_view model) {
    return model == modified[0] ? "Cubic of the angle" : "Cubic of N.H";
}

std::string_view verdict_of(const std::optional<double>& times, double claimed) {
    if (!times) return "not measured";
    if (*times <= 1.0) return "not true";
    if (*times < claimed * (1.0 - tolerance)) return "less than printed";
    return *times <= claimed * (1.0 + tolerance) ? "true" : "more than printed";
}

/// A cost of the full form over that of each modified one, and whether it bears out the printed ratio.
std::vector<Cell> gain(const Models& models, std::string_view claim, const std::string& printed_text, const Cost& cost,
                       double claimed) {
    std::string measured, verdict;
    for (const std::string_view model : modified) {
        std::string times_text, words;
        for (const std::string_view type : types) {
            const auto times = models.ratio(cost, full, model, type);
            const std::string_view separator = times_text.empty() ? "" : ", ";
            times_text += fmt::format("{}{} in {}", separator, number(times, 2), type);
            words += fmt::format("{}{} in {}", separator, verdict_of(times, claimed), type);
        }
        measured += fmt::format(" {}: {}.", variant(model), times_text);
        verdict += fmt::format("{}{}: {}.", verdict.empty() ? "" : " ", variant(model), words);
    }
    return {{"claim", std::string(claim), Cell::words},
            {"printed", printed_text, Cell::words},
            {"measured", "Full / modified." + measured, Cell::words},
            {"verdict", verdict, Cell::words}};
}

std::vector<Cell> order(const Models& models, const Cost& cost, std::string_view type) {
    std::vector<studies::paper2::TableRow> rows(studies::paper2::table().begin(), studies::paper2::table().end());
    const auto names = [&](const auto& less) {
        std::sort(rows.begin(), rows.end(), less);
        std::string out;
        for (const auto& row : rows) out += fmt::format("{}{}", out.empty() ? "" : " &lt; ", row.model);
        return out;
    };
    const auto value = [&](std::string_view model) { return models.cost(cost, model, type).value_or(0.0); };
    const std::string claimed = names([](const auto& a, const auto& b) { return a.instructions < b.instructions; });
    const std::string found = names([&](const auto& a, const auto& b) { return value(a.model) < value(b.model); });
    const bool measured = std::all_of(rows.begin(), rows.end(), [&](const auto& r) { return value(r.model) > 0.0; });
    const int right = studies::paper2::pairs_in_order(value);
    const int pairs = static_cast<int>(rows.size() * (rows.size() - 1) / 2);
    return {{"claim", fmt::format("Order of the five models: {}, {}", cost.name, type), Cell::words},
            {"printed", claimed, Cell::words},
            {"measured", measured ? found : "–", Cell::words},
            {"verdict",
             !measured        ? "Not measured."
             : right == pairs ? "True."
                              : fmt::format("Not the same: {} of {} pairs in the printed order.", right, pairs),
             Cell::words}};
}

std::string claims(const Models& models) {
    std::vector<std::vector<Cell>> rows;
    const double speed = studies::paper2::printed_speedup;
    const int printed_full = printed(full)->instructions;
    rows.push_back(gain(models, "77 % faster: throughput", fmt::format("{:.2f} times", speed), throughput, speed));
    rows.push_back(gain(models, "77 % faster: latency", fmt::format("{:.2f} times", speed), latency, speed));
    const double fewer = static_cast<double>(printed_full) / studies::paper2::printed_modified_instructions;
    rows.push_back(gain(models, "Fewer machine instructions",
                        fmt::format("{} to about {}, {:.2f} times", printed_full,
                                    studies::paper2::printed_modified_instructions, fewer),
                        instructions, fewer));
    for (const Cost& cost : {throughput, instructions}) {
        for (const std::string_view type : types) rows.push_back(order(models, cost, type));
    }
    return table_html(rows);
}

// ---- the models --------------------------------------------------------------------------------------------------

/// Of the full form's instructions and of its time, as the paper has them.
std::pair<std::optional<double>, std::optional<double>> printed_ratios(std::string_view model) {
    const auto* of_full = printed(full);
    const auto* row = printed(model);
    if (model == modified[0]) {
        return {static_cast<double>(studies::paper2::printed_modified_instructions) / of_full->instructions,
                1.0 / studies::paper2::printed_speedup};
    }
    if (row == nullptr) return {};
    return {static_cast<double>(row->instructions) / of_full->instructions,
            of_full->pixels_per_second / row->pixels_per_second};
}

std::string models_table(const Models& models, std::string_view type) {
    std::vector<std::vector<Cell>> rows;
    for (const auto& counted : models.data.models) {
        const auto& price = models.price(counted.model, type);
        const auto [fewer, faster] = printed_ratios(counted.model);
        const auto ratio = [&](const Cost& cost, std::string_view other) {
            return number(models.ratio(cost, counted.model, other, type), 2);
        };
        rows.push_back(
            {{"model", fmt::format("{}<small>{}</small>", counted.model, escaped(counted.form)), Cell::words},
             {"printed: instructions / full", number(fewer, 2)},
             {"printed: time / full", number(faster, 2)},
             {"throughput, ns",
              fmt::format("{:.2f}<small>{:.2f} to {:.2f}</small>", price.throughput, price.q1, price.q3)},
             {"/ Lambert", ratio(throughput, base)},
             {"/ full", ratio(throughput, full)},
             {"latency, ns", number(price.latency, 1)},
             {"latency / full", ratio(latency, full)},
             {"instructions", number(price.instructions, 0)},
             {"instructions / Lambert", ratio(instructions, base)},
             {"instructions / full", ratio(instructions, full)}});
    }
    return table_html(rows);
}

}  // namespace

std::string models_on_processor(const Paper2Data& data, const std::optional<CpuPrices>& prices) {
    std::string out = "<h3>Lighting models on a processor</h3>\n";
    if (!prices) return out + missing_cpu_prices("glint-bench-models", "cpu-models");
    const Models models{data, *prices};
    out += fmt::format(
        "<p>The code whose operations are counted above, timed one pixel at a time: independent pixels (throughput), "
        "and each waiting for the one before (latency). Instructions are those of one pixel with its loop and with "
        "what it calls of the C library, counted by Valgrind; docs/cpu-cost.md has the conditions. The small numbers "
        "are quartiles. {} Flags: <code>{}</code>.</p>\n",
        measured_by(*prices), escaped(prices->flags));
    out += claims(models);
    out +=
        "<p>The cubic of the angle needs an arc cosine, which is a call of the C library as the exponential is that it "
        "replaces; a cubic of N.H needs neither. <em>Full</em> is Cook-Torrance.</p>\n";
    for (const std::string_view type : types) {
        out += fmt::format("<p>In {}:</p>\n", type) + models_table(models, type);
    }
    return out;
}

}  // namespace glint::cli
