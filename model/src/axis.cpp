// The AXI4-Stream unit around the unit of a lobe or of an effect, made of what the manifest says of that unit.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "blocks.hpp"
#include "glint/emit.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"

namespace glint {
namespace {

using Port = HardwareUnit::Port;

constexpr int word_bits = 32;  ///< of tdata for each input of an effect, and for each result

/// The ports that carry numbers.
std::vector<Port> numbers(const HardwareUnit& unit, bool output) {
    static constexpr std::string_view stream[] = {"clk_i",   "rst_ni",  "valid_i", "ready_o",  "tag_i",
                                                  "valid_o", "ready_i", "tag_o",   "clamped_o"};
    std::vector<Port> out;
    std::copy_if(unit.ports.begin(), unit.ports.end(), std::back_inserter(out), [&](const Port& port) {
        return port.output == output && std::find(std::begin(stream), std::end(stream), port.name) == std::end(stream);
    });
    return out;
}

/// The field of so many bits at the start of a word of tdata.
std::string bits_of(std::size_t word, int bits) {
    const std::size_t low = word * word_bits;
    return fmt::format("[{}:{}]", low + static_cast<std::size_t>(bits) - 1, low);
}

/// What tdata holds, for people: "[19:0] nl_i; [41:32] n_i".
std::string fields(const std::vector<Port>& ports) {
    std::string out;
    for (std::size_t k = 0; k < ports.size(); ++k) {
        out += fmt::format("{}{} {}", k == 0 ? "" : "; ", bits_of(k, ports[k].bits), ports[k].name);
    }
    return out;
}

std::vector<Port> axis_ports(const HardwareUnit& core, const Sidebands& side) {
    const bool lobe = core.kind == "lobe";
    const std::vector<Port> in = numbers(core, false), results = numbers(core, true);
    const int s_bits = static_cast<int>(in.size()) * word_bits, m_bits = static_cast<int>(results.size()) * word_bits;
    std::vector<Port> out{{"aclk", false, 1, "", false, "clock, rising edge"},
                          {"aresetn", false, 1, "", false, "reset, synchronous, active low"}};
    if (lobe) {
        out.push_back({"s_axis_tdata", false, 0, "WORD_W", false,
                       fmt::format("[9:0] n; [63:32] cosine code, sign-extended; where WORD_W is 32: [{}:10] cosine "
                                   "code; the rest is ignored",
                                   core.F + 11)});
    } else {
        out.push_back({"s_axis_tdata", false, s_bits, "", false, fields(in) + "; the rest is ignored"});
    }
    // A byte of s_axis_tkeep for each 8 bits of s_axis_tdata.
    const std::string bytes = lobe ? "WORD_W / 8" : "";
    if (side.keep) out.push_back({"s_axis_tkeep", false, s_bits / 8, bytes, false, "0: a word without bytes"});
    if (side.id) out.push_back({"s_axis_tid", false, 0, "ID_W", false, "passes along"});
    if (side.dest) out.push_back({"s_axis_tdest", false, 0, "DEST_W", false, "passes along"});
    out.insert(out.end(), {{"s_axis_tuser", false, 0, "USER_W", false, "passes along"},
                           {"s_axis_tlast", false, 1, "", false, "passes along"},
                           {"s_axis_tvalid", false, 1, "", false, "an input is offered"},
                           {"s_axis_tready", true, 1, "", false, "the unit takes an input at this edge"},
                           {"m_axis_tdata", true, m_bits, "", false,
                            lobe ? fmt::format("[{}:0] y; [31] clamped; the rest is 0", core.O)
                                 : fields(results) + "; bit 31 of each word: clamped; the rest is 0"}});
    if (side.keep) out.push_back({"m_axis_tkeep", true, m_bits / 8, "", false, "all 1, or 0 where s_axis_tkeep was 0"});
    if (side.id) out.push_back({"m_axis_tid", true, 0, "ID_W", false, "s_axis_tid of this result's input"});
    if (side.dest) out.push_back({"m_axis_tdest", true, 0, "DEST_W", false, "s_axis_tdest of this result's input"});
    out.insert(out.end(), {{"m_axis_tuser", true, 0, "USER_W", false, "s_axis_tuser of this result's input"},
                           {"m_axis_tlast", true, 1, "", false, "s_axis_tlast of this result's input"},
                           {"m_axis_tvalid", true, 1, "", false, "a result is offered"},
                           {"m_axis_tready", false, 1, "", false, "the receiver takes the result at this edge"}});
    return out;
}

std::string range(const Port& port) {
    if (!port.parameter.empty()) return fmt::format("[{}-1:0]", port.parameter);
    return port.bits == 1 ? "" : fmt::format("[{}:0]", port.bits - 1);
}

std::string joined(const std::vector<std::string>& texts, std::string_view between) {
    std::string out;
    for (const std::string& text : texts) out += (out.empty() ? "" : std::string(between)) + text;
    return out;
}

std::vector<std::string> names(const std::vector<Port>& ports) {
    std::vector<std::string> out;
    for (const Port& port : ports) out.push_back(port.name);
    return out;
}

/// What travels beside a number: s_ or m_axis_tuser and the sidebands, `kept` for tkeep.
std::string beside(char side, const Sidebands& with, const std::string& kept) {
    std::vector<std::string> all;
    if (with.id) all.push_back(fmt::format("{}_axis_tid", side));
    if (with.dest) all.push_back(fmt::format("{}_axis_tdest", side));
    if (with.keep) all.push_back(kept);
    all.push_back(fmt::format("{}_axis_tuser", side));
    return joined(all, ", ");
}

std::string in_braces(const std::string& text) { return text.find(',') == std::string::npos ? text : '{' + text + '}'; }

/// The signals between a lobe's unit and glint_axis, and that instance.
std::string around_lobe(const HardwareUnit& core, const std::string& width, const std::string& s,
                        const std::string& m) {
    return fmt::format(R"(    wire    [9:0] n;
    wire [{0}:0] cosine;
    wire [{1}:0] in_tag, out_tag;
    wire [{2}:0] y;

    glint_axis #(
        .F     ({3}),
        .O     ({2}),
        .USER_W({1}),
        .WORD_W(WORD_W)
    ) axis (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tdata (s_axis_tdata),
        .s_axis_tuser ({4}),
        .s_axis_tlast (s_axis_tlast),
        .s_axis_tvalid(s_axis_tvalid),
        .s_axis_tready(s_axis_tready),
        .m_axis_tdata (m_axis_tdata),
        .m_axis_tuser ({5}),
        .m_axis_tlast (m_axis_tlast),
        .m_axis_tvalid(m_axis_tvalid),
        .m_axis_tready(m_axis_tready),
        .valid_o      (in_valid),
        .ready_i      (in_ready),
        .n_o          (n),
        .cos_o        (cosine),
        .tag_o        (in_tag),
        .valid_i      (out_valid),
        .ready_o      (out_ready),
        .y_i          (y),
        .tag_i        (out_tag),
        .clamped_i    (clamped)
    );
)",
                       core.F + 1, width, core.O, core.F, in_braces(s), in_braces(m));
}

