"""A unit that works on one input for many clocks, with each open fault: the same results?

The registers of a unit are cut, and the clocks of one input are laid out one after another: reset, transfer, then as many clocks
as the manifest states. What the registers hold at the start is free, so an input may follow any other, a reset or power-up.
A fault is equivalent where
  1. the results of that input are those of the unit without the fault: the same gates, or no difference for any value of what
     they depend on (exhaust.cpp up to MOST bits; else `cec` of ABC, which knows no such limit);
  2. while a result waits, the outputs stay, whatever the registers hold;
  3. valid_o, ready_o and the valid bits take the same gates.
With one input in the unit at a time, stalls come only while its result waits: the three say it all. In a pipelined unit a register
moves when its neighbours do: there 2 is not asked, and faults that reach an enable are left to the other tests.
"""

import json
import random
import re
import subprocess

from exhaust import in_numbers
from faults import HERE, Failed

MOST = 30  # bits of input that are tried
VALID = re.compile(r"(^|\.)(valid_q|full_q|spare_full_q)$")


class Gates:
    """And and exclusive-or gates, each once; a literal is twice a gate's number, odd where inverted; 0 is false."""

    def __init__(self):
        self.gates, self.known, self.names, self.free_of = [("0", 0, 0)], {}, {}, {}

    def free(self, name):
        if name not in self.free_of:
            self.gates.append(("i", name, 0))
            self.free_of[name] = 2 * (len(self.gates) - 1)
        return self.free_of[name]

    def add(self, op, a, b):
        key = (op, a, b)
        if key not in self.known:
            self.gates.append(key)
            self.known[key] = 2 * (len(self.gates) - 1)
        return self.known[key]

    def both(self, a, b):
        a, b = min(a, b), max(a, b)
        if a == 0 or a ^ b == 1:
            return 0
        return b if a == 1 or a == b else self.add("&", a, b)

    def differ(self, a, b):
        odd, a, b = (a ^ b) & 1, min(a & ~1, b & ~1), max(a & ~1, b & ~1)
        return odd if a == b else b ^ odd if a == 0 else self.add("^", a, b) ^ odd

    def either(self, a, b):
        return self.both(a ^ 1, b ^ 1) ^ 1

    def choose(self, a, b, s):
        """b where s is 1, else a."""
        if s <= 1 or a == b:
            return b if s == 1 else a
        if a <= 1 or b <= 1 or a ^ b == 1:
            return self.differ(a, s) if a ^ b == 1 else self.either(self.both(s, b), self.both(s ^ 1, a))
        return self.differ(a, self.both(s, self.differ(a, b)))

    def cone(self, literals, stop=()):
        """The gates that these need, operands first."""
        out, seen, stack = [], set(stop), [(x >> 1, False) for x in literals]
        while stack:
            gate, done = stack.pop()
            if done:
                out.append(gate)
            elif gate not in seen:
                seen.add(gate)
                stack.append((gate, True))
                if self.gates[gate][0] in "&^":
                    stack += [(x >> 1, False) for x in self.gates[gate][1:]]
        return out

    def tell(self, pairs):
        """Does one of 4096 random inputs tell the two of a pair apart?"""
        every = (1 << 4096) - 1
        value = {0: 0}
        draw = random.Random(1)
        for gate in self.cone([x for pair in pairs for x in pair]):
            op, a, b = self.gates[gate]
            if op == "i":
                value[gate] = draw.getrandbits(4096)
            elif op in "&^":
                a, b = (value[x >> 1] ^ (every if x & 1 else 0) for x in (a, b))
                value[gate] = a & b if op == "&" else a ^ b
        return any(value[x >> 1] ^ value[y >> 1] ^ (every if (x ^ y) & 1 else 0) for x, y in pairs)


