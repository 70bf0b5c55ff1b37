// A line with a lobe, or with an effect after a '+', a line with an architecture, and one with sidebands.
#include "check.hpp"
#include "glint/effect.hpp"
#include "glint/lobes.hpp"
#include "targets.hpp"

namespace glint::fuzz {

static const Registration architectures("architectures", [](const std::string& text) {
    std::vector<std::string> lines = split(text, '\n');
    if (text.size() > 400) return;
    lines.resize(3);
    may_refuse([&] {
        const Profile& profile = shipped_profiles().front();
        const Sidebands sidebands = parse_sidebands(lines[2]);
        std::vector<GeneratedFile> files;
        if (lines[0].starts_with('+')) {
            files = find_effect(lines[0].substr(1)).emit(profile, "bps");
            const HardwareUnit& unit = *files.front().unit;
            const Architecture architecture = parse_architecture(unit, lines[1]);
            if (!architecture.name.empty())
                require(parse_architecture(unit, architecture.name) == architecture, "a name, read, is itself");
        } else {
            const LobeChoice choice = parse_lobe(lines[0]);
            const Architecture architecture = parse_architecture(*choice.lobe, lines[1]);
            require(parse_architecture(*choice.lobe, architecture.name) == architecture, "a name, read, is itself");
            files = choice.lobe->emit(with_options(profile, choice.options), architecture);
        }
        const std::size_t units = units_of(files).size();
        require(units > 0, "there is a unit");
        require(units_of(with_axi_stream(std::move(files), sidebands)).size() > units, "it has an AXI4-Stream unit");
    });
});

}  // namespace glint::fuzz
