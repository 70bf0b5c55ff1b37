// Fuzz targets: each is a parser and what holds of every input of it. One program has them all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint::fuzz {

struct Target {
    std::string_view name;  ///< of its folder of inputs, too
    void (*run)(const std::string& text);
};

/// Those that this program is linked with, by name.
const std::vector<Target>& targets();

/// Every target is one file of the build, which adds itself before main() starts.
struct Registration {
    Registration(std::string_view name, void (*run)(const std::string& text));
};

}  // namespace glint::fuzz
