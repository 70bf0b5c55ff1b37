// What an evaluation of a lobe costs: the formulas as code, counted.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace glint::studies {

/// Operations of one evaluation.
struct Operations {
    int multiplications = 0, divisions = 0, additions = 0, increments = 0, comparisons = 0;
    int calls = 0;  ///< of exp, acos or pow, from a library

    /// Sum of the latencies of the operations, in cycles; of calls it knows nothing.
    struct Latencies {
        int multiplication, division, addition, increment, comparison;
        friend bool operator==(const Latencies&, const Latencies&) = default;
    };
    int cycles(const Latencies& l) const;
    friend bool operator==(const Operations&, const Operations&) = default;
};

/// Latencies in cycles of scalar double instructions on Zen 4, as LLVM's scheduling model has them
/// (llvm/lib/Target/X86/X86ScheduleZnver4.td: WriteFMul64, WriteFDiv64, WriteFAdd64, WriteFCmp64).
inline constexpr Operations::Latencies zen4_double{3, 13, 3, 3, 1};

/// A formula as code, in the form that the paper counts: run with a number type that counts what is done to it, and
/// with double.
struct Form {
    std::string_view name;     ///< of the formula: the lobe's, but where a lobe has two
    std::string_view lobe;     ///< in the registry
    std::string_view formula;  ///< as evaluated
    int least_n;               ///< the formula is the lobe from this n on
    Operations (*count)();
    double (*value)(double c, double n);
};

/// f_s, f_8, f_kv, f_kub as printed and by Horner's rule, f_bps, then lobes of our own and c^n itself. What f_kub needs
/// for an n is at hand, as from a memory.
std::span<const Form> forms();

}  // namespace glint::studies
