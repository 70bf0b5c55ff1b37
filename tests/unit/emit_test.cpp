#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/lobes.hpp"

using namespace glint;

namespace {

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("the committed generated files are those of the model, and every shipped profile has its own") {
    const std::filesystem::path root = GLINT_SOURCE_DIR;
    const std::filesystem::path folders[] = {root / "rtl/generated", root / "hls/generated",
                                             root / "proofs/gappa/generated"};
    // Lobe and profile of a file, from its name: shipped, or custom as numbers joined by '_'.
    const std::regex pattern("glint_([a-z0-9_]+?)_(?:axis_)?(p[0-9]+|[0-9]+(?:_[0-9]+)+)(?:_constants)?\\.[a-z]+");
    std::set<std::string> committed;
    for (std::size_t target = 0; target < std::size(folders); ++target) {
        for (const auto& entry : std::filesystem::directory_iterator(folders[target])) {
            const std::string name = entry.path().filename().string();
            CAPTURE(name);
            if (name.rfind("glint_effect_", 0) == 0) continue;
            std::smatch match;
            REQUIRE(std::regex_match(name, match, pattern));
            std::string profile = match[2];
            std::replace(profile.begin(), profile.end(), '_', ',');
            std::size_t found = 0;
            const Lobe& lobe = find_lobe(match[1].str());
            for (const GeneratedFile& file : lobe.emit(parse_profile(profile), default_architecture(lobe))) {
                if (file.name != name || static_cast<std::size_t>(file.target) != target) continue;
                CHECK(contents(entry.path()) == file.text);
                ++found;
            }
            CHECK(found == 1);
            committed.insert(name);
        }
    }
    for (const Lobe& lobe : lobes()) {
        for (const Profile& profile : shipped_profiles()) {
            for (const GeneratedFile& file : lobe.emit(profile, default_architecture(lobe))) {
                CAPTURE(file.name);
                CHECK(committed.count(file.name) == 1);
            }
        }
    }
    CHECK(committed.size() >= 3 * lobes().size());
}

TEST_CASE("the committed generated files of effects are those of the model, and every shipped profile has its own") {
    const std::filesystem::path root = GLINT_SOURCE_DIR;
    const std::filesystem::path folders[] = {root / "rtl/generated", root / "hls/generated"};
    std::set<std::filesystem::path> current;
    for (const Effect& effect : effects()) {
        for (const Profile& profile : shipped_profiles()) {
            const auto files = effect.emit(profile, "bps");
            CHECK(!files.empty());
            for (const GeneratedFile& file : files) {
                CAPTURE(file.name);
                REQUIRE(static_cast<std::size_t>(file.target) < std::size(folders));
                const auto path = folders[static_cast<std::size_t>(file.target)] / file.name;
                CHECK(contents(path) == file.text);
                CHECK(current.insert(path).second);
            }
        }
    }
    for (const auto& folder : folders) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            CAPTURE(entry.path().string());
            const bool of_an_effect = entry.path().filename().string().rfind("glint_effect_", 0) == 0;
            CHECK((!of_an_effect || current.count(entry.path()) == 1));
        }
    }
    CHECK(current.size() >= 3 * effects().size());
}

TEST_CASE("the wrapper of an effect with another lobe is that with bps, but for the name") {
    // CMake makes use of it (glint_generated_effect).
    const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
            text.replace(at, from.size(), to);
        }
        return text;
    };
    for (const char* effect : {"phong", "blinn_phong"}) {
        for (const Lobe& lobe : lobes()) {
            const std::string name(lobe.name);
            CAPTURE(effect, name);
            const auto files = find_effect(effect).emit(parse_profile("p12"), lobe.name);
            const auto of_bps = find_effect(effect).emit(parse_profile("p12"), "bps");
            REQUIRE(files.size() == 1);
            REQUIRE(of_bps.size() == 1);
            const std::string renamed = replaced(of_bps[0].text, "_bps_", "_" + name + "_");
            CHECK(files[0].text == replaced(renamed, "--lobe bps ", "--lobe " + name + " "));
        }
    }
}
