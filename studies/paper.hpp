// What paper 1 prints (Zavalniuk, Romanyuk, Satsiuk 2024: the modified Schlick reflectance model), as data with its
// place in the paper, and how it stands to what is measured.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "studies/forms.hpp"
#include "studies/study.hpp"

namespace glint::studies::paper {

/// The exponents that the paper compares over.
inline constexpr int first_n = 8;
inline constexpr int last_n = 1000;

/// A row of Table 1.
struct TableRow {
    std::string_view symbol;  ///< as in the paper, e.g. "f_kv"
    std::string_view lobe;    ///< in the registry
    Operations operations;
    int cycles = 0;
};
std::span<const TableRow> table_1();

/// All latencies of 1 .. `most` cycles with which every row of Table 1 adds up to its cycles.
std::vector<Operations::Latencies> latencies_of_table_1(int most);

enum class Measure { delta, absolute };
enum class Statistic {
    largest,  ///< over first_n .. last_n
    median,   ///< what the paper says of "most of" that range is held against the median
};

struct Claim {
    std::string_view lobe;
    Measure measure;
    Statistic statistic;
    double printed;     ///< a fraction, 0.11 for 11 %
    double half_digit;  ///< half a unit of the last printed digit
    std::string_view source;
};
std::span<const Claim> claims();

/// "f_bps is ten times better than f_s", of delta and of Delta.
inline constexpr double printed_ratio = 10.0;

/// Differences up to this need no explanation.
inline constexpr double tolerance = 0.05;

struct Check {
    double measured = 0.0;    ///< the statistic of the claim
    double difference = 0.0;  ///< relative to what is printed
    int n_rounding = 0;       ///< exponents at which the measured value rounds to the printed one
    int n_count = 0;          ///< of so many
    enum Explanation {
        agrees,          ///< within the tolerance
        stepped,         ///< agrees over the angles of the paper's data set, to the first one beyond the zone
        most_exponents,  ///< it is the median that agrees, not the largest
        none,
    } explanation = none;
    double explained = 0.0;             ///< the value that agrees
    double explained_difference = 0.0;  ///< and its difference
};
Check check(const Claim& claim, const Study& study);

/// In how many of the exponents the lobe of studies[index] has the least error of all, from the same rows of all.
int times_best(std::span<const Study> studies, std::size_t index, Measure measure);

}  // namespace glint::studies::paper
