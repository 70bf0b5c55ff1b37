"""Every input of a pipelined unit, with each open fault: the same results?

A unit without stalls is a function of its input: each of its registers takes over a value a clock, so a wire in its place
gives the same numbers. Yosys makes gates of that function; exhaust.cpp runs them on every code of every port, legal or not.
That speaks of a fault only if it is in the numbers: it must not reach an enable, valid_o or ready_o. Then a fault that changes
no result is equivalent, stalls and resets included: whatever a register holds is what it holds here, with the fault or
without. Where all inputs are too many, what a fault changes is followed as far as MOST bits of input decide.
"""

import functools
import json
import re
import subprocess

from faults import HERE, Failed

MOST = 28  # bits of input that are tried
OPS = {"$_AND_": "&", "$_OR_": "|", "$_XOR_": "^", "$_ANDNOT_": "d", "$_ORNOT_": "o", "$_NOT_": "!", "$_MUX_": "?"}
WIRES = "".join(f"module \\{cell} ({', '.join(ports)}); parameter WIDTH = 1; parameter CLK_POLARITY = 1; parameter EN_POLARITY = 1;\n"
                f"input CLK{', EN' if 'EN' in ports else ''}; input [WIDTH-1:0] D; output [WIDTH-1:0] Q; assign Q = D; endmodule\n"
                for cell, ports in (("$dff", ("CLK", "D", "Q")), ("$dffe", ("CLK", "EN", "D", "Q"))))


def in_numbers(faults, numbers, stuck=False):
    """The faults of a unit that touch its numbers alone: number, and how `mutate` applies it. What changes a register's own value in
    a stall is applied to the value that the register takes over: each later reader sees the one or the other."""
    faults.yosys("read_rtlil unit.il\nwrite_json unit.json\n")
    module = json.loads((faults.folder / "unit.json").read_text())["modules"][faults.module]
    cells, readers, held = module["cells"], {}, {}
    for name, cell in cells.items():
        outputs = {"Y", "Q", "DATA", "RD_DATA", "mutant_o"}
        for port, wires in cell["connections"].items():
            for wire in wires if port not in outputs else ():
                readers.setdefault(wire, []).append((name, port))
        if cell["type"].startswith("$dff"):
            held[tuple(cell["connections"]["D"])] = cell["connections"]["Q"]

    def holds(cell):
        """A multiplexer that keeps a register's value."""
        return cell["type"] == "$mux" and held.get(tuple(cell["connections"]["Y"])) == cell["connections"]["A"]

    steers = {wire for port in ("valid_o", "ready_o", "m_axis_tvalid", "s_axis_tready") for wire in module["ports"].get(port, {"bits": []})["bits"]}

    def out(cell):
        return [w for port in ("Y", "Q", "DATA", "RD_DATA") for w in cell["connections"].get(port, [])]

    def applied(fault):
        name, port = (re.search(rf"-{key} (\S+)", fault["apply"])[1] for key in ("cell", "port"))
        cell = cells[name] if name in cells else cells[name.lstrip("\\")]
        if holds(cell) and port == "S" and not (stuck and "-mode const0" in fault["apply"]):
            return None
        todo, seen = out(cell), set()
        while todo:
            wire = todo.pop()
            if wire in seen:
                continue
            seen.add(wire)
            if wire in steers:
                return None
            for reader, at in readers.get(wire, ()):
                if at in ("EN", "RD_EN", "WR_EN", "ARST", "SRST") or at == "S" and holds(cells[reader]):
                    return None
                todo += out(cells[reader])
        return fault["apply"].replace("-port A", "-port B") if holds(cell) else fault["apply"]

    out_of_all = {f["number"]: "" if "flip" in f else applied(f) for f in faults.faults if f["number"] in numbers}
    return {number: text for number, text in out_of_all.items() if text is not None}


