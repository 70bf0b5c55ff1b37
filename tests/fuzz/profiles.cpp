// A line with a lobe and its options, or with an effect after a '+', and a line with a profile.
#include <algorithm>

#include "check.hpp"
#include "glint/effect.hpp"
#include "glint/lobe_unit.hpp"
#include "glint/lobes.hpp"
#include "targets.hpp"

namespace glint::fuzz {
namespace {

/// A word of file and module names.
void check_name(const std::string& name) {
    constexpr std::string_view legal = "abcdefghijklmnopqrstuvwxyz0123456789_";
    require(!name.empty() && name.find_first_not_of(legal) == name.npos, "a profile's name is a word");
    require(name.size() < 100, "a profile's name is short");
}

/// Results at the ends of every port, one port after another. Sanitizers watch the intermediates.
void check_results(const EffectModel& model) {
    const auto ports = model.inputs();
    for (std::size_t p = 0; p < ports.size(); ++p) {
        for (const std::int64_t code :
             {ports[p].least(), ports[p].low, ports[p].low + 1, ports[p].high, ports[p].greatest()}) {
            for (const bool low : {false, true}) {
                std::vector<std::int64_t> in;
                for (const EffectPort& port : ports) in.push_back(low ? port.low : port.high);
                in[p] = code;
                const EffectResult result = model.eval_port(in);
                for (std::size_t i = 0; i < result.values.size(); ++i) {
                    const EffectPort& port = model.outputs()[i];
                    require(result.values[i] >= port.least() && result.values[i] <= port.greatest(),
                            "a result fits its port");
                }
            }
        }
    }
}

}  // namespace

static const Registration profiles("profiles", [](const std::string& text) {
    const std::vector<std::string> lines = split(text, '\n');
    if (text.size() > 400 || lines.size() < 2) return;
    may_refuse([&] {
        if (lines[0].starts_with('+')) {
            const Effect& effect = find_effect(lines[0].substr(1));
            const Profile profile = parse_profile(lines[1]);
            check_name(profile.name);
            check_results(*effect.golden(profile, "bps"));
            return;
        }
        const LobeChoice choice = parse_lobe(lines[0]);
        const auto model = choice.lobe->golden(choice.profile(lines[1]));
        check_name(model->profile().name);
        check_results(*lobe_unit(*model));
        require(!choice.lobe->emit(model->profile(), default_architecture(*choice.lobe)).empty(), "it has Verilog");
    });
});

}  // namespace glint::fuzz
