// The registry: every lobe that has a golden model.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "glint/emit.hpp"
#include "glint/golden.hpp"
#include "glint/hard_cases.hpp"

namespace glint {

struct Lobe {
    std::string_view name;     ///< as on the command line and in every file name
    std::string_view formula;  ///< for people
    std::string_view custom;   ///< what the numbers of a custom profile mean
    double (*reference)(double c, double n);
    std::unique_ptr<GoldenModel> (*golden)(const Profile&);
    std::vector<GeneratedFile> (*emit)(const Profile&);
    std::vector<HardCase> (*hard_cases)(const GoldenModel&);
};

std::span<const Lobe> lobes();

/// Throws Error with the list of the known lobes.
const Lobe& find_lobe(std::string_view name);

}  // namespace glint
