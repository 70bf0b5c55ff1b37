#include "glint/profile.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {

std::string Profile::argument() const {
    std::string out = name;
    if (!options.empty()) out.resize(out.rfind('_'));
    std::replace(out.begin(), out.end(), '_', ',');
    return out;
}

std::span<const Profile> shipped_profiles() {
    static const std::array<Profile, 3> profiles{
        {{"p8", 16, 8, {}, {}}, {"p12", 18, 12, {}, {}}, {"p16", 20, 16, {}, {}}}};
    return profiles;
}

Profile parse_profile(std::string_view text) {
    for (const Profile& profile : shipped_profiles()) {
        if (profile.name == text) return profile;
    }
    const auto refuse = [&](std::string_view why) {
        return Error(fmt::format(
            "profile '{}' is not legal: {}; legal are p8, p12, p16, or F,...,O with 8 <= F <= 30 and 4 <= O <= 28",
            text, why));
    };
    Profile out;
    for (std::string_view rest = text;;) {
        const std::string_view field = rest.substr(0, rest.find(','));
        int number = 0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
        if (error != std::errc{} || end != field.data() + field.size()) {
            throw refuse(fmt::format("'{}' is neither a profile's name nor a number", field));
        }
        if (number < 0 || number > 99) throw refuse(fmt::format("{} is out of range", number));
        out.custom.push_back(number);
        out.name += fmt::format("{}{}", out.name.empty() ? "" : "_", number);
        if (field.size() == rest.size()) break;
        rest.remove_prefix(field.size() + 1);
    }
    if (out.custom.size() < 2) throw refuse("too few numbers");
    out.F = out.custom.front();
    out.O = out.custom.back();
    if (out.F < 8 || out.F > 30) throw refuse(fmt::format("F = {}", out.F));
    if (out.O < 4 || out.O > 28) throw refuse(fmt::format("O = {}", out.O));
    return out;
}

Profile with_options(Profile profile, std::string_view options) {
    if (options.empty()) return profile;
    std::uint32_t hash = 2166136261U;  // FNV-1a: files and modules of different options need different names
    for (const char c : options) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    profile.options = options;
    profile.name += fmt::format("_x{:08x}", hash);
    return profile;
}

}  // namespace glint