class Unit:
    """The gates of one clock, from Yosys."""

    def __init__(self, faults, applied, memory="memory", file="unit.il"):
        script = "".join(f"mutate -ctrl m_{number} 1 1 -module {faults.module} {apply}\n" for number, apply in applied.items())
        faults.yosys(f"""read_rtlil {file}
{script}delete t:glint_mutant
{"setundef -undriven -expose" if file != "unit.il" else ""}
opt_expr
opt_clean
{memory}
{"setundef -undriven -zero" if memory else ""}
opt_expr
opt_clean
techmap
opt -fast
dfflegalize -cell $_DFF_P_ x
opt_expr
opt_merge
abc -fast -g AND,OR,XOR,MUX
opt_clean
write_json clock.json
""")
        module = json.loads((faults.folder / "clock.json").read_text())["modules"][faults.module]
        self.ports = {n: p["bits"] for n, p in module["ports"].items() if p["direction"] == "input"}
        self.outputs = {n: p["bits"] for n, p in module["ports"].items() if p["direction"] == "output"}
        cells = {c["connections"]["Y"][0]: c for c in module["cells"].values() if "Y" in c["connections"]}
        self.registers = {c["connections"]["Q"][0]: c["connections"]["D"][0] for c in module["cells"].values() if "Q" in c["connections"]}
        memories = [c["connections"] | {"": c["connections"]["DATA"]} if "rd" in c["type"] else c["connections"]
                    for c in module["cells"].values() if c["type"].startswith("$mem")]
        self.answers = [bit for memory in memories for bit in memory.get("", [])]
        self.asked = [bit for memory in memories for port in sorted(memory) for bit in memory[port] if bit not in memory.get("", [])]
        self.names = {}
        for name, net in module["netnames"].items():
            for i, bit in enumerate(net["bits"]):
                if bit in self.registers and (bit not in self.names or VALID.search(name)):
                    self.names[bit] = (name, i)
        self.valid = [q for q, (name, _) in self.names.items() if VALID.search(name)]
        self.ordered, seen = [], set()
        stack = [(wire, False) for wire in cells]
        while stack:
            wire, done = stack.pop()
            if done:
                self.ordered.append((wire, cells[wire]["type"], [cells[wire]["connections"].get(p, ["0"])[0] for p in "ABS"]))
            elif wire in cells and wire not in seen:
                seen.add(wire)
                stack.append((wire, True))
                stack += [(cells[wire]["connections"].get(p, ["0"])[0], False) for p in "ABS"]

    def live(self, outputs):
        """The outputs, what memories are asked, and the next values of the registers on which these depend."""
        driven = {wire: operands for wire, _, operands in self.ordered} | {q: [d] for q, d in self.registers.items()}
        seen, stack = set(), [*outputs, *self.asked]
        told = list(stack)
        while stack:
            wire = stack.pop()
            if wire not in seen:
                seen.add(wire)
                stack += driven.get(wire, [])
                told += driven[wire] if wire in self.registers else []
        return told

    def clock(self, gates, state, ports, fault):
        """The value of each wire in a clock."""
        value = {"0": 0, "1": 1, "x": 0, **state}
        for name, bits in self.ports.items():
            for i, bit in enumerate(bits):
                value[bit] = int(name == f"m_{fault}") if name.startswith("m_") else ports(name, i)
        value |= {bit: gates.free(("memory", i)) for i, bit in enumerate(self.answers)}
        for wire, kind, operands in self.ordered:
            a, b, s = (value[x] if x in value else gates.free(("cut", x)) for x in operands)
            value[wire] = (a ^ 1 if kind == "$_NOT_" else gates.both(a, b) if kind == "$_AND_" else gates.either(a, b) if kind == "$_OR_"
                           else gates.differ(a, b) if kind == "$_XOR_" else gates.choose(a, b, s))
        return value

    def next(self, value):
        return {q: value[d] for q, d in self.registers.items()}


