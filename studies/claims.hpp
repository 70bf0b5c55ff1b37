// What the two papers say, claim by claim, and how it stands to what is measured and computed here.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "studies/paper2_data.hpp"
#include "studies/paper_data.hpp"

namespace glint::studies {

struct Claim {
    std::string id;  ///< "delta-bps-largest"
    std::string says;
    std::string_view source;  ///< its place in the paper; may be empty
    /// A number in `unit`, a text where no number says it, or null.
    nlohmann::ordered_json printed, measured;
    std::string_view unit;     ///< "%" for a fraction shown in percent, "times", or empty
    int digits = 0;            ///< of the measured number, after the point
    std::string_view verdict;  ///< "true", "true in part", "not true" or "not measured"
    std::string_view reason;   ///< names what explains a difference; empty: it needs none, or has none
    nlohmann::ordered_json numbers = nlohmann::ordered_json::object();  ///< what the reason is told with
};

/// What one evaluation costs on a processor: nanoseconds, or instructions.
enum class Cost { latency, throughput, instructions, batch };
std::string_view name_of(Cost cost);

/// The cost of a formula or model by name, in "double" or "float"; nothing where it was not measured.
using Costs = std::function<std::optional<double>(std::string_view name, std::string_view type, Cost cost)>;

/// How far from a printed ratio a measured time may be to count as the same.
inline constexpr double time_tolerance = 0.1;

/// Errors, comparisons, and how much longer f_bps takes than f_s in double. `costs` knows formulas (studies/forms.hpp).
std::vector<Claim> claims_of_paper_1(const PaperData& data, const Costs& costs);

/// What is counted and computed.
std::vector<Claim> claims_of_paper_2(const Paper2Data& data);

/// What is timed. `costs` knows lighting models by CountedModel::name.
std::vector<Claim> processor_claims_of_paper_2(const Paper2Data& data, const Costs& costs);

nlohmann::ordered_json to_json(const std::vector<Claim>& claims);

/// A line a claim, for people.
std::string claims_table(const std::vector<Claim>& claims);

}  // namespace glint::studies
