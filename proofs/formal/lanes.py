"""The proof that the lanes of an AXI4-Stream unit keep step: its model.

The wrapper is what `glint emit --lanes` writes, around the units as they are: nothing is cut. What their handshake depends on
is found by Yosys, back from `tready` and `tvalid` of each lane; every register there has to be equal in all lanes. So a
handshake that depends on a number, of which each lane has another, does not pass.
"""

import re

from tasks import flatten

LANES = 3


def instance(lane):
    return f"lane[{lane}].{'other' if lane else 'first'}.unit"


def everywhere(name):
    """Whether a wire of the unit has the same value in all lanes, as Verilog."""
    return " && ".join(rf"\{instance(0)}.{name} == \{instance(lane)}.{name} " for lane in range(1, LANES))


def registers(task, folder, run):
    """The registers that the handshake of a lane depends on, which the others have, too: name in the unit, width."""
    (folder / "cone.ys").write_text(
        f"{read(task)}proc\nflatten\nopt_clean\n"
        "select -set cone w:*.unit.s_axis_tready w:*.unit.m_axis_tvalid %ci*\n"
        "select -set kept @cone t:$*dff* %i %co1:+[Q] w:* %i\ntee -q -o registers.txt select -list @kept\nwrite_rtlil cone.il\n")
    run(["yosys", "-q", "-l", "cone.log", "cone.ys"], folder, "Yosys")
    widths = {name: int(width or 1) for width, name in
              re.findall(r"^  wire (?:width (\d+) )?.*?\\(\S+)$", (folder / "cone.il").read_text(), re.M)}
    found = {line.split("/", 1)[1] for line in (folder / "registers.txt").read_text().splitlines()}
    suffixes = [name[len(instance(0)) + 1:] for name in sorted(found) if name.startswith(instance(0) + ".")]
    return {suffix: widths[f"{instance(0)}.{suffix}"] for suffix in suffixes
            if all(f"{instance(lane)}.{suffix}" in found for lane in range(LANES))}


def read(task):
    """The Yosys commands that read the copies."""
    chosen = " ".join(f"-chparam {name} {value}" for name, value in {"LANES": LANES, **task.parameters}.items())
    return f"read_verilog -formal -defer -D SYNTHESIS *.v\nhierarchy -check -top {task.top} {chosen}\n"


def write_model(task, folder, modules, unit, run):
    """Writes the copies, model.il and model.smt2."""
    for name, text in modules.items():
        (folder / f"{name}.v").write_text(text)
    kept = registers(task, folder, run)
    word = next(port["width"] for port in unit["ports"] if port["name"] == "s_axis_tdata")
    word = next((int(p["default"]) for p in unit["parameters"] if p["name"] == word), word)
    seen = {"s_axis_tready": 1, "m_axis_tvalid": 1, "s_axis_tdata": word, **kept}
    text = "".join(f"(* hierconn *) wire [{width - 1}:0] \\{instance(lane)}.{name} ;\n"
                   for name, width in seen.items() for lane in range(LANES))
    text += "always @* begin\n    if ($initstate) assume (!aresetn);\n    else begin\n"
    text += f"        same_ready: assert ({everywhere('s_axis_tready')});\n"
    text += f"        same_valid: assert ({everywhere('m_axis_tvalid')});\n"
    text += f"        inv_step: assert ({' && '.join(everywhere(name) for name in kept)});\n    end\n"
    own = " && ".join(rf"\{instance(k)}.s_axis_tdata == s_axis_tdata[{k * word}+:{word}]" for k in range(LANES))
    text += f"    own_words: assert ({own});\n"
    text += f"    cover_other_words: cover (s_axis_tvalid && s_axis_tready && s_axis_tdata[{word}] != s_axis_tdata[0]);\n"
    text += "    cover_stall: cover (m_axis_tvalid && !m_axis_tready && aresetn && !s_axis_tready);\nend\n"
    copy = folder / f"{task.top}.v"
    end = modules[task.top].rindex("endmodule")
    copy.write_text(modules[task.top][:end] + text + modules[task.top][end:])
    kind = "assert" if task.method == "cover" else "cover"
    (folder / "model.ys").write_text(
        f"{read(task)}proc\n{flatten()}delete t:${kind}\n"
        "delete -output o:*\nopt_expr\nopt_clean\n"  # what no property looks at goes
        "setundef -undriven -anyseq\nopt -full\ndffunmap\nopt_clean\n"
        "check -assert\nwrite_rtlil model.il\nwrite_smt2 -wires model.smt2\n")
    run(["yosys", "-q", "-l", "yosys.log", "model.ys"], folder, "Yosys")
