"""The proof that `y` belongs to its own input: its model.

Two units of the same text stand side by side (own.vh). A product may be any number, but the same one in both where both its
factors are the same, and so may the difference of a divider's row: what holds then holds for the real ones. All else is as it stands, quotients and tables, too. What the
induction needs is that the registers which hold the watched input are equal in both. Which these are is found in the netlist: a
register stands as many clocks behind the ports as the registers that it is computed from, and one.
"""

import json
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
PRODUCT = "always @(posedge clk_i) if (enable_i) product_q <= a * slice;"  # in glint_multiplier
ROW = "wire [Y_W+1:0] difference = {shifted, 1'b1} + {1'b1, complement, 1'b1};"  # in glint_divider_restoring
# What may be any number, but equal where the two of its operands are: the end of its name, its operands.
FUNCTIONS = (("_slice.product", ("a", "slice")), (".difference", ("shifted", "complement")))


def read(top, chosen, folder, run):
    """The netlist of the unit."""
    (folder / "depth.ys").write_text(
        f"read_verilog -formal -defer -D SYNTHESIS *.v\nhierarchy -check -top {top} {chosen}\nproc -norom\nflatten\nopt_expr\nopt_dff\nopt_clean\n"
        "write_json depth.json\n")
    run(["yosys", "-q", "-l", "depth.log", "depth.ys"], folder, "Yosys")
    return json.loads((folder / "depth.json").read_text())["modules"][top]


def registers(module):
    """Of each clock of the pipeline, the bits of registers that hold what entered so many clocks ago: [(name, bit), ...]."""
    named = {}
    for name, net in module["netnames"].items():
        for place, bit in enumerate(net["bits"]):
            if not net["hide_name"] and not isinstance(bit, str):
                named.setdefault(bit, (name, place + net.get("offset", 0)))
    source, registered, register = {}, {}, {}
    for cell in module["cells"].values():
        wires = cell["connections"]
        given = [bit for port, bits in wires.items() if cell["port_directions"][port] == "input" for bit in bits if not isinstance(bit, str)]
        if re.match(r"\$s?dff", cell["type"]):
            registered |= dict(zip(wires["Q"], wires["D"]))
            register |= {bit: set(wires["Q"]) for bit in wires["Q"]}
        else:
            for port, bits in wires.items():
                if cell["port_directions"][port] == "output":
                    source |= {bit: given for bit in bits}
    steers = {bit for bit, (name, _) in named.items() if name.endswith("ports.valid_q")}

    def behind(bit):
        """The registers that a register is computed from."""
        seen, stack, found = set(), [registered[bit]], set()
        while stack:
            wire = stack.pop()
            if wire in seen or isinstance(wire, str):
                continue
            seen.add(wire)
            if wire in registered:
                found.add(wire)
            else:
                stack += source.get(wire, [])
        return found - steers - register[bit]

    from_ = {bit: behind(bit) for bit in registered if bit not in steers and not isinstance(registered[bit], str)}
    constant = {bit for bit in registered if bit not in steers and bit not in from_}
    while True:  # and what is computed from these alone
        more = {bit for bit, others in from_.items() if others and others <= constant}
        if not more:
            break
        constant |= more
        from_ = {bit: others for bit, others in from_.items() if bit not in more}
    from_ = {bit: others - constant for bit, others in from_.items()}
    depth = {}
    while len(depth) < len(from_):
        ready = [bit for bit in from_ if bit not in depth and all(other in depth for other in from_[bit])]
        if not ready:
            raise RuntimeError("the registers of this unit are no pipeline")
        for bit in ready:
            of = {depth[other] for other in from_[bit]}
            if len(of) > 1:
                raise RuntimeError(f"{named.get(bit)} is computed from registers of clocks {sorted(of)}")
            depth[bit] = of.pop() + 1 if of else 0
    readers = {}
    for bit in registered:
        if bit not in steers:
            for other in behind(bit) if not isinstance(registered[bit], str) else ():
                readers.setdefault(other, []).append(bit)
    left = set(constant)
    while left:  # a constant holds from the clock on in which what reads it wants it
        ready = {bit for bit in left if any(reader in depth for reader in readers.get(bit, []))}
        if not ready:
            break  # nothing reads the others
        for bit in ready:
            depth[bit] = min(depth[reader] for reader in readers[bit] if reader in depth) - 1
        left -= ready
    out = {}
    for bit, clock in depth.items():
        out.setdefault(clock, []).append(named[bit])
    return out


def slices(bits):
    """Runs of neighbouring bits of a register: (name, high, low)."""
    out = []
    for name, bit in sorted(bits):
        if out and out[-1][0] == name and out[-1][1] + 1 == bit:
            out[-1][1] = bit
        else:
            out.append([name, bit, bit])
    return out


