// The lobes that have a golden model; which, says model/registry.cmake.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/architecture.hpp"
#include "glint/emit.hpp"
#include "glint/golden.hpp"
#include "glint/hard_cases.hpp"

namespace glint {

struct Lobe {
    std::string_view name;     ///< as on the command line and in every file name
    std::string_view formula;  ///< for people
    std::string_view custom;   ///< what the numbers of a custom profile mean, e.g. "F,S,K,O"
    /// The real function, in [0, 1]. Any arguments: those outside the domain have the answers of glint/reference.hpp.
    double (*reference)(double c, double n);
    /// Throws Error when the profile is not legal for the lobe; so does `emit`.
    std::unique_ptr<GoldenModel> (*golden)(const Profile&);
    /// The architecture sets the defaults of the wrappers' parameters.
    std::vector<GeneratedFile> (*emit)(const Profile&, const Architecture&);
    std::vector<HardCase> (*hard_cases)(const GoldenModel&);
    /// Word lengths that the lobe's rule picks for F and O; for a shipped F and O, those of the shipped profile.
    std::vector<int> (*numbers)(int F, int O) = nullptr;
    std::string_view options = {};  ///< what may follow the name after a ':'; empty: nothing
    bool divider = false;           ///< its unit divides: the divider can be chosen
    bool deep = false;              ///< its unit can have more registers: the architecture "pipelined:deep"
    bool block = false;             ///< its tables can be put into block memory: the architecture "pipelined:block"
    double bound_ulp = 1.0;  ///< the rounding error of a shipped profile is below it, in ulps, at every legal input
    /// A number that the error against the real function is not above, at any legal input of a profile: proven, in less
    /// time than trying them takes. Null: there is none but `bound_ulp`. Throws Error when the profile is not legal.
    double (*error_bound)(const Profile&) = nullptr;
};

/// All lobes, in the order of model/registry.cmake.
std::span<const Lobe> lobes();

/// Throws Error with the list of the known lobes.
const Lobe& find_lobe(std::string_view name);

/// A lobe, and what followed its name: "polynomial:symmetric:0:0:3:-2".
struct LobeChoice {
    const Lobe* lobe = nullptr;
    std::string options;

    /// "p12", "18,14,14,12": the profile for this choice. Throws Error.
    Profile profile(std::string_view text) const { return with_options(parse_profile(text), options); }
};

/// Throws Error: an unknown lobe, or options for one that takes none.
LobeChoice parse_lobe(std::string_view text);

}  // namespace glint
