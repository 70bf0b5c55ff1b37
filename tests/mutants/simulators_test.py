#!/usr/bin/env python3
"""Every unit of a profile in another simulator than Verilator's, or as the netlist of a device, through the cosimulation's tests.

    simulators_test.py --build build/release --by cxxrtl                    all units of p8
    simulators_test.py --build build/release --by xc7 --unit glint_bps_p8   one unit

--by cxxrtl: the C++ that Yosys writes (write_cxxrtl).
--by xc7, ice40 or ecp5: the netlist that Yosys makes for the device, with Yosys' models of its cells.
The tests are those that the planted faults meet first: resets in mid-stream, stalls, illegal inputs, against the golden model
(tests/mutants/runner.cpp, steps short and middle). A bug that is planted in one unit has to be found. Exit status: 0, 1 a mismatch, 2 bad
arguments.
"""

import argparse
import re
import shutil
import sys
import tempfile
import time
from pathlib import Path

from faults import RTL, Failed, Faults, Manifest

# -nosrl: up to 0.67 Yosys leaves the enable out of the shift registers that it makes (its issue 6058), so they move in a stall.
# The models of DSP48E1 and MULT18X18D in Yosys 0.23 are not whole.
DEVICES = {"xc7": ("synth_xilinx -family xc7 -flatten -noiopad -noclkbuf -nosrl -nodsp", "xilinx"), "ice40": ("synth_ice40", "ice40"),
           "ecp5": ("synth_ecp5 -noiopad -nodsp", "ecp5")}
BUGGED = "glint_quadratic_p8"  # which unit gets a bug: for CXXRTL this one, for a device a wrong look-up table
BUG = ("glint_ports", "wire              advance = ready_i | ~valid_q[CLOCKS-1];", "wire              advance = 1'b1;")


class OfUnit(Manifest):
    """A unit by its module's name, in its first architecture."""

    def __getitem__(self, name):
        architecture = self.units[name]["architectures"][0]
        return self.units[name], architecture["name"], architecture["parameters"]


def adapter(unit, parameters):
    """A CXXRTL model that looks like a Verilated one: C++ with the class Mutated."""
    fields, given, taken = [], [], []
    for port in unit["ports"]:
        width = port["width"] if isinstance(port["width"], int) else parameters[port["width"]]
        name, mangled = port["name"], "p_" + port["name"].replace("_", "__")
        if width > 64:
            fields.append(f"std::array<std::uint32_t, {(width + 31) // 32}> {name}{{}};")
            given.append(f"for (std::size_t i = 0; i < {name}.size(); ++i) top_.{mangled}.data[i] = {name}[i];")
            taken.append(f"for (std::size_t i = 0; i < {name}.size(); ++i) {name}[i] = top_.{mangled}.data[i];")
        else:
            fields.append(f"std::uint{8 if width <= 8 else 16 if width <= 16 else 32 if width <= 32 else 64}_t {name} = 0;")
            given.append(f"top_.{mangled}.set<std::uint64_t>({name});")
            taken.append(f"{name} = static_cast<decltype({name})>(top_.{mangled}.get<std::uint64_t>());")
        if port["direction"] == "input":
            taken.pop()
        else:
            given.pop()
    return f"""#include <array>
#include <cstdint>
#include "unit.cc"
class VerilatedContext;
namespace {{
class Mutated {{
public:
    {' '.join(fields)}
    explicit Mutated(VerilatedContext*) {{}}
    void eval() {{
        {' '.join(given)}
        top_.step();
        {' '.join(taken)}
    }}
    void final() {{}}

private:
    cxxrtl_design::p_{unit['name'].replace('_', '__')} top_;
}};
}}  // namespace
"""