/// The signals between an effect's unit and a register slice at each end, and these.
std::string around_effect(const std::vector<Port>& in, const std::vector<Port>& results, const std::string& width,
                          const std::string& s, const std::string& m) {
    static constexpr std::string_view below = ",\n                   ";
    std::string wires, result_words;
    std::vector<std::string> taken, shown;
    int in_bits = 0, out_bits = 1;
    for (std::size_t k = 0; k < in.size(); ++k) {
        wires += fmt::format("    wire [{}:0] {};\n", in[k].bits - 1, in[k].name);
        taken.push_back("s_axis_tdata" + bits_of(k, in[k].bits));
        in_bits += in[k].bits;
    }
    for (const Port& port : results) {
        wires += fmt::format("    wire [{0}:0] {1}, shown_{1};\n", port.bits - 1, port.name);
        shown.push_back("shown_" + port.name);
        out_bits += port.bits;
        const int rest = word_bits - 1 - port.bits;
        result_words = fmt::format("shown_clamped, {}{}{}{}", rest > 0 ? fmt::format("{}'d0, ", rest) : "",
                                   shown.back(), result_words.empty() ? "" : ", ", result_words);
    }
    return fmt::format(R"({0}    wire [{1}:0] in_tag, out_tag;
    wire          shown_clamped;

    glint_skid #(
        .WIDTH({1} + 1 + {2})
    ) skid_in (
        .clk_i  (aclk),
        .rst_ni (aresetn),
        .valid_i(s_axis_tvalid),
        .ready_o(s_axis_tready),
        .data_i ({{{3}, s_axis_tlast, {4}}}),
        .valid_o(in_valid),
        .ready_i(in_ready),
        .data_o ({{in_tag, {5}}})
    );

    glint_skid #(
        .WIDTH({1} + 1 + {6})
    ) skid_out (
        .clk_i  (aclk),
        .rst_ni (aresetn),
        .valid_i(out_valid),
        .ready_o(out_ready),
        .data_i ({{out_tag, clamped, {7}}}),
        .valid_o(m_axis_tvalid),
        .ready_i(m_axis_tready),
        .data_o ({{{8}, m_axis_tlast, shown_clamped, {9}}})
    );

    assign m_axis_tdata = {{{10}}};
)",
                       wires, width, in_bits, s, joined(taken, below), joined(names(in), ", "), out_bits,
                       joined(names(results), ", "), m, joined(shown, ", "), result_words);
}