def gates(faults, applied):
    """The function of the unit as gates: inputs, gates in order, outputs, wires of the choice."""
    chosen = [f for f in faults.faults if f["number"] in applied and "apply" in f]
    ports = [p for p in faults.numbers["ports"] if not re.fullmatch("clk_i|rst_ni|valid_[io]|ready_[io]|tag_[io]", p["name"])]
    given = "".join(f", input [{p['width'] - 1}:0] {p['name']}" for p in ports if p["direction"] == "input")
    taken = "".join(f", output [{p['width'] - 1}:0] {p['name']}" for p in ports if p["direction"] == "output")
    choices = [f"m_{f['number']}" for f in chosen]
    named = "".join(f", .{name}({name})" for name in [p["name"] for p in ports] + choices)
    (faults.folder / "top.v").write_text(
        f"module top (input [15:0] mutant{given}{taken}{''.join(f', input {name}' for name in choices)});\n"
        f"{faults.module} unit (.clk_i(1'b0), .rst_ni(1'b1), .valid_i(1'b1), .ready_i(1'b1), .tag_i(31'd0), .mutant(mutant){named});\nendmodule\n")
    (faults.folder / "wires.v").write_text(WIRES)
    # The instances of glint_mutant, which switch the faults of tables on, become an input.
    text = (faults.folder / "unit.il").read_text()
    text = re.sub(r"(?:  attribute .*\n)*  cell \\glint_mutant \S+\n    connect \\mutant_o (.+)\n  end\n", r"  connect \1 \\mutant\n", text)
    text = re.sub(rf"(module \\{faults.module}\n)", r"\1  wire width 16 input 9999 \\mutant\n", text)
    (faults.folder / "chosen.il").write_text(text)
    script = "".join(f"mutate -ctrl m_{fault['number']} 1 1 -module {faults.module} {applied[fault['number']]}\n" for fault in chosen)
    faults.yosys(f"""read_rtlil chosen.il
{script}read_verilog top.v
hierarchy -top top
flatten
opt_expr
opt_clean
memory
opt_expr
opt_clean
techmap -map wires.v
opt -full
techmap
opt -fast
abc -fast -g AND,OR,XOR,ANDNOT,ORNOT,MUX
opt_clean
write_json gates.json
""")
    return json.loads((faults.folder / "gates.json").read_text())["modules"]["top"]