def beside(task, unit, netlist, found):
    """The properties of the unit, the instance `other`, and which clocks' registers are equal in both, as Verilog."""
    width = {name: len(net["bits"]) for name, net in netlist["netnames"].items()}
    clocks = width["core.ports.valid_q"]
    if found and sorted(found) != list(range(clocks)):
        raise RuntimeError(f"registers of clocks {sorted(found)}, where the unit has {clocks}")
    lines = [f"localparam CLOCKS = {clocks}, F = {unit['F']}, O = {unit['O']};",
             (HERE / "unit.vh").read_text().replace("\\ports.", "\\core.ports."),
             f"(* hierconn *) wire [{clocks - 1}:0] \\other.core.ports.valid_q ;"]
    lines += [f"(* hierconn *) wire [{width[name] - 1}:0] \\{copy}{name} ;" for copy in ("", "other.")
              for name in sorted({name for bits in found.values() for name, _ in bits})]
    chosen = ", ".join(f".{name}({value})" for name, value in task.parameters.items())
    lines += ["(* anyseq *) wire [9:0] other_n;", "(* anyseq *) wire [F+1:0] other_cos;",
              "wire other_valid, other_ready, other_clamped;", "wire [O:0] other_y;", "wire [TAG_W-1:0] other_tag;",
              f"{task.top}_other #({chosen}) other (.clk_i(clk_i), .rst_ni(rst_ni),",
              "    .valid_i(valid_i), .ready_o(other_ready), .n_i(other_n), .cos_i(other_cos), .tag_i(tag_i), .valid_o(other_valid),",
              "    .ready_i(ready_i), .y_o(other_y), .tag_o(other_tag), .clamped_o(other_clamped));",
              f"wire [{clocks - 1}:0] same_registers;"]
    for name, operands in ((name, operands) for end, operands in FUNCTIONS for name in width if name.endswith(end)):
        place, result = name.rsplit(".", 1)
        if f"{place}.{operands[0]}" not in width:
            continue
        for copy in ("", "other."):
            lines += [f"(* hierconn *) wire [{width[f'{place}.{part}'] - 1}:0] \\{copy}{place}.{part} ;" for part in (*operands, result)]
        same = " && ".join(f"\\{place}.{part} == \\other.{place}.{part} " for part in operands)
        lines.append(f"always @* if ({same}) assume (\\{name} == \\other.{name} );")
    if not found:
        lines.append("assign same_registers = 0;")
    for clock in sorted(found):
        same = " && ".join(f"\\{name} [{high}:{low}] == \\other.{name} [{high}:{low}]" if width[name] > 1 else f"\\{name} == \\other.{name} "
                           for name, high, low in slices(found[clock]))
        lines.append(f"assign same_registers[{clock}] = {same};")
    return "\n".join([*lines, (HERE / "own.vh").read_text().replace("\\ports.", "\\core.ports.").replace("\\other.ports.", "\\other.core.ports.")])


def write_model(task, folder, unit, modules, run):
    """Writes the copies, model.il and model.smt2."""
    for name, text in modules.items():
        (folder / f"{name}.v").write_text(text)
    chosen = " ".join(f"-chparam {name} {value}" for name, value in task.parameters.items())
    named = PRODUCT.replace("a * slice", "product")
    cuts = {"glint_multiplier": (PRODUCT, f"wire [NODE_W-1:0] product = a * slice; {named}", f"(* anyseq *) wire [NODE_W-1:0] product; {named}"),
            "glint_divider_restoring": (ROW, ROW, "(* anyseq *) wire [Y_W+1:0] difference;")}
    for name, (text, full, _) in cuts.items():
        if name in modules:
            if text not in modules[name]:
                raise RuntimeError(f"{name} has no '{text}'")
            (folder / f"{name}.v").write_text(modules[name].replace(text, full))
    netlist = read(task.top, chosen, folder, run)
    # A planted bug is looked for from reset, and needs no invariants.
    found = registers(netlist) if task.method == "induction" else {}
    for name, (text, _, cut) in cuts.items():
        if name in modules:
            (folder / f"{name}.v").write_text(modules[name].replace(text, cut))
    for name in ("glint_ports", "glint_delay"):  # the bookkeeping of the handshake's proof
        end = modules[name].rindex("endmodule")
        (folder / f"{name}.v").write_text(modules[name][:end] + (HERE / f"{name}.vh").read_text() + modules[name][end:])
    (folder / f"{task.top}_other.v").write_text(modules[task.top].replace(f"module {task.top} ", f"module {task.top}_other ", 1))
    end = modules[task.top].rindex("endmodule")
    (folder / f"{task.top}.v").write_text(modules[task.top][:end] + beside(task, unit, netlist, found) + modules[task.top][end:])
    (folder / "glint_scoreboard.v").write_text((HERE / "glint_scoreboard.v").read_text())
    (folder / "model.ys").write_text(
        f"read_verilog -formal -defer -D SYNTHESIS *.v\nhierarchy -check -top {task.top} {chosen}\nproc -norom\nflatten\n"
        f"delete t:${'assert' if task.method == 'cover' else 'cover'}\nsetundef -undriven -anyseq\nopt -full\ndffunmap\nopt_clean\n"
        "check -assert\nwrite_rtlil model.il\nwrite_smt2 -wires model.smt2\n")
    run(["yosys", "-q", "-l", "yosys.log", "model.ys"], folder, "Yosys")