class Unit(Faults):
    """A unit, made by another program than Verilator, or of another text."""

    def script(self, edit):
        """The Yosys commands that read it; `edit`: module, text, what stands there instead."""
        files = []
        for file in self.unit["files"]:
            path = RTL / file
            if edit and path.stem == edit[0]:
                text = path.read_text()
                if text.count(edit[1]) != 1:
                    raise Failed(f"{file}: no single '{edit[1]}'")
                path = self.folder / path.name
                path.write_text(text.replace(edit[1], edit[2]))
            files.append(str(path))
        chosen = "".join(f" -set {key} {value}" for key, value in self.parameters.items())
        return (f"read_verilog -DSYNTHESIS {' '.join(files)}\n" + (f"chparam{chosen} {self.module}\n" if chosen else "")
                + f"hierarchy -top {self.module}\n")

    def cxxrtl(self, edit=None):
        self.yosys(self.script(edit) + "proc\nflatten\nwrite_cxxrtl -nohierarchy unit.cc\n")
        (self.folder / "cpp").mkdir()
        (self.folder / "unit.cc").rename(self.folder / "cpp/unit.cc")
        return self.link(adapter(self.unit, self.parameters), [yosys_data() / "include", yosys_data() / "include/backends/cxxrtl/runtime"])

    def netlist(self, device, spoiled=False):
        """Verilated, from what Yosys makes for a device; `spoiled`: with the bits of one look-up table inverted."""
        commands, cells = DEVICES[device]
        cells = yosys_data() / cells / "cells_sim.v"
        self.yosys(self.script(None) + f"{commands} -top {self.module}\nwrite_verilog -noattr netlist.v\n")
        file = self.folder / "netlist.v"
        if spoiled:
            text, found = re.subn(r"(INIT\()(\d+)'h(\w+)\)", lambda m: f"{m[1]}{m[2]}'h{int(m[3], 16) ^ (1 << int(m[2])) - 1:x})", file.read_text(), count=1)
            if found != 1:
                raise Failed(f"{self.name}: no look-up table to spoil")
            file.write_text(text)
        # One module, for Verilator compiles thousands of small ones for minutes.
        self.yosys(f"read_verilog -DNO_ICE40_DEFAULT_ASSIGNMENTS netlist.v {cells}\nhierarchy -top {self.module}\nproc\nflatten\nopt_expr\nopt_clean\n"
                   "write_verilog -noattr flat.v\n")
        return self.compile(["flat.v"])

    def library(self, by, bug=False):
        if by == "cxxrtl":
            return self.cxxrtl(BUG if bug else None)
        return self.netlist(by, bug)


def yosys_data():
    return Path(shutil.which("yosys")).resolve().parents[1] / "share/yosys"


def passes(name, options, bug=False):
    """What the tests say of a unit, "" where all pass."""
    with tempfile.TemporaryDirectory() as folder:
        unit = Unit(name, OfUnit(), options.build.resolve(), folder)
        library = unit.library(options.by, bug)
        for steps in ("short", "middle"):
            judged = unit.judge(library, [0], steps)[0]
            if judged["killed_by"]:
                return f"{judged['killed_by']}: {judged['complaint']}"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, required=True, help="a build folder with glint-mutants")
    parser.add_argument("--by", choices=("cxxrtl", *DEVICES), required=True)
    parser.add_argument("--profile", default="p8")
    parser.add_argument("--unit", action="append", help="one unit; may be given several times")
    parser.add_argument("--only-right", action="store_true", help="plants no bug: the run without this option shows that one is found")
    parser.add_argument("--without", default="-", metavar="PATTERN", help="leaves out the units that it matches")
    options = parser.parse_args()
    if not (options.build / "glint-mutants").exists():
        print(f"simulators_test.py: --build '{options.build}' has no glint-mutants: build that target", file=sys.stderr)
        return 2
    if options.by == "cxxrtl" and not (yosys_data() / "include/backends/cxxrtl").is_dir():
        print("SKIPPED: no CXXRTL; install the package `yosys-dev`")
        return 77
    known = [u["name"] for u in OfUnit().units.values() if u["profile"] == options.profile and u["kind"] in ("lobe", "effect")]
    wrong = [name for name in options.unit or [] if name not in known]
    if wrong or not known:
        print(f"simulators_test.py: --unit '{', '.join(wrong)}' is not legal: {', '.join(known)}", file=sys.stderr)
        return 2
    names = options.unit or [name for name in known if not re.search(options.without, name)]
    failed = []
    try:
        for name in names:
            start = time.monotonic()
            complaint = passes(name, options)
            print(f"{name}, {options.by}: {complaint or 'no mismatch'} ({time.monotonic() - start:.0f} s)", flush=True)
            failed += [name] if complaint else []
        found = "not asked" if options.only_right else passes(BUGGED, options, bug=True)
        print(f"{BUGGED}, {options.by}, with a bug: {found.splitlines()[0] if found else 'NOT FOUND'}")
    except Failed as error:
        print(f"simulators_test.py: FAILED: {error}", file=sys.stderr)
        return 1
    print(f"{len(names)} units, {len(failed)} with mismatches")
    return 1 if failed or not found or not names else 0


if __name__ == "__main__":
    sys.exit(main())
