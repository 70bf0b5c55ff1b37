#include "cli/report/report.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "cli/report/report_page.hpp"
#include "glint/error.hpp"
#include "io/command.hpp"

namespace glint::cli {

int report(const ReportOptions& options) {
    if (options.results.empty()) throw Error("--results names no file: one or more JSON result files are needed");
    std::vector<ResultFile> files;
    std::string command = "glint report --results";
    for (const std::string& path : options.results) {
        files.push_back(read_results(path));
        command += " " + path;
    }
    std::optional<ProofsFile> proofs;
    if (!options.proofs.empty()) {
        proofs = read_proofs(options.proofs);
        command += " --proofs " + options.proofs;
    }
    std::optional<CpuPrices> cpu;
    if (!options.cpu.empty()) {
        cpu = read_cpu_prices(options.cpu);
        command += " --cpu " + options.cpu;
    }
    const Paper2Data paper2 = paper2_data();
    std::optional<CpuPrices> models;
    if (!options.cpu_models.empty()) {
        models = read_model_prices(options.cpu_models, paper2.models);
        command += " --cpu-models " + options.cpu_models;
    }
    std::optional<CostReport> cost;
    if (!options.cost.empty()) {
        cost = read_cost_report(options.cost);
        command += " --cost " + options.cost;
    }
    command += " -o " + options.output;

    const std::vector<MeasuredRun> measured = measured_runs(files);
    PlotData plots{curves(50), error_map("p12"), schlick_errors(), {}, paper_data(), paper2, {}};
    if (cost) plots.cost = cost->plots;
    std::copy_if(measured.begin(), measured.end(), std::back_inserter(plots.measured),
                 [](const MeasuredRun& run) { return !run.accuracy().rows.empty(); });
    // A plot holds four curves apart; of more, those of the lobe that the page begins with. The tables have all.
    if (plots.measured.size() > 4) {
        const std::string lobe = plots.measured.front().run->lobe;
        std::erase_if(plots.measured, [&](const MeasuredRun& run) { return run.run->lobe != lobe; });
    }
    const Pictures pictures = draw(plots);

    const std::filesystem::path folder = options.output;
    io::make_folder(folder);
    const auto write = [&](const std::string& name, const std::string& text) {
        io::write_file(folder / name, text);
        fmt::print("{}\n", (folder / name).string());
    };
    io::make_folder(folder / "figures");
    for (const FigureCsv& figure : figure_csvs(plots.curves, plots.paper)) {
        write("figures/" + figure.name, figure.text);
    }
    for (const FigureCsv& figure : paper2_csvs(plots.paper2)) write("figures/" + figure.name, figure.text);
    for (const std::string_view theme : themes) {
        if (!plots.measured.empty()) write(overview_file(theme), pictures.at(overview_file(theme)));
    }
    write("index.html", page({files, proofs, cpu, models, cost, measured, plots, pictures, command}));
    return io::success;
}

}  // namespace glint::cli
