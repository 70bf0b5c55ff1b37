// A run that is split over processes or machines, a shard each; glint merge joins what they write (docs/cluster.md).
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "io/results.hpp"

namespace glint::io {

/// The options --shard and --resume of a command.
class ShardOptions {
public:
    /// `json`: the option whose file holds the results. Returns --shard.
    CLI::Option* add(CLI::App& app, CLI::Option* json);
    Shard shard() const { return shard_; }
    /// With --resume: whether the file holds the results of this shard already, of runs with these keys, none of which
    /// had a complaint. Says so on standard output.
    bool there(const std::string& json, const std::string& tool, const std::vector<std::string>& keys) const;

private:
    Shard shard_;
    bool resume_ = false;
};

/// The results of all shards of a run. They are those of the run in one piece, but for the seconds, which are added up.
struct Merged {
    std::string tool;
    std::vector<RunResult> runs;
};

/// Throws Error: a file that is no shard, a shard that is missing, there twice, or foreign: of another tool, version,
/// number of shards, run, or hash of the Verilog.
Merged merge_shards(const std::vector<std::string>& files);

}  // namespace glint::io
