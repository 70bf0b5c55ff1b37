#include <filesystem>
#include <fstream>
#include <map>
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

TEST_CASE("rtl/generated and rtl/units.json are those of the model") {
    const std::filesystem::path rtl = std::filesystem::path(GLINT_SOURCE_DIR) / "rtl";
    const std::vector<GeneratedFile> files = committed_verilog();
    const std::vector<HardwareUnit> units = units_of(files);
    std::map<std::string, std::string> expected;
    for (const GeneratedFile& file : files) expected[file.name] = file.text;
    for (const HardwareUnit& unit : units) {
        CAPTURE(unit.name);
        expected[unit.name + ".f"] = file_list(unit, committed_list);
        CHECK(unit.files.back().name == unit.name + ".v");
        CHECK(unit.architectures.front().latency > 1);
        for (const HardwareUnit::File& file : unit.files) {
            CAPTURE(file.name);
            CHECK(std::filesystem::is_regular_file(rtl / (file.generated ? "generated" : "") / file.name));
        }
    }
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(rtl / "generated")) {
        CAPTURE(entry.path().string());
        const auto file = expected.find(entry.path().filename().string());
        CHECK((file != expected.end() && contents(entry.path()) == file->second));
        ++found;
    }
    CHECK(found == expected.size());
    CHECK(contents(rtl / "units.json") == manifest(units, committed_paths));
    CHECK(units.size() > 3 * (lobes().size() + effects().size()));
}

TEST_CASE("a table is one module: equal names have equal texts, other names other entries") {
    std::map<std::string, std::string> texts, names;  // and of each text without its name, the name
    const auto add = [&](const std::vector<GeneratedFile>& files) {
        for (const GeneratedFile& file : files) {
            if (file.name.rfind("glint_table_", 0) != 0) continue;
            CAPTURE(file.name);
            CHECK(texts.try_emplace(file.name, file.text).first->second == file.text);
            const std::string entries = file.text.substr(file.text.find("case ("));
            CHECK(names.try_emplace(entries, file.name).first->second == file.name);
        }
    };
    for (const Profile& profile : shipped_profiles()) {
        for (const Lobe& lobe : lobes()) add(lobe.emit(profile, default_architecture(lobe)));
        for (const Effect& effect : effects()) add(effect.emit(profile, lobes().front().name));
    }
    CHECK(texts.size() >= 12);
}

TEST_CASE("the committed kernels' constants and proofs are those of the model, and every shipped profile has its own") {
    const std::filesystem::path root = GLINT_SOURCE_DIR;
    // Custom profiles with a committed proof; of effects, proofs have a folder of their own.
    const std::pair<std::string_view, std::string_view> custom[] = {{"bps", "27,23,23,20"}, {"bps", "28,27,27,24"}};
    std::map<std::filesystem::path, std::string> expected;
    const auto add = [&](const std::vector<GeneratedFile>& files, bool effect, bool shipped) {
        for (const GeneratedFile& file : files) {
            if (file.target == GeneratedFile::Target::proof) {
                expected[root / (effect ? "proofs/gappa/effects" : "proofs/gappa/generated") / file.name] = file.text;
            } else if (file.target == GeneratedFile::Target::hls && shipped) {
                expected[root / "hls/generated" / file.name] = file.text;
            }
        }
    };
    for (const Profile& profile : shipped_profiles()) {
        for (const Lobe& lobe : lobes()) add(lobe.emit(profile, default_architecture(lobe)), false, true);
        for (const Effect& effect : effects()) add(effect.emit(profile, lobes().front().name), true, true);
    }
    for (const auto& [name, profile] : custom) {
        const Lobe& lobe = find_lobe(name);
        add(lobe.emit(parse_profile(profile), default_architecture(lobe)), false, false);
    }
    for (const auto& [path, text] : expected) {
        CAPTURE(path.string());
        CHECK(contents(path) == text);
    }
    std::size_t found = 0;
    for (const char* folder : {"hls/generated", "proofs/gappa/generated", "proofs/gappa/effects"}) {
        for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
            CAPTURE(entry.path().string());
            CHECK(expected.count(entry.path()) == 1);
            ++found;
        }
    }
    CHECK(found == expected.size());
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
            const std::string renamed = replaced(of_bps[0].text, "_bps_", "_" + name + "_");
            CHECK(files[0].text == replaced(renamed, "--lobe bps ", "--lobe " + name + " "));
        }
    }
}

TEST_CASE("AXI4-Stream wrappers of a lobe differ in numbers only: what is proven of the one at p12 holds for all") {
    const auto without_numbers = [](const Lobe& lobe, const Profile& profile) {
        for (const GeneratedFile& file : with_axi_stream(lobe.emit(profile, default_architecture(lobe)))) {
            if (file.name.find("_axis_") == std::string::npos || file.target != GeneratedFile::Target::verilog)
                continue;
            std::string out;
            for (const char c : file.text.substr(file.text.find("#("))) {
                const bool digit = c >= '0' && c <= '9';
                if (!digit || out.back() != '#') out += digit ? '#' : c;
            }
            return out;
        }
        return std::string();
    };
    for (const Lobe& lobe : lobes()) {
        CAPTURE(lobe.name);
        const std::string proven = without_numbers(lobe, parse_profile("p12"));
        CHECK(proven.find("s_axis_tdata") != std::string::npos);
        CHECK(without_numbers(lobe, parse_profile("p8")) == proven);
        CHECK(without_numbers(lobe, parse_profile("p16")) == proven);
    }
}