def results(unit, gates, latency, fault, follows):
    """The outputs of one input, clock by clock up to the one of its result; `follows`: it takes the place of a result that leaves."""
    valid = {"valid_i", "s_axis_tvalid"}
    reset = {"rst_ni", "aresetn"}

    def ports(step):
        def value(name, i):
            if name in reset:
                return int(step >= 0)
            if step == 0 and name in valid:
                return 1
            if step == 0 and follows and name in ("ready_i", "m_axis_tready"):
                return 1
            return gates.free((name, i, step))
        return value

    state = {q: gates.free((unit.names[q], "at first")) for q in unit.registers}
    state = unit.next(unit.clock(gates, state, ports(-1), fault))
    if follows:
        state |= {q: int(unit.names[q][1] == latency - 1) for q in unit.valid}
    out = []
    for step in range(latency + 1):
        value = unit.clock(gates, state, ports(step), fault)
        out.append({name: [value[b] for b in bits] for name, bits in unit.outputs.items()})
        state = unit.next(value)
    return out


def steady(unit, gates, latency, fault):
    """A result that waits: do the outputs stay?  And do the valid bits, valid_o and ready_o take the gates of the clean unit?"""
    free = {q: gates.free((unit.names[q], "any")) for q in unit.registers}

    def ports(name, i):
        return gates.free((name, i, "any"))

    waits = free | {q: int(unit.names[q][1] == latency - 1) for q in unit.valid}
    before = unit.clock(gates, waits, lambda name, i: {"ready_i": 0, "rst_ni": 1}.get(name, ports(name, i)), fault)
    after = unit.clock(gates, unit.next(before), lambda name, i: {"ready_i": 0, "rst_ni": 1}.get(name, gates.free((name, i, "later"))), fault)
    clean, faulty = (unit.clock(gates, free, ports, number) for number in (0, fault))
    same = all(clean[unit.registers[q]] == faulty[unit.registers[q]] for q in unit.valid)
    same &= all(clean[b] == faulty[b] for name in ("valid_o", "ready_o") for b in unit.outputs[name])
    return same and all(before[b] == after[b] for bits in unit.outputs.values() for b in bits)


def text(gates, inputs, clean, pairs):
    """What exhaust.cpp reads: `clean`, the literals of the unit's outputs, and for each fault (clean, faulty) pairs of them."""
    lines, place = [], {0: 0, 1: 1}
    for i, x in enumerate(inputs):
        place[x] = 2 + i

    def put(literals, first, stop, write):
        at = first
        for gate in gates.cone(literals, stop):
            op, a, b = gates.gates[gate]
            if op not in "&^":
                continue
            for x in (a, b):
                if x & 1 and x not in place:
                    at = write("!", place[x ^ 1], 0, x, at)
            at = write(op, place[a], place[b], 2 * gate, at)
        for x in literals:
            if x not in place:
                at = write("!", place[x ^ 1], 0, x, at)
        return at

    def plain(op, a, b, literal, at):
        lines.append(f"{op} {a} {b} 0")
        place[literal] = at
        return at + 1

    last = put(clean, 2 + len(inputs), (), plain)
    count, done = len(lines), {x >> 1 for x in place}
    base = dict(place)
    for number, some in pairs.items():
        own = []

        def more(op, a, b, literal, at):
            own.append(f"{op} {a} {b} 0 {at}")
            place[literal] = at
            return at + 1

        put([y for _, y in some], last, done, more)
        lines += [f"{number} {len(own)} {len(some)}", *own, *(f"{place[x]} {place[y]}" for x, y in some)]
        place.clear()
        place.update(base)
    return f"inputs {len(inputs)} random 0 gates {count} faults {len(pairs)}\n" + "\n".join(lines) + "\n"


