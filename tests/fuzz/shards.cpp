// Files of shards, as `glint merge` and --resume read them.
#include <list>

#include <nlohmann/json.hpp>

#include "check.hpp"
#include "io/command.hpp"
#include "io/shards.hpp"
#include "memory_file.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration shards("shards", [](const std::string& text) {
    std::list<MemoryFile> files;
    std::vector<std::string> paths;
    for (const std::string& part : split(text, separator)) {
        if (paths.size() < 4) paths.push_back(files.emplace_back(part).path());
    }
    may_refuse([&] {
        const io::Merged merged = io::merge_shards(paths);
        require(!merged.runs.empty(), "there are runs");
        require(io::json_text(io::to_json(merged.runs, merged.tool, "glint merge")).ends_with("}\n"), "it is JSON");
        require(io::to_csv(merged.runs).ends_with('\n'), "it is CSV");
        require(io::results_table(merged.runs, true).ends_with('\n'), "it is a table");
        for (const io::RunResult& run : merged.runs) io::bound_reached(run);
    });
    may_refuse([&] {
        CLI::App app;
        io::ShardOptions options;
        std::string json;
        options.add(app, app.add_option("--json", json));
        app.parse("--json " + paths.front() + " --shard 1/2 --resume");
        options.there(json, "glint sweep", {"bps p8 n 50:51:1 cos 0:9:1"});
    });
});

}  // namespace glint::fuzz