class Circuit:
    """The gates in order, and for each fault what exhaust.cpp reads."""

    def __init__(self, module):
        ports = module["ports"]
        self.choices = {n: p["bits"] for n, p in ports.items() if re.fullmatch(r"mutant|m_\d+", n)}
        inputs = [n for n, p in ports.items() if p["direction"] == "input" and n not in self.choices]
        self.inputs = [w for name in sorted(inputs, key=lambda n: n != "cos_i") for w in ports[name]["bits"]]
        self.outputs = [w for p in ports.values() if p["direction"] == "output" for w in p["bits"]]
        self.cells = {cell["connections"]["Y"][0]: (OPS[cell["type"]], [cell["connections"].get(p, ["0"])[0] for p in "ABS"])
                      for cell in module["cells"].values()}
        self.ordered, seen = [], set()
        for root in self.cells:
            stack = [(root, False)]
            while stack:
                wire, done = stack.pop()
                if done:
                    self.ordered.append(wire)
                elif wire in self.cells and wire not in seen:
                    seen.add(wire)
                    stack.append((wire, True))
                    stack += [(w, False) for w in self.cells[wire][1]]
        self.support = {wire: 1 << i for i, wire in enumerate(self.inputs)}
        for wire in self.ordered:
            self.support[wire] = functools.reduce(int.__or__, (self.support.get(x, 0) for x in self.cells[wire][1]))
        rank = {wire: i for i, wire in enumerate(self.ordered)}
        self.ordered.sort(key=lambda w: (self.support[w].bit_count(), rank[w]))  # still operands first

    def cone(self, number, most):
        """What a fault changes: the value of its choice, the wires that need no more inputs than `most`, those that lead on, the inputs, and
        whether they lead to outputs alone."""
        value = {w: 1 for w in self.choices.get(f"m_{number}", [])} or \
            {w: 1 for i, w in enumerate(self.choices["mutant"]) if number >> i & 1}
        moved, ends, whole, inputs = set(value), set(), True, 0
        for wire in self.ordered:
            operands = moved.intersection(self.cells[wire][1])
            if operands:
                if (inputs | self.support[wire]).bit_count() <= most:
                    inputs |= self.support[wire]
                    moved.add(wire)
                else:
                    ends |= operands - set(value)
                    whole = False
        return value, moved, ends | moved.intersection(self.outputs), inputs, whole

    def text(self, cones, inputs, random):
        """A run over some inputs, with the faults that need these alone."""
        needed, todo = set(), [x for _, moved, ends, _, _ in cones.values() for w in moved | ends if w in self.cells for x in (w, *self.cells[w][1])]
        while todo:
            wire = todo.pop()
            if wire in self.cells and wire not in needed:
                needed.add(wire)
                todo += self.cells[wire][1]
        place = {"0": 0, "1": 1, "x": 0, **{w: 0 for bits in self.choices.values() for w in bits}}
        place |= {w: 2 + i for i, w in enumerate(w for i, w in enumerate(self.inputs) if inputs >> i & 1)}
        first = 2 + inputs.bit_count()
        gates = [w for w in self.ordered if w in needed]
        place |= {w: first + i for i, w in enumerate(gates)}
        lines = [" ".join([self.cells[w][0], *(str(place.get(x, 0)) for x in self.cells[w][1])]) for w in gates]
        for number, (value, moved, ends, _, _) in cones.items():
            now, cone = dict(value), []
            for wire in gates:
                if wire in moved:
                    op, operands = self.cells[wire]
                    now[wire] = first + len(gates) + len(cone)
                    cone.append(" ".join([op, *(str(now.get(x, place.get(x, 0))) for x in operands), str(now[wire])]))
            lines += [f"{number} {len(cone)} {len(ends)}", *cone, *(f"{place[w]} {now[w]}" for w in ends)]
        return f"inputs {inputs.bit_count()} random {random} gates {len(gates)} faults {len(cones)}\n" + "\n".join(lines) + "\n"


def possible(faults):
    """A result a clock, and no wrapper."""
    stated = next(a for a in faults.unit["architectures"] if a["name"] == faults.architecture)
    return faults.form == "core" and stated["interval"] == 1 and not faults.module.startswith("glint_effect_shade")


def legal(faults, told):
    """Is an input of a lobe, cos_i its last bits, one of the exhaustive test? n = 0 gives what n = 1 does."""
    width = next((p["width"] for p in faults.numbers["ports"] if p["name"] == "cos_i"), 0)
    return not width or int(told[-width:], 2) <= 1 << (width - 2)


def exhaust(faults, numbers, random=0):
    """Number and what was found, of those faults that are in the numbers: "none" where no input makes a difference, an input that does,
    or nothing: a wire inside differs, and which results that changes needs more inputs than can be tried."""
    applied = in_numbers(faults, numbers)
    if not applied:
        return {}
    circuit = Circuit(gates(faults, applied))
    program = faults.folder / "exhaust"
    subprocess.run(["g++", "-std=c++20", "-O3", "-march=native", HERE / "exhaust.cpp", "-o", program], check=True)
    runs, out = {}, {}
    for number in sorted(applied):
        cone = circuit.cone(number, 1000 if random else MOST)
        runs.setdefault(cone[3], {})[number] = cone
    for inputs, cones in runs.items():
        done = subprocess.run([program], input=circuit.text(cones, inputs, random), capture_output=True, text=True)
        if done.returncode != 0:
            raise Failed(done.stderr)
        for number, found in map(str.split, done.stdout.splitlines()):
            decided = cones[int(number)][4] if found != "none" else not random
            out[int(number)] = found if decided else ""
    return out
