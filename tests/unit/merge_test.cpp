#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "glint/lobes.hpp"
#include "io/process.hpp"
#include "io/quantity.hpp"
#include "io/results.hpp"
#include "io/shards.hpp"
#include "refusal.hpp"

// Results in parts: what merge_shards makes of them, and the line for people.
using namespace glint;
using namespace glint::io;

namespace {

struct ShardFiles {
    TemporaryFolder folder;
    std::vector<std::string> names;

    void add(const std::string& text) {
        names.push_back((folder.path() / fmt::format("{}.json", names.size() + 1)).string());
        std::ofstream(names.back()) << text;
    }
    void add(const std::vector<RunResult>& runs, Shard shard, const std::string& tool = "glint-cosim") {
        add(to_json(runs, tool, "command", shard).dump());
    }
    /// What is wrong with them; empty: nothing.
    std::string complaint() const {
        return refusal([&] { merge_shards(names); });
    }
};

/// Of hardware: every number of the k-th part is another.
RunResult hardware(std::uint64_t k) {
    RunResult out = run_result(*find_lobe("bps").golden(parse_profile("p8")), "core", "stream");
    out.key = "a key";
    out.architecture = "restoring";
    out.seconds = static_cast<double>(k) / 4;
    out.hardware = HardwareResult{k + 2, 100 * k, {20, 20, 1000 * k, 10 * k, 7 * k, 35 * k}, 0.25, 77};
    out.set_inputs(500 * k);
    return out;
}

/// Of a sweep over two exponents and some codes of the cosine.
RunResult swept(Range codes) {
    const auto model = find_lobe("bps").golden(parse_profile("p8"));
    RunResult out = run_result(*model, "model", "sweep");
    out.key = "a key";
    out.accuracy = sweep(*model, {2, 3, 1}, codes, 1);
    out.set_inputs(out.accuracy->total.inputs);
    return out;
}

std::vector<std::string> cells(const std::string& table, int line) {
    std::istringstream text(table);
    std::string row, word;
    for (int i = 0; i <= line; ++i) std::getline(text, row);
    std::istringstream words(row);
    std::vector<std::string> out;
    while (words >> word) out.push_back(word);
    return out;
}

}  // namespace

TEST_CASE("merge: counts are added, what describes the run stays") {
    ShardFiles files;
    for (std::uint64_t k : {1, 2, 3}) files.add({hardware(k)}, {k, 3});
    const Merged merged = merge_shards({files.names[2], files.names[0], files.names[1]});
    CHECK(merged.tool == "glint-cosim");
    REQUIRE(merged.runs.size() == 1);
    const RunResult& run = merged.runs[0];
    CHECK((run.lobe == "bps" && run.profile == "p8" && run.F == 16 && run.O == 8 && run.unit == "core"));
    CHECK((run.test == "stream" && run.architecture == "restoring" && run.key == "a key" && run.complaint.empty()));
    CHECK(run.inputs == 3000);
    CHECK(run.seconds == 1.5);
    REQUIRE(run.hardware.has_value());
    CHECK(run.hardware->mismatches == 12);
    CHECK(run.hardware->cycles == 600);
    CHECK(run.hardware->stall_probability == 0.25);
    CHECK(run.hardware->seed == 77);
    const Timing& timing = run.hardware->timing;
    CHECK((timing.least_latency == 20 && timing.most_latency == 20));
    CHECK((timing.span == 6000 && timing.span_results == 60));
    CHECK((timing.intervals == 42 && timing.interval_clocks == 210));
    CHECK(timing.results_per_cycle() == 0.01);
    CHECK(timing.interval_cycles() == 5.0);

    const auto json = to_json(merged.runs, "glint merge", "command")["runs"][0];
    CHECK((json["latency_cycles"] == 20 && json["interval_cycles"] == 5.0 && json["results_per_cycle"] == 0.01));
    CHECK((json["seed"] == 77 && json["mismatches"] == 12 && json["vectors_per_second"] == 2000.0));
    CHECK_FALSE(json.contains("part"));
}

