// What the report says of paper 2's two forms of Cook-Torrance as hardware.
#pragma once

#include "cli/report/rooms.hpp"

#include <optional>
#include <string>

#include "cli/report/cost_page.hpp"

namespace glint::cli {

/// The clocks and the area of the full and of the modified form, by device and profile; without their prices, what
/// writes them.
std::string paper2_hardware_section(const std::optional<CostReport>& cost);

}  // namespace glint::cli
