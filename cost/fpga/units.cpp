#include "cost/fpga/units.hpp"

#include <algorithm>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "cost/fpga/table.hpp"
#include "glint/architecture.hpp"
#include "glint/effect.hpp"
#include "glint/error.hpp"
#include "glint/shade.hpp"
#include "glint/vectors.hpp"
#include "io/command.hpp"

namespace glint::fpga {
namespace {

constexpr int tag_w = 1;  // the least: each further bit is a register, or a part of one, a clock of latency
constexpr std::string_view rival = "table";

std::string module_of(const Design& design) { return std::filesystem::path(design.generated.back().name).stem(); }

// ---- lobes -------------------------------------------------------------------------------------------------------

/// Every divider, and units without one, with products of one clock and of two.
std::string all_architectures() {
    std::string out = "pipelined,pipelined:m2";
    for (const std::string_view stages : {"", ":m2"}) {
        for (const Divider& divider : dividers()) out += fmt::format(",{}{}", divider.name, stages);
    }
    return out;
}

/// Those of a list that the lobe can have: one with a divider and one without have none in common. Throws Error when
/// there is none.
std::vector<Architecture> architectures(const Lobe& lobe, const std::string& text) {
    if (text.empty()) return {default_architecture(lobe)};
    std::vector<Architecture> out;
    std::string refused;
    for (const std::string& name : io::split_list(text == "all" ? all_architectures() : text)) {
        try {
            const Architecture architecture = parse_architecture(lobe, name);
            if (std::find(out.begin(), out.end(), architecture) == out.end()) out.push_back(architecture);
        } catch (const Error& error) {
            refused = error.what();
        }
    }
    if (out.empty()) throw Error(refused);
    return out;
}

/// Throws Error for an architecture of a list that none of the lobes can have.
void check_architectures(const std::vector<LobeChoice>& lobes, const std::string& text) {
    if (text.empty() || text == "all") return;
    for (const std::string& name : io::split_list(text)) {
        std::string refused;
        const bool legal = std::any_of(lobes.begin(), lobes.end(), [&](const LobeChoice& choice) {
            try {
                parse_architecture(*choice.lobe, name);
                return true;
            } catch (const Error& error) {
                refused = error.what();
                return false;
            }
        });
        if (!legal) throw Error(refused);
    }
}

/// Legal inputs, their ends among them, and some that are corrected.
std::vector<Exchange> lobe_burst(const GoldenModel& model) {
    constexpr std::size_t length = 64;
    const Profile& profile = model.profile();
    const std::int64_t one = profile.one();
    std::vector<Exchange> out;
    for (const auto& [n, cosine] : std::initializer_list<std::pair<int, std::int64_t>>{
             {1, 0}, {max_n, one}, {1, one}, {0, 1}, {50, -1}, {50, one + 1}}) {
        out.push_back({{n, cosine}, {}});
    }
    std::mt19937 random;
    while (out.size() < length) {
        const int n = 1 + static_cast<int>(random() % max_n);
        out.push_back({{n, static_cast<std::int64_t>(random() % static_cast<unsigned>(one + 1))}, {}});
    }
    for (Exchange& exchange : out) {
        const PortResult result = model.eval_port(static_cast<int>(exchange.in[0]), exchange.in[1]);
        exchange.out = {result.y, result.clamped ? 1 : 0};
    }
    return out;
}

PricedUnit lobe_unit_of(const std::string& name, const GoldenModel& model, const Architecture& architecture,
                        Design design) {
    PricedUnit out;
    out.point.lobe = name;
    out.point.profile = model.profile().argument();
    out.point.architecture = architecture.name;
    out.family = architecture.family;
    out.deep = architecture.parameter("DEEP", 0) != 0;
    out.unit = lobe_unit(module_of(design), model.profile(), tag_w);
    for (const auto& [parameter, value] : architecture.parameters) {
        out.unit.parameters += fmt::format(", .{}({})", parameter, value);
    }
    out.design = std::move(design);
    out.burst = lobe_burst(model);
    return out;
}

/// The AXI4-Stream unit around the priced one, or so many of them side by side, in a module with the ports of the
/// latter: its tag is tlast, and tuser is a constant, so that one bit travels along in all. `files`: of the priced one.
PricedUnit in_shell(PricedUnit core, const std::vector<GeneratedFile>& files, int lanes) {
    std::vector<GeneratedFile> all = with_axi_stream(files);
    if (lanes > 1) all = with_lanes(std::move(all), lanes);
    std::swap(all[0], all[lanes > 1 ? 2 : 1]);
    Design design = design_of(all);
    std::string parameters = core.unit.parameters;
    const std::string tag = fmt::format(".TAG_W({})", tag_w);
    parameters.replace(parameters.find(tag), tag.size(), ".USER_W(1)");
    if (lanes > 1) parameters = fmt::format(".LANES({}), {}", lanes, parameters);

    const std::vector<Port> ins = data_ports(core.unit);
    std::vector<Port> outs = result_ports(core.unit);
    outs.pop_back();  // clamped_o
    std::vector<Port> inputs, results;
    std::string taken, given, words, assigned;  // a word of 32 bits for each number, the first at the bottom
    const auto lane = [&](const std::string& name, int k) {
        return lanes == 1 || (k == lanes - 1 && name == "clamped_o") ? name : fmt::format("lane{}_{}", k, name);
    };
    for (int k = 0; k < lanes; ++k) {
        for (const Port& port : ins) {
            inputs.push_back({lane(port.name, k), port.width});
            const std::string padding = port.width < 32 ? fmt::format("{}'d0, ", 32 - port.width) : "";
            words = padding + inputs.back().name + (words.empty() ? "" : ", " + words);
            taken += fmt::format("    input wire [{}:0] {},\n", port.width - 1, inputs.back().name);
        }
        const int low = k * 32 * static_cast<int>(outs.size());
        for (std::size_t r = 0; r < outs.size(); ++r) {
            results.push_back({lane(outs[r].name, k), outs[r].width});
            const int bottom = low + 32 * static_cast<int>(r);
            assigned +=
                fmt::format("    assign {} = word[{}:{}];\n", results.back().name, bottom + outs[r].width - 1, bottom);
        }
        assigned += fmt::format("    assign {} = word[{}];\n", lane("clamped_o", k), low + 31);
        if (k < lanes - 1) results.push_back({lane("clamped_o", k), 1});
    }
    for (const Port& port : results) given += fmt::format("    output wire [{}:0] {},\n", port.width - 1, port.name);
    design.generated.push_back(
        {"glint_shell.v", fmt::format(R"(`default_nettype none
module glint_shell #(
    parameter TAG_W = 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,
    input  wire             valid_i,
    output wire             ready_o,
{0}    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
{1}    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o
);
    wire [{2}:0] word;
{3}    {4} #({5}) axis (
        .aclk(clk_i), .aresetn(rst_ni), .s_axis_tdata({{{6}}}), .s_axis_tuser(1'b0),
        .s_axis_tlast(tag_i), .s_axis_tvalid(valid_i), .s_axis_tready(ready_o), .m_axis_tdata(word), .m_axis_tuser(),
        .m_axis_tlast(tag_o), .m_axis_tvalid(valid_o), .m_axis_tready(ready_i)
    );
endmodule
`default_nettype wire
)",
                                      taken, given, 32 * lanes * static_cast<int>(outs.size()) - 1, assigned,
                                      module_of(design), parameters, words)});
    core.design = std::move(design);
    core.unit = stream_unit("glint_shell", inputs, results, tag_w);
    core.point.unit = lanes > 1 ? "lanes" : "axis";
    core.point.lanes = lanes;
    const std::vector<Exchange> burst = core.burst;  // each lane is one input ahead of the one below
    for (std::size_t i = 0; i < burst.size(); ++i) {
        for (std::size_t k = 1; k < static_cast<std::size_t>(lanes); ++k) {
            const Exchange& more = burst[(i + k) % burst.size()];
            core.burst[i].in.insert(core.burst[i].in.end(), more.in.begin(), more.in.end());
            core.burst[i].out.insert(core.burst[i].out.end(), more.out.begin(), more.out.end());
        }
    }
    return core;
}

/// Adds the unit; where the options ask for shells, also those around it. `files`: of the unit.
void add(std::vector<PricedUnit>& units, PricedUnit unit, const Options& options,
         const std::vector<GeneratedFile>& files) {
    if (options.shell) unit.point.unit = "core";
    units.push_back(std::move(unit));
    if (!options.shell) return;
    const PricedUnit core = units.back();
    units.push_back(in_shell(core, files, 1));
    if (options.lanes > 1) units.push_back(in_shell(core, files, options.lanes));
}

std::vector<PricedUnit> lobes_of(const Options& options, const std::string& lobes) {
    std::vector<PricedUnit> out;
    const std::vector<LobeChoice> choices = io::split_lobes(lobes);
    check_architectures(choices, options.architecture);
    for (const LobeChoice& choice : choices) {
        const Lobe& lobe = *choice.lobe;
        const std::string name = std::string(lobe.name) + (choice.options.empty() ? "" : ":" + choice.options);
        for (const std::string& text : io::split_profiles(options.profile)) {
            const Profile profile = choice.profile(text);
            const std::unique_ptr<GoldenModel> model = lobe.golden(profile);
            for (const Architecture& architecture : architectures(lobe, options.architecture)) {
                Architecture parameters = architecture;
                if (architecture == default_architecture(lobe)) parameters.parameters.clear();  // the wrapper's own
                const std::vector<GeneratedFile> files = lobe.emit(profile, architecture);
                add(out, lobe_unit_of(name, *model, parameters, design_of(files)), options, files);
            }
        }
    }
    return out;
}

std::vector<PricedUnit> tables(const Options& options) {
    std::vector<PricedUnit> out;
    for (const std::string& text : io::split_profiles(options.profile)) {
        const Profile profile = parse_profile(text);
        if (!profile.shipped())
            throw Error(fmt::format("profile '{}' is not legal for {}: p8, p12 or p16", text, rival));
        const TableFormat format = TableFormat::best(profile);
        const std::shared_ptr<const GoldenModel> model = table_model(profile, format);
        out.push_back(lobe_unit_of(std::string(rival), *model, {"pipelined", {}}, table_unit(profile, format)));
        out.back().rival = model;
    }
    return out;
}

// ---- effects -----------------------------------------------------------------------------------------------------

/// The effects alone, lambert with blinn_phong, what the scenes of scenes/ call for (`glint render`), and all.
constexpr std::string_view default_masks = "1,2,4,8,16,32,64,128,3,10,11,15,19,35,195,255";

std::vector<int> masks(const std::string& text) {
    const std::int64_t most = (std::int64_t{1} << shade_effects().size()) - 1;
    std::vector<int> out;
    for (const std::string& mask : io::split_list(text.empty() ? std::string(default_masks) : text)) {
        out.push_back(static_cast<int>(io::parse_integer(mask, "--mask", 0, most)));
        if (std::count(out.begin(), out.end(), out.back()) > 1) {
            throw Error(fmt::format("--mask '{}' is not legal: each mask once", text));
        }
    }
    return out;
}

/// The effect's hard cases, then random codes, legal but for one input in eight. It is longer than what shade, the unit
/// that holds most, accepts without delivering: else the interval of one that holds too little would be 1, too.
std::vector<Exchange> effect_burst(const Effect& effect, const EffectModel& model, std::optional<int> mask) {
    constexpr std::size_t random_inputs = 256;
    std::vector<Exchange> out;
    for (const EffectCase& hard : effect.hard_cases(model)) out.push_back({hard.in, {}});
    Random random(1);
    for (std::size_t i = 0; i < random_inputs; ++i) {
        const bool legal = i % 8 != 0;
        Exchange exchange;
        for (const EffectPort& port : model.inputs()) {
            exchange.in.push_back(legal ? random.between(port.low, port.high)
                                        : random.between(port.least(), port.greatest()));
        }
        out.push_back(std::move(exchange));
    }
    for (Exchange& exchange : out) {
        std::vector<std::int64_t> in = exchange.in;
        if (mask) in[0] &= *mask;  // the port `effects`: what is not built counts as not asked for
        EffectResult result = model.eval_port(in);
        exchange.out = std::move(result.values);
        for (std::size_t p = 0; p < exchange.out.size(); ++p) {  // as the bench prints them: without a sign
            exchange.out[p] &= (std::int64_t{1} << model.outputs()[p].bits) - 1;
        }
        exchange.out.push_back(result.clamped ? 1 : 0);
    }
    return out;
}

/// Whether its unit has the parameter MASK.
bool masked(const Effect& effect) { return effect.name == "shade" || effect.name == "pixel"; }

std::vector<Port> ports(std::span<const EffectPort> of_model, std::string_view suffix) {
    std::vector<Port> out;
    for (const EffectPort& port : of_model) out.push_back({fmt::format("{}_{}", port.name, suffix), port.bits});
    return out;
}

PricedUnit effect_unit(const Effect& effect, const EffectModel& model, const Design& design, const std::string& lobe,
                       const Architecture& architecture, int latency, std::optional<int> mask) {
    constexpr int shallow =
        32;  // clocks: a unit of more has so many valid bits that their resets want a synthesis of their own
    PricedUnit out;
    out.point.architecture = architecture.name;
    out.family = architecture.family;
    out.deep = latency > shallow;
    out.point.effect = effect.name;
    out.point.mask = mask;
    if (effect.takes_lobe) out.point.lobe = lobe;
    out.point.profile = model.profile().argument();
    out.unit = stream_unit(module_of(design), ports(model.inputs(), "i"), ports(model.outputs(), "o"), tag_w);
    if (mask) out.unit.parameters += fmt::format(", .MASK({})", *mask);
    for (const auto& [parameter, value] : architecture.parameters) {
        out.unit.parameters += fmt::format(", .{}({})", parameter, value);
    }
    out.design = design;
    out.burst = effect_burst(effect, model, mask);
    return out;
}

std::vector<const Effect*> effects_of(const std::string& text) {
    std::vector<const Effect*> out;
    if (text == "all") {
        for (const Effect& effect : effects()) out.push_back(&effect);
        return out;
    }
    for (const std::string& name : io::split_list(text)) out.push_back(&find_effect(name));
    return out;
}

std::vector<PricedUnit> effects_of(const Options& options) {
    const std::vector<const Effect*> effects = effects_of(options.effect);
    if (!options.mask.empty() &&
        std::none_of(effects.begin(), effects.end(), [](const Effect* effect) { return masked(*effect); })) {
        throw Error("--mask is not legal here: it is a parameter of the effects shade and pixel");
    }
    const std::vector<int> chosen = masks(options.mask);
    std::vector<PricedUnit> out;
    for (const Effect* effect : effects) {
        for (const std::string& text : io::split_profiles(options.profile)) {
            const Profile profile = parse_profile(text);
            const std::unique_ptr<EffectModel> model = effect->golden(profile, options.lobe);
            for (const std::string& name :
                 io::split_list(options.architecture.empty() ? "default" : options.architecture)) {
                std::vector<GeneratedFile> files = effect->emit(profile, options.lobe);
                const Architecture architecture = parse_architecture(*files.front().unit, name);
                use_family(*files.front().unit, architecture.family);
                const int latency = files.front().unit->architectures[0].latency;
                if (architecture.block) use_block_tables(files);
                const Design design = design_of(files);
                const std::vector<std::optional<int>> of_effect =
                    masked(*effect) ? std::vector<std::optional<int>>(chosen.begin(), chosen.end())
                                    : std::vector<std::optional<int>>{std::nullopt};
                for (const std::optional<int>& mask : of_effect) {
                    add(out, effect_unit(*effect, *model, design, options.lobe, architecture, latency, mask), options,
                        files);
                }
            }
        }
    }
    return out;
}

}  // namespace

std::vector<PricedUnit> priced_units(const Options& options) {
    if (options.shell && options.lobe.find(rival) != std::string::npos) {
        throw Error(fmt::format("--shell is not legal here: {} has no AXI4-Stream unit", rival));
    }
    if (options.lanes > 1 && !options.shell) throw Error("--lanes is not legal here: it is of --shell");
    if (!options.effect.empty()) return effects_of(options);
    if (!options.mask.empty())
        throw Error("--mask is not legal here: it is a parameter of the effects shade and pixel");
    std::string lobes;
    bool with_rival = false;
    for (const std::string& name : io::split_list(options.lobe)) {
        if (name == rival) {
            with_rival = true;
        } else {
            lobes += (lobes.empty() ? "" : ",") + name;
        }
    }
    std::vector<PricedUnit> out;
    if (!lobes.empty() || !with_rival) out = lobes_of(options, lobes);
    if (with_rival) {
        for (PricedUnit& unit : tables(options)) out.push_back(std::move(unit));
    }
    return out;
}

}  // namespace glint::fpga
