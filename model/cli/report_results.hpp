// The JSON result files, read back and checked.
#pragma once

#include <string>
#include <vector>

#include "results.hpp"

namespace glint::cli {

struct ResultFile {
    std::string path;
    std::string tool;
    std::string version;
    std::string command;  ///< the command line that measured it
    std::vector<RunResult> runs;
};

/// Throws Error, one line with the file, the field and what is legal: a file that is missing or is no result file, one
/// without runs, a run without inputs.
ResultFile read_results(const std::string& path);

/// A run that measured errors, with the file that it stands in.
struct MeasuredRun {
    const RunResult* run = nullptr;
    const ResultFile* file = nullptr;

    std::string name() const { return run->lobe + " " + run->profile; }
    const SweepResult& accuracy() const { return *run->accuracy; }
};

/// For every lobe and profile the run that measured the most inputs, in the order of the files. Points into `files`.
std::vector<MeasuredRun> measured_runs(const std::vector<ResultFile>& files);

}  // namespace glint::cli
