// The effects that the effect `shade` is made of: docs/effects/shade.md.
#pragma once

#include <string_view>
#include <vector>

namespace glint {

/// In the order of their bits in the port `effects` and in the parameter MASK; the first is "ambient".
std::vector<std::string_view> shade_effects();

}  // namespace glint
