#include "io/files.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::io {

namespace {

/// /dev/stdout and other pipes and devices, which are written to; renaming would put a file in their place.
bool is_device(const std::filesystem::path& path) {
    std::error_code unknown;
    const std::filesystem::file_status there = std::filesystem::status(path, unknown);
    return std::filesystem::exists(there) && !std::filesystem::is_regular_file(there) &&
           !std::filesystem::is_directory(there);
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error(fmt::format("folder '{}' cannot be made: {}", folder.string(), error.message()));
}

void write_file(const std::filesystem::path& path, std::string_view text) {
    const bool device = is_device(path);
    // The process number keeps two commands that write the same file apart.
    std::filesystem::path temporary = path;
    if (!device) temporary += fmt::format(".{}.tmp", getpid());
    std::ofstream file(temporary, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    std::error_code error;
    if (file && !device) std::filesystem::rename(temporary, path, error);
    if (!file || error) {
        std::error_code ignored;
        if (!device) std::filesystem::remove(temporary, ignored);
        throw Error(fmt::format("file '{}' cannot be written", path.string()));
    }
}

void check_writable(const std::filesystem::path& path) {
    if (path.empty()) return;
    std::error_code unknown;
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const bool good =
        is_device(path) || (!std::filesystem::is_directory(path, unknown) &&
                            std::filesystem::is_directory(folder, unknown) && access(folder.c_str(), W_OK) == 0);
    if (!good) throw Error(fmt::format("file '{}' cannot be written", path.string()));
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto place = [](const std::filesystem::path& file) {
        std::error_code unknown;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(file, unknown), unknown);
    };
    return place(a) == place(b);
}

void check_writable(const std::filesystem::path& one, const std::filesystem::path& other) {
    check_writable(one);
    check_writable(other);
    if (!one.empty() && !other.empty() && !is_device(one) && same_file(one, other)) {
        throw Error(fmt::format("file '{}' is not legal: two options name it", other.string()));
    }
}

Progress progress_bar(std::string label) {
    if (!isatty(STDERR_FILENO)) return {};
    using clock = std::chrono::steady_clock;
    return [label = std::move(label), start = clock::now(), last = clock::time_point{}](double done) mutable {
        const auto now = clock::now();
        const bool end = done >= 1.0;
        if (now - start < std::chrono::seconds(2) || (!end && now - last < std::chrono::milliseconds(100))) return;
        last = now;
        constexpr int width = 40;
        const auto filled = static_cast<std::size_t>(done * width);
        const double seconds = std::chrono::duration<double>(now - start).count();
        fmt::print(stderr, "\r{} [{}{}] {:3.0f} % {:4.0f} s{}", label, std::string(filled, '#'),
                   std::string(width - filled, '.'), 100.0 * done, seconds, end ? "\n" : "");
        std::fflush(stderr);
    };
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string out;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool number = !row[i].empty() && std::isdigit(static_cast<unsigned char>(row[i][0])) != 0;
            const bool heading = &row == &rows.front();
            line +=
                number || heading ? fmt::format("{:>{}}", row[i], widths[i]) : fmt::format("{:<{}}", row[i], widths[i]);
            if (i + 1 < row.size()) line += "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + '\n';
    }
    return out;
}

}  // namespace glint::io