/// The instance of the unit; of a lobe the wires have the names of glint_axis.
std::string instance(const HardwareUnit& core, const std::string& width, const std::vector<Port>& in,
                     const std::vector<Port>& results) {
    const auto wire = [&](const std::string& port) -> std::string {
        if (core.kind != "lobe") return port;
        return port == "n_i" ? "n" : port == "cos_i" ? "cosine" : "y";
    };
    std::vector<std::pair<std::string, std::string>> all{
        {"clk_i", "aclk"}, {"rst_ni", "aresetn"}, {"valid_i", "in_valid"}, {"ready_o", "in_ready"}};
    for (const Port& port : in) all.emplace_back(port.name, wire(port.name));
    all.insert(all.end(), {{"tag_i", "in_tag"}, {"valid_o", "out_valid"}, {"ready_i", "out_ready"}});
    for (const Port& port : results) all.emplace_back(port.name, wire(port.name));
    all.insert(all.end(), {{"tag_o", "out_tag"}, {"clamped_o", "clamped"}});
    std::size_t longest = 0;
    for (const auto& [port, name] : all) longest = std::max(longest, port.size());
    std::vector<std::string> connections, values;
    for (const auto& [port, name] : all) connections.push_back(fmt::format("        .{:{}}({})", port, longest, name));
    for (const HardwareUnit::Parameter& p : core.parameters) {
        if (p.name != "TAG_W") values.push_back(fmt::format("        .{0}({0})", p.name));
    }
    values.push_back(fmt::format("        .TAG_W({} + 1)", width));
    return fmt::format("\n    {} #(\n{}\n    ) core (\n{}\n    );\n", core.name, joined(values, ",\n"),
                       joined(connections, ",\n"));
}

/// The comment that a generated file starts with.
std::string header(const HardwareUnit& core, const std::string& module, const std::string& command) {
    const std::string what = core.kind == "lobe" ? core.core : fmt::format("the effect {}", core.effect);
    return fmt::format(
        "// {}: {} as an AXI4-Stream unit at profile {}.\n"
        "// Generated by `glint emit {}`; do not edit. Ports: docs/{}.md.\n",
        module, what, core.profile, command, core.kind == "lobe" ? "rtl" : fmt::format("effects/{}", core.effect));
}

/// The command that writes the unit.
std::string command(const HardwareUnit& core, const Sidebands& side) {
    std::string out;
    if (core.kind == "effect") out = fmt::format("--effect {} ", core.effect);
    if (!core.lobe.empty()) out += fmt::format("--lobe {} ", core.lobe);
    out += fmt::format("--profile {}", core.profile);
    const std::string& architecture = core.architectures.front().name;
    if (core.kind == "lobe") {
        const std::string lobe = core.lobe.substr(0, core.lobe.find(':'));
        if (architecture != default_architecture(find_lobe(lobe)).name) out += " --architecture " + architecture;
    }
    std::vector<std::string> bands;
    if (side.keep) bands.emplace_back("keep");
    if (side.id) bands.emplace_back("id");
    if (side.dest) bands.emplace_back("dest");
    return bands.empty() ? out : out + " --sidebands " + joined(bands, ",");
}

/// "glint_bps_axis_p12" of "glint_bps_p12".
std::string axis_name(const HardwareUnit& core) {
    const std::string lobe = core.lobe.substr(0, core.lobe.find(':'));
    std::string before = "glint_" + lobe;
    if (core.kind == "effect") {
        before = fmt::format("glint_effect_{}{}{}", core.effect, lobe.empty() ? "" : "_", lobe);
    }
    return before + "_axis" + core.name.substr(before.size());
}

