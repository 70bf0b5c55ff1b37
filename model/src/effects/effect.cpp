#include "effect.hpp"

#include <algorithm>

namespace glint {

namespace {

using Kind = EffectPort::Kind;

std::int64_t power_of_two(int exponent) { return std::int64_t{1} << exponent; }

}  // namespace

EffectPort dot_port(std::string_view name, const Profile& profile) {
    return {name, Kind::dot, profile.F + 2, true, profile.F, -power_of_two(profile.F), power_of_two(profile.F)};
}

EffectPort exponent_port() { return {"n", Kind::parameter, 10, false, 0, 1, max_n}; }

EffectPort material_colour_port(std::string_view name, const Profile& profile) {
    return {name, Kind::colour, profile.O + 1, false, profile.O, 0, power_of_two(profile.O)};
}

EffectPort light_colour_port(std::string_view name, const Profile& profile) {
    return {name, Kind::colour, profile.O + 4, false, profile.O, 0, power_of_two(profile.O + 4) - 1};
}

EffectPort term_port(std::string_view name, const Profile& profile, int E) {
    return {name, Kind::term, profile.O + 1 + E, false, profile.O, 0, power_of_two(profile.O + 1 + E) - 1};
}

EffectPort component_port(std::string_view name, int W) {
    return {name, Kind::component, W, true, W - 1, -power_of_two(W - 1), power_of_two(W - 1) - 1};
}

void check_output_bits(std::string_view effect, const Profile& profile, int greatest_O) {
    if (profile.O > greatest_O) {
        throw Error(fmt::format("O = {} is not legal for the effect {}: 4 to {}", profile.O, effect, greatest_O));
    }
}

std::string effect_module_name(const EffectModel& model, std::string_view lobe) {
    return fmt::format("glint_effect_{}_{}{}{}", model.effect(), lobe, lobe.empty() ? "" : "_", model.profile().name);
}

namespace {

std::vector<HardwareUnit::Port> described(std::span<const EffectPort> ports, bool output) {
    static constexpr std::string_view kinds[] = {"dot product", "parameter", "colour", "term", "component"};
    std::vector<HardwareUnit::Port> out;
    for (const EffectPort& port : ports) {
        out.push_back({fmt::format("{}_{}", port.name, output ? "o" : "i"), output, port.bits, "", port.is_signed,
                       fmt::format("{}, code / 2^{}; {} to {}", kinds[static_cast<std::size_t>(port.kind)],
                                   port.fraction_bits, port.low, port.high)});
    }
    return out;
}

HardwareUnit described(const EffectModel& model, std::string_view lobe, const Hardware& hardware,
                       std::string_view core) {
    HardwareUnit unit;
    const Profile& profile = model.profile();
    unit.name = effect_module_name(model, lobe);
    unit.kind = "effect";
    unit.lobe = lobe;
    if (!profile.options.empty()) unit.lobe += ":" + profile.options;
    unit.effect = model.effect();
    unit.profile = profile.argument();
    unit.F = profile.F;
    unit.O = profile.O;
    unit.core = core;
    unit.files = files_of(core, hardware);
    unit.ports = stream_ports(described(model.inputs(), false), described(model.outputs(), true));
    unit.parameters = {{"TAG_W", "16", "at least 1", "bits of the tag"}};
    unit.architectures = {timed({"default", {}}, hardware.sum())};
    return unit;
}

Kernel kernel(const EffectModel& model) {
    Kernel out{"effects",
               fmt::format("effect_{}", model.effect()),
               fmt::format("--effect {}", model.effect()),
               fmt::format("docs/effects/{}.md", model.effect()),
               "void",
               "",
               ""};
    const auto add = [&](std::string_view type, std::string_view argument, std::string_view passed) {
        const char* separator = out.arguments.empty() ? "" : ", ";
        out.arguments += fmt::format("{}{} {}", separator, type, argument);
        out.passed += fmt::format("{}{}", separator, passed);
    };
    for (const EffectPort& port : model.inputs()) {
        const char* sign = port.is_signed ? "" : "u";
        add(fmt::format("glint_hls::{}int_port<{}>", port.is_signed ? "s" : "u", port.bits), port.name,
            fmt::format("static_cast<std::{}int32_t>({})", sign, port.name));
    }
    for (const EffectPort& port : model.outputs()) {
        add(fmt::format("glint_hls::{}int_port<{}>*", port.is_signed ? "s" : "u", port.bits), port.name, port.name);
    }
    add("bool*", "clamped", "clamped");
    return out;
}

}  // namespace

GeneratedFile effect_module(const EffectModel& model, std::string_view lobe, const Hardware& hardware,
                            std::string_view core, std::string_view body,
                            const std::vector<HardwareUnit::Parameter>& choices) {
    const Profile& profile = model.profile();
    const std::string module = effect_module_name(model, lobe);
    HardwareUnit unit = described(model, lobe, hardware, core);
    unit.files.push_back({module + ".v", true});
    unit.parameters.insert(unit.parameters.begin(), choices.begin(), choices.end());
    std::string chosen, ports;
    for (const auto& choice : choices) chosen += fmt::format("    parameter {} = {},\n", choice.name, choice.value);
    const auto add = [&](std::string_view direction, std::string_view range, std::string_view name) {
        ports += fmt::format("{}    {:6} wire {:>11} {}", ports.empty() ? "" : ",\n", direction, range, name);
    };
    const auto range = [](const EffectPort& port) { return fmt::format("[{}:0]", port.bits - 1); };
    add("input", "", "clk_i");
    add("input", "", "rst_ni");
    add("input", "", "valid_i");
    add("output", "", "ready_o");
    for (const EffectPort& port : model.inputs()) add("input", range(port), fmt::format("{}_i", port.name));
    add("input", "[TAG_W-1:0]", "tag_i");
    add("output", "", "valid_o");
    add("input", "", "ready_i");
    for (const EffectPort& port : model.outputs()) add("output", range(port), fmt::format("{}_o", port.name));
    add("output", "[TAG_W-1:0]", "tag_o");
    add("output", "", "clamped_o");
    std::string choice;
    if (!lobe.empty()) {
        choice = fmt::format(" --lobe {}{}{}", lobe, profile.options.empty() ? "" : ":", profile.options);
    }
    return {GeneratedFile::Target::verilog, module + ".v",
            fmt::format(R"(// {0}: the effect {1} at profile {2}.
// Generated by `glint emit --effect {1}{3} --profile {2}`; do not edit. Ports: docs/effects/{1}.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module {0} #(
{6}    parameter TAG_W = 16
) (
{4}
);

{5}
endmodule

`default_nettype wire
)",
                        module, model.effect(), profile.argument(), choice, ports, body, chosen),
            std::move(unit)};
}

GeneratedFile effect_wrapper(const EffectModel& model, const Hardware& hardware,
                             const std::vector<Constant>& parameters, const std::vector<Table>& tables,
                             const std::vector<HardwareUnit::Parameter>& choices) {
    std::vector<std::string> names{"clk_i", "rst_ni", "valid_i", "ready_o"};
    for (const EffectPort& port : model.inputs()) names.push_back(fmt::format("{}_i", port.name));
    names.insert(names.end(), {"tag_i", "valid_o", "ready_i"});
    for (const EffectPort& port : model.outputs()) names.push_back(fmt::format("{}_o", port.name));
    names.insert(names.end(), {"tag_o", "clamped_o"});

    std::size_t name_width = 0, parameter_width = 5;
    for (const std::string& name : names) name_width = std::max(name_width, name.size());
    for (const Constant& p : parameters) parameter_width = std::max(parameter_width, p.name.size());
    for (const auto& choice : choices) parameter_width = std::max(parameter_width, choice.name.size());
    std::string values, connections;
    for (const Constant& p : parameters) {
        values += fmt::format("        .{:{}}({}),\n", p.name, parameter_width, p.value);
    }
    for (const auto& choice : choices) {
        values += fmt::format("        .{:{}}({}),\n", choice.name, parameter_width, choice.name);
    }
    values += fmt::format("        .{:{}}(TAG_W)\n", "TAG_W", parameter_width);
    for (const std::string& name : names) {
        connections += fmt::format("{}        .{:{}}({})", connections.empty() ? "" : ",\n", name, name_width, name);
    }
    const TableText memories = table_text(tables);
    const std::string core = fmt::format("glint_effect_{}", model.effect());
    GeneratedFile file =
        effect_module(model, "", hardware, core,
                      fmt::format("{}    glint_effect_{} #(\n{}    ) core (\n{}{}\n    );\n{}", memories.wires,
                                  model.effect(), values, connections, memories.ports, memories.instances),
                      choices);
    describe(*file.unit, parameters, tables);
    return file;
}

std::vector<GeneratedFile> made_of(GeneratedFile file, std::vector<GeneratedFile> parts,
                                   const HardwareUnit::Architecture& timing) {
    HardwareUnit& unit = *file.unit;
    std::vector<HardwareUnit::File> files;
    for (const GeneratedFile& part : parts) {
        if (part.unit) add_files(files, part.unit->files);
    }
    add_files(files, unit.files);
    unit.files = std::move(files);
    unit.architectures = {timing};
    std::vector<GeneratedFile> out{std::move(file)};
    for (GeneratedFile& part : parts) {
        const bool there =
            std::any_of(out.begin(), out.end(), [&](const GeneratedFile& f) { return f.name == part.name; });
        if (part.target == GeneratedFile::Target::verilog && !there) out.push_back(std::move(part));
    }
    return out;
}

GeneratedFile effect_constants(const EffectModel& model, const std::vector<Constant>& constants,
                               const std::vector<Table>& tables) {
    return constants_header(kernel(model), model.profile(), constants, tables);
}

GeneratedFile effect_top(const EffectModel& model) { return top_function(kernel(model), model.profile()); }

std::vector<EffectCase> common_effect_cases(const EffectModel& model) {
    const auto ports = model.inputs();
    std::vector<std::int64_t> middle;
    for (const EffectPort& port : ports) {
        // Half of the top: inside every port, and no dot product behind the surface.
        middle.push_back(std::clamp((port.high + 1) / 2, port.low, port.high));
    }
    std::vector<EffectCase> cases;
    for (std::size_t p = 0; p < ports.size(); ++p) {
        const EffectPort& port = ports[p];
        const std::vector<std::pair<std::int64_t, std::string_view>> codes{
            {port.least(), "the least code: its negative may not fit"},
            {port.low - 1, "just below the legal range"},
            {port.low, "the least legal code"},
            {-1, "would be huge if taken as unsigned"},
            {0, "a product or a logarithm of 0"},
            {1, "the least code above 0: a result that rounds to 0"},
            {port.high - 1, "one ulp below the top"},
            {port.high, "the top of the legal range: needs the highest bit"},
            {port.high + 1, "just above the legal range"},
            {port.greatest(), "the greatest code"},
        };
        std::vector<std::int64_t> seen;
        for (const auto& [code, risk] : codes) {
            if (code < port.least() || code > port.greatest() || std::count(seen.begin(), seen.end(), code) != 0)
                continue;
            seen.push_back(code);
            std::vector<std::int64_t> in = middle;
            in[p] = code;
            cases.push_back({fmt::format("{} = {}", port.name, code), std::move(in), std::string(risk)});
        }
    }
    return cases;
}

}  // namespace glint
