// Generated sources: the constants of a lobe on their way to rtl/ and hls/.
#pragma once

#include <optional>
#include <string>

#include "glint/manifest.hpp"

namespace glint {

struct GeneratedFile {
    enum class Target { verilog, hls, proof };
    Target target = Target::verilog;
    std::string name;  ///< file name without a folder
    std::string text;
    std::optional<HardwareUnit> unit{};  ///< where it is the top module of one
};

}  // namespace glint