TEST_CASE("merge: what was not measured is 0, latencies that differ are a complaint, another complaint stays") {
    ShardFiles files;
    RunResult first = hardware(1), second = hardware(2);
    first.hardware->timing = second.hardware->timing = {};
    first.hardware->mismatches = first.hardware->cycles = second.hardware->mismatches = second.hardware->cycles = 0;
    files.add({first, hardware(1), hardware(1)}, {1, 2});
    RunResult slow = hardware(2), wrong = hardware(2);
    slow.hardware->timing.most_latency = slow.hardware->timing.least_latency = 21;
    wrong.hardware->timing = slow.hardware->timing;
    wrong.complaint = "wrong";
    files.add({second, slow, wrong}, {2, 2});
    const std::vector<RunResult> runs = merge_shards(files.names).runs;
    REQUIRE(runs.size() == 3);
    CHECK((runs[0].hardware->mismatches == 0 && runs[0].hardware->cycles == 0));
    CHECK((runs[0].hardware->timing.most_latency == 0 && runs[0].hardware->timing.intervals == 0));
    CHECK(runs[0].hardware->timing.interval_cycles() == 0.0);
    CHECK(runs[0].complaint.empty());
    CHECK(runs[1].complaint == "latency varies without stalls: 20 to 21 clocks\n");
    CHECK(runs[2].complaint == "wrong");
    // A part with stalls, that measured nothing, does not make the least latency 0.
    Timing timing = hardware(1).hardware->timing;
    timing.merge({});
    CHECK((timing.least_latency == 20 && timing.most_latency == 20));
}

TEST_CASE("merge: a sweep in parts is the sweep in one piece") {
    ShardFiles files;
    const RunResult first = swept({0, 20000, 1}), second = swept({20001, 65536, 1});
    files.add({first}, {1, 2});
    files.add({second}, {2, 2});
    const RunResult whole = swept({0, 65536, 1});
    const Merged merged = merge_shards(files.names);
    CHECK(to_json(merged.runs, "", "").dump() == to_json({whole}, "", "").dump());
    REQUIRE(merged.runs[0].accuracy->rows.size() == 2);
    const Accuracy& row = merged.runs[0].accuracy->rows[0].accuracy;
    CHECK(row.inputs == 65537);
    CHECK(row.rounding_rms() == whole.accuracy->rows[0].accuracy.rounding_rms());
    CHECK_FALSE(whole.exhaustive);
}

TEST_CASE("merge: parts that are missing, twice there, empty or of another run are refused") {
    const auto refused = [](const std::vector<std::vector<RunResult>>& parts, const std::vector<Shard>& shards,
                            const std::string& says) {
        ShardFiles files;
        for (std::size_t i = 0; i < parts.size(); ++i) files.add(parts[i], shards[i]);
        INFO(files.complaint());
        CHECK(files.complaint().find(says) != std::string::npos);
    };
    const RunResult run = hardware(1);
    refused({{run}, {run}}, {{1, 4}, {3, 4}}, "2 of 4 shards are missing: 2, 4");
    refused({{run}}, {{1, 12}}, "11 of 12 shards are missing: 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, ...");
    refused({{run}, {run}}, {{1, 2}, {1, 2}}, "shard 1/2 is there twice");
    refused({{run}, {run}}, {{1, 2}, {2, 3}}, "is foreign: it is of '3 shards'");
    refused({{run}, {run, run}}, {{1, 2}, {2, 2}}, "is foreign: it is of '2 runs'");
    RunResult other = run;
    other.key = "another key";
    refused({{run}, {other}}, {{1, 2}, {2, 2}}, "is foreign: it is of 'another key'");
    refused({std::vector<RunResult>{}}, {{1, 2}}, "holds no runs");
    RunResult rows = swept({0, 10, 1}), more = rows;
    more.accuracy->rows.push_back(more.accuracy->rows[0]);
    refused({{rows}, {more}}, {{1, 2}, {2, 2}}, "its rows are not those of");
    refused({{rows}, {run}}, {{1, 2}, {2, 2}}, "its rows are not those of");
    ShardFiles whole;
    whole.add({run}, {1, 1});
    CHECK(whole.complaint().find("is no shard") != std::string::npos);
    ShardFiles tools;
    tools.add({run}, {1, 2});
    tools.add({run}, {2, 2}, "glint sweep");
    CHECK(tools.complaint().find("is foreign: it is of 'glint sweep', but") != std::string::npos);
}

