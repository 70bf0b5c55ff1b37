#include "cost/choice.hpp"

#include "catch.hpp"
#include "glint/error.hpp"

using namespace glint;
using namespace glint::cost;

namespace {

/// On one device, a result a clock at 100 MHz.
Configuration made(std::string lobe, double error, int luts, int latency = 10) {
    Configuration out;
    out.lobe = std::move(lobe);
    out.profile = "p12";
    out.device = "hx8k";
    out.output_bits = 12;
    out.error = error;
    out.luts = luts;
    out.clock_mhz = 100.0;
    out.latency = latency;
    return out;
}

}  // namespace

TEST_CASE("choice: what a configuration's clock makes of clocks") {
    Configuration c = made("a", 0.1, 100, 25);
    c.interval = 5;
    CHECK(value(c, Metric::latency) == 250.0);
    CHECK(value(c, Metric::ns) == 50.0);
    CHECK(value(c, Metric::throughput) == 20e6);
    // Run more slowly than it could be: the time is that of the clock asked for, the clock that it reaches stays.
    c.asked_mhz = 50.0;
    CHECK(value(c, Metric::latency) == 500.0);
    CHECK(value(c, Metric::throughput) == 10e6);
    CHECK(value(c, Metric::clock) == 100.0);
    // A clock that it does not reach does not make it faster.
    c.asked_mhz = 200.0;
    CHECK(value(c, Metric::latency) == 250.0);
    c.clock_mhz.reset();
    for (const Metric metric : {Metric::clock, Metric::latency, Metric::ns, Metric::throughput}) {
        CHECK_FALSE(value(c, metric).has_value());
        CHECK(better(metric, made("b", 1, 1), c));
        CHECK_FALSE(better(metric, c, made("b", 1, 1)));
        CHECK_FALSE(better(metric, c, c));
    }
}

TEST_CASE("choice: every metric has a name that finds it") {
    REQUIRE(metrics().size() == 12);
    for (const MetricInfo& entry : metrics()) {
        CHECK(find_metric(entry.name).metric == entry.metric);
        CHECK(info(entry.metric).name == entry.name);
        CHECK(value(made("a", 0.1, 1), entry.metric).has_value());
    }
    CHECK_THROWS_AS(find_metric("price"), Error);
    CHECK_THROWS_AS(find_metric(""), Error);
}

TEST_CASE("choice: dominated") {
    const Metric axes[] = {Metric::error, Metric::luts};
    // b is worse than a on both, c trades, d equals a, e is as good as c on one axis and worse on the other.
    std::vector<Configuration> all{made("a", 0.10, 100), made("b", 0.20, 150), made("c", 0.05, 300),
                                   made("d", 0.10, 100), made("e", 0.05, 301)};
    CHECK(dominated(all, axes) == std::vector{false, true, false, false, true});
    // Another device has LUTs of its own.
    all[1].device = "up5k";
    CHECK(dominated(all, axes) == std::vector{false, false, false, false, true});
    // More of a clock is better.
    const Metric clocked[] = {Metric::luts, Metric::clock};
    all[3].clock_mhz = 120.0;
    CHECK(dominated(all, clocked) == std::vector{true, false, true, false, true});
    CHECK(dominated({}, axes).empty());
}

TEST_CASE("choice: the best under constraints") {
    const std::vector<Configuration> all{made("coarse", 0.03, 100), made("good", 0.004, 300), made("fine", 0.0002, 400),
                                         made("worse", 0.004, 350), made("quick", 0.004, 500, 4)};
    const Constraint accurate[] = {{Metric::error, 0.005}};
    Choice choice = choose(all, accurate, Metric::luts);
    CHECK(choice.feasible == std::vector<std::size_t>{1, 3, 2, 4});
    // `worse` gives up LUTs and wins nothing.
    CHECK(choice.worthwhile == std::vector<std::size_t>{1, 2, 4});
    CHECK(choice.relaxations.empty());

    CHECK(choose(all, accurate, Metric::error).feasible.front() == 2);
    CHECK(choose(all, accurate, Metric::latency).feasible.front() == 4);
    CHECK(choose(all, {}, Metric::luts).feasible.front() == 0);

    // A bound is met by its own value, from either side.
    const Constraint exact[] = {{Metric::error, 0.004}, {Metric::clock, 100.0}, {Metric::luts, 300.0}};
    CHECK(choose(all, exact, Metric::luts).feasible == std::vector<std::size_t>{1});
}

TEST_CASE("choice: ties are broken by the other axes, then by name") {
    std::vector<Configuration> all{made("c", 0.2, 100), made("b", 0.1, 100), made("a", 0.1, 100)};
    CHECK(choose(all, {}, Metric::luts).feasible == std::vector<std::size_t>{2, 1, 0});
    // Equal ones do not dominate each other.
    CHECK(choose(all, {}, Metric::luts).worthwhile == std::vector<std::size_t>{2, 1});
    // The best is worthwhile even where the metric is no common axis.
    all[0].registers = 5;
    all[1].registers = all[2].registers = 6;
    CHECK(choose(all, {}, Metric::registers).worthwhile == std::vector<std::size_t>{0, 2, 1});
}

TEST_CASE("choice: which constraint to relax when none will do") {
    const std::vector<Configuration> all{made("coarse", 0.03, 100), made("good", 0.004, 300),
                                         made("fine", 0.0002, 400)};
    const Constraint both[] = {{Metric::error, 0.001}, {Metric::luts, 350}};
    const Choice choice = choose(all, both, Metric::luts);
    CHECK(choice.feasible.empty());
    CHECK(choice.worthwhile.empty());
    REQUIRE(choice.relaxations.size() == 2);
    // The nearest, not just any: `good`, not `coarse`.
    CHECK(choice.relaxations[0].constraint == 0);
    CHECK(choice.relaxations[0].configuration == 1);
    CHECK(choice.relaxations[0].bound == 0.004);
    CHECK(choice.relaxations[1].constraint == 1);
    CHECK(choice.relaxations[1].configuration == 2);
    CHECK(choice.relaxations[1].bound == 400.0);

    // A clock that nothing reaches is the only one whose step back helps: the error alone would not.
    const Constraint fast[] = {{Metric::error, 0.001}, {Metric::clock, 150.0}};
    const Choice slow = choose(all, fast, Metric::luts);
    REQUIRE(slow.relaxations.size() == 1);
    CHECK(slow.relaxations[0].constraint == 1);
    CHECK(slow.relaxations[0].bound == 100.0);

    // Two that stand in the way together: no single one helps.
    const Constraint hopeless[] = {{Metric::error, 1e-9}, {Metric::clock, 150.0}};
    CHECK(choose(all, hopeless, Metric::luts).relaxations.empty());

    // What is not known does not open a solution.
    std::vector<Configuration> unplaced = all;
    for (Configuration& c : unplaced) c.clock_mhz.reset();
    const Constraint clock[] = {{Metric::clock, 1.0}};
    CHECK(choose(unplaced, clock, Metric::luts).relaxations.empty());
    CHECK(choose({}, both, Metric::luts).relaxations.empty());
}
