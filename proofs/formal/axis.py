"""The text of AXI4-Stream wrappers under proof, and what the properties of axis.vh need to know of their words."""

import pathlib
import re
import subprocess

STREAM = ("clk_i", "rst_ni", "valid_i", "ready_o", "tag_i", "valid_o", "ready_i", "tag_o", "clamped_o")
STAND_IN_CLOCKS = 4
SIDEBANDS = "keep,id,dest"


def edited(name, text, old, new):
    if text.count(old) != 1:
        raise RuntimeError(f"the edit applies {text.count(old)} times to {name}.v, not once")
    return text.replace(old, new)


def emitted(glint, unit, folder, name, *options):
    """The wrapper `name` around the unit, written by the command `glint` with these options."""
    of = (["--effect", unit["effect"]] if unit["effect"] else []) + (["--lobe", unit["lobe"]] if unit["lobe"] else [])
    command = [str(glint), "emit", *of, "--profile", unit["profile"], "--target", "verilog", *options, "-o", str(folder / "emitted")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"`{' '.join(command)}`: {done.stderr.strip()}")
    return pathlib.Path(folder / "emitted" / f"{name}.v").read_text()


def at_any_size(units, unit, text, names):
    """The wrapper of a lobe with parameters for its numbers, around the unit in the place of the unit's own wrapper."""
    module, core, F, O = unit["name"], unit["core"]["module"], unit["F"], unit["O"]
    declared = "".join(f", {name} = 0" for name in ["CORE_CLOCKS", *names])
    passed = "".join(f".{name}({name}), " for name in names)
    for old, new in (("parameter USER_W = 16", f"parameter USER_W = 16{declared}"), (f".F     ({F})", ".F     (F)"),
                     (f".O     ({O})", ".O     (O)"), (f"[{F + 1}:0] cosine;", "[F+1:0] cosine;"),
                     (f"[{O}:0] y;", "[O:0] y;"), (f"{core} #(", f"{units[core]['core']['module']} #({passed}")):
        text = edited(module, text, old, new)
    return text.replace("        .LOGIC(LOGIC),\n", "")  # of the tables, which are not in the core


def numbers(unit, direction):
    return [port for port in unit["ports"] if port["direction"] == direction and port["name"] not in STREAM]


def stand_in(unit):
    """In the place of an effect's unit: its ports around a glint_stream of a few clocks, with any results."""
    parameters = ", ".join(f"parameter {p['name']} = {p['default']}" for p in unit["parameters"])
    ports = ", ".join(f"{p['direction']} wire [{p['width']}-1:0] {p['name']}" for p in unit["ports"])
    results = "".join(f"    (* anyseq *) wire [{p['width']}-1:0] any_{p['name']};\n    assign {p['name']} = any_{p['name']};\n"
                      for p in numbers(unit, "output"))
    connected = ", ".join(f".{name}({name})" for name in STREAM)
    return (f"module {unit['name']} #({parameters}) ({ports});\n{results}"
            f"    (* anyseq *) wire any_clamped;\n"
            f"    glint_stream #(.LATENCY({STAND_IN_CLOCKS}), .TAG_W(TAG_W)) stream ({connected}, .clamped_i(any_clamped), .advance_o());\n"
            "endmodule\n")


def words_of_lobe():
    """What axis.vh reads: the fields as docs/contract.md has them, by the parameters F, O and WORD_W."""
    return """
localparam OPERAND_W = F + 2 + 10;
localparam RESULT_W  = O + 2;
localparam WORDS_W   = 32;
wire [OPERAND_W-1:0] offered = {s_axis_tdata[WORD_W == 32 ? 10 : 32 +: F + 2], s_axis_tdata[9:0]};
wire [OPERAND_W-1:0] taken   = {cosine, n};
wire  [RESULT_W-1:0] given   = {clamped, y};
reg   [RESULT_W-1:0] result;  // what the core answered to the watched item
wire   [WORDS_W-1:0] words   = {result[O+1], {(30 - O) {1'b0}}, result[O:0]};
"""


def words_of_effect(unit):
    """The same of an effect: a word of 32 bits for each number, from bit 0; bit 31 of each result is `clamped`."""
    inputs, results = numbers(unit, "input"), numbers(unit, "output")
    low, words = 0, []
    for port in reversed(results):
        words.insert(0, f"{{result[RESULT_W-1], {31 - port['width']}'d0, result[{low + port['width'] - 1}:{low}]}}"
                     if port["width"] < 31 else f"{{result[RESULT_W-1], result[{low + 30}:{low}]}}")
        low += port["width"]
    offered = ", ".join(f"s_axis_tdata[{32 * k + port['width'] - 1}:{32 * k}]" for k, port in enumerate(inputs))
    return f"""
localparam OPERAND_W   = {sum(port['width'] for port in inputs)};
localparam RESULT_W    = {low + 1};
localparam WORDS_W     = {32 * len(results)};
localparam CORE_CLOCKS = {STAND_IN_CLOCKS};
wire [OPERAND_W-1:0] offered = {{{offered}}};
wire [OPERAND_W-1:0] taken   = {{{', '.join(port['name'] for port in inputs)}}};
wire  [RESULT_W-1:0] given   = {{clamped, {', '.join(port['name'] for port in results)}}};
reg   [RESULT_W-1:0] result;  // what the core answered to the watched item
wire   [WORDS_W-1:0] words   = {{{', '.join(reversed(words))}}};
"""


def beside(sidebands):
    """What travels with an item: as it comes, and as it leaves."""
    if not sidebands:
        return ("localparam TAG_W = USER_W + 1;\nwire [TAG_W-1:0] item_in = {s_axis_tuser, s_axis_tlast};\n"
                "wire [TAG_W-1:0] item_out = {m_axis_tuser, m_axis_tlast};\n")
    return """localparam TAG_W = USER_W + 1 + ID_W + DEST_W + 1;
wire [TAG_W-1:0] item_in  = {s_axis_tid, s_axis_tdest, s_axis_tkeep != 0, s_axis_tuser, s_axis_tlast};
wire [TAG_W-1:0] item_out = {m_axis_tid, m_axis_tdest, m_axis_tkeep[0], m_axis_tuser, m_axis_tlast};
always @* keep_whole: assert (&m_axis_tkeep == |m_axis_tkeep);
"""


def frame(text, in_stream, effect):
    """axis.vh for a core whose numbers stand in glint_stream, and for an effect's wrapper, which has its slices itself."""
    if in_stream:
        text = text.replace("core.ports.all.", "core.stream.").replace("core.ports.", "core.stream.")
    return re.sub(r"\\axis\.skid", r"\\skid", text) if effect else text
