#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "glint/effect.hpp"
#include "glint/lobes.hpp"
#include "glint/manifest.hpp"

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
            if (name.rfind("glint_effect_", 0) == 0 || entry.path().extension() == ".f") continue;
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
    const std::filesystem::path folders[] = {root / "rtl/generated", root / "hls/generated",
                                             root / "proofs/gappa/effects"};
    std::set<std::filesystem::path> current;
    for (const Effect& effect : effects()) {
        for (const Profile& profile : shipped_profiles()) {
            const auto files = effect.emit(profile, "bps");
            REQUIRE(!files.empty());
            CHECK(current.count(folders[0] / files[0].name) == 0);
            for (const GeneratedFile& file : files) {
                CAPTURE(file.name);
                REQUIRE(static_cast<std::size_t>(file.target) < std::size(folders));
                const auto path = folders[static_cast<std::size_t>(file.target)] / file.name;
                CHECK(contents(path) == file.text);
                current.insert(path);
            }
        }
    }
    for (const auto& folder : folders) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            CAPTURE(entry.path().string());
            const bool of_an_effect =
                entry.path().filename().string().rfind("glint_effect_", 0) == 0 && entry.path().extension() != ".f";
            CHECK((!of_an_effect || current.count(entry.path()) == 1));
        }
    }
    CHECK(current.size() >= 3 * effects().size());
}

TEST_CASE("rtl/units.json is that of the model, and every file that it names is there") {
    const std::filesystem::path rtl = std::filesystem::path(GLINT_SOURCE_DIR) / "rtl";
    const std::vector<HardwareUnit> units = committed_units();
    CHECK(contents(rtl / "units.json") == manifest(units, committed_paths));
    for (const HardwareUnit& unit : units) {
        CAPTURE(unit.name);
        CHECK(unit.files.back().name == unit.name + ".v");
        for (const HardwareUnit::File& file : unit.files) {
            CAPTURE(file.name);
            CHECK(std::filesystem::is_regular_file(rtl / (file.generated ? "generated" : "") / file.name));
        }
        CHECK(unit.architectures.front().latency > 1);
        CHECK(contents(rtl / "generated" / (unit.name + ".f")) == file_list(unit, committed_list));
    }
    for (const auto& entry : std::filesystem::directory_iterator(rtl / "generated")) {
        if (entry.path().extension() != ".f") continue;
        CAPTURE(entry.path().string());
        CHECK(std::count_if(units.begin(), units.end(),
                            [&](const HardwareUnit& unit) { return unit.name == entry.path().stem(); }) == 1);
    }
    CHECK(units.size() >= 3 * (lobes().size() + effects().size()));
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
            REQUIRE(files.size() == 2);  // and that of its lobe
            REQUIRE(of_bps.size() == 2);
            const std::string renamed = replaced(of_bps[0].text, "_bps_", "_" + name + "_");
            CHECK(files[0].text == replaced(renamed, "--lobe bps ", "--lobe " + name + " "));
        }
    }
}
