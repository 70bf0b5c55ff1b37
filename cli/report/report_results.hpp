// The JSON files of results and of proofs, read back and checked.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>
#include <vector>

#include "io/results.hpp"

namespace glint::cli {

struct ResultFile {
    std::string path;
    std::string tool;
    std::string version;
    std::string command;  ///< the command line that measured it
    std::vector<io::RunResult> runs;
};

/// Throws Error, one line with the file, the field and what is legal: a file that is missing or is no result file, one
/// without runs, a run without inputs.
ResultFile read_results(const std::string& path);

/// What Gappa proves of the rounding error of a lobe at a profile, and what was measured there.
struct Proof {
    struct Measured {
        double ulp = 0.0;
        std::uint64_t inputs = 0;
        bool exhaustive = false;
        std::optional<Worst> worst;  ///< where it lies, and
        int F = 0;                   ///< the fraction bits of its cosine
    };
    std::string lobe;
    std::string profile;
    std::optional<double> ulp;  ///< the bound; none only where something failed
    std::optional<Measured> measured;
    std::vector<std::string> failures;

    std::string name() const { return lobe + " " + profile; }
};

struct ProofsFile {
    std::string command;  ///< the command line that proved it
    std::vector<Proof> proofs;
};

/// A file of proofs/gappa/run.py --json. Throws Error as read_results does.
ProofsFile read_proofs(const std::string& path);

/// A run that measured errors, with the file that it stands in.
struct MeasuredRun {
    const io::RunResult* run = nullptr;
    const ResultFile* file = nullptr;

    std::string name() const { return run->lobe + " " + run->profile; }
    const SweepResult& accuracy() const { return *run->accuracy; }
};

/// For every lobe and profile the run that measured the most inputs, in the order of the files. Points into `files`.
std::vector<MeasuredRun> measured_runs(const std::vector<ResultFile>& files);

}  // namespace glint::cli
