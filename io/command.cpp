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
#include "io/cleanup.hpp"

namespace glint::io {

namespace {

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

/// The error as one line. Arguments that it echoes may be long, and hold what moves a terminal's cursor.
void tell(const CLI::App& app, std::string message, int argc, char** argv) {
    constexpr std::size_t most = 200;
    for (int i = 1; i < argc; ++i) {
        const std::string text = argv[i];
        if (text.size() <= most) continue;
        for (std::size_t at = message.find(text); at != message.npos; at = message.find(text, at + most))
            message.replace(at, text.size(), text.substr(0, most) + "...");
    }
    const auto moves = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    std::replace_if(message.begin(), message.end(), moves, ' ');
    fmt::print(stderr, "{}: {}\n", app.get_name(), message);
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
    clean_up_when_interrupted();
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
        tell(app, fmt::format("{} (see {} --help)", explain(error, app), app.get_name()), argc, argv);
    } catch (const std::bad_alloc&) {
        tell(app, "there is not enough memory", argc, argv);
    } catch (const Error& error) {
        tell(app, error.what(), argc, argv);
    } catch (const std::filesystem::filesystem_error& error) {
        tell(app, error.what(), argc, argv);
    } catch (const std::system_error&) {  // fmt::print
        tell(app, "standard output cannot be written", argc, argv);
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

CLI::Option* add_real(CLI::App& app, const std::string& name, double& value, double low, double high,
                      const std::string& description) {
    const auto take = [&value, name, low, high](const std::string& text) {
        double x = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
        if (error != std::errc{} || end != text.data() + text.size() || !(x >= low && x <= high)) {
            throw Error(fmt::format("{} '{}' is not legal: a number from {} to {}", name, text, low, high));
        }
        value = x;
    };
    return app.add_option_function<std::string>(name, take, description)->type_name("FLOAT");
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
