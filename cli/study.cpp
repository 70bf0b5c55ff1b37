#include "cli/study.hpp"

#include <memory>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cost/cpu_prices.hpp"
#include "io/command.hpp"

namespace glint::cli {
namespace {

studies::Costs costs(std::optional<cost::CpuPrices> prices) {
    return [prices = std::move(prices)](std::string_view name, std::string_view type,
                                        studies::Cost what) -> std::optional<double> {
        using studies::Cost;
        const auto* price = prices ? prices->find(name, type, what == Cost::batch ? "batch" : "scalar") : nullptr;
        if (price == nullptr) return std::nullopt;
        if (what == Cost::latency) return price->latency;
        return what == Cost::instructions ? price->instructions : std::optional(price->throughput);
    };
}

struct StudyOptions {
    StudyInputs inputs;
    std::string json;
};

int run_study(const StudyOptions& options, const std::string& command) {
    io::check_writable(options.json);
    const studies::Findings found = find(options.inputs);
    if (!options.json.empty()) {
        nlohmann::ordered_json out = studies::to_json(found);
        out.update({{"tool", "glint study"}, {"version", GLINT_VERSION}, {"command", command}});
        io::write_json(options.json, out, -1);
    }
    fmt::print("Paper 1 (δ: relative error in the epicentre zone, Δ: absolute error)\n{}\n",
               studies::claims_table(found.claims_1));
    fmt::print("Paper 2\n{}\n{}", studies::claims_table(found.claims_2),
               studies::claims_table(found.processor_claims_2));
    return io::success;
}

}  // namespace

studies::Findings find(const StudyInputs& inputs) {
    std::optional<cost::CpuPrices> formulas, models;
    if (!inputs.cpu.empty()) formulas = cost::read_cpu_prices(inputs.cpu);
    if (!inputs.cpu_models.empty()) models = cost::read_model_prices(inputs.cpu_models, studies::paper2::model_names());
    return studies::find(costs(std::move(formulas)), costs(std::move(models)));
}

void add_options(CLI::App& command, StudyInputs& inputs) {
    command.add_option("--cpu", inputs.cpu, "JSON file of bench/run.py: what lobes cost on a processor");
    command.add_option("--cpu-models", inputs.cpu_models,
                       "JSON file of bench/run.py: what lighting models cost on a processor");
}

void add_study(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App* command = app.add_subcommand("study", "What the two papers claim, held against what is measured");
    add_options(*command, options->inputs);
    command->add_option("--json", options->json, "Write claims, errors of all lobes and the points of all figures");
    command->footer("Example: glint study --cpu cost/data/cpu.json --json study.json");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_study(*options, chosen.command); }; });
}

}  // namespace glint::cli
