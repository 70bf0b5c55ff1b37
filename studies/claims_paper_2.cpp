#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "studies/claims.hpp"

namespace glint::studies {
namespace {

using Json = nlohmann::ordered_json;

/// Where "almost identical" begins: the largest difference as a part of the highlight's greatest value.
constexpr double alike = 0.05;
/// Where "sharply" begins: so much of the fall in two fifths of the axis.
constexpr double sharp = 0.8;
/// So far from the real function a stand-in may be.
constexpr double close_enough = 0.1;

constexpr std::string_view full_form = "Cook-Torrance";
constexpr std::string_view modified_forms[] = {"modified Cook-Torrance", "modified Cook-Torrance, N.H"};

bool near(double ratio, double wanted) { return std::abs(ratio / wanted - 1.0) <= paper::tolerance; }

std::string_view part(std::size_t good, std::size_t all) {
    return good == all ? "true" : good > 0 ? "true in part" : "not true";
}

/// The printed instructions, from what the full form has: each division and each call as so many instructions that it
/// comes to what is printed, and every other operation as one.
struct Expanded {
    explicit Expanded(const Paper2Data& data) {
        const Operations& f = data.model(full_form).operations;
        const Operations& m = data.model(modified_forms[0]).operations;
        full = paper2::total(f);
        modified = paper2::total(m);
        each = static_cast<double>(printed_full - (full - heavy(f))) / heavy(f);
        of_modified = modified - heavy(m) + each * heavy(m);
    }
    static int heavy(const Operations& o) { return o.divisions + o.calls; }

    int printed_full = paper2::printed(full_form)->instructions;
    int full = 0, modified = 0;
    double each = 0.0, of_modified = 0.0;

    double printed() const { return static_cast<double>(printed_full) / paper2::printed_modified_instructions; }
    double counted() const { return static_cast<double>(full) / modified; }
    double expanded() const { return printed_full / of_modified; }
    Json numbers() const {
        return {{"full", full},           {"modified", modified},
                {"counted", counted()},   {"printed", printed()},
                {"each", each},           {"of_modified", of_modified},
                {"expanded", expanded()}, {"gap", printed() / paper2::printed_speedup - 1.0}};
    }
};

Claim instructions(const Expanded& e) {
    Claim out{"instructions", "Fewer instructions", "", {}, {}, "times", 2, "", "", e.numbers()};
    out.printed =
        fmt::format("{} to about {}, {:.2f} times", e.printed_full, paper2::printed_modified_instructions, e.printed());
    out.measured = e.counted();
    out.verdict = near(e.counted(), e.printed()) ? "true" : e.counted() > 1.0 ? "true in part" : "not true";
    if (out.verdict == "true in part" && near(e.expanded(), e.printed())) out.reason = "expanded";
    return out;
}

Claim speed(const Expanded& e) {
    Claim out{"speed", "77 % faster", "", paper2::printed_speedup, e.counted(), "times", 2, "", "", e.numbers()};
    const bool own = std::abs(e.printed() / paper2::printed_speedup - 1.0) <= time_tolerance;
    if (e.expanded() >= paper2::printed_speedup) out.reason = "operations";
    out.verdict = part(own + (out.reason == "operations"), 2);
    return out;
}

/// Whether a cost orders the five models as their printed instructions do.
Claim order(std::string id, std::string says, const std::function<std::optional<double>(std::string_view)>& cost) {
    std::vector<paper2::TableRow> rows(paper2::table().begin(), paper2::table().end());
    std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.instructions < b.instructions; });
    const auto names = [&] {
        std::string out;
        for (const auto& row : rows) out += fmt::format("{}{}", out.empty() ? "" : " < ", row.model);
        return out;
    };
    Claim out;
    out.id = std::move(id);
    out.says = std::move(says);
    out.printed = names();
    out.verdict = "not measured";
    Json wrong = Json::array();
    int pairs = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = i + 1; k < rows.size(); ++k, ++pairs) {
            const auto a = cost(rows[i].model), b = cost(rows[k].model);
            if (!a || !b) return out;
            if (*a < *b) continue;
            wrong.push_back({{"a", rows[i].model},
                             {"cost_a", *a},
                             {"printed_a", rows[i].instructions},
                             {"b", rows[k].model},
                             {"cost_b", *b},
                             {"printed_b", rows[k].instructions}});
        }
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const auto& a, const auto& b) { return *cost(a.model) < *cost(b.model); });
    out.measured = names();
    out.verdict = wrong.empty()                                        ? "true"
                  : 2 * wrong.size() < static_cast<std::size_t>(pairs) ? "true in part"
                                                                       : "not true";
    out.numbers = {{"right", pairs - static_cast<int>(wrong.size())}, {"pairs", pairs}, {"wrong", std::move(wrong)}};
    return out;
}

