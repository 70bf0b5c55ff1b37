// gnuplot as a child process.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace glint::io {

/// The bytes of pictures by file name.
using Pictures = std::map<std::string, std::string>;

/// Runs a script in a temporary folder and reads back the pictures that it is to write there. Throws Error: gnuplot not
/// on the PATH (the line names the package), gnuplot failing (with what it said), a picture missing or empty.
Pictures run_gnuplot(const std::string& script, const std::vector<std::string>& pictures);

}  // namespace glint::io
