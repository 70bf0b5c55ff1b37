#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "io/command.hpp"
#include "io/shards.hpp"

namespace glint::cli {
namespace {

struct MergeOptions {
    std::vector<std::string> files;
    std::string csv;
    std::string json;
};

int run_merge(const MergeOptions& options, const std::string& command) {
    io::check_writable(options.csv, options.json);
    const io::Merged merged = io::merge_shards(options.files);
    if (!options.csv.empty()) io::write_file(options.csv, io::to_csv(merged.runs));
    if (!options.json.empty()) {
        io::write_json(options.json, io::to_json(merged.runs, merged.tool, command));
    }
    bool failed = false;
    bool hardware = false;
    for (const io::RunResult& run : merged.runs) {
        const bool reached = !run.hardware && io::bound_reached(run);
        if (!run.complaint.empty()) fmt::print(stderr, "{}: FAILED: {}", run.key, run.complaint);
        if (reached) fmt::print(stderr, "{}", io::bound_line);
        failed = failed || reached || !run.complaint.empty();
        hardware = hardware || run.hardware;
    }
    fmt::print("{}{} shards\n", io::results_table(merged.runs, hardware), options.files.size());
    return failed ? io::check_failed : io::success;
}

}  // namespace

void add_merge(CLI::App& app, Chosen& chosen) {
    auto options = std::make_shared<MergeOptions>();
    CLI::App* command = app.add_subcommand("merge", "The shards of a sweep or a cosimulation as one result");
    command->add_option("files", options->files, "What each --shard wrote with --json")->required();
    command->add_option("--csv", options->csv, "Write one row per n, and a total");
    command->add_option("--json", options->json, "Write the results, as the run in one piece does");
    command->footer("Example: glint merge shards/*.json --json sweep.json");
    command->callback([=, &chosen] { chosen.run = [=, &chosen] { return run_merge(*options, chosen.command); }; });
}

}  // namespace glint::cli
