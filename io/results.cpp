#include "io/results.hpp"

#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "glint/lobes.hpp"
#include "io/files.hpp"

namespace glint::io {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Worst& worst, const char* name) {
    if (!worst.seen()) return nullptr;
    return Json{{name, worst.value}, {"n", worst.n}, {"cos_code", worst.cos_code}};
}

Json to_json(const Accuracy& a) {
    Json rounding = to_json(a.rounding, "max_ulp");
    rounding["rms_ulp"] = a.rounding_rms();
    Json approximation = to_json(a.approximation, "max");
    approximation["rms"] = a.approximation_rms();
    return Json{{"inputs", a.inputs},
                {"rounding", rounding},
                {"approximation", approximation},
                {"approximation_exact_cosine", to_json(a.approximation_exact, "max")},
                {"epicentre", to_json(a.epicentre, "max")}};
}

/// All of a run that the figures for people are made from.
Json part_json(const RunResult& run) {
    Json out{{"key", run.key}, {"complaint", run.complaint}};
    if (run.hardware) {
        const Timing& t = run.hardware->timing;
        out["timing"] = {{"least_latency", t.least_latency},
                         {"most_latency", t.most_latency},
                         {"span", t.span},
                         {"span_results", t.span_results},
                         {"intervals", t.intervals},
                         {"interval_clocks", t.interval_clocks}};
    }
    if (!run.accuracy) return out;
    out["squares"] = Json::array();
    for (const AccuracyRow& row : run.accuracy->rows) {
        out["squares"].push_back({{"rounding", row.accuracy.rounding_squares.halves()},
                                  {"approximation", row.accuracy.approximation_squares.halves()}});
    }
    return out;
}

Json to_json(const RunResult& run) {
    Json out{{"lobe", run.lobe},
             {"profile", run.profile},
             {"F", run.F},
             {"O", run.O},
             {"unit", run.unit},
             {"test", run.test},
             {"exhaustive", run.exhaustive},
             {"inputs", run.inputs},
             {"seconds", run.seconds},
             {"vectors_per_second", run.seconds > 0 ? static_cast<double>(run.inputs) / run.seconds : 0.0}};
    if (run.hardware) {
        out["architecture"] = run.architecture;
        out["mismatches"] = run.hardware->mismatches;
        out["cycles"] = run.hardware->cycles;
        out["latency_cycles"] = run.hardware->timing.most_latency;
        out["interval_cycles"] = run.hardware->timing.interval_cycles();
        out["results_per_cycle"] = run.hardware->timing.results_per_cycle();
        out["stall_probability"] = run.hardware->stall_probability;
        out["seed"] = run.hardware->seed;
    }
    if (run.accuracy) {
        Json rows = Json::array();
        for (const AccuracyRow& row : run.accuracy->rows) {
            Json json{{"n", row.n}};
            json.update(to_json(row.accuracy));
            rows.push_back(std::move(json));
        }
        out["accuracy"] = Json{{"total", to_json(run.accuracy->total)}, {"rows", std::move(rows)}};
    }
    return out;
}

std::string place(const Worst& worst, int F) {
    if (!worst.seen()) return "-";
    return fmt::format("n={} c={:.5f}", worst.n, static_cast<double>(worst.cos_code) / static_cast<double>(1 << F));
}

double ratio(std::uint64_t above, std::uint64_t below) {
    return below == 0 ? 0.0 : static_cast<double>(above) / static_cast<double>(below);
}

}  // namespace

void Timing::merge(const Timing& other) {
    if (other.most_latency > 0) {
        least_latency = most_latency == 0 ? other.least_latency : std::min(least_latency, other.least_latency);
        most_latency = std::max(most_latency, other.most_latency);
    }
    span += other.span;
    span_results += other.span_results;
    intervals += other.intervals;
    interval_clocks += other.interval_clocks;
}

double Timing::results_per_cycle() const { return ratio(span_results, span); }
double Timing::interval_cycles() const { return ratio(interval_clocks, intervals); }

std::string Timing::complaint() const {
    if (least_latency == most_latency) return {};
    return fmt::format("latency varies without stalls: {} to {} clocks\n", least_latency, most_latency);
}

void RunResult::set_inputs(std::uint64_t count) {
    inputs = count;
    exhaustive = accuracy && count == max_n * ((std::uint64_t{1} << F) + 1);
}

RunResult run_result(const GoldenModel& model, std::string unit, std::string test) {
    RunResult out;
    out.lobe = model.lobe();
    out.profile = model.profile().name;
    out.F = model.profile().F;
    out.O = model.profile().O;
    out.unit = std::move(unit);
    out.test = std::move(test);
    return out;
}

nlohmann::ordered_json to_json(const std::vector<RunResult>& runs, const std::string& tool, const std::string& command,
                               Shard shard) {
    Json out{{"tool", tool}, {"version", GLINT_VERSION}, {"command", command}};
    if (shard.count > 1) out["shard"] = {{"index", shard.index}, {"count", shard.count}};
    out["runs"] = Json::array();
    for (const RunResult& run : runs) {
        out["runs"].push_back(to_json(run));
        if (shard.count > 1) out["runs"].back()["part"] = part_json(run);
    }
    return out;
}

