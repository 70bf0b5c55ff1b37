#!/usr/bin/env python3
"""Planted faults in the parameters of instances, which Yosys' `mutate` cannot reach: each is one more or one less.

    parameters.py --build build/release [--unit NAME] [--record FILE]

Each fault is a build of its own. The lint of Verilator finds most, for widths no longer fit (rtl.lint.verilator); the
others meet the tests of the clocks (cosim.clocks) and of the cosimulation, in the unit's other architectures, too. A fault that no architecture turns into
another netlist is equivalent. The lines go into the record of mutants.py. Exit status as there.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from faults import ROOT, RTL, Failed, Faults, Manifest, digest, order, plan
from mutants import RECORD, is_open, read_record, summary, write_record

sys.path.insert(0, str(ROOT / "tests/rtl"))
import clocks_test  # noqa: E402

SHARE = 3  # faults of a file
INSTANCE = re.compile(r"\bglint_\w+ #\((.*?)\n\s*\) \w+ \(", re.DOTALL)
PARAMETER = re.compile(r"\.([A-Z]\w*)\s*\(((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)\)")
ARCHITECTURES = ("iterative", "reciprocal:m2", "radix4", "pipelined:m2")


def faults_of(file):
    """Some instance parameters of a file, each with another value: where in the text, and what stands there."""
    text = (RTL / file).read_text()
    out = []
    for instance in INSTANCE.finditer(text):
        for parameter in PARAMETER.finditer(instance[1]):
            name, value = parameter.groups()
            if name == "TAG_W":  # the test bench sets it
                continue
            place = instance.start(1) + parameter.start(2)
            line = text.count("\n", 0, place) + 1
            sign = "+-"[int(order(f"{file} {place}"), 16) % 2]
            out.append({"file": file, "line": line, "place": place, "old": value, "new": f"({value}) {sign} 1",
                        "mutation": f".{name}({value}) {sign} 1"})
    return sorted(sorted(out, key=lambda f: order(f"{file} {f['place']}"))[:SHARE], key=lambda f: f["place"])


def shares():
    """The files of each unit that no unit before it has, and that have instances."""
    manifest, seen, out = Manifest(), set(), {}
    for name in plan():
        files = [f for f in manifest[name][0]["files"] if f not in seen and "glint_table_" not in f]
        seen.update(files)
        out[name] = [fault for file in files for fault in faults_of(file)]
    return {name: faults for name, faults in out.items() if faults}


class Unit(Faults):
    """A unit in which one file is another text."""

    def __init__(self, name, architecture, manifest, build, folder):
        super().__init__(name, manifest, build, folder)
        if architecture:
            self.architecture = architecture
            known = {a["name"]: a["parameters"] for a in self.unit["architectures"]}
            self.parameters = {**self.parameters, **known[architecture]}

    def files(self, fault):
        """The unit's files, with the fault's instead of its own."""
        if fault is None:
            return [RTL / f for f in self.unit["files"]]
        text = (RTL / fault["file"]).read_text()
        start, end = fault["place"], fault["place"] + len(fault["old"])
        copy = self.folder / Path(fault["file"]).name
        copy.write_text(text[:start] + fault["new"] + text[end:])
        return [copy if f == fault["file"] else RTL / f for f in self.unit["files"]]

    def arguments(self, fault):
        return [f"-G{key}={value}" for key, value in self.parameters.items()] + self.files(fault)

    def lint(self, fault):
        done = subprocess.run(["verilator", "--lint-only", "-Wall", "--top-module", self.module, *map(str, self.arguments(fault))],
                              capture_output=True, text=True)
        return done.stdout + done.stderr

    def netlist(self, fault):
        """What Yosys makes of it, without names and places."""
        parameters = " ".join(f"-set {key} {value}" for key, value in self.parameters.items())
        self.yosys(f"read_verilog -DSYNTHESIS {' '.join(map(str, self.files(fault)))}\n"
                   + (f"chparam {parameters} {self.module}\n" if parameters else "")
                   + f"hierarchy -top {self.module}\nproc\nflatten\nopt -full\nopt_clean -purge\nsetattr -unset src *\n"
                   "setattr -mod -unset src\nrename -hide w:*\nrename -enumerate\nwrite_verilog -noattr netlist.v\n")
        return re.sub(r"/\*.*?\*/", "", (self.folder / "netlist.v").read_text(), flags=re.DOTALL)


def find(name, fault, manifest, build, clean):
    """What finds it, or that it is equivalent, or neither. `clean`: the netlists without a fault, by architecture."""
    known = [a["name"] for a in manifest[name][0]["architectures"]]
    same = True
    for architecture in [None, *(a for a in ARCHITECTURES if a in known)]:
        with tempfile.TemporaryDirectory() as folder:
            unit = Unit(name, architecture, manifest, build, folder)
            if unit.lint(fault):
                return {"killed_by": "lint"}
            try:
                if architecture not in clean:
                    clean[architecture] = unit.netlist(None)
                if unit.netlist(fault) == clean[architecture]:
                    continue
            except Failed:
                return {"killed_by": "lint yosys"}
            same = False
            stated = next(a for a in unit.unit["architectures"] if a["name"] == unit.architecture)
            measured = clocks_test.measured({**unit.unit, "files": unit.files(fault)}, stated["parameters"], folder)
            if measured != f"latency {stated['latency']}, interval {stated['interval']}":
                return {"killed_by": "clocks" + (f", {architecture}" if architecture else "")}
            library = unit.compile(unit.arguments(fault))
            for step in ("short", "middle", "long"):
                judged = unit.judge(library, [0], step)[0]
                if judged["killed_by"]:
                    return {"killed_by": judged["killed_by"] + (f", {architecture}" if architecture else "")}
    return {"killed_by": "", "equivalent": "the same netlist"} if same else {"killed_by": ""}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, required=True, help="a build folder with glint-mutants")
    parser.add_argument("--unit", choices=list(plan()), metavar="NAME", help="one unit")
    parser.add_argument("--record", type=Path, default=RECORD, metavar="FILE", help="another record, begun as the committed one")
    options = parser.parse_args()
    if not (options.build / "glint-mutants").exists():
        print(f"parameters.py: --build '{options.build}' has no glint-mutants: build that target", file=sys.stderr)
        return 2
    manifest = Manifest()
    for name, faults in shares().items():
        if options.unit not in (None, name):
            continue
        known = {(line["file"], line["mutation"], line["line"], line["sha256"]) for line in read_record(options.record)
                 if line["unit"] == name and line["kind"] == "parameter"}
        lines, clean = [], {}
        for number, fault in enumerate(faults, 10001):
            line = {"unit": name, "module": Path(fault["file"]).stem, "number": number, "kind": "parameter", "file": fault["file"],
                    "line": fault["line"], "mutation": fault["mutation"], "sha256": digest(RTL / fault["file"])}
            if (fault["file"], fault["mutation"], fault["line"], line["sha256"]) in known:
                continue
            try:
                lines.append({**line, **find(name, fault, manifest, options.build.resolve(), clean)})
            except Failed as failed:
                print(f"parameters.py: FAILED: {failed}", file=sys.stderr)
                return 1
        if lines:
            files = {line["file"] for line in lines}
            now = {file: digest(RTL / file) for file in files}
            kept = [line for line in read_record(options.record)
                    if not (line["unit"] == name and line["kind"] == "parameter" and line["sha256"] != now.get(line["file"], line["sha256"]))]
            write_record(options.record, kept + lines)
            print(f"{name}: {len(lines)} parameters, {sum(map(is_open, lines))} survive", flush=True)
    return 1 if summary([line for line in read_record(options.record) if line["kind"] == "parameter"]) else 0


if __name__ == "__main__":
    sys.exit(main())
