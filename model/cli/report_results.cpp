#include "report_results.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/lobes.hpp"

namespace glint::cli {
namespace {

using Json = nlohmann::json;

/// A JSON object of a file, which knows its name for errors; the name of the outermost object is empty.
class Node {
public:
    Node(const Json& json, const std::string& file, std::string name = {})
        : json_(json), file_(file), name_(std::move(name)) {
        if (!json_.is_object()) throw Error(file_ + (name_.empty() ? "" : ": " + name_) + " is not a JSON object");
    }

    bool has(const char* key) const { return json_.contains(key) && !json_[key].is_null(); }

    Node node(const char* key) const { return {value(key), file_, path(key)}; }

    std::vector<Node> nodes(const char* key) const {
        const Json& list = value(key);
        if (!list.is_array()) fail(key, "a list");
        std::vector<Node> out;
        for (std::size_t i = 0; i < list.size(); ++i)
            out.emplace_back(list[i], file_, fmt::format("{}[{}]", path(key), i));
        return out;
    }

    std::string text(const char* key) const {
        if (!value(key).is_string()) fail(key, "a text");
        return value(key).get<std::string>();
    }

    /// A name goes into the scripts of the plots as it is, so it may hold no quotes and no line breaks.
    std::string word(const char* key) const {
        const std::string out = text(key);
        const bool legal = !out.empty() && std::all_of(out.begin(), out.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
        });
        if (!legal) fail(key, "a name of letters, digits, '_' and '-'");
        return out;
    }

    std::vector<std::string> texts(const char* key) const {
        const Json& list = value(key);
        const auto is_text = [](const Json& item) { return item.is_string(); };
        if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_text)) fail(key, "a list of texts");
        return list.get<std::vector<std::string>>();
    }

    bool boolean(const char* key) const {
        if (!value(key).is_boolean()) fail(key, "true or false");
        return value(key).get<bool>();
    }

    /// At least 0.
    double number(const char* key) const {
        if (!value(key).is_number() || !(value(key).get<double>() >= 0.0)) fail(key, "a number, 0 or more");
        return value(key).get<double>();
    }

    std::uint64_t count(const char* key, std::uint64_t low, std::uint64_t high = UINT64_MAX) const {
        const bool whole = value(key).is_number_unsigned();
        if (!whole || value(key).get<std::uint64_t>() < low || value(key).get<std::uint64_t>() > high) {
            fail(key, high == UINT64_MAX ? fmt::format("a whole number, {} or more", low)
                                         : fmt::format("a whole number, {} to {}", low, high));
        }
        return value(key).get<std::uint64_t>();
    }

    int integer(const char* key, int low, int high) const {
        return static_cast<int>(count(key, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high)));
    }

    [[noreturn]] void fail(const char* key, std::string_view legal) const {
        std::string shown = value(key).dump(-1, ' ', true);
        if (shown.size() > 40) shown = shown.substr(0, 40) + "...";
        throw Error(fmt::format("{}: {} {} is not legal: {}", file_, path(key), shown, legal));
    }

private:
    std::string path(const char* key) const { return name_.empty() ? key : fmt::format("{}.{}", name_, key); }

    const Json& value(const char* key) const {
        if (!json_.contains(key)) throw Error(fmt::format("{}: {} is missing", file_, path(key)));
        return json_[key];
    }

    const Json& json_;
    const std::string& file_;
    std::string name_;
};

Worst read_worst(const Node& node, const char* value, int F) {
    Worst out;
    out.value = node.number(value);
    out.n = node.integer("n", 1, max_n);
    out.cos_code = node.integer("cos_code", 0, 1 << F);
    return out;
}

Accuracy read_accuracy(const Node& node, int F) {
    Accuracy out;
    out.inputs = node.count("inputs", 1);
    const auto inputs = static_cast<double>(out.inputs);
    const Node rounding = node.node("rounding");
    out.rounding = read_worst(rounding, "max_ulp", F);
    out.rounding_squares = std::pow(rounding.number("rms_ulp"), 2) * inputs;
    const Node approximation = node.node("approximation");
    out.approximation = read_worst(approximation, "max", F);
    out.approximation_squares = std::pow(approximation.number("rms"), 2) * inputs;
    out.approximation_exact = read_worst(node.node("approximation_exact_cosine"), "max", F);
    if (node.has("epicentre")) out.epicentre = read_worst(node.node("epicentre"), "max", F);
    return out;
}

