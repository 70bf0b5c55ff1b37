#include "studies/paper.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "glint/lobes.hpp"

using namespace glint;
using namespace glint::studies;

TEST_CASE("paper: the cycles of Table 1 are those of one set of latencies, and no other up to 30") {
    const auto found = studies::paper::latencies_of_table_1(30);
    REQUIRE(found.size() == 1);
    CHECK(found[0] == Operations::Latencies{3, 10, 1, 1, 1});
}

TEST_CASE("paper: the claims against the studies") {
    const auto study_of = [](std::string_view lobe) { return study(find_lobe(lobe)); };
    const Study schlick = study_of("schlick");
    const Study bps = study_of("bps");
    const Study quadratic = study_of("quadratic");
    std::size_t checked = 0;
    for (const studies::paper::Claim& claim : studies::paper::claims()) {
        if (claim.lobe == "schlick") {
            // The zone's edge tends to e^(1/2) / 1.5 - 1; a step of 0.001 rad beyond it makes 11 % of that.
            const auto c = studies::paper::check(claim, schlick);
            CHECK(std::abs(c.measured - (std::exp(0.5) / 1.5 - 1.0)) < 1e-5);
            CHECK(c.explanation == studies::paper::Check::stepped);
            CHECK(std::abs(c.explained - 0.1109) < 1e-4);
            CHECK(c.n_count == 993);
            CHECK(c.n_rounding == 0);
            ++checked;
        }
        if (claim.lobe == "quadratic") {
            const auto c = studies::paper::check(claim, quadratic);
            CHECK(std::abs(c.measured - 0.0523) < 1e-4);
            CHECK(std::abs(c.difference - c.measured / 0.03 + 1.0) < 1e-12);
            CHECK(c.explanation == studies::paper::Check::most_exponents);
            CHECK(c.n_rounding > 900);
            ++checked;
        }
        if (claim.lobe == "bps" && claim.measure == studies::paper::Measure::absolute) {
            const auto c = studies::paper::check(claim, bps);
            CHECK(c.explanation == studies::paper::Check::agrees);
            CHECK(c.measured == bps.absolute(8, 1000).median);
            ++checked;
        }
    }
    CHECK(checked == 3);
}

TEST_CASE("paper: a claim that nothing explains is said to be so") {
    Study flat{"bps", {}};
    for (int n = 1; n <= 1000; ++n) flat.rows.push_back({n, {0.02, 0.1}, {0.03, 0.1}, {0.5, 0.1}});
    const studies::paper::Claim claim{
        "bps", studies::paper::Measure::delta, studies::paper::Statistic::largest, 0.011, 0.0005, ""};
    const auto c = studies::paper::check(claim, flat);
    CHECK(c.explanation == studies::paper::Check::none);
    CHECK(c.n_rounding == 0);
    CHECK(c.n_count == 993);
}

TEST_CASE("paper: how often a lobe is the best") {
    Study a{"a", {}};
    Study b{"b", {}};
    for (int n = 1; n <= 1000; ++n) {
        a.rows.push_back({n, {0.1, 0}, {}, {n <= 10 ? 0.3 : 0.1, 0}});
        b.rows.push_back({n, {0.2, 0}, {}, {0.2, 0}});
    }
    const std::vector<Study> both{a, b};
    CHECK(studies::paper::times_best(both, 0, studies::paper::Measure::delta) == 993);
    CHECK(studies::paper::times_best(both, 1, studies::paper::Measure::delta) == 0);
    CHECK(studies::paper::times_best(both, 0, studies::paper::Measure::absolute) == 990);
    CHECK(studies::paper::times_best(both, 1, studies::paper::Measure::absolute) == 3);
}
