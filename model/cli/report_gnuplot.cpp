#include "report_gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "common.hpp"
#include "glint/error.hpp"

extern char** environ;  // POSIX: no header declares it

namespace glint::cli {
namespace {

namespace fs = std::filesystem;

fs::path find_on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path candidate = fs::path(folder.empty() ? "." : folder) / program;
        std::error_code error;
        if (fs::is_regular_file(candidate, error) && access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    throw Error(
        fmt::format("{} is not on the PATH: install the package `gnuplot-nox` (Debian, Ubuntu) or `gnuplot`", program));
}

/// Removed with everything in it at the end of the scope.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code error;
        std::string name = (fs::temp_directory_path(error) / "glint-report-XXXXXX").string();
        if (error || mkdtemp(name.data()) == nullptr) {
            throw Error(fmt::format("temporary folder '{}' cannot be made: {}", name,
                                    error ? error.message() : std::strerror(errno)));
        }
        path_ = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string read_file(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// For gnuplot: nothing is special between single quotes but the quote itself, which is doubled.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

/// The exit status, or 128 and more after a signal, as a shell has it. Output and errors go to `log`.
int run_program(const fs::path& program, std::vector<std::string> arguments, const fs::path& log) {
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = 0;
    const int failure = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) throw Error(fmt::format("'{}' cannot be run: {}", program.string(), std::strerror(failure)));
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) throw Error(fmt::format("'{}' was lost: {}", program.string(), std::strerror(errno)));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// What gnuplot says about an error, its last line that is not blank, as the end of a sentence.
std::string last_line(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t begin = line.find_first_not_of(" \t^");
        if (begin != std::string::npos) out = ": " + line.substr(begin);
    }
    return out;
}

}  // namespace

Pictures run_gnuplot(const std::string& script, const std::vector<std::string>& pictures) {
    const fs::path gnuplot = find_on_path("gnuplot");
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "report.gp";
    const fs::path log = folder.path() / "log";
    write_file(file, fmt::format("cd {}\n{}", quoted(folder.path().string()), script));
    // -d: a user's own settings would change the pictures.
    const int status = run_program(gnuplot, {"gnuplot", "-d", file.string()}, log);
    const std::string said = last_line(read_file(log));
    if (status != 0) throw Error(fmt::format("gnuplot failed with exit status {}{}", status, said));
    Pictures out;
    for (const std::string& name : pictures) {
        std::string bytes = read_file(folder.path() / name);
        if (bytes.empty()) throw Error(fmt::format("gnuplot ended without writing '{}'{}", name, said));
        out.emplace(name, std::move(bytes));
    }
    return out;
}

}  // namespace glint::cli