HardwareResult read_hardware(const Node& node) {
    HardwareResult out;
    out.mismatches = node.count("mismatches", 0);
    if (node.has("cycles")) out.cycles = node.count("cycles", 0);
    if (node.has("latency_cycles")) out.latency_cycles = node.integer("latency_cycles", 0, 1'000'000);
    if (node.has("results_per_cycle")) out.results_per_cycle = node.number("results_per_cycle");
    if (node.has("stall_probability")) out.stall_probability = node.number("stall_probability");
    if (node.has("seed")) out.seed = node.count("seed", 0);
    return out;
}

RunResult read_run(const Node& node) {
    RunResult out;
    out.lobe = node.word("lobe");
    const auto all = lobes();
    if (std::none_of(all.begin(), all.end(), [&](const Lobe& lobe) { return lobe.name == out.lobe; })) {
        node.fail("lobe", "a lobe of this glint");
    }
    out.profile = node.word("profile");
    out.F = node.integer("F", 8, 30);
    out.O = node.integer("O", 4, 28);
    out.unit = node.word("unit");
    out.test = node.word("test");
    out.exhaustive = node.boolean("exhaustive");
    out.inputs = node.count("inputs", 1);
    out.seconds = node.number("seconds");
    if (out.unit != "model") out.hardware = read_hardware(node);
    if (node.has("accuracy")) {
        const Node accuracy = node.node("accuracy");
        SweepResult sweep;
        sweep.total = read_accuracy(accuracy.node("total"), out.F);
        for (const Node& row : accuracy.nodes("rows")) {
            const int n = row.integer("n", 1, max_n);
            if (!sweep.rows.empty() && n <= sweep.rows.back().n) row.fail("n", "above the n of the row before");
            sweep.rows.push_back({n, read_accuracy(row, out.F)});
        }
        out.accuracy = std::move(sweep);
    }
    return out;
}

Proof read_proof(const Node& node) {
    Proof out;
    out.lobe = node.word("lobe");
    out.profile = node.word("profile");
    out.failures = node.texts("failures");
    if (node.boolean("ok") != out.failures.empty()) node.fail("ok", "true exactly when there are no failures");
    if (node.has("proven_ulp") || out.failures.empty()) out.ulp = node.number("proven_ulp");
    if (node.has("measured_ulp")) {
        Proof::Measured measured;
        measured.ulp = node.number("measured_ulp");
        measured.inputs = node.count("measured_inputs", 1);
        measured.exhaustive = node.boolean("measured_exhaustive");
        if (node.has("measured_at")) {
            const Node at = node.node("measured_at");
            measured.F = at.integer("F", 8, 30);
            measured.worst = Worst{measured.ulp, at.integer("n", 1, max_n), at.integer("cos_code", 0, 1 << measured.F)};
        }
        out.measured = measured;
    }
    return out;
}

Json read_json(const std::string& path, const std::string& name) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    if (!stream || !(text << stream.rdbuf())) throw Error(name + " cannot be read");
    Json json = Json::parse(text.str(), nullptr, false);
    if (json.is_discarded()) throw Error(name + " is not JSON");
    return json;
}

}  // namespace

ProofsFile read_proofs(const std::string& path) {
    const std::string name = fmt::format("proofs file '{}'", path);
    const Json json = read_json(path, name);
    const Node top(json, name);
    ProofsFile out;
    out.command = top.text("command");
    for (const Node& proof : top.nodes("proofs")) out.proofs.push_back(read_proof(proof));
    if (out.proofs.empty()) throw Error(name + " holds no proofs");
    return out;
}

ResultFile read_results(const std::string& path) {
    const std::string name = fmt::format("results file '{}'", path);
    const Json json = read_json(path, name);
    const Node top(json, name);
    ResultFile out;
    out.path = path;
    out.tool = top.text("tool");
    out.version = top.text("version");
    out.command = top.text("command");
    for (const Node& run : top.nodes("runs")) out.runs.push_back(read_run(run));
    if (out.runs.empty()) throw Error(name + " holds no runs");
    return out;
}

std::vector<MeasuredRun> measured_runs(const std::vector<ResultFile>& files) {
    std::vector<MeasuredRun> out;
    for (const ResultFile& file : files) {
        for (const RunResult& run : file.runs) {
            if (!run.accuracy) continue;
            const auto same = std::find_if(out.begin(), out.end(), [&](const MeasuredRun& other) {
                return other.run->lobe == run.lobe && other.run->profile == run.profile;
            });
            if (same == out.end()) {
                out.push_back({&run, &file});
            } else if (run.accuracy->total.inputs > same->accuracy().total.inputs) {
                *same = {&run, &file};
            }
        }
    }
    return out;
}

}  // namespace glint::cli
