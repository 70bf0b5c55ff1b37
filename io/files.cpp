#include "io/files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "glint/error.hpp"
#include "io/cleanup.hpp"

namespace glint::io {

namespace {

/// /dev/stdout and other pipes and devices, which are written to; renaming would put a file in their place.
bool is_device(const std::filesystem::path& path) {
    std::error_code unknown;
    const std::filesystem::file_status there = std::filesystem::status(path, unknown);
    return std::filesystem::exists(there) && !std::filesystem::is_regular_file(there) &&
           !std::filesystem::is_directory(there);
}

/// Writes all of it, and closes the file. Returns what went wrong, or 0.
int write_and_close(int file, std::string_view text) {
    int error = 0;
    while (!text.empty() && error == 0) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    if (::close(file) != 0 && error == 0) error = errno;
    return error;
}

Error not_written(const std::filesystem::path& path, int error) {
    return Error(fmt::format("file '{}' cannot be written: {}", path.string(), std::strerror(error)));
}

/// A new file beside `path`, which replaces it in the end.
class NewFile {
public:
    /// Throws Error.
    explicit NewFile(const std::filesystem::path& path) : path_(path) {
        const SignalsWait signals;
        // The process number keeps two runs apart, the other number two machines that share a disk.
        for (int i = 0; file_ < 0; ++i) {
            name_ = fmt::format("{}.{}-{}.tmp", path.string(), getpid(), i);
            file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (file_ < 0 && (errno != EEXIST || i == 1000)) throw not_written(path, errno);
        }
        cleanup_.emplace(Cleanup::Kind::file, name_);
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile() {
        if (!done_) ::unlink(name_.c_str());
    }

    /// Throws Error.
    void replace(std::string_view text) {
        int error = write_and_close(file_, text);
        if (error == 0 && ::rename(name_.c_str(), path_.c_str()) != 0) error = errno;
        if (error != 0) throw not_written(path_, error);
        done_ = true;
    }

private:
    const std::filesystem::path& path_;
    std::string name_;
    int file_ = -1;
    bool done_ = false;
    std::optional<Cleanup> cleanup_;
};

}  // namespace

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error(fmt::format("folder '{}' cannot be made: {}", folder.string(), error.message()));
}

void write_file(const std::filesystem::path& path, std::string_view text) {
    if (!is_device(path)) {
        NewFile(path).replace(text);
        return;
    }
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    const int error = file < 0 ? errno : write_and_close(file, text);
    if (error != 0) throw not_written(path, error);
}

std::string json_text(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json, int indent) {
    write_file(path, json_text(json, indent));
}

FolderLock::FolderLock(const std::filesystem::path& file) {
    if (file.empty()) return;
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    while (folder_ >= 0 && ::flock(folder_, LOCK_EX) != 0 && errno == EINTR) {
    }
}

FolderLock::~FolderLock() {
    if (folder_ >= 0) ::close(folder_);
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
