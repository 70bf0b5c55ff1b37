#include "studies/paper.hpp"

#include <algorithm>
#include <cmath>

namespace glint::studies::paper {
namespace {

double value(const StudyRow& row, Measure measure) {
    return measure == Measure::delta ? row.delta.value : row.absolute.value;
}

double relative(double measured, double printed) { return measured / printed - 1.0; }

}  // namespace

std::span<const TableRow> table_1() {
    static const std::vector<TableRow> rows{
        {"f_s", "schlick", {1, 1, 2, 0, 0}, 15},    {"f_8", "cosine_power", {4, 1, 0, 2, 0}, 24},
        {"f_kv", "quadratic", {4, 0, 2, 0, 1}, 15}, {"f_kub", "cubic", {5, 1, 2, 0, 0}, 27},
        {"f_bps", "bps", {4, 1, 4, 1, 1}, 28},
    };
    return rows;
}

std::vector<Operations::Latencies> latencies_of_table_1(int most) {
    std::vector<Operations::Latencies> out;
    const auto rows = table_1();
    Operations::Latencies l{};
    for (l.multiplication = 1; l.multiplication <= most; ++l.multiplication) {
        for (l.division = 1; l.division <= most; ++l.division) {
            for (l.addition = 1; l.addition <= most; ++l.addition) {
                for (l.increment = 1; l.increment <= most; ++l.increment) {
                    for (l.comparison = 1; l.comparison <= most; ++l.comparison) {
                        if (std::all_of(rows.begin(), rows.end(),
                                        [&](const TableRow& row) { return row.operations.cycles(l) == row.cycles; }))
                            out.push_back(l);
                    }
                }
            }
        }
    }
    return out;
}

std::span<const Claim> claims() {
    constexpr auto delta = Measure::delta;
    constexpr auto largest = Statistic::largest;
    static const std::vector<Claim> all{
        {"schlick", delta, largest, 0.11, 0.005, "Table 1"},
        {"cosine_power", delta, largest, 0.018, 0.0005, "Table 1"},
        {"quadratic", delta, largest, 0.03, 0.005, "Table 1"},
        {"cubic", delta, largest, 0.03, 0.005, "Table 1"},
        {"bps", delta, largest, 0.011, 0.0005, "Table 1"},
        {"bps", delta, Statistic::median, 0.0105, 0.00005, "at Fig. 5, for most n"},
        {"bps", Measure::absolute, Statistic::median, 0.02, 0.005, "at Fig. 7, for most n"},
    };
    return all;
}

Check check(const Claim& claim, const Study& study) {
    const Summary summary =
        claim.measure == Measure::delta ? study.delta(first_n, last_n) : study.absolute(first_n, last_n);
    Check out;
    out.measured = claim.statistic == Statistic::largest ? summary.largest : summary.median;
    out.difference = relative(out.measured, claim.printed);
    for (const StudyRow& row : study.rows) {
        if (row.n < first_n || row.n > last_n) continue;
        ++out.n_count;
        if (std::abs(value(row, claim.measure) - claim.printed) <= claim.half_digit) ++out.n_rounding;
    }
    const auto explain = [&](Check::Explanation explanation, double measured) {
        if (out.explanation != Check::none || std::abs(relative(measured, claim.printed)) > tolerance) return;
        out.explanation = explanation;
        out.explained = measured;
        out.explained_difference = relative(measured, claim.printed);
    };
    explain(Check::agrees, out.measured);
    if (claim.measure == Measure::delta) explain(Check::stepped, study.delta_stepped(first_n, last_n).largest);
    explain(Check::most_exponents, summary.median);
    return out;
}

int times_best(std::span<const Study> studies, std::size_t index, Measure measure) {
    int out = 0;
    for (std::size_t row = 0; row < studies[index].rows.size(); ++row) {
        const int n = studies[index].rows[row].n;
        if (n < first_n || n > last_n) continue;
        const double own = value(studies[index].rows[row], measure);
        if (std::all_of(studies.begin(), studies.end(),
                        [&](const Study& study) { return own <= value(study.rows[row], measure); }))
            ++out;
    }
    return out;
}

}  // namespace glint::studies::paper
