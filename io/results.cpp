#include "io/results.hpp"

#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include <fmt/format.h>

#include "io/command.hpp"

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
        out["latency_cycles"] = run.hardware->latency_cycles;
        out["interval_cycles"] = run.hardware->interval_cycles;
        out["results_per_cycle"] = run.hardware->results_per_cycle;
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

std::string grouped(std::uint64_t number) {
    std::string out = fmt::format("{}", number);
    for (std::size_t i = out.size(); i > 3; i -= 3) out.insert(i - 3, 1, ' ');
    return out;
}

}  // namespace

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

nlohmann::ordered_json to_json(const std::vector<RunResult>& runs, const std::string& tool,
                               const std::string& command) {
    Json out{{"tool", tool}, {"version", GLINT_VERSION}, {"command", command}, {"runs", Json::array()}};
    for (const RunResult& run : runs) out["runs"].push_back(to_json(run));
    return out;
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
        const bool timed = run.hardware && run.hardware->latency_cycles > 0;
        add(row, hardware,
            {timed ? fmt::format("{}", run.hardware->latency_cycles) : "-",
             timed && run.hardware->interval_cycles > 0 ? fmt::format("{:g}", run.hardware->interval_cycles) : "-"});
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
