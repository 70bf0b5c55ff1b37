// Inputs at which a fixed-point lobe could go wrong, by name: one list for the tests, the report and the documents.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glint/golden.hpp"

namespace glint {

struct Effect;
struct Lobe;

struct HardCase {
    std::string name;
    int n = 0;
    std::int32_t cos_code = 0;
    std::string risk;  ///< what could go wrong there
    /// Ids of the tests and proofs that cover it; by default those that meet every legal input.
    std::vector<std::string_view> covered{"exhaustive", "kernel", "oracle"};
};

/// Hard cases as texts, for a document: each with what could go wrong, what comes out, and the ids of what covers it,
/// with
/// ", " between them.
struct HardCaseTable {
    std::string title;
    std::vector<std::string> columns;
    std::size_t sentences = 0;  ///< so many columns, from the first, hold words that may be broken into lines
    std::vector<std::vector<std::string>> rows;
};

/// The cases of a lobe, at every shipped profile.
HardCaseTable hard_case_table(const Lobe& lobe);

/// The cases of an effect, at p12; of one that is made of a lobe, with f_bps.
HardCaseTable effect_case_table(const Effect& effect);

/// The cases of pictures: scenes and models, for which no input of a unit stands.
HardCaseTable render_case_table();

/// The cases of the streams, which have no input.
HardCaseTable stream_case_table();

/// What the tables show and how to read it, for their heading (Markdown).
std::string_view hard_case_legend();

}  // namespace glint
