#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "studies/claims.hpp"

namespace glint::studies {
namespace {

using paper::first_n;
using paper::last_n;
using paper::Measure;

Summary summary(const Study& study, Measure measure) {
    return measure == Measure::delta ? study.delta(first_n, last_n) : study.absolute(first_n, last_n);
}

std::string_view symbol(Measure measure) { return measure == Measure::delta ? "δ" : "Δ"; }

std::string_view id(Measure measure) { return measure == Measure::delta ? "delta" : "absolute"; }

bool same(double measured, double printed, double tolerance) { return std::abs(measured / printed - 1.0) <= tolerance; }

Claim error_claim(const paper::Claim& claim, const Study& study) {
    const paper::Check check = paper::check(claim, study);
    const bool delta = claim.measure == Measure::delta;
    const bool largest = claim.statistic == paper::Statistic::largest;
    Claim out;
    out.id = fmt::format("{}-{}-{}", id(claim.measure), claim.lobe, largest ? "largest" : "median");
    out.says = fmt::format("{} {} of {}", largest ? "Largest" : "Median", symbol(claim.measure), claim.lobe);
    out.source = claim.source;
    out.printed = claim.printed;
    out.measured = check.measured;
    out.unit = delta ? "%" : "";
    out.digits = delta ? 3 : 5;
    out.numbers = {{"lobe", claim.lobe}, {"rounding", check.n_rounding}, {"of", check.n_count}};
    const auto explained = [&](std::string_view reason, int n) {
        out.verdict = "true in part";
        out.reason = reason;
        out.numbers.update({{"explained", check.explained}, {"difference", check.explained_difference}, {"n", n}});
    };
    switch (check.explanation) {
        case paper::Check::agrees:
            out.verdict = "true";
            break;
        case paper::Check::stepped: {
            const int n = summary(study, claim.measure).n;
            const int at = study.delta_stepped(first_n, last_n).n;
            const auto row = [&](int k) { return study.rows[static_cast<std::size_t>(k - 1)]; };
            explained("stepped", at);
            out.numbers["at_edge"] = row(n).delta.theta >= epicentre_angle(n);
            out.numbers["beyond"] = row(at).delta_stepped.theta / epicentre_angle(at) - 1.0;
            break;
        }
        case paper::Check::most_exponents:
            explained("median", summary(study, claim.measure).n);
            break;
        case paper::Check::none:
            out.verdict = "not true";
            break;
    }
    return out;
}

Claim least_of_five(const PaperData& data) {
    std::vector<Study> five;
    std::size_t bps = 0;
    for (std::size_t i = 0; i < data.of_paper; ++i) {
        if (data.lobes[i].lobe->name == "bps") bps = i;
        five.push_back(data.lobes[i].study);
    }
    const int count = last_n - first_n + 1;
    const int delta = paper::times_best(five, bps, Measure::delta);
    const int absolute = paper::times_best(five, bps, Measure::absolute);
    Claim out;
    out.id = "least";
    out.says = fmt::format("bps has the least errors of the five at most n of {} to {}", first_n, last_n);
    out.printed = "most";
    out.measured = fmt::format("{} of {}", std::min(delta, absolute), count);
    out.verdict = 2 * std::min(delta, absolute) > count ? "true" : "not true";
    out.numbers = {{"delta", delta}, {"absolute", absolute}, {"of", count}};
    return out;
}

Claim ten_times(const PaperData& data, Measure measure) {
    const Study& schlick = data.lobe("schlick").study;
    const Summary s = summary(schlick, measure);
    const Summary b = summary(data.lobe("bps").study, measure);
    Claim out;
    out.id = fmt::format("ten-times-{}", id(measure));
    out.says = fmt::format("bps is ten times better than schlick in {}", symbol(measure));
    out.printed = paper::printed_ratio;
    out.measured = s.median / b.median;
    out.unit = "times";
    out.digits = 2;
    out.verdict = same(s.median / b.median, paper::printed_ratio, paper::tolerance) ? "true" : "not true";
    out.numbers = {{"largest", s.largest / b.largest}, {"n", b.n}};
    const double stepped = schlick.delta_stepped(first_n, last_n).largest / b.median;
    if (measure == Measure::delta && out.verdict != "true" && same(stepped, paper::printed_ratio, paper::tolerance)) {
        out.verdict = "true in part";
        out.reason = "stepped";
        out.numbers["stepped"] = stepped;
    }
    return out;
}

Claim time_claim(const Costs& costs, Cost cost) {
    const auto printed = [](std::string_view lobe) {
        const auto rows = paper::table_1();
        return std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.lobe == lobe; })->cycles;
    };
    const auto bps = costs("bps", "double", cost);
    const auto schlick = costs("schlick", "double", cost);
    Claim out;
    out.id = fmt::format("time-{}", name_of(cost));
    out.says = fmt::format("bps costs {} cycles, schlick {}: {}", printed("bps"), printed("schlick"), name_of(cost));
    out.source = "Table 1";
    const double ratio = static_cast<double>(printed("bps")) / printed("schlick");
    out.printed = std::round(100.0 * ratio) / 100.0;
    out.unit = "times";
    out.digits = 2;
    out.verdict = "not measured";
    if (bps && schlick) {
        out.measured = *bps / *schlick;
        out.verdict = same(*bps / *schlick, ratio, time_tolerance) ? "true" : "not true";
    }
    return out;
}

}  // namespace

std::vector<Claim> claims_of_paper_1(const PaperData& data, const Costs& costs) {
    std::vector<Claim> out;
    for (const paper::Claim& claim : paper::claims()) out.push_back(error_claim(claim, data.lobe(claim.lobe).study));
    out.push_back(least_of_five(data));
    for (const Measure measure : {Measure::delta, Measure::absolute}) out.push_back(ten_times(data, measure));
    for (const Cost cost : {Cost::latency, Cost::throughput, Cost::instructions, Cost::batch}) {
        out.push_back(time_claim(costs, cost));
    }
    return out;
}

}  // namespace glint::studies