GeneratedFile axi_stream(const HardwareUnit& core, const Sidebands& side) {
    const bool lobe = core.kind == "lobe";
    HardwareUnit unit = core;
    unit.core = core.name;
    unit.numbers = {};
    unit.name = axis_name(core);
    unit.kind = lobe ? "lobe_axis" : "effect_axis";
    unit.files = files_of(lobe ? "glint_axis" : "glint_skid");
    add_files(unit.files, core.files);
    unit.files.push_back({unit.name + ".v", true});
    unit.ports = axis_ports(core, side);
    unit.parameters = {{"USER_W", "16", "at least 1", "bits of tuser"}};
    if (side.id) unit.parameters.push_back({"ID_W", "8", "at least 1", "bits of tid"});
    if (side.dest) unit.parameters.push_back({"DEST_W", "4", "at least 1", "bits of tdest"});
    if (lobe) {
        unit.parameters.push_back({"WORD_W", "64", core.F <= 20 ? "32, 64" : "64", "bits of s_axis_tdata"});
    }
    std::copy_if(core.parameters.begin(), core.parameters.end(), std::back_inserter(unit.parameters),
                 [](const HardwareUnit::Parameter& p) { return p.name != "TAG_W"; });
    for (HardwareUnit::Architecture& a : unit.architectures) a.latency += block::axis().clocks;

    std::vector<std::string> parameters, ports;
    for (const HardwareUnit::Parameter& p : unit.parameters) {
        const std::string bits = p.bits == 0 ? "" : fmt::format("[{}:0] ", p.bits - 1);
        const std::string sized = p.bits == 0 ? "" : fmt::format("{}'d", p.bits);
        parameters.push_back(fmt::format("    parameter {}{} = {}{}", bits, p.name, sized, p.value));
    }
    std::size_t longest = 0;
    for (const Port& port : unit.ports) longest = std::max(longest, range(port).size());
    for (const Port& port : unit.ports) {
        ports.push_back(
            fmt::format("    {:6} wire {:>{}} {}", port.output ? "output" : "input", range(port), longest, port.name));
        if (!lobe && port.name == "s_axis_tdata") {
            ports.back() = fmt::format(
                "    /* verilator lint_off UNUSED */  // bits between the fields are ignored\n{},\n"
                "    /* verilator lint_on UNUSED */",
                ports.back());
        }
    }
    std::string list;
    for (std::size_t i = 0; i < ports.size(); ++i) {
        const bool comma = i + 1 < ports.size() && !ports[i].ends_with("*/");
        list += ports[i] + (comma ? ",\n" : "\n");
    }

    std::string width = "USER_W", wider;
    if (side.keep || side.id || side.dest) {
        width = "SIDE_W";
        wider = fmt::format("    localparam SIDE_W = USER_W{}{}{};\n\n", side.keep ? " + 1" : "",
                            side.id ? " + ID_W" : "", side.dest ? " + DEST_W" : "");
    }
    const std::string s = beside('s', side, "|s_axis_tkeep"), m = beside('m', side, "kept");
    const std::vector<Port> in = numbers(core, false), results = numbers(core, true);
    std::string keep;
    if (side.keep) {
        wider += "    wire          kept;\n";
        keep = fmt::format("\n    assign m_axis_tkeep = {{{}{{kept}}}};\n", results.size() * word_bits / 8);
    }
    return {GeneratedFile::Target::verilog, unit.name + ".v",
            header(core, unit.name, command(core, side)) +
                fmt::format(R"(
`default_nettype none
// verilator lint_off TIMESCALEMOD

module {} #(
{}
) (
{});

{}    wire          in_valid, in_ready, out_valid, out_ready, clamped;
{}{}{}
endmodule

`default_nettype wire
)",
                            unit.name, joined(parameters, ",\n"), list, wider,
                            lobe ? around_lobe(core, width, s, m) : around_effect(in, results, width, s, m), keep,
                            instance(core, width, in, results)),
            unit};
}

}  // namespace

Sidebands parse_sidebands(std::string_view list) {
    Sidebands out;
    while (!list.empty()) {
        const std::string_view name = list.substr(0, list.find(','));
        if (name == "keep") {
            out.keep = true;
        } else if (name == "id") {
            out.id = true;
        } else if (name == "dest") {
            out.dest = true;
        } else {
            throw Error(fmt::format("--sidebands '{}' is not legal: keep, id, dest, separated by commas", name));
        }
        list.remove_prefix(std::min(list.size(), name.size() + 1));
    }
    return out;
}

std::vector<GeneratedFile> with_axi_stream(std::vector<GeneratedFile> files, const Sidebands& sidebands) {
    GeneratedFile wrapper = axi_stream(*files.front().unit, sidebands);
    files.insert(files.begin() + 1, std::move(wrapper));
    return files;
}

}  // namespace glint
