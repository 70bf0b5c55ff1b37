#include "cli/report/inputs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "io/json_node.hpp"

namespace glint::cli {
namespace {

using Node = io::JsonNode;

void check_worst(const Node& node, const char* value, int F) {
    node.number(value);
    node.integer("n", 1, max_n);
    node.integer("cos_code", 0, 1 << F);
}

void check_accuracy(const Node& node, int F) {
    node.count("inputs", 1);
    check_worst(node.node("rounding"), "max_ulp", F);
    node.node("rounding").number("rms_ulp");
    check_worst(node.node("approximation"), "max", F);
    node.node("approximation").number("rms");
    check_worst(node.node("approximation_exact_cosine"), "max", F);
    if (node.has("epicentre")) check_worst(node.node("epicentre"), "max", F);
}

void check_run(const Node& node) {
    const std::string lobe = node.word("lobe");
    const auto all = lobes();
    if (std::none_of(all.begin(), all.end(), [&](const Lobe& each) { return each.name == lobe; })) {
        node.fail("lobe", "a lobe of this glint");
    }
    for (const char* key : {"profile", "test"}) node.word(key);
    const int F = node.integer("F", 8, 30);
    node.integer("O", 4, 28);
    if (node.has("architecture")) node.text("architecture");
    node.boolean("exhaustive");
    node.count("inputs", 1);
    node.number("seconds");
    const bool hardware = node.word("unit") != "model";
    if (hardware || node.has("mismatches")) node.count("mismatches", 0);
    if (hardware) {
        for (const char* key : {"cycles", "seed"}) {
            if (node.has(key)) node.count(key, 0);
        }
        for (const char* key : {"latency_cycles", "results_per_cycle", "stall_probability"}) {
            if (node.has(key)) node.number(key);
        }
    }
    if (!node.has("accuracy")) return;
    const Node accuracy = node.node("accuracy");
    check_accuracy(accuracy.node("total"), F);
    int last = 0;
    for (const Node& row : accuracy.nodes("rows")) {
        const int n = row.integer("n", 1, max_n);
        if (n <= last) row.fail("n", "above the n of the row before");
        last = n;
        check_accuracy(row, F);
    }
}

void check_proof(const Node& node) {
    node.word("lobe");
    node.word("profile");
    const bool held = node.texts("failures").empty();
    if (node.boolean("ok") != held) node.fail("ok", "true exactly when there are no failures");
    if (node.has("proven_ulp") || held) node.number("proven_ulp");
    if (!node.has("measured_ulp")) return;
    node.number("measured_ulp");
    node.count("measured_inputs", 1);
    node.boolean("measured_exhaustive");
    if (!node.has("measured_at")) return;
    const Node at = node.node("measured_at");
    const int F = at.integer("F", 8, 30);
    at.integer("n", 1, max_n);
    at.integer("cos_code", 0, 1 << F);
}

std::string name_of(const nlohmann::json& unit) {
    return fmt::format("{} {}", unit["lobe"].get<std::string>(), unit["profile"].get<std::string>());
}

}  // namespace

nlohmann::json read_results(const std::string& path) {
    const std::string name = fmt::format("results file '{}'", path);
    nlohmann::json json = io::read_json(path, name);
    const Node top(json, name);
    for (const char* key : {"tool", "version", "command"}) top.text(key);
    const auto runs = top.nodes("runs");
    if (runs.empty()) throw Error(name + " holds no runs");
    for (const Node& run : runs) check_run(run);
    return json;
}

nlohmann::json read_proofs(const std::string& path) {
    const std::string name = fmt::format("proofs file '{}'", path);
    nlohmann::json json = io::read_json(path, name);
    const Node top(json, name);
    top.text("command");
    const auto proofs = top.nodes("proofs");
    if (proofs.empty()) throw Error(name + " holds no proofs");
    for (const Node& proof : proofs) check_proof(proof);
    return json;
}

nlohmann::ordered_json problems(const std::vector<nlohmann::json>& results, const nlohmann::json& proofs) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const auto& file : results) {
        for (const auto& run : file["runs"]) {
            const auto found = run.find("mismatches");  // null counts as not there
            const auto count = found == run.end() || found->is_null() ? 0 : found->get<std::uint64_t>();
            if (count == 0) continue;
            out.push_back({{"kind", "mismatches"}, {"name", name_of(run)}, {"unit", run["unit"]}, {"count", count}});
        }
    }
    if (proofs.is_null()) return out;
    for (const auto& proof : proofs["proofs"]) {
        for (const auto& text : proof["failures"]) {
            out.push_back({{"kind", "proof"}, {"name", name_of(proof)}, {"text", text}});
        }
        double largest = 0.0;
        for (const auto& file : results) {
            for (const auto& run : file["runs"]) {
                if (!run.contains("accuracy") || run["accuracy"].is_null() || name_of(run) != name_of(proof)) continue;
                largest = std::max(largest, run["accuracy"]["total"]["rounding"]["max_ulp"].get<double>());
            }
        }
        if (proof.contains("proven_ulp") && !proof["proven_ulp"].is_null() && largest > proof["proven_ulp"]) {
            out.push_back({{"kind", "contradiction"}, {"name", name_of(proof)}, {"ulp", largest}});
        }
    }
    return out;
}

}  // namespace glint::cli
