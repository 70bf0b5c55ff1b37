// `glint report`: measured results, prices and what the papers claim, joined in one JSON file and shown as one page.
#include <filesystem>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/report/inputs.hpp"
#include "cli/study.hpp"
#include "cost/effect_prices.hpp"
#include "cost/fpga/device.hpp"
#include "cost/table.hpp"
#include "glint/hard_cases.hpp"
#include "io/command.hpp"
#include "io/json_node.hpp"
#include "io/page.hpp"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ReportOptions {
    std::vector<std::string> results;
    std::string proofs, cost, output = "report";
    StudyInputs study;
};

/// The command that writes a unit; null for a rival, which is no lobe.
Json emit_line_of(const cost::Configuration& c) {
    const auto all = lobes();
    const std::string name = c.lobe.substr(0, c.lobe.find(':'));
    if (std::none_of(all.begin(), all.end(), [&](const Lobe& lobe) { return lobe.name == name; })) return nullptr;
    return cost::emit_line(c);
}

/// Every price with its error; those of effects as they are.
Json cost_json(const std::string& folder) {
    const cost::Prices data = cost::read_cost_data(folder);
    const cost::Scope scope{{8, 1000, 1}, cost::Cosine::rounded, {}, true};  // the exponents that the papers speak of
    std::vector<cost::Configuration> all = cost::join(data, scope, "");
    cost::sort_by(all, cost::Metric::error);
    Json out = cost::table_json(all, cost::common_axes, data,
                                data.cpu ? data.cpu->prices : std::vector<cost::CpuPrice>(), scope);
    std::set<std::string> with_dsps;
    for (std::size_t i = 0; i < all.size(); ++i) {
        out["configurations"][i]["emit"] = emit_line_of(all[i]);
        if (all[i].clock_mhz && all[i].dsps > 0) with_dsps.insert(all[i].device);
    }
    out["tools"] = data.tools;
    out["devices"] = cost::priced_devices(data);
    out["notes"] = fpga::dsp_clock_notes(with_dsps);
    out["does_not_fit"] = Json::array();
    for (const cost::Price& price : data.fpga) {
        const cost::Configuration& c = price.configuration;
        if (!price.fits) out["does_not_fit"].push_back(fmt::format("{} on {}", cost::name_of(c), c.device));
    }
    const std::string effects = (std::filesystem::path(folder) / "effects.json").string();
    out["effects"] = nullptr;
    if (std::filesystem::is_regular_file(effects)) {
        cost::read_effect_prices(effects);  // refuses what is not legal
        out["effects"] = io::read_json(effects, effects);
    }
    const std::string hls = (std::filesystem::path(folder) / "hls.json").string();
    out["hls"] = std::filesystem::is_regular_file(hls) ? Json(io::read_json(hls, hls)) : Json();
    return out;
}

/// The cases of the lobes that have results, and of the streams.
Json hard_cases_json(const std::vector<nlohmann::json>& results) {
    std::set<std::string> reported;
    for (const auto& file : results) {
        for (const auto& run : file["runs"]) reported.insert(run["lobe"]);
    }
    Json tables = Json::array();
    const auto add = [&](const HardCaseTable& table) {
        tables.push_back(
            {{"title", table.title}, {"columns", table.columns}, {"sentences", table.sentences}, {"rows", table.rows}});
    };
    for (const Lobe& lobe : lobes()) {
        if (reported.contains(std::string(lobe.name))) add(hard_case_table(lobe));
    }
    add(stream_case_table());
    return {{"legend", hard_case_legend()}, {"tables", std::move(tables)}};
}

int run_report(const ReportOptions& options, const std::string& command) {
    const auto json_of = [](const std::string& path) {
        return path.empty() ? nlohmann::json() : io::read_json(path, path);
    };
    std::vector<nlohmann::json> results;
    for (const std::string& path : options.results) results.push_back(read_results(path));
    const nlohmann::json proofs = options.proofs.empty() ? nlohmann::json() : read_proofs(options.proofs);
    Json report{
        {"format", "glint-report-1"}, {"version", GLINT_VERSION}, {"command", command}, {"lobes", Json::array()}};
    for (const Lobe& lobe : lobes()) report["lobes"].push_back(lobe.name);
    report["problems"] = problems(results, proofs);
    report["results"] = results;
    report["proofs"] = proofs;
    report["cost"] = options.cost.empty() ? Json() : cost_json(options.cost);
    report["study"] = studies::to_json(find(options.study));
    report["cpu"] = json_of(options.study.cpu);
    report["cpu_models"] = json_of(options.study.cpu_models);
    report["hard_cases"] = hard_cases_json(results);
    io::make_folder(options.output);
    io::check_writable(std::filesystem::path(options.output) / "index.html");
    io::run_page_script("report.py", io::json_text(report), options.output);
    return report["problems"].empty() ? io::success : io::check_failed;
}

}  // namespace

void add_report(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command =
        app.add_subcommand("report", "The page of measured results: which unit to take, errors, proofs, papers");
    command->add_option("--results", options->results, "JSON files of glint-cosim or glint sweep")->required();
    command->add_option("--proofs", options->proofs,
                        "JSON file of proofs/gappa/run.py, for the table of proven bounds");
    add_options(*command, options->study);
    command->add_option("--cost", options->cost, "Folder of accuracy.json and fpga.json, for what accuracy costs");
    command->add_option("-o,--output", options->output, "Folder for index.html, report.json, figures and pictures")
        ->capture_default_str();
    command->footer("Example: glint report --results cosim.json --proofs proofs.json --cost cost/data -o report");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_report(*options, chosen.command); }; });
}

}  // namespace glint::cli
