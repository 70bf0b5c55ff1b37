// What the files of costs lack: a lobe is legal, and its tests pass, without them.
#pragma once

#include <string>
#include <vector>

namespace glint::cost {

/// A line for every lobe of which accuracy.json in a folder lacks a shipped profile, or cpu.json a type or form. Throws
/// Error: a file is missing or not legal.
std::vector<std::string> not_measured(const std::string& folder);

}  // namespace glint::cost
