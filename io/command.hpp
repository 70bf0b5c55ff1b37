// What the commands share: the frame of a command line.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "glint/lobes.hpp"
#include "io/files.hpp"

namespace glint::io {

/// The exit statuses of every command.
enum Exit { success = 0, check_failed = 1, bad_arguments = 2 };

/// Parses the command line, runs `command` and turns errors into one line on stderr and an exit status.
int run(CLI::App& app, int argc, char** argv, const std::function<int()>& command);

inline constexpr std::int64_t largest_seed = INT64_MAX;
inline constexpr std::int64_t most_threads = 1024;

/// A decimal integer in low..high; `what` names the argument. Throws Error.
std::int64_t parse_integer(std::string_view text, std::string_view what, std::int64_t low, std::int64_t high);

/// An option that takes a decimal integer in low..high. (CLI11 by itself reads 010 as 8 and 0x10 as 16.)
template <class Integer>
CLI::Option* add_integer(CLI::App& app, const std::string& name, Integer& value, std::int64_t low, std::int64_t high,
                         const std::string& description) {
    return app
        .add_option_function<std::string>(
            name,
            [&value, name, low, high](const std::string& text) {
                value = static_cast<Integer>(parse_integer(text, name, low, high));
            },
            description)
        ->type_name("INT")
        ->default_str(std::to_string(value));
}

/// An option that takes a number in low..high.
CLI::Option* add_real(CLI::App& app, const std::string& name, double& value, double low, double high,
                      const std::string& description);

/// "a,b" -> a; b. There is always one: an empty text is an empty one.
std::vector<std::string> split_list(const std::string& text);

/// "bps,schlick", or "all": every lobe of the registry. Throws Error.
std::vector<LobeChoice> split_lobes(const std::string& text);

/// The golden models of every pair of the two comma separated lists, lobes outermost. A custom profile holds commas
/// itself: its numbers are taken together. Throws Error.
std::vector<std::unique_ptr<GoldenModel>> models(const std::string& lobes, const std::string& profiles);

/// "p8,18,14,14,12,p12" -> p8; 18,14,14,12; p12. A custom profile ends where a name begins or where its numbers are
/// separated by ';' from the next one. Throws Error.
std::vector<std::string> split_profiles(const std::string& text);

}  // namespace glint::io
