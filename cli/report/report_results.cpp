#include "cli/report/report_results.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "glint/error.hpp"
#include "glint/lobes.hpp"
#include "io/json_node.hpp"

namespace glint::cli {
namespace {

using Node = io::JsonNode;

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

io::HardwareResult read_hardware(const Node& node) {
    io::HardwareResult out;
    out.mismatches = node.count("mismatches", 0);
    if (node.has("cycles")) out.cycles = node.count("cycles", 0);
    if (node.has("latency_cycles")) out.latency_cycles = node.integer("latency_cycles", 0, 1'000'000);
    if (node.has("results_per_cycle")) out.results_per_cycle = node.number("results_per_cycle");
    if (node.has("stall_probability")) out.stall_probability = node.number("stall_probability");
    if (node.has("seed")) out.seed = node.count("seed", 0);
    return out;
}

io::RunResult read_run(const Node& node) {
    io::RunResult out;
    out.lobe = node.word("lobe");
    const auto all = lobes();
    if (std::none_of(all.begin(), all.end(), [&](const Lobe& lobe) { return lobe.name == out.lobe; })) {
        node.fail("lobe", "a lobe of this glint");
    }
    out.profile = node.word("profile");
    out.F = node.integer("F", 8, 30);
    out.O = node.integer("O", 4, 28);
    if (node.has("architecture")) out.architecture = node.text("architecture");
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

}  // namespace

ProofsFile read_proofs(const std::string& path) {
    const std::string name = fmt::format("proofs file '{}'", path);
    const nlohmann::json json = io::read_json(path, name);
    const Node top(json, name);
    ProofsFile out;
    out.command = top.text("command");
    for (const Node& proof : top.nodes("proofs")) out.proofs.push_back(read_proof(proof));
    if (out.proofs.empty()) throw Error(name + " holds no proofs");
    return out;
}

ResultFile read_results(const std::string& path) {
    const std::string name = fmt::format("results file '{}'", path);
    const nlohmann::json json = io::read_json(path, name);
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
        for (const io::RunResult& run : file.runs) {
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
