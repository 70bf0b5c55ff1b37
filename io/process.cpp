#include "io/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "glint/error.hpp"

extern char** environ;  // POSIX: no header declares it

namespace glint::io {

namespace fs = std::filesystem;

std::optional<fs::path> find_on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path candidate = fs::path(folder.empty() ? "." : folder) / program;
        std::error_code error;
        if (fs::is_regular_file(candidate, error) && access(candidate.c_str(), X_OK) == 0) {
            return fs::absolute(candidate);
        }
    }
    return std::nullopt;
}

TemporaryFolder::TemporaryFolder() {
    const SignalsWait signals;
    std::error_code error;
    std::string name = (fs::absolute(fs::temp_directory_path(error)) / "glint-XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr) {
        throw Error(fmt::format("temporary folder '{}' cannot be made: {}", name,
                                error ? error.message() : std::strerror(errno)));
    }
    path_ = name;
    cleanup_.emplace(Cleanup::Kind::folder, name);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

const int out_of_time = 128 + SIGXCPU;

int run_program(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& folder,
                const fs::path& log, std::optional<unsigned> cpu_seconds) {
    std::vector<std::string> words{program.filename().string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    pid_t child = 0;
    std::optional<SignalsWait> signals(std::in_place);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setsigmask(&attributes, &signals->before());
    const int failure = posix_spawn(&child, program.c_str(), &actions, &attributes, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (failure != 0) throw Error(fmt::format("'{}' cannot be run: {}", program.string(), std::strerror(failure)));
    const Cleanup cleanup(child);
    signals.reset();
    if (cpu_seconds) {
        const rlimit limit{*cpu_seconds, *cpu_seconds + 10};
        prlimit(child, RLIMIT_CPU, &limit, nullptr);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) throw Error(fmt::format("'{}' was lost: {}", program.string(), std::strerror(errno)));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string read_file(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) throw Error(fmt::format("file '{}' cannot be read", path.string()));
    return text.str();
}

std::string last_line(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t begin = line.find_first_not_of(" \t^\r");
        if (begin != std::string::npos) out = line.substr(begin);
    }
    return out;
}

}  // namespace glint::io
