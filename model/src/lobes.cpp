#include "glint/lobes.hpp"

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {

const Lobe& find_lobe(std::string_view name) {
    std::string known;
    for (const Lobe& lobe : lobes()) {
        if (lobe.name == name) return lobe;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", lobe.name);
    }
    throw Error(fmt::format("lobe '{}' is not known: {}", name, known));
}

LobeChoice parse_lobe(std::string_view text) {
    const std::size_t colon = text.find(':');
    LobeChoice out{&find_lobe(text.substr(0, colon)), {}};
    if (colon == std::string_view::npos) return out;
    out.options = text.substr(colon + 1);
    if (out.lobe->options.empty() || out.options.empty()) {
        throw Error(fmt::format("lobe '{}' is not legal: {}", text,
                                out.lobe->options.empty() ? fmt::format("{} takes no options", out.lobe->name)
                                                          : fmt::format("{}:{}", out.lobe->name, out.lobe->options)));
    }
    return out;
}

}  // namespace glint
