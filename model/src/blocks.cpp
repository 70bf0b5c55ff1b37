#include "blocks.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint {
namespace {

struct Module {
    std::string_view name;
    std::vector<std::string_view> contains = {};
};

/// The modules, the dividers, and the one that chooses a divider.
std::vector<Module> with_dividers(std::vector<Module> out) {
    Module divider{"glint_divider"};
    for (const Divider& one : dividers()) {
        out.push_back({one.module, one.parts});
        divider.contains.push_back(one.module);
    }
    out.push_back(divider);
    return out;
}

/// The modules by hand that units share. One that is not here is the core of a lobe or an effect, which says itself
/// what it contains.
const std::vector<Module>& modules() {
    static const std::vector<Module> all = with_dividers({
        {"glint_delay"},
        {"glint_fifo"},
        {"glint_skid"},
        {"glint_multiplier"},
        {"glint_multiplier_sliced", {"glint_delay"}},
        {"glint_sqrt"},
        {"glint_normalise", {"glint_delay"}},
        {"glint_signed_multiplier", {"glint_delay"}},
        {"glint_dot_product", {"glint_signed_multiplier"}},
        {"glint_nearest", {"glint_divider"}},
        {"glint_vectors", {"glint_delay", "glint_multiplier", "glint_dot_product"}},
        {"glint_cosine", {"glint_delay", "glint_vectors", "glint_sqrt", "glint_nearest"}},
        {"glint_wait", {"glint_delay"}},
        {"glint_frame",
         {"glint_delay", "glint_wait", "glint_dot_product", "glint_multiplier", "glint_sqrt", "glint_cosine"}},
        {"glint_ports", {"glint_delay"}},
        {"glint_stream", {"glint_delay"}},
        {"glint_axis", {"glint_skid"}},
        {"glint_dot"},
        {"glint_colour"},
        {"glint_ratio", {"glint_delay", "glint_multiplier", "glint_divider"}},
        {"glint_horner", {"glint_delay", "glint_multiplier"}},
        {"glint_square", {"glint_multiplier"}},
        {"glint_power", {"glint_delay", "glint_multiplier", "glint_square"}},
        {"glint_parabola", {"glint_delay", "glint_multiplier"}},
        {"glint_log2", {"glint_delay", "glint_parabola"}},
        {"glint_exp2", {"glint_delay", "glint_parabola"}},
        {"glint_microfacets", {"glint_dot"}},
        {"glint_attenuation", {"glint_log2"}},
        {"glint_scaled_power", {"glint_delay", "glint_parabola"}},
        {"glint_effect_ambient", {"glint_colour", "glint_stream"}},
        {"glint_effect_tint", {"glint_colour", "glint_stream"}},
        {"glint_shade_part", {"glint_fifo", "glint_effect_tint"}},
        {"glint_effect_highlight", {"glint_dot"}},
        {"glint_effect_shade",
         {"glint_delay", "glint_fifo", "glint_stream", "glint_shade_part", "glint_effect_ambient"}},
        {"glint_effect_pixel", {"glint_stream", "glint_wait", "glint_frame"}},
        {"glint_effect_lobe_select", {"glint_fifo", "glint_stream"}},
    });
    return all;
}

void add(std::vector<HardwareUnit::File>& files, std::string_view module, const Hardware& hardware) {
    const auto add_part = [&](std::string_view part) {
        if (!part.empty()) add(files, part, {});
    };
    const auto known =
        std::find_if(modules().begin(), modules().end(), [&](const Module& m) { return m.name == module; });
    if (known != modules().end()) std::for_each(known->contains.begin(), known->contains.end(), add_part);
    for (const Block& block : hardware.way) add_part(block.module);
    std::for_each(hardware.beside.begin(), hardware.beside.end(), add_part);
    const std::string_view folder = module.starts_with("glint_effect_") ? "effects"
                                    : known != modules().end()          ? "blocks"
                                                                        : "lobes";
    add_files(files, {{fmt::format("{}/{}.v", folder, module)}});
}

}  // namespace

std::vector<std::string_view> shared_modules() {
    std::vector<std::string_view> out;
    for (const Module& module : modules()) out.push_back(module.name);
    return out;
}

Block Hardware::sum() const { return std::accumulate(way.begin(), way.end(), Block{}); }

std::vector<HardwareUnit::File> files_of(std::string_view module, const Hardware& hardware) {
    std::vector<HardwareUnit::File> out;
    add(out, module, hardware);
    return out;
}