TEST_CASE("shards: a run that is there is skipped, any other is not") {
    CLI::App app;
    std::string json;
    ShardOptions options;
    options.add(app, app.add_option("--json", json));
    app.parse("--json file --shard 2/3 --resume");
    ShardFiles files;
    const auto there = [&](const std::vector<RunResult>& runs, Shard shard, const std::string& tool = "glint-cosim") {
        files.add(runs, shard, tool);
        return options.there(files.names.back(), "glint-cosim", {"a key", "a key"});
    };
    const RunResult run = hardware(1);
    RunResult other = run, wrong = run;
    other.key = "another";
    wrong.complaint = "wrong";
    CHECK(there({run, run}, {2, 3}));
    CHECK_FALSE(there({run, run}, {1, 3}));
    CHECK_FALSE(there({run, run}, {2, 4}));
    CHECK_FALSE(there({run, run}, {2, 3}, "glint sweep"));
    CHECK_FALSE(there({run}, {2, 3}));
    CHECK_FALSE(there({run, run, run}, {2, 3}));
    CHECK_FALSE(there({run, other}, {2, 3}));
    CHECK_FALSE(there({run, wrong}, {2, 3}));
    CHECK_FALSE(options.there("/no/such/file", "glint-cosim", {"a key", "a key"}));
    files.add("no JSON");
    CHECK_FALSE(options.there(files.names.back(), "glint-cosim", {"a key", "a key"}));
}

TEST_CASE("results: the table has a dash for what was not measured") {
    const RunResult fast = hardware(1);  // 500 inputs in a quarter of a second
    RunResult stalled = hardware(2), at_once = hardware(1);
    stalled.hardware->timing = {};
    at_once.seconds = 0.0;
    at_once.hardware->timing.intervals = 0;
    const std::string table = results_table({fast, stalled, at_once}, true);
    CHECK(cells(table, 0) == std::vector<std::string>{"lobe", "profile", "unit", "architecture", "test", "inputs",
                                                      "mismatches", "latency", "interval", "M/s"});
    CHECK(cells(table, 1) ==
          std::vector<std::string>{"bps", "p8", "core", "restoring", "stream", "500", "3", "20", "5", "0.0"});
    CHECK(cells(table, 2) ==
          std::vector<std::string>{"bps", "p8", "core", "restoring", "stream", "1", "000", "4", "-", "-", "0.0"});
    CHECK(cells(table, 3) ==
          std::vector<std::string>{"bps", "p8", "core", "restoring", "stream", "500", "3", "20", "-", "0.0"});

    RunResult accurate = swept({0, 10, 1});
    accurate.seconds = 1e-6;
    accurate.accuracy->total = {};
    accurate.accuracy->total.rounding = {0.5, 2, 1};
    accurate.accuracy->total.approximation = {0.25, 7, 32768};
    accurate.accuracy->total.approximation_exact = {0.375, 7, 32768};
    accurate.accuracy->total.epicentre = {0.125, 3, 65536};
    const std::string sweeps = results_table({accurate, fast}, false);
    CHECK(cells(sweeps, 1) == std::vector<std::string>{"bps", "p8", "22", "0.5000", "0.25000", "n=7", "c=0.50000",
                                                       "0.37500", "12.500", "%", "n=3", "c=1.00000", "22.0"});
    CHECK(cells(sweeps, 2) == std::vector<std::string>{"bps", "p8", "500", "-", "-", "-", "-", "-", "-", "0.0"});
    CHECK(sweeps.find("epicentre:") != std::string::npos);
    CHECK(table.find("epicentre:") == std::string::npos);
    CHECK(grouped(999) == "999");
    CHECK(grouped(1234567) == "1 234 567");
}

TEST_CASE("quantities: a unit that is not known is refused, with or without a number before it") {
    const auto clock = [](const char* text) {
        return parse_quantity(text, "--clock", {{"MHz", 1e6}, {"GHz", 1e9}, {"kHz", 1e3}, {"Hz", 1.0}});
    };
    CHECK(clock("48") == 48.0);
    CHECK(clock("48MHz") == 48.0);
    CHECK(clock("2GHz") == 2000.0);
    CHECK(clock("500kHz") == 0.5);
    CHECK(clock("1e6Hz") == 1.0);
    for (const char* wrong : {"MHz", "5 parsec", "5m", "0", "-1", "", "nan", "1e999"}) {
        INFO(wrong);
        CHECK_THROWS_AS(clock(wrong), Error);
    }
    CHECK(parse_quantity("0", "--x", {}, true) == 0.0);
}