def abc(faults, gates, pairs, seconds):
    """Does ABC prove that these literals are the same?"""
    if gates.tell(pairs):
        return False
    order = gates.cone([x for pair in pairs for x in pair])
    inputs = [g for g in order if gates.gates[g][0] == "i"]
    for side in (0, 1):
        lines = [f".model m\n.inputs {' '.join(f'g{g}' for g in inputs)}\n.outputs {' '.join(f'o{i}' for i in range(len(pairs)))}\n.names g0"]
        for g in order:
            op, a, b = gates.gates[g]
            if op in "&^":
                rows = [(1 - (a & 1), 1 - (b & 1))] if op == "&" else [(0, 1), (1, 0)]
                lines.append(f".names g{a >> 1} g{b >> 1} g{g}\n" + "\n".join(f"{x}{y} 1" for x, y in rows))
        for i, pair in enumerate(pairs):
            lines.append(f".names g{pair[side] >> 1} o{i}\n{1 - (pair[side] & 1)} 1")
        (faults.folder / f"side{side}.blif").write_text("\n".join(lines) + "\n.end\n")
    done = subprocess.run(["yosys-abc", "-c", f"cec -T {seconds} side0.blif side1.blif"], cwd=faults.folder, capture_output=True, text=True)
    return "Networks are equivalent" in done.stdout


def near(faults, applied):
    """A netlist with what the faults can reach in a clock and what decides that; the rest is cut off. Its name."""
    faults.yosys("read_rtlil unit.il\nwrite_json unit.json\n")
    module = json.loads((faults.folder / "unit.json").read_text())["modules"][faults.module]
    cells, ports = module["cells"], module["ports"]
    driver, readers = {}, {}
    for name, cell in cells.items():
        for port, bits in cell["connections"].items():
            for bit in bits:
                if cell["port_directions"][port] == "output":
                    driver[bit] = name
                else:
                    readers.setdefault(bit, []).append(name)
    names = {name.replace("\\", ""): name for name in cells}
    mutated = [names[re.search(r"-cell (\S+)", text)[1].replace("\\", "")] for text in applied.values()]

    def reached(start, way, others):
        """`start`, and on from cell to cell up to registers and memories."""
        seen, stack = set(), list(start)
        while stack:
            name = stack.pop()
            if name in seen:
                continue
            seen.add(name)
            if name in start or not re.match(r"\$(dff|mem)", cells[name]["type"]):
                stack += [other for port, bits in cells[name]["connections"].items() if cells[name]["port_directions"][port] == way
                          for bit in bits for other in others(bit)]
        return seen

    changed = reached(mutated, "output", lambda bit: readers.get(bit, []))
    kept = reached(changed, "input", lambda bit: [driver[bit]] if bit in driver and not re.match(r"\$(dff|mem)", cells[driver[bit]]["type"]) else [])

    def cut(found):
        """A cell that is left; of a register or a memory what it is given, as outputs; a register with a fault stays whole."""
        name = names.get(found[2].replace("\\", ""))
        if name not in kept:
            return ""
        if not re.match(r"\$(dff|mem)", cells[name]["type"]):
            return found[0]
        out = ""
        for port, bits in cells[name]["connections"].items():
            if name in mutated and port == "Q" or name not in mutated and cells[name]["port_directions"][port] == "input" and port != "CLK":
                new = f"next_{found.start()}_{port}"
                out += f"  wire width {len(bits)} output {50000 + found.start()} \\{new}\n" \
                    f"  connect \\{new} {re.search(rf'connect .{port} (.*)', found[0])[1]}\n"
        return out + (found[0] if name in mutated else "")

    text = re.sub(r"(?:  attribute .*\n)*  cell (\S+) (\S+)\n(?:    .*\n)*  end\n", cut, (faults.folder / "unit.il").read_text())
    text = re.sub(r"output \d+ (\\\w+)\n", lambda found: found[0] if found[1].startswith("\\next_") or any(
        driver.get(bit) in kept for bit in ports.get(found[1][1:], {"bits": []})["bits"]) else f"{found[1]}\n", text)
    (faults.folder / "near.il").write_text(text)
    return "near.il"