void add_files(std::vector<HardwareUnit::File>& files, const std::vector<HardwareUnit::File>& more) {
    for (const HardwareUnit::File& file : more) {
        if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
    }
}

std::span<const Family> families() {
    static const std::array<Family, 3> all{
        {{"ecp5",
          {"glint_multiplier", "glint_divider_restoring", "glint_divider_radix4", "glint_signed_multiplier",
           "glint_sqrt", "glint_nearest", "glint_parabola", "glint_log2", "glint_exp2", "glint_ratio", "glint_fifo",
           "glint_effect_tint", "glint_cayley"},
          {{"MULT18X18D", "glint_multiplier_block"}, {"CCU2C", "glint_add_sub"}, {"DP16KD", "glint_table_block"}},
          {"glint_table_block"}},
         {"up5k", {"glint_multiplier", "glint_divider_iterative"}, {{"SB_MAC16", "glint_multiplier_block"}}},
         {"ice40", {"glint_multiplier", "glint_divider_restoring"}}}};
    return all;
}

void use_family(HardwareUnit& unit, std::string_view family) {
    const auto of_family = std::ranges::find(families(), family, &Family::name);
    if (of_family == families().end()) return;
    std::vector<HardwareUnit::File> files;
    for (const HardwareUnit::File& file : unit.files) {
        const std::string folder = file.name.substr(0, file.name.find('/') + 1);
        const auto name =
            std::find_if(of_family->modules.begin(), of_family->modules.end(),
                         [&](std::string_view module) { return file.name == fmt::format("{}{}.v", folder, module); });
        if (name == of_family->modules.end()) {
            add_files(files, {file});
            continue;
        }
        const bool is_tint = *name == "glint_effect_tint";
        if ((*name == "glint_multiplier" || is_tint) && !of_family->primitives.empty()) {
            add_files(files, files_of("glint_multiplier_sliced"));
            add_files(files, {{fmt::format("blocks/{}/glint_multiplier_block.v", family)}});
        }
        if (is_tint) add_files(files, {{fmt::format("blocks/{}/glint_multiplier.v", family)}});
        if (name->starts_with("glint_divider_r") && family == "ecp5")
            add_files(files, {{fmt::format("blocks/{}/glint_add_sub.v", family)}});
        if (*name == "glint_sqrt" || *name == "glint_nearest") {
            add_files(files, {{fmt::format("blocks/{}/glint_add_sub_odd.v", family)}});
        }
        add_files(files, {{fmt::format("{}{}/{}.v", folder, family, *name)}});
    }
    unit.files = std::move(files);
    unit.simulation = {};
    for (const auto& [primitive, module] : of_family->primitives) {
        const std::string block = fmt::format("blocks/{}/{}", family, module);
        if (std::ranges::any_of(unit.files, [&](const auto& file) { return file.name.starts_with(block); }))
            unit.simulation.push_back({fmt::format("simulation/{}.v", primitive)});
    }
}

std::vector<HardwareUnit::Port> stream_ports(const std::vector<HardwareUnit::Port>& inputs,
                                             const std::vector<HardwareUnit::Port>& outputs) {
    std::vector<HardwareUnit::Port> out{{"clk_i", false, 1, "", false, "clock, rising edge"},
                                        {"rst_ni", false, 1, "", false, "reset, synchronous, active low"},
                                        {"valid_i", false, 1, "", false, "an input is offered"},
                                        {"ready_o", true, 1, "", false, "the unit takes an input at this edge"}};
    out.insert(out.end(), inputs.begin(), inputs.end());
    out.push_back({"tag_i", false, 0, "TAG_W", false, "anything; leaves with the result"});
    out.push_back({"valid_o", true, 1, "", false, "a result is offered"});
    out.push_back({"ready_i", false, 1, "", false, "the receiver takes the result at this edge"});
    out.insert(out.end(), outputs.begin(), outputs.end());
    out.push_back({"tag_o", true, 0, "TAG_W", false, "the tag of this result's input"});
    out.push_back({"clamped_o", true, 1, "", false, "an input was out of range and was corrected"});
    return out;
}

HardwareUnit::Architecture timed(const Architecture& architecture, const Block& way) {
    HardwareUnit::Architecture out{architecture.name, architecture.parameters, 0, 1};
    out.latency = way.clocks + division_clocks(architecture, way.quotient_bits) +
                  way.products * (architecture.parameter("MULTIPLIER_STAGES", 1) - 1) +
                  way.deep * architecture.parameter("DEEP", 0);
    if (!takes_one_a_clock(architecture)) out.interval = out.latency;
    return out;
}

}  // namespace glint
