// Running other programs: where they are, what they said, and a folder for their files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/cleanup.hpp"

namespace glint::io {

/// The program in the folders of PATH, as an absolute path.
std::optional<std::filesystem::path> find_on_path(const std::string& program);

/// Removed with everything in it at the end of the scope, or when a signal ends the program.
class TemporaryFolder {
public:
    /// Throws Error.
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::optional<Cleanup> cleanup_;
};

/// The exit status, or 128 and more after a signal, as a shell has it. The program works in `folder`; its output and
/// errors are appended to the file `log`. With `cpu_seconds`, more processor time than that ends it: out_of_time.
/// Throws Error when it cannot be started.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& folder, const std::filesystem::path& log,
                std::optional<unsigned> cpu_seconds = std::nullopt);

/// What run_program returns for a program that had no more time.
extern const int out_of_time;

/// Throws Error.
std::string read_file(const std::filesystem::path& path);

/// The last line that is not blank, without leading blanks; empty when there is none.
std::string last_line(const std::string& text);

}  // namespace glint::io
