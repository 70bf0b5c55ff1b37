#include "cli/report/report.hpp"
#include "cli/commands.hpp"

namespace glint::cli {

void add_report(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<ReportOptions>();
    options->output = "report";
    CLI::App* command = app.add_subcommand(
        "report", "A page with measured results, the papers' claims checked, and how to choose a lobe");
    command->add_option("--results", options->results, "JSON files of glint-cosim or glint sweep")->required();
    command->add_option("--proofs", options->proofs,
                        "JSON file of proofs/gappa/run.py, for the table of proven bounds");
    command->add_option("--cpu", options->cpu, "JSON file of bench/run.py, for what lobes cost on a processor");
    command->add_option("--cpu-models", options->cpu_models,
                        "JSON file of bench/run.py, for lighting models on a processor");
    command->add_option("--cost", options->cost, "Folder of accuracy.json and fpga.json, for what accuracy costs");
    command->add_option("-o,--output", options->output, "Folder for index.html, figures/*.csv and the pictures")
        ->capture_default_str();
    command->footer(
        "Example: glint report --results cosim.json --proofs proofs.json --cpu cost/data/cpu.json -o report");
    command->callback([=, &chosen] { chosen.run = [=] { return report(*options); }; });
}

}  // namespace glint::cli
