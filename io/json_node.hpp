// JSON files of this project, read back: every error is one line with the file, the field and what is legal.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace glint::io {

/// `name` is what errors call the file: "results file 'build/cosim.json'". Throws Error: not readable, not JSON.
nlohmann::json read_json(const std::string& path, const std::string& name);

/// A JSON object of a file, which knows its name for errors; the name of the outermost object is empty. Keeps
/// references: the file's JSON and its name have to outlive it. Every member throws Error when the field is missing or
/// is not of its kind.
class JsonNode {
public:
    JsonNode(const nlohmann::json& json, const std::string& file, std::string name = {});

    bool has(const char* key) const;  ///< there, and not null
    JsonNode node(const char* key) const;
    std::vector<JsonNode> nodes(const char* key) const;
    std::string text(const char* key) const;
    /// A name goes into the scripts of the plots as it is, so it may hold no quotes and no line breaks.
    std::string word(const char* key) const;
    std::vector<std::string> texts(const char* key) const;
    bool boolean(const char* key) const;
    double number(const char* key) const;  ///< at least 0
    std::vector<double> numbers(const char* key) const;
    std::uint64_t count(const char* key, std::uint64_t low, std::uint64_t high = UINT64_MAX) const;
    int integer(const char* key, int low, int high) const;
    /// `size` whole numbers, 0 or more.
    std::vector<std::uint32_t> counts(const char* key, std::size_t size) const;

    [[noreturn]] void fail(const char* key, std::string_view legal) const;

private:
    std::string path(const char* key) const;
    const nlohmann::json& value(const char* key) const;

    const nlohmann::json& json_;
    const std::string& file_;
    std::string name_;
};

}  // namespace glint::io
