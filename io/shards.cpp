#include "io/shards.hpp"

#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace glint::io {

CLI::Option* ShardOptions::add(CLI::App& app, CLI::Option* json) {
    CLI::Option* shard = app.add_option_function<std::string>(
                                "--shard", [this](const std::string& text) { shard_ = parse_shard(text); },
                                "Part i of N of the run, for glint merge")
                             ->option_text("i/N")
                             ->needs(json);
    app.add_flag("--resume", resume_, "Skip the run where the file of --json holds this shard")
        ->needs(shard)
        ->option_text(" ");
    return shard;
}

bool ShardOptions::there(const std::string& json, const std::string& tool, const std::vector<std::string>& keys) const {
    if (!resume_) return false;
    std::ifstream stream(json, std::ios::binary);
    if (!stream) return false;
    const auto file = nlohmann::json::parse(stream, nullptr, false);
    try {
        if (file.at("tool") != tool || file.at("version") != GLINT_VERSION) return false;
        const nlohmann::json& shard = file.at("shard");
        if (shard.at("index") != shard_.index || shard.at("count") != shard_.count) return false;
        const nlohmann::json& runs = file.at("runs");
        if (runs.size() != keys.size()) return false;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const nlohmann::json& part = runs.at(i).at("part");
            if (part.at("key") != keys[i] || part.at("complaint") != "") return false;
        }
    } catch (const nlohmann::json::exception&) {
        return false;  // whatever it is, it is not this shard
    }
    fmt::print("shard {}/{} is there: {}\n", shard_.index, shard_.count, json);
    return true;
}

}  // namespace glint::io