Claim look(const Paper2Data& data) {
    const auto [least, most] = std::minmax_element(data.likeness.begin(), data.likeness.end(),
                                                   [](const auto& a, const auto& b) { return a.largest < b.largest; });
    std::size_t close = 0;
    double least_index = cook_torrance::greatest_index;
    for (const auto& l : data.likeness) {
        if (l.largest > alike) continue;
        ++close;
        least_index = std::min(least_index, l.index);
    }
    const auto at = [](const paper2::Likeness& l) {
        return Json{{"largest", l.largest}, {"m", l.m}, {"index", l.index}, {"light", l.light}};
    };
    Claim out{"look", "Almost identical look", "", {}, {}, "%", 1, "", "", {}};
    out.measured = most->largest;
    out.verdict = part(close, data.likeness.size());
    out.numbers = {{"least", at(*least)},        {"most", at(*most)}, {"close", close},
                   {"of", data.likeness.size()}, {"alike", alike},    {"least_index", least_index}};
    return out;
}

/// A value of each index, which is to be at least (or at most) `bound`; the measured one is the worst.
Claim by_index(const Paper2Data& data, std::string id, std::string says, double paper2::ReflectanceFigure::*value,
               double bound, bool at_least) {
    Claim out{std::move(id), std::move(says), "", {}, {}, "%", 0, "", "", {{"by_index", Json::array()}}};
    std::size_t good = 0;
    double worst = at_least ? HUGE_VAL : 0.0;
    for (const auto& figure : data.reflectances) {
        const double x = figure.*value;
        out.numbers["by_index"].push_back({{"index", figure.index}, {"value", x}});
        worst = at_least ? std::min(worst, x) : std::max(worst, x);
        good += at_least ? x >= bound : x <= bound;
    }
    out.measured = worst;
    out.verdict = part(good, data.reflectances.size());
    return out;
}

Claim cubic(const Paper2Data& data) {
    Claim out{"cubic", "A cubic does for D", "", "in the angle", {}, "%", 1, "", "", {}};
    Json by_m = Json::array();
    std::size_t good = 0;
    int closer = 0;
    double worst = 0.0;
    for (const auto& figure : data.distributions) {
        const auto angle_to_90 =
            cook_torrance::fit_beckmann(figure.m, cook_torrance::Variable::angle, 0.5 * std::numbers::pi);
        const double angle = figure.angle.error().largest, half = figure.half.error().largest;
        by_m.push_back({{"m", figure.m}, {"whole", angle_to_90.error().largest}, {"angle", angle}, {"half", half}});
        worst = std::max(worst, angle);
        good += angle <= close_enough;
        closer += half < angle;
    }
    out.measured = worst;
    out.verdict = part(good, data.distributions.size());
    out.numbers = {{"by_m", std::move(by_m)}, {"closer", closer}};
    return out;
}

/// A cost of the full form over that of a modified one, and whether it bears out the printed ratio.
Claim gain(const Paper2Data& data, const Costs& costs, Cost cost, double printed, std::string_view form,
           std::string_view type) {
    const auto full = costs(data.model(full_form).name, type, cost);
    const auto modified = costs(data.model(form).name, type, cost);
    Claim out;
    out.id = fmt::format("gain-{}-{}-{}", name_of(cost), data.model(form).name, type);
    out.says = fmt::format(
        "{}{}, the cubic of {}, {}", cost == Cost::instructions ? "Fewer machine instructions" : "77 % faster: ",
        cost == Cost::instructions ? "" : name_of(cost), form == modified_forms[0] ? "the angle" : "N.H", type);
    out.printed = std::round(100.0 * printed) / 100.0;
    out.unit = "times";
    out.digits = 2;
    out.verdict = "not measured";
    if (!full || !modified) return out;
    const double times = *full / *modified;
    out.measured = times;
    out.verdict = times <= 1.0                                ? "not true"
                  : times < printed * (1.0 - time_tolerance)  ? "less than printed"
                  : times <= printed * (1.0 + time_tolerance) ? "true"
                                                              : "more than printed";
    return out;
}

}  // namespace

std::vector<Claim> claims_of_paper_2(const Paper2Data& data) {
    const Expanded e(data);
    return {instructions(e),
            speed(e),
            order("order", "Order of the five models: operations",
                  [&](std::string_view model) -> std::optional<double> {
                      return paper2::total(data.model(model).operations);
                  }),
            look(data),
            by_index(data, "fall", "F changes sharply only for V.H below 0.4", &paper2::ReflectanceFigure::steep, sharp,
                     true),
            by_index(data, "constant", "A constant does for F from there on", &paper2::ReflectanceFigure::largest,
                     close_enough, false),
            cubic(data)};
}

std::vector<Claim> processor_claims_of_paper_2(const Paper2Data& data, const Costs& costs) {
    std::vector<Claim> out;
    for (const Cost cost : {Cost::throughput, Cost::latency, Cost::instructions}) {
        const double printed = cost == Cost::instructions ? Expanded(data).printed() : paper2::printed_speedup;
        for (const std::string_view form : modified_forms) {
            for (const std::string_view type : {"double", "float"}) {
                out.push_back(gain(data, costs, cost, printed, form, type));
            }
        }
    }
    for (const Cost cost : {Cost::throughput, Cost::instructions}) {
        for (const std::string_view type : {"double", "float"}) {
            out.push_back(order(fmt::format("order-{}-{}", name_of(cost), type),
                                fmt::format("Order of the five models: {}, {}", name_of(cost), type),
                                [&](std::string_view model) { return costs(data.model(model).name, type, cost); }));
        }
    }
    return out;
}

}  // namespace glint::studies
