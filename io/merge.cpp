#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "io/json_node.hpp"
#include "io/shards.hpp"

namespace glint::io {
namespace {

struct ShardFile {
    std::string path, tool, version;
    Shard shard;
    std::vector<RunResult> runs;
};

Worst read_worst(const JsonNode& node, const char* name, const char* value) {
    if (!node.has(name)) return {};
    const JsonNode worst = node.node(name);
    return {worst.number(value), worst.integer("n", 1, max_n), worst.integer("cos_code", 0, 1 << 30)};
}

ExactSum read_sum(const JsonNode& node, const char* key) {
    ExactSum::Halves halves{};
    const auto list = node.counts(key, halves.size());
    std::copy(list.begin(), list.end(), halves.begin());
    return ExactSum::of(halves);
}

SweepResult read_accuracy(const JsonNode& run, const JsonNode& part) {
    SweepResult out;
    const auto rows = run.node("accuracy").nodes("rows");
    const auto squares = part.nodes("squares");
    if (squares.size() != rows.size()) part.fail("squares", "one of each row");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        AccuracyRow row{rows[i].integer("n", 1, max_n), {}};
        row.accuracy.inputs = rows[i].count("inputs", 1);
        row.accuracy.rounding = read_worst(rows[i], "rounding", "max_ulp");
        row.accuracy.rounding_squares = read_sum(squares[i], "rounding");
        row.accuracy.approximation = read_worst(rows[i], "approximation", "max");
        row.accuracy.approximation_squares = read_sum(squares[i], "approximation");
        row.accuracy.approximation_exact = read_worst(rows[i], "approximation_exact_cosine", "max");
        row.accuracy.epicentre = read_worst(rows[i], "epicentre", "max");
        out.total.merge(row.accuracy);
        out.rows.push_back(row);
    }
    return out;
}

RunResult read_run(const JsonNode& node) {
    const JsonNode part = node.node("part");
    RunResult run;
    run.key = part.text("key");
    run.complaint = part.text("complaint");
    run.lobe = node.word("lobe");
    run.profile = node.word("profile");
    run.F = node.integer("F", 8, 30);
    run.O = node.integer("O", 4, 28);
    run.unit = node.word("unit");
    run.test = node.word("test");
    run.inputs = node.count("inputs", 1);
    run.seconds = node.number("seconds");
    if (node.has("architecture")) {
        run.architecture = node.text("architecture");
        const JsonNode timing = part.node("timing");
        run.hardware = {node.count("mismatches", 0),
                        node.count("cycles", 0),
                        {timing.integer("least_latency", 0, INT32_MAX), timing.integer("most_latency", 0, INT32_MAX),
                         timing.count("span", 0), timing.count("span_results", 0), timing.count("intervals", 0),
                         timing.count("interval_clocks", 0)},
                        node.number("stall_probability"),
                        node.count("seed", 0)};
    }
    if (node.has("accuracy")) run.accuracy = read_accuracy(node, part);
    return run;
}

ShardFile read_shard(const std::string& path) {
    const std::string name = fmt::format("shard file '{}'", path);
    const nlohmann::json json = read_json(path, name);
    const JsonNode top(json, name);
    if (!top.has("shard")) throw Error(name + " is no shard: --shard i/N writes one");
    const JsonNode shard = top.node("shard");
    ShardFile out{path, top.text("tool"), top.text("version"), {}, {}};
    out.shard.count = shard.count("count", 2, 1'000'000);
    out.shard.index = shard.count("index", 1, out.shard.count);
    for (const JsonNode& run : top.nodes("runs")) out.runs.push_back(read_run(run));
    if (out.runs.empty()) throw Error(name + " holds no runs");
    return out;
}

/// Throws Error where `file` is a part of another run than `first`.
void refuse_foreign(const ShardFile& first, const ShardFile& file) {
    const auto compare = [&](const std::string& here, const std::string& there) {
        if (here == there) return;
        throw Error(fmt::format("shard file '{}' is foreign: it is of '{}', but '{}' of '{}'", file.path, there,
                                first.path, here));
    };
    compare(first.tool, file.tool);
    compare("version " + first.version, "version " + file.version);
    compare(fmt::format("{} shards", first.shard.count), fmt::format("{} shards", file.shard.count));
    compare(fmt::format("{} runs", first.runs.size()), fmt::format("{} runs", file.runs.size()));
    for (std::size_t i = 0; i < first.runs.size(); ++i) {
        compare(first.runs[i].key, file.runs[i].key);
        if (first.runs[i].accuracy.has_value() != file.runs[i].accuracy.has_value() ||
            (first.runs[i].accuracy && first.runs[i].accuracy->rows.size() != file.runs[i].accuracy->rows.size())) {
            throw Error(
                fmt::format("shard file '{}' is foreign: its rows are not those of '{}'", file.path, first.path));
        }
    }
}

void add(RunResult& run, const RunResult& other) {
    run.seconds += other.seconds;
    run.complaint += other.complaint;
    if (run.hardware) {
        run.hardware->mismatches += other.hardware->mismatches;
        run.hardware->cycles += other.hardware->cycles;
        run.hardware->timing.merge(other.hardware->timing);
    }
    if (run.accuracy) {
        run.accuracy->total.merge(other.accuracy->total);
        for (std::size_t i = 0; i < run.accuracy->rows.size(); ++i) {
            run.accuracy->rows[i].accuracy.merge(other.accuracy->rows[i].accuracy);
        }
    }
    run.set_inputs(run.inputs + other.inputs);
}

}  // namespace

Merged merge_shards(const std::vector<std::string>& files) {
    std::map<std::uint64_t, ShardFile> shards;
    std::uint64_t count = 0;
    for (const std::string& path : files) {
        ShardFile file = read_shard(path);
        if (!shards.empty()) refuse_foreign(shards.begin()->second, file);
        count = file.shard.count;
        const auto [there, added] = shards.try_emplace(file.shard.index, std::move(file));
        if (!added) {
            throw Error(fmt::format("shard {}/{} is there twice: '{}' and '{}'", there->first, count,
                                    there->second.path, path));
        }
    }
    std::string missing;
    std::uint64_t absent = 0;
    for (std::uint64_t i = 1; i <= count; ++i) {
        if (shards.contains(i) || ++absent > 10) continue;
        missing += fmt::format("{}{}", missing.empty() ? "" : ", ", i);
    }
    if (absent > 0) {
        throw Error(
            fmt::format("{} of {} shards are missing: {}{}", absent, count, missing, absent > 10 ? ", ..." : ""));
    }
    Merged out{shards.begin()->second.tool, {}};
    for (auto& [index, file] : shards) {
        if (out.runs.empty()) {
            out.runs = std::move(file.runs);
            continue;
        }
        for (std::size_t i = 0; i < out.runs.size(); ++i) add(out.runs[i], file.runs[i]);
    }
    for (RunResult& run : out.runs) {
        if (run.hardware && run.complaint.empty()) run.complaint = run.hardware->timing.complaint();
    }
    return out;
}

}  // namespace glint::io
