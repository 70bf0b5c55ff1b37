// Output files, and what people see: progress, tables.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "glint/parallel.hpp"

namespace glint::io {

/// Writes a file whole or not at all: under a temporary name beside it, then renamed. A pipe or device is written to
/// directly. Throws Error.
void write_file(const std::filesystem::path& path, std::string_view text);

/// JSON and a line feed. Bytes that are no UTF-8, which a command line or a file's name may hold, become U+FFFD.
std::string json_text(const nlohmann::ordered_json& json, int indent = -1);

/// write_file of it.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json, int indent = 1);

/// While it is there, other runs that want to change a file of the same folder wait: one that reads a file, merges its
/// own results and writes it again. Where the file system has no locks there is none.
class FolderLock {
public:
    /// An empty path is fine: no lock.
    explicit FolderLock(const std::filesystem::path& file);
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

private:
    int folder_ = -1;
};

/// Before work that takes time: throws Error, the line of write_file, where that would not be able to write. An empty
/// path is fine.
void check_writable(const std::filesystem::path& path);

/// True where the two names are of one place, whether a file is there or not.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// check_writable of both. Throws Error where they are one file, and no device.
void check_writable(const std::filesystem::path& one, const std::filesystem::path& other);

/// Makes the folder if it is not there. Throws Error.
void make_folder(const std::filesystem::path& folder);

/// A bar on stderr for work that takes longer than two seconds, when stderr is a terminal.
Progress progress_bar(std::string label);

/// Columns aligned; the first row is the heading, numbers to the right.
std::string table(const std::vector<std::vector<std::string>>& rows);

}  // namespace glint::io
