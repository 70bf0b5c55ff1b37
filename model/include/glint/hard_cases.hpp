// Inputs at which a fixed-point lobe could go wrong, by name: one list for the tests, the report and the documents.
#pragma once

#include <string>
#include <vector>

#include "glint/golden.hpp"

namespace glint {

struct HardCase {
    std::string name;
    int n = 0;
    std::int32_t cos_code = 0;
    std::string risk;     ///< what could go wrong there
    std::string covered;  ///< by which test or proof it is covered
};

/// The hard cases of `bps` at the profile of a model; legal and illegal port inputs.
std::vector<HardCase> bps_hard_cases(const GoldenModel& model);

/// The page of hard cases for a lobe (Markdown): each case with what comes out, at every shipped profile, and the cases
/// of the streams, which have no input. `glint cases` prints it; docs/hard-cases.md is its output.
std::string hard_cases_page();

}  // namespace glint
