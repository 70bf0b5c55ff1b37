#include "glint/sweep.hpp"

#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "io/command.hpp"
#include "io/results.hpp"
#include "io/shards.hpp"

namespace glint::cli {
namespace {

struct SweepOptions {
    std::string lobe = "bps";
    std::string profile = "p12";
    std::string n = "all";
    std::string cos = "all";
    std::string csv;
    std::string json;
    unsigned threads = 0;
    io::ShardOptions shard;
    std::uint64_t plan = 0;
};

struct Work {
    std::unique_ptr<GoldenModel> model;
    Range n, codes;
};

std::string duration(double seconds) {
    if (seconds < 120) return fmt::format("{:.1f} s", seconds);
    if (seconds < 7200) return fmt::format("{:.1f} min", seconds / 60);
    if (seconds < 172800) return fmt::format("{:.1f} h", seconds / 3600);
    return fmt::format("{:.1f} days", seconds / 86400);
}

/// Measures some of the tasks on one core, for a second or two, and tells what all of them would take on `cores`.
std::vector<std::string> planned(const Work& work, std::uint64_t cores) {
    using clock = std::chrono::steady_clock;
    const std::uint64_t tasks = SweepPlan(work.n, work.codes).tasks();
    const auto start = clock::now();
    double seconds = 0.0;
    std::uint64_t measured = 0, done = 0;
    for (; done < tasks && (done < 2 || seconds < 2.0); ++done) {
        // Spread over the codes: odd steps of a golden section meet no task twice early.
        const auto place = std::fmod(static_cast<double>(done) * 0.618033988749895, 1.0);
        const Shard shard{1 + static_cast<std::uint64_t>(place * static_cast<double>(tasks)), tasks};
        measured += sweep(*work.model, work.n, work.codes, 1, {}, shard).total.inputs;
        seconds = std::chrono::duration<double>(clock::now() - start).count();
    }
    const double task = seconds / static_cast<double>(done);
    const std::uint64_t rounds = (tasks + cores - 1) / cores;
    const auto inputs = static_cast<std::uint64_t>(work.n.size()) * static_cast<std::uint64_t>(work.codes.size());
    return {std::string(work.model->lobe()),
            work.model->profile().name,
            io::grouped(inputs),
            io::grouped(tasks),
            io::grouped(measured),
            fmt::format("{:.1f}", static_cast<double>(measured) / seconds / 1e6),
            duration(task * static_cast<double>(tasks)),
            duration(task * static_cast<double>(rounds))};
}

int run_plan(const std::vector<Work>& work, std::uint64_t cores) {
    std::vector<std::vector<std::string>> rows{{"lobe", "profile", "inputs", "shards at most", "measured", "M/s a core",
                                                "one core", fmt::format("{} cores", cores)}};
    for (const Work& each : work) rows.push_back(planned(each, cores));
    fmt::print("{}measured: so many inputs, on one core of this machine; the times are in proportion\n",
               io::table(rows));
    return io::success;
}

int run_sweep(SweepOptions& options, const std::string& command) {
    io::check_writable(options.csv, options.json);
    std::vector<Work> work;
    std::vector<std::string> keys;
    for (auto& model : io::models(options.lobe, options.profile)) {
        const Range n = parse_range(options.n, "--n", 1, max_n);
        const Range codes = parse_range(options.cos, "--cos", 0, model->profile().one());
        keys.push_back(fmt::format("{} {} n {}:{}:{} cos {}:{}:{}", model->lobe(), model->profile().name, n.first,
                                   n.last, n.step, codes.first, codes.last, codes.step));
        work.push_back({std::move(model), n, codes});
    }
    if (options.plan > 0) return run_plan(work, options.plan);
    for (const Work& each : work) options.shard.shard().check(SweepPlan(each.n, each.codes).tasks());
    if (options.shard.there(options.json, "glint sweep", keys)) return io::success;
    std::vector<io::RunResult> runs;
    bool failed = false;
    for (const auto& [model, n, codes] : work) {
        io::RunResult run = io::run_result(*model, "model", "sweep");
        run.key = keys[runs.size()];
        const auto start = std::chrono::steady_clock::now();
        run.accuracy = sweep(*model, n, codes, options.threads,
                             io::progress_bar(fmt::format("{} {}", run.lobe, run.profile)), options.shard.shard());
        run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        run.set_inputs(run.accuracy->total.inputs);
        failed = failed || io::bound_reached(run);
        runs.push_back(std::move(run));
    }
    if (!options.csv.empty()) io::write_file(options.csv, io::to_csv(runs));
    if (!options.json.empty()) {
        const auto json = io::to_json(runs, "glint sweep", command, options.shard.shard());
        io::write_json(options.json, json);
    }
    fmt::print("{}", io::results_table(runs, false));
    if (failed) fmt::print("{}", io::bound_line);
    return failed ? io::check_failed : io::success;
}

}  // namespace

void add_sweep(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<SweepOptions>();
    CLI::App* command =
        app.add_subcommand("sweep", "Errors of a golden model over ranges of inputs, per n and in total");
    command->add_option("--lobe", options->lobe, "Lobes, separated by commas, or all")->capture_default_str();
    command->add_option("--profile", options->profile, "Profiles: p8, p12, p16 or the lobe's F,..,O")
        ->capture_default_str();
    command->add_option("--n", options->n, "Exponents: n, first:last, first:last:step or all")->capture_default_str();
    command->add_option("--cos", options->cos, "Cosine codes: a range as for --n, or all (0 to 2^F)")
        ->capture_default_str();
    CLI::Option* csv = command->add_option("--csv", options->csv, "Write one row per n, and a total");
    CLI::Option* json = command->add_option("--json", options->json, "Write the same as JSON");
    io::add_integer(*command, "--threads", options->threads, 0, io::most_threads, "Threads; 0: one a core");
    CLI::Option* shard = options->shard.add(*command, json);
    io::add_integer(*command, "--plan", options->plan, 1, 1'000'000,
                    "Measure for two seconds; print what INT cores would take")
        ->excludes(json)
        ->excludes(csv)
        ->excludes(shard)
        ->option_text("INT");
    command->footer("Example: glint sweep --lobe bps --profile p8,p12 --n 1:1000 --cos all --csv out.csv");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_sweep(*options, chosen.command); }; });
}

}  // namespace glint::cli
