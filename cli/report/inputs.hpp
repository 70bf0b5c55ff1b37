// The files that `glint report` joins, checked.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace glint::cli {

/// A file of `glint-cosim --json` or `glint sweep --json`, as it is. Throws Error, one line with the file, the field
/// and what is legal: a file that is missing or is no result file, one without runs, a run without inputs.
nlohmann::json read_results(const std::string& path);

/// A file of proofs/gappa/run.py --json, as it is. Throws Error as read_results does.
nlohmann::json read_proofs(const std::string& path);

/// What must not be: results that differ from the golden model, proofs that failed, and proven bounds below an error of
/// the results, which need not be those that the proofs were compared with. `proofs` may be null.
nlohmann::ordered_json problems(const std::vector<nlohmann::json>& results, const nlohmann::json& proofs);

}  // namespace glint::cli
