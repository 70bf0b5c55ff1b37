// Everything that is known of the two papers and of the lobes as real functions, as one JSON object: for `glint study
// --json`, and for the page.
#pragma once

#include <nlohmann/json.hpp>

#include "studies/claims.hpp"

namespace glint::studies {

struct Findings {
    PaperData paper_1 = paper_data();
    Paper2Data paper_2 = paper2_data();
    std::vector<Claim> claims_1, claims_2, processor_claims_2;
};

/// Computes all of it: seconds. Where nothing is timed, `costs` returns nothing.
Findings find(const Costs& formulas, const Costs& models);

/// Real numbers have seven digits. "curves", "schlick", "map" and "surfaces" hold the points of plots; "lobes" the
/// errors of every lobe at n = 1 .. 1000 with what sums them up; "paper_1" and "paper_2" the claims, and what they rest
/// on.
nlohmann::ordered_json to_json(const Findings& findings);

}  // namespace glint::studies
