#include "glint/sweep.hpp"

#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "glint/lobes.hpp"
#include "io/command.hpp"
#include "io/results.hpp"

namespace glint::cli {
namespace {

struct Options {
    std::string lobe = "bps";
    std::string profile = "p12";
    std::string n = "all";
    std::string cos = "all";
    std::string csv;
    std::string json;
    unsigned threads = 0;
};

int run_sweep(const Options& options, const std::string& command) {
    io::check_writable(options.csv);
    io::check_writable(options.json);
    std::vector<io::RunResult> runs;
    bool failed = false;
    for (const auto& model : io::models(options.lobe, options.profile)) {
        const Range n = parse_range(options.n, "--n", 1, max_n);
        const Range codes = parse_range(options.cos, "--cos", 0, model->profile().one());
        io::RunResult run = io::run_result(*model, "model", "sweep");
        const auto start = std::chrono::steady_clock::now();
        run.accuracy =
            sweep(*model, n, codes, options.threads, io::progress_bar(fmt::format("{} {}", run.lobe, run.profile)));
        run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        run.inputs = run.accuracy->total.inputs;
        run.exhaustive = run.inputs == max_n * (static_cast<std::uint64_t>(model->profile().one()) + 1);
        if (model->profile().shipped() && run.accuracy->total.rounding.value >= find_lobe(model->lobe()).bound_ulp)
            failed = true;
        runs.push_back(std::move(run));
    }
    if (!options.csv.empty()) io::write_file(options.csv, io::to_csv(runs));
    if (!options.json.empty()) io::write_file(options.json, io::to_json(runs, "glint sweep", command).dump(1) + "\n");
    fmt::print("{}", io::results_table(runs, false));
    if (failed) fmt::print("FAILED: the rounding error of a shipped profile reaches the bound of its lobe\n");
    return failed ? io::check_failed : io::success;
}

}  // namespace

void add_sweep(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("sweep", "Errors of a golden model over ranges of inputs, per n and in total");
    command->add_option("--lobe", options->lobe, "Lobes, separated by commas, or all")->capture_default_str();
    command->add_option("--profile", options->profile, "Profiles: p8, p12, p16 or the lobe's F,..,O")
        ->capture_default_str();
    command->add_option("--n", options->n, "Exponents: n, first:last, first:last:step or all")->capture_default_str();
    command->add_option("--cos", options->cos, "Cosine codes: a range as for --n, or all (0 to 2^F)")
        ->capture_default_str();
    command->add_option("--csv", options->csv, "Write one row per n, and a total");
    command->add_option("--json", options->json, "Write the same as JSON");
    io::add_integer(*command, "--threads", options->threads, 0, io::most_threads, "Threads; 0: one a core");
    command->footer("Example: glint sweep --lobe bps --profile p8,p12 --n 1:1000 --cos all --csv out.csv");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_sweep(*options, chosen.command); }; });
}

}  // namespace glint::cli
