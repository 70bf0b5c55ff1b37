// The scripts of page/ as child processes.
#pragma once

#include <filesystem>
#include <string>

namespace glint::io {

/// Runs a script of page/ (in the tree, or installed under share/glint) as `script JSON -o output`, with `json` in a
/// temporary file, and prints the files that it says it wrote. Throws Error: no Python, no script, or the last line of
/// a script that failed.
void run_page_script(const std::string& script, const std::string& json, const std::filesystem::path& output);

}  // namespace glint::io
