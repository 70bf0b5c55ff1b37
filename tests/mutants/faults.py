"""The faults of a unit: Yosys lists them, some of each file are chosen, and all stand in one netlist."""

import functools
import hashlib
import json
import re
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
RTL = ROOT / "rtl"
SEED = 1
FIRST, AGAIN, TABLE = 45, 6, 12  # faults of a file: in the first unit that has it, in others; of a table
MODES = "inv const0 const1 cnot0 cnot1".split()

DIVIDED = "bps schlick cayley polynomial".split()
UNDIVIDED = "cubic cosine_power quadratic taylor blinn_phong spherical_gaussian gauss decay".split()
EFFECTS = ("ambient lambert tint cosine oren_nayar ward cook_torrance cook_torrance_modified phong_bps blinn_phong_bps "
           "shade_bps").split()

LATER = ["bps_vectors"]


class Failed(Exception):
    """A tool that failed; the text says which and why."""


def plan():
    """The units with faults by name: module, architecture."""
    units = {lobe: (f"glint_{lobe}_p8", "restoring") for lobe in DIVIDED}
    units |= {lobe: (f"glint_{lobe}_p8", "pipelined") for lobe in UNDIVIDED}
    for architecture in "radix4 iterative reciprocal restoring:m2 iterative:m2 reciprocal:m2".split():
        units[f"bps-{architecture.replace(':', '-')}"] = ("glint_bps_p8", architecture)
    units |= {"cayley-iterative": ("glint_cayley_p8", "iterative"), "taylor-m2": ("glint_taylor_p8", "pipelined:m2"),
              "bps-axis": ("glint_bps_axis_p12", "restoring")}
    units |= {effect: (f"glint_effect_{effect}_p8", "default") for effect in EFFECTS}
    units["tint-axis"] = ("glint_effect_tint_axis_p12", "default")
    return units | {effect: (f"glint_effect_{effect}_p8", "default") for effect in LATER}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def run(*command, cwd=None):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, cwd=cwd)
    if done.returncode != 0:
        raise Failed(f"{' '.join(map(str, command))[:300]}: exit status {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


class Manifest:
    def __init__(self):
        units = json.loads((RTL / "units.json").read_text())["units"]
        self.units = {unit["name"]: unit for unit in units}

    def __getitem__(self, name):
        module, architecture = plan()[name]
        unit = self.units[module]
        parameters = next(a["parameters"] for a in unit["architectures"] if a["name"] == architecture)
        return unit, architecture, parameters

    def shares(self):
        """How many faults each file has in each unit: [unit][file]."""
        seen = set()
        out = {}
        for name in plan():
            unit, architecture, _ = self[name]
            out[name] = {}
            for file in unit["files"]:
                again = AGAIN * 2 if architecture not in ("restoring", "pipelined", "default") else AGAIN
                out[name][file] = again if file in seen else TABLE if "glint_table_" in file else FIRST
                seen.add(file)
            if architecture == "radix4" or architecture == "iterative" or architecture == "reciprocal":
                out[name][f"blocks/glint_divider_{architecture}.v"] = FIRST
        return out


# ---- the faults of a unit ----------------------------------------------------------------------------------------------

def order(text):
    return hashlib.sha256(f"{SEED} {text}".encode()).hexdigest()


CONTROL = re.compile(r"^\s*(if \(.*\) )?(assign|wire|reg)?\s*(\[.*?\])?\s*(valid|ready|advance|room|load|start|done|accept|leave|spare_full|"
                     r"read|write|written|push|pop|busy|enable|left)\w*\s*(<=|=)")


@functools.lru_cache(maxsize=None)
def kind_of(file, line, port):
    """Reset, control or data: by the line of the source, and whether the port is a choice."""
    text = (RTL / file).read_text().splitlines()[line - 1]
    if "rst_ni" in text or "aresetn" in text:
        return "reset"
    return "control" if port in ("S", "EN") or CONTROL.search(text) else "data"


def parsed(line):
    """A line of `mutate -list` as a fault; None where it is of no file of rtl/."""
    words = line.split()
    options = {}
    sources = []
    for key, value in zip(words[1::2], words[2::2]):
        if key == "-src":
            sources.append(value)
        else:
            options[key[1:]] = value
    places = [re.match(rf"{re.escape(str(RTL))}/(.*):(\d+)\.", source) for source in sources]
    places = [(place[1], int(place[2])) for place in places if place]  # not those of a copied table
    if not places:
        return None
    file, number = places[0]
    mutation = " ".join(f"-{key} {options[key]}" for key in ("mode", "cell", "port", "portbit", "ctrlbit") if key in options)
    return {"file": file, "line": number, "kind": kind_of(file, number, options["port"]), "mutation": mutation, "apply": mutation}


def rename(faults):
    """Gives the cells of a file names that hold while the file does: no path, and Yosys' numbers counted from 0."""
    number = re.compile(r"\$(\d+) ")
    known = sorted({int(number.search(fault["apply"])[1]) for fault in faults if number.search(fault["apply"])})
    rank = {cell: i for i, cell in enumerate(known)}
    for fault in faults:
        shown = number.sub(lambda found: f"${rank[int(found[1])]} ", fault["apply"], count=1)
        fault["mutation"] = re.sub(r"\$[^ ]*/rtl/", "$", shown)


def chosen(faults, share):
    """`share` of the faults of a file: as many lines as there are, then as many modes."""
    lines = {}
    for fault in sorted(faults, key=lambda f: order(f["mutation"])):
        lines.setdefault((fault["line"], fault["kind"]), []).append(fault)
    out = []
    turn = 0
    while len(out) < share and any(lines.values()):
        for place in sorted(lines, key=lambda p: order(str(p))):
            rest = lines[place]
            wanted = MODES[turn % len(MODES)]
            if rest and len(out) < share:
                rest.sort(key=lambda f: wanted not in f["mutation"])  # stable
                out.append(rest.pop(0))
        turn += 1
    return out


WORD = re.compile(r"(\d+)'d(\d+): entry_[oq] <= (\d+)'h([0-9a-f]+);")


def table_faults(file, share):
    """Bits of words of a table, each flipped."""
    words = WORD.findall((RTL / file).read_text())
    out = []
    for address_bits, address, width, _ in sorted(words, key=lambda w: order(f"{file} {w[1]}"))[:share]:
        bit = int(order(f"{file} {address} bit"), 16) % int(width)
        out.append({"file": file, "line": 0, "kind": "table", "mutation": f"bit {bit} of word {address}",
                    "flip": (int(address_bits), int(address), int(width), bit)})
    if len(out) < share:  # a table of few words: more bits of each
        for address_bits, address, width, _ in words:
            for bit in range(int(width)):
                if len(out) < share and not any(f["flip"][1::2] == (int(address), bit) for f in out):
                    out.append({"file": file, "line": 0, "kind": "table", "mutation": f"bit {bit} of word {address}",
                                "flip": (int(address_bits), int(address), int(width), bit)})
    return out


def with_flips(file, faults):
    """The text of a table in which each fault is switched on by its number."""
    text = (RTL / file).read_text()
    width = faults[0]["flip"][2]
    flips = " : ".join(f"mutant == 16'd{f['number']} && address_i == {f['flip'][0]}'d{f['flip'][1]} ? {width}'d1 << {f['flip'][3]}"
                       for f in faults)
    more = f"""
    reg [{width - 1}:0] read_q, flip_q;
    wire [15:0] mutant;
    glint_mutant select (.mutant_o(mutant));
    always @(posedge clk_i) if (enable_i) flip_q <= {flips} : {width}'d0;
"""
    entry = re.search(r"(\w+) <= \d+'h", text)[1]  # entry_o, or entry_q where more follows the memory
    text = text.replace(f"{entry} <=", "read_q <=")
    if entry == "entry_o":
        text = re.sub(r"output reg +(\[.*?\]) entry_o", r"output wire \1 entry_o", text)
        more += "    assign entry_o = read_q ^ flip_q;\n"
    else:
        text = re.sub(r"    reg (\[.*?\]) entry_q;", r"    wire \1 entry_q = read_q ^ flip_q;", text)
    return text.replace(");\n\n", ");\n" + more, 1)


SELECT = "(* blackbox *) module glint_mutant (output wire [15:0] mutant_o); endmodule\n"


class Faults:
    """A unit with faults: their list, and the library that glint-mutants loads."""

    def __init__(self, name, manifest, build, folder):
        self.name, self.folder, self.build, self.faults = name, Path(folder), build, []
        self.unit, self.architecture, self.parameters = manifest[name]
        self.module = self.unit["name"]
        self.form = "axis" if self.unit["kind"].endswith("_axis") else "core"
        self.numbers = manifest.units[self.unit["core"]["module"]] if self.form == "axis" else self.unit
        if self.form == "core":
            self.parameters = {**self.parameters, "TAG_W": 31}

    def read(self):
        files = [self.folder / Path(f).name if "glint_table_" in f else RTL / f for f in self.unit["files"]]
        parameters = " ".join(f"-set {key} {value}" for key, value in self.parameters.items())
        # Only its own line stays with a cell: flattening would add those of all instances that it is in.
        return f"""
read_verilog -DSYNTHESIS {' '.join(map(str, files))} {self.folder / 'select.v'}
{f'chparam {parameters} {self.module}' if parameters else ''}
hierarchy -top {self.module}
proc
setattr -unset src w:*
setattr -unset src t:glint_* t:$paramod*
flatten
opt_clean
"""

    def yosys(self, script):
        (self.folder / "script.ys").write_text(script)
        run("yosys", "-q", "script.ys", cwd=self.folder)

    def list(self, shares):
        """The faults, numbered from 1."""
        if self.faults:
            return self.faults
        (self.folder / "select.v").write_text(SELECT)
        for file, share in shares.items():
            if "glint_table_" in file:
                faults = table_faults(file, share)
                self.number(faults)
                (self.folder / Path(file).name).write_text(with_flips(file, faults))
        self.yosys(self.read() + f"write_rtlil unit.il\nmutate -list 10000000 -seed {SEED} -o list.txt\n")
        by_file = {}
        for line in (self.folder / "list.txt").read_text().splitlines():
            fault = parsed(line)
            if fault and "glint_table_" not in fault["file"] and "$mem" not in fault["apply"]:
                by_file.setdefault(fault["file"], []).append(fault)
        for file, share in shares.items():
            rename(by_file.get(file, []))
            self.number(chosen(by_file.get(file, []), share))
        return self.faults

    def number(self, faults):
        for fault in faults:
            fault["number"] = len(self.faults) + 1
            self.faults.append(fault)

    def library(self, numbers):
        """Builds the unit with these faults; the fewer, the faster it runs."""
        script = "read_rtlil unit.il\n"
        for fault in self.faults:
            if "apply" in fault and fault["number"] in numbers:
                script += f"mutate -ctrl mutant_i 16 {fault['number']} -module {self.module} {fault['apply']}\n"
        self.yosys(script + "opt_clean\nwrite_verilog -noattr faults.v\n")
        (self.folder / "mutant.v").write_text(
            f"module glint_mutant (output wire [15:0] mutant_o); assign mutant_o = {self.module}.mutant_i; endmodule\n")
        return self.compile(["faults.v", "mutant.v"], "mutant_i = static_cast<SData>(chosen_mutant);")

    def compile(self, verilog, prepare=""):
        """The library of a unit from Verilog; `prepare` is done before its first clock."""
        run(ROOT / "testbench/verilate.sh", self.folder / "cpp", "Vunit", "--top-module", self.module, "-Wno-fatal",
            "-Wno-lint", "-Wno-UNOPTFLAT", *verilog, cwd=self.folder)
        return self.link(f"""#include "Vunit.all.inc"
namespace {{
int chosen_mutant = 0;
class Mutated : public Vunit {{
public:
    explicit Mutated(VerilatedContext* context) : Vunit(context) {{ {prepare} }}
}};
}}  // namespace
""")

    def link(self, model, includes=()):
        """The library of a unit from C++ with the class Mutated, which looks like a Verilated model."""
        cpp = self.folder / "cpp"
        cpp.mkdir(exist_ok=True)
        chosen = "" if "chosen_mutant" in model else "namespace { int chosen_mutant = 0; }\n"
        (cpp / "mutated.inc").write_text(f"""{model}{chosen}extern "C" void glint_choose_mutant(int number);
extern "C" void glint_choose_mutant(int number) {{ chosen_mutant = number; }}
""")
        tools = json.loads((self.build / "mutants.json").read_text())
        command = [tools["launcher"]] if tools["launcher"] else []
        command += [tools["compiler"], "-std=c++20", "-O1", "-w", "-fPIC", "-shared", "-I", cpp, "-DGLINT_LOADED",
                    "-DGLINT_MODEL=Mutated", '-DGLINT_VERILATED="mutated.inc"', *self.pins()]
        command += [f"-I{path}" for path in includes]
        command += [f"-I{path}" for path in dict.fromkeys(tools["includes"].split(";")) if path != "/usr/include"]
        command += [f"-D{name}" for name in tools["definitions"].split(";")]
        library = self.folder / "unit.so"
        run(*command, ROOT / "testbench/register_unit.cpp", tools["verilated"], "-o", library)
        return library

    def pins(self):
        """What register_unit.cpp is told of the unit's ports, as by glint_unit in cmake/GlintUnits.cmake."""
        pins = {"input": "", "output": ""}
        for port in self.numbers["ports"]:
            if re.fullmatch("clk_i|rst_ni|valid_[io]|ready_[io]|tag_[io]|clamped_o", port["name"]):
                continue
            name, signed = port["name"], port["signed"] and port["direction"] == "output"
            pins[port["direction"]] += f" GLINT_SIGNED_PIN({name},{port['width']})" if signed else f" GLINT_PIN({name})"
        return [f"-DGLINT_INPUTS={pins['input']}", f"-DGLINT_OUTPUTS={pins['output']}", f'-DGLINT_UNIT="{self.form}"',
                "-DGLINT_AXIS" if self.form == "axis" else "-DGLINT_STREAM"]

    def judge(self, library, numbers, steps):
        """Number and what found it, one after another."""
        if not numbers:
            return {}
        arguments = ["--library", library, "--profile", self.unit["profile"], "--steps", steps, "--unit", self.form]
        if self.unit["effect"]:
            arguments += ["--effect", self.unit["effect"]]
        else:
            arguments += ["--architecture", self.architecture]
        if self.unit["lobe"]:
            arguments += ["--lobe", self.unit["lobe"]]
        output = run(self.build / "glint-mutants", *arguments, "--mutants", ",".join(map(str, numbers)))
        judged = {line["mutant"]: line for line in map(json.loads, output.splitlines())}
        if list(judged) != list(numbers):
            raise Failed(f"{self.name}: {len(judged)} of {len(numbers)} faults were judged")
        return judged
