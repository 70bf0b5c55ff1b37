#include "io/command.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <new>
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

/// What is wrong with the arguments. Where a subcommand is missing, CLI11 does not say what stood in its place.
std::string explain(const CLI::ParseError& error, const CLI::App& app) {
    const std::vector<std::string> extra = app.remaining();
    if (app.get_require_subcommand_min() == 0 || !app.get_subcommands().empty() || extra.empty()) return error.what();
    std::string known;
    for (const CLI::App* command : app.get_subcommands(std::function<bool(const CLI::App*)>())) {
        known += fmt::format("{}{}", known.empty() ? "" : ", ", command->get_name());
    }
    return fmt::format("subcommand '{}' is not known: {}", extra.front(), known);
}

/// Throws Error for an argument without a character, as a shell variable that is not set gives: CLI11 reads it as a 0,
/// or as an option that is not there.
void refuse_empty(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view text = argv[i];
        const std::string_view before = argv[i - 1];
        const bool option = before.size() > 1 && before.front() == '-' && i > 1;
        if (before == "--n") continue;  // refused wherever it is read, with what is legal
        if (text.empty()) {
            throw Error(fmt::format("{} '' is not legal: an empty text is no value", option ? before : "argument"));
        }
        if (text.starts_with("--") && text.find('=') == text.size() - 1) {
            throw Error(fmt::format("{} '' is not legal: an empty text is no value", text.substr(0, text.size() - 1)));
        }
    }
}

/// Throws Error unless all that was printed has arrived.
void flush_output() {
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw Error("standard output cannot be written");
    }
}

}  // namespace

int run(CLI::App& app, int argc, char** argv, const std::function<int()>& command) {
    app.set_version_flag("--version", GLINT_VERSION);
    try {
        int status = success;
        try {
            app.parse(argc, argv);
            refuse_empty(argc, argv);
            status = command();
        } catch (const CLI::ParseError& error) {
            if (error.get_exit_code() != 0) throw;
            status = app.exit(error);  // --help, --version
        }
        flush_output();  // here a failure can be told
        return status;
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "{}: {} (see {} --help)\n", app.get_name(), explain(error, app), app.get_name());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "{}: there is not enough memory\n", app.get_name());
    } catch (const Error& error) {
        fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
    } catch (const std::system_error&) {  // fmt::print
        fmt::print(stderr, "{}: standard output cannot be written\n", app.get_name());
    }
    return bad_arguments;
}

std::int64_t parse_integer(std::string_view text, std::string_view what, std::int64_t low, std::int64_t high) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || number < low || number > high) {
        throw Error(fmt::format("{} '{}' is not legal: {} to {}", what, text, low, high));
    }
    return number;
}

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

std::vector<std::string> split_profiles(const std::string& text) {
    std::vector<std::string> out;
    bool open = false;  // the last entry is a custom profile that may go on
    std::string field;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        if (i < text.size() && text[i] != ',' && text[i] != ';') {
            field += text[i];
            continue;
        }
        const bool number = !field.empty() && std::all_of(field.begin(), field.end(),
                                                          [](unsigned char c) { return std::isdigit(c) != 0; });
        if (number && open) {
            out.back() += ',' + field;
        } else {
            out.push_back(field);
        }
        open = number && i < text.size() && text[i] == ',';
        field.clear();
    }
    return out;
}

std::vector<std::string> split_list(const std::string& text) {
    std::vector<std::string> out;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        out.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

std::vector<LobeChoice> split_lobes(const std::string& text) {
    std::vector<LobeChoice> out;
    if (text == "all") {
        for (const Lobe& lobe : lobes()) out.push_back({&lobe, {}});
        return out;
    }
    for (const std::string& name : split_list(text)) out.push_back(parse_lobe(name));
    return out;
}

std::vector<std::unique_ptr<GoldenModel>> models(const std::string& lobes, const std::string& profiles) {
    std::vector<std::unique_ptr<GoldenModel>> out;
    for (const LobeChoice& choice : split_lobes(lobes)) {
        for (const std::string& profile : split_profiles(profiles)) {
            out.push_back(choice.lobe->golden(choice.profile(profile)));
        }
    }
    return out;
}

}  // namespace glint::io
