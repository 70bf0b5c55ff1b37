#include "io/json_node.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::io {

using Json = nlohmann::json;

JsonNode::JsonNode(const Json& json, const std::string& file, std::string name)
    : json_(json), file_(file), name_(std::move(name)) {
    if (!json_.is_object()) throw Error(file_ + (name_.empty() ? "" : ": " + name_) + " is not a JSON object");
}

bool JsonNode::has(const char* key) const { return json_.contains(key) && !json_[key].is_null(); }

JsonNode JsonNode::node(const char* key) const { return {value(key), file_, path(key)}; }

std::vector<JsonNode> JsonNode::nodes(const char* key) const {
    const Json& list = value(key);
    if (!list.is_array()) fail(key, "a list");
    std::vector<JsonNode> out;
    for (std::size_t i = 0; i < list.size(); ++i) {
        out.emplace_back(list[i], file_, fmt::format("{}[{}]", path(key), i));
    }
    return out;
}

std::string JsonNode::text(const char* key) const {
    if (!value(key).is_string()) fail(key, "a text");
    return value(key).get<std::string>();
}

std::string JsonNode::word(const char* key) const {
    const std::string out = text(key);
    const bool legal = !out.empty() && std::all_of(out.begin(), out.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    if (!legal) fail(key, "a name of letters, digits, '_' and '-'");
    return out;
}

std::vector<std::string> JsonNode::texts(const char* key) const {
    const Json& list = value(key);
    const auto is_text = [](const Json& item) { return item.is_string(); };
    if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_text)) fail(key, "a list of texts");
    return list.get<std::vector<std::string>>();
}

bool JsonNode::boolean(const char* key) const {
    if (!value(key).is_boolean()) fail(key, "true or false");
    return value(key).get<bool>();
}

double JsonNode::number(const char* key) const {
    if (!value(key).is_number() || !(value(key).get<double>() >= 0.0)) fail(key, "a number, 0 or more");
    return value(key).get<double>();
}

std::vector<double> JsonNode::numbers(const char* key) const {
    const Json& list = value(key);
    const auto good = [](const Json& item) { return item.is_number() && item.get<double>() >= 0.0; };
    if (!list.is_array() || !std::all_of(list.begin(), list.end(), good)) fail(key, "a list of numbers, 0 or more");
    return list.get<std::vector<double>>();
}

std::uint64_t JsonNode::count(const char* key, std::uint64_t low, std::uint64_t high) const {
    const bool whole = value(key).is_number_unsigned();
    if (!whole || value(key).get<std::uint64_t>() < low || value(key).get<std::uint64_t>() > high) {
        fail(key, high == UINT64_MAX ? fmt::format("a whole number, {} or more", low)
                                     : fmt::format("a whole number, {} to {}", low, high));
    }
    return value(key).get<std::uint64_t>();
}

int JsonNode::integer(const char* key, int low, int high) const {
    return static_cast<int>(count(key, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high)));
}

std::vector<std::uint32_t> JsonNode::counts(const char* key, std::size_t size) const {
    const Json& list = value(key);
    const auto good = [](const Json& item) {
        return item.is_number_unsigned() && item.get<std::uint64_t>() <= UINT32_MAX;
    };
    if (!list.is_array() || list.size() != size || !std::all_of(list.begin(), list.end(), good)) {
        fail(key, fmt::format("a list of {} whole numbers", size));
    }
    return list.get<std::vector<std::uint32_t>>();
}

void JsonNode::fail(const char* key, std::string_view legal) const {
    std::string shown = value(key).dump(-1, ' ', true);
    if (shown.size() > 40) shown = shown.substr(0, 40) + "...";
    throw Error(fmt::format("{}: {} {} is not legal: {}", file_, path(key), shown, legal));
}

std::string JsonNode::path(const char* key) const { return name_.empty() ? key : fmt::format("{}.{}", name_, key); }

const Json& JsonNode::value(const char* key) const {
    if (!json_.contains(key)) throw Error(fmt::format("{}: {} is missing", file_, path(key)));
    return json_[key];
}

Json read_json(const std::string& path, const std::string& name) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    if (!stream || !(text << stream.rdbuf())) throw Error(name + " cannot be read");
    Json json = Json::parse(text.str(), nullptr, false);
    if (json.is_discarded()) throw Error(name + " is not JSON");
    return json;
}

}  // namespace glint::io