std::string grouped(std::uint64_t number) {
    std::string out = fmt::format("{}", number);
    for (std::size_t i = out.size(); i > 3; i -= 3) out.insert(i - 3, 1, ' ');
    return out;
}

bool bound_reached(const RunResult& run) {
    const auto shipped = shipped_profiles();
    const auto same = [&](const Profile& profile) { return profile.name == run.profile; };
    return run.accuracy && std::any_of(shipped.begin(), shipped.end(), same) &&
           run.accuracy->total.rounding.value >= find_lobe(run.lobe).bound_ulp;
}

std::string results_table(const std::vector<RunResult>& runs, bool hardware) {
    const bool accuracy = std::any_of(runs.begin(), runs.end(), [](const RunResult& run) { return run.accuracy; });
    std::vector<std::string> heading{"lobe", "profile"};
    const auto add = [](std::vector<std::string>& row, bool wanted, std::initializer_list<std::string> cells) {
        if (wanted) row.insert(row.end(), cells);
    };
    add(heading, hardware, {"unit", "architecture", "test"});
    add(heading, true, {"inputs"});
    add(heading, hardware, {"mismatches"});
    add(heading, accuracy, {"rounding/ulp", "error", "at", "exact cos", "epicentre", "at"});
    add(heading, hardware, {"latency", "interval"});
    add(heading, true, {"M/s"});
    std::vector<std::vector<std::string>> rows{heading};
    for (const RunResult& run : runs) {
        std::vector<std::string> row{run.lobe, run.profile};
        add(row, hardware, {run.unit, run.architecture, run.test});
        add(row, true, {grouped(run.inputs)});
        add(row, hardware, {run.hardware ? grouped(run.hardware->mismatches) : "-"});
        if (run.accuracy) {
            const Accuracy& a = run.accuracy->total;
            add(row, true,
                {fmt::format("{:.4f}", a.rounding.value), fmt::format("{:.5f}", a.approximation.value),
                 place(a.approximation, run.F), fmt::format("{:.5f}", a.approximation_exact.value),
                 a.epicentre.seen() ? fmt::format("{:.3f} %", 100.0 * a.epicentre.value) : "-",
                 place(a.epicentre, run.F)});
        } else {
            add(row, accuracy, {"-", "-", "-", "-", "-", "-"});
        }
        // Both are measured at full speed only.
        const bool timed = run.hardware && run.hardware->timing.most_latency > 0;
        add(row, hardware,
            {timed ? fmt::format("{}", run.hardware->timing.most_latency) : "-",
             timed && run.hardware->timing.intervals > 0 ? fmt::format("{:g}", run.hardware->timing.interval_cycles())
                                                         : "-"});
        add(row, true,
            {fmt::format("{:.1f}", run.seconds > 0 ? static_cast<double>(run.inputs) / run.seconds / 1e6 : 0.0)});
        rows.push_back(row);
    }
    const std::string legend =
        "rounding: against the lobe's real function; error, epicentre: against c^n at the rounded cosine (epicentre:\n"
        "relative, n >= 2); exact cos: against c^n at the worse end of what rounds to the cosine's code\n";
    return table(rows) + (accuracy ? legend : "");
}

std::string to_csv(const std::vector<RunResult>& runs) {
    std::string out =
        "lobe,profile,n,inputs,rounding_max_ulp,rounding_cos_code,rounding_rms_ulp,error_max,error_cos_code,error_rms,"
        "error_exact_cosine_max,error_exact_cosine_cos_code,epicentre_max,epicentre_cos_code\n";
    const auto line = [&](const RunResult& run, const std::string& n, const Accuracy& a) {
        const auto epicentre =
            a.epicentre.seen() ? fmt::format("{:.9g},{}", a.epicentre.value, a.epicentre.cos_code) : std::string(",");
        out += fmt::format("{},{},{},{},{:.9g},{},{:.9g},{:.9g},{},{:.9g},{:.9g},{},{}\n", run.lobe, run.profile, n,
                           a.inputs, a.rounding.value, a.rounding.cos_code, a.rounding_rms(), a.approximation.value,
                           a.approximation.cos_code, a.approximation_rms(), a.approximation_exact.value,
                           a.approximation_exact.cos_code, epicentre);
    };
    for (const RunResult& run : runs) {
        if (!run.accuracy) continue;
        for (const AccuracyRow& row : run.accuracy->rows) line(run, fmt::format("{}", row.n), row.accuracy);
        line(run, "total", run.accuracy->total);
    }
    return out;
}

std::string command_line(int argc, char** argv) {
    std::string out = std::filesystem::path(argv[0]).filename().string();
    for (int i = 1; i < argc; ++i) out += fmt::format(" {}", argv[i]);
    return out;
}

}  // namespace glint::io
