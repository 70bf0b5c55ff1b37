// What other tools find the Verilog by: FuseSoC cores, VHDL packages, a Bender package. All from the manifest.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "glint/emit.hpp"

namespace glint::cli {

/// A path in the folder that is written to, and the text of the file.
using PackageFile = std::pair<std::filesystem::path, std::string>;

/// For each file of Verilog a FuseSoC core (CAPI2), for each unit a VHDL package with its component. The cores name the
/// Verilog in `folder` ("" or "generated"); the files by hand are those of the core glint:rtl:by_hand.
std::vector<PackageFile> packages(const std::vector<GeneratedFile>& files, const std::filesystem::path& folder);

/// The core glint:rtl:by_hand: every file by hand that these units are made of, relative to rtl/.
std::string by_hand_core(std::span<const HardwareUnit> units);

/// Bender.yml of rtl/, with every file of these units.
std::string bender(std::span<const HardwareUnit> units);

}  // namespace glint::cli