def equivalent(faults, numbers):
    """Those that change no output and no next value of a register, whatever the inputs and the registers hold. Memories are
    cut: their addresses count as outputs, what they answer as inputs."""
    listed = {f["number"]: f for f in faults.faults}
    applied = {n: listed[n]["apply"] for n in numbers if "apply" in listed[n]}
    large = bool(faults.unit["effect"])
    unit, gates = Unit(faults, applied, "", near(faults, applied) if large else "unit.il"), Gates()
    outputs = [bit for bits in unit.outputs.values() for bit in bits]
    told = [*outputs, *unit.asked, *unit.registers.values()] if large else unit.live(outputs)
    free = {q: gates.free(("any", q)) for q in unit.registers}

    def values(number):
        value = unit.clock(gates, free, lambda name, i: gates.free((name, i)), number)
        return [value[bit] if bit in value else gates.free(("cut", bit)) for bit in told]

    clean, out = values(0), set()
    for number in applied:
        pairs = sorted({(x, y) for x, y in zip(clean, values(number)) if x != y})
        if not pairs or abc(faults, gates, pairs, 10):
            out.add(number)
    return out


def possible(faults):
    """A lobe's unit, without a wrapper."""
    return faults.form == "core" and not faults.unit["effect"]


def unroll(faults, numbers):
    """Number and what was found: "none" where nothing makes a difference, an input that does, or "" where nobody knows."""
    listed = {f["number"]: f for f in faults.faults}
    stated = next(a for a in faults.unit["architectures"] if a["name"] == faults.architecture)
    one = stated["interval"] != 1
    applied = {n: listed[n]["apply"] for n in numbers if "apply" in listed[n]}
    if not one:
        applied = in_numbers(faults, numbers, stuck=True)  # one that never moves is a number, too
    unit, gates, out = Unit(faults, applied), Gates(), {}
    latency = stated["latency"]
    runs = {}
    clean = {follows: results(unit, gates, latency, 0, follows) for follows in ((False, True) if one else (False,))}
    for number in applied:
        pairs = set()
        for follows, expected in clean.items():
            found = results(unit, gates, latency, number, follows)
            for step, (a, b) in enumerate(zip(expected, found)):
                names = a if step == latency else [n for n in a if n.endswith(("valid_o", "ready_o", "tvalid", "tready"))]
                pairs |= {(x, y) for name in names for x, y in zip(a[name], b[name]) if x != y}
        if one and not steady(unit, gates, latency, number):
            out[number] = ""
            continue
        if not pairs:
            out[number] = "none"
            continue
        inputs = tuple(g for g in gates.cone([x for pair in pairs for x in pair]) if gates.gates[g][0] == "i")
        runs.setdefault(frozenset(inputs), {})[number] = sorted(pairs)
    for inputs, some in runs.items():
        names = {g: gates.gates[g][1] for g in inputs}
        print(f"  {len(some)} faults, {len(inputs)} inputs", flush=True)
        if len(inputs) > MOST:
            for number, pairs in some.items():
                out[number] = "none" if abc(faults, gates, pairs, 60) else ""
            continue
        ordered = sorted(inputs, key=lambda g: (names[g][0] != "cos_i", str(names[g][0]), names[g][1]))
        program = faults.folder / "exhaust"
        subprocess.run(["g++", "-std=c++20", "-O3", "-march=native", HERE / "exhaust.cpp", "-o", program], check=True)
        given = text(gates, [2 * g for g in ordered], sorted({x for pairs in some.values() for x, _ in pairs}), some)
        done = subprocess.run([program], input=given, capture_output=True, text=True)
        if done.returncode != 0:
            raise Failed(done.stderr)
        for number, found in map(str.split, done.stdout.splitlines()):
            free = any("at first" in map(str, names[g]) for g in ordered)
            out[int(number)] = found if not free or found == "none" else ""
    return out
