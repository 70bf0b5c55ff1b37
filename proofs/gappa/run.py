#!/usr/bin/env python3
"""Runs Gappa on the scripts that `glint emit` writes, and judges what it proves.

For each script: the bound of the rounding error has to be below 1 ulp, every claim and every question of the script has
to be answered, and no warning may remain (an equation that Gappa cannot check would be believed). With --measured, no
measured error may be above the proven one. Exit status: 0, 1 (a check failed), 2 (bad arguments, or no Gappa).
"""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
from fractions import Fraction
from typing import NamedTuple, Optional

HERE = pathlib.Path(__file__).resolve().parent
TOOL = "proofs/gappa/run.py"
TIMEOUT_SECONDS = 600

NUMBER = r"-?\d+(?:[be][-+]?\d+)?"
RESULT = re.compile(rf"^  (\w+) in \[({NUMBER})(?: {{[^}}]*}})?, ({NUMBER})(?: {{[^}}]*}})?\]$")


class UsageError(Exception):
    """What was asked cannot be done: one line, exit status 2."""


def number(text):
    """A number as Gappa writes it: 12, 25e-2 or -835b-9, which is -835 * 2^-9."""
    mantissa, _, exponent = re.sub("[be]", " ", text).partition(" ")
    base = 2 if "b" in text else 10
    return int(mantissa) * Fraction(base) ** int(exponent or 0)


def up(x):
    """The least double that is not below x."""
    nearest = float(x)
    return nearest if Fraction(nearest) >= x else math.nextafter(nearest, math.inf)


def outward(ends):
    return [0.0 - up(-ends[0]), up(ends[1])]


class Script:
    """A Gappa script: what it says of itself in its comments, and what it asks."""

    def __init__(self, path):
        self.path = path
        text = path.read_text()
        self.lobe = self.field(text, "lobe|effect")
        self.profile = self.field(text, "profile")
        body = re.sub(r"#.*", "", text)
        self.asked = re.findall(r"(\w+) in \?", body)
        if "error" not in self.asked:
            raise UsageError(f"{path} is not a proof script: it does not ask for `error`")

    def field(self, text, name):
        found = re.search(rf"^# (?:{name}): (\S+)$", text, re.M)
        if not found:
            raise UsageError(f"{self.path} is not a proof script: no comment `# {name}: ...`")
        return found.group(1)

    def order(self):
        numbers = [int(x) for x in re.findall(r"\d+", self.profile)]
        return (self.lobe, len(numbers), numbers)


class Proof:
    """What Gappa makes of a script."""

    def __init__(self, script, gappa):
        self.script = script
        self.failures = []
        self.ranges = {}
        self.proven = None
        self.measured = None
        try:
            done = subprocess.run([gappa, str(script.path)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, timeout=TIMEOUT_SECONDS, check=False)
        except subprocess.TimeoutExpired:
            self.failures.append(f"Gappa was stopped after {TIMEOUT_SECONDS} s")
            return
        self.judge(done.returncode, done.stdout)

    def judge(self, status, output):
        for line in output.splitlines():
            found = RESULT.match(line)
            if found:
                self.ranges[found.group(1)] = (number(found.group(2)), number(found.group(3)))
            elif re.search("warning|error:|pointless|BND", line, re.I):
                self.failures.append(line.strip())
        if status != 0 and not self.failures:
            self.failures.append(f"Gappa ended with status {status}: {output.strip()[-200:]}")
        missing = [name for name in self.script.asked if name not in self.ranges]
        if missing:
            self.failures.append(f"no bound proven for {', '.join(missing)}")
        if "error" in self.ranges:
            self.proven = max(abs(end) for end in self.ranges["error"])
            if self.proven >= 1:
                self.failures.append(f"proven bound {up(self.proven):.4f} ulp is not below 1")

    def compare(self, measured):
        self.measured = measured
        for what, ulp in (("measured,", measured.ulp), ("of some real s,", measured.any_s)):
            if self.proven is not None and ulp is not None and Fraction(ulp) > self.proven:
                self.failures.append(f"the error {what} {ulp:.6f} ulp, is above the proven {float(self.proven):.6f}")

    def to_json(self):
        out = {"lobe": self.script.lobe, "profile": self.script.profile, "script": self.script.path.name,
               "ok": not self.failures}
        if self.proven is not None:
            out["proven_ulp"] = up(self.proven)
        if self.measured is not None:
            out["measured_ulp"] = self.measured.ulp
            out["measured_inputs"] = self.measured.inputs
            out["measured_exhaustive"] = self.measured.exhaustive
            if self.measured.at is not None:
                out["measured_at"] = self.measured.at
            if self.measured.any_s is not None:
                out["any_real_s_ulp"] = self.measured.any_s
            if self.proven:
                out["ratio"] = self.measured.ulp / float(self.proven)
        out["ranges"] = {name: outward(self.ranges[name]) for name in self.script.asked if name in self.ranges}
        out["failures"] = self.failures
        return out


class Measured(NamedTuple):
    """The largest error of a run, over how many inputs, whether those are all, at which one it lies, and what glint-wide
    says of any real s, if it is from there."""

    ulp: float
    inputs: int
    exhaustive: bool = False
    at: Optional[dict] = None
    any_s: Optional[float] = None


def find_scripts(paths):
    scripts = []
    for path in paths:
        if not path.exists():
            raise UsageError(f"{path} does not exist; legal is a script or a folder of scripts (*.g)")
        files = sorted(path.glob("*.g")) if path.is_dir() else [path]
        scripts += [Script(file) for file in files]
    return sorted(scripts, key=Script.order)


def read_measured(paths):
    """Of all runs at a (lobe, profile) the one with the largest error, and of equal ones that with the most inputs."""
    measured = {}
    for path in paths:
        try:
            runs = json.loads(path.read_text())["runs"]
            for run in runs:
                if not run.get("accuracy"):
                    continue  # a run that measures no error, such as a reset test
                total = run["accuracy"]["total"]
                rounding = total["rounding"]
                at = {"n": rounding["n"], "cos_code": rounding["cos_code"], "F": run["F"]} if "n" in rounding else None
                entry = Measured(float(rounding["max_ulp"]), int(total["inputs"]), bool(run.get("exhaustive", False)), at,
                                 rounding.get("max_ulp_any_real_s"))
                key = (run["lobe"], run["profile"].replace(",", "_"))
                if key not in measured or entry[:2] > measured[key][:2]:
                    measured[key] = entry
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise UsageError(f"--measured {path} is not a result file of glint sweep, glint-cosim or glint-wide: "
                             f"{type(error).__name__} {error}") from error
    return measured


def table(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = []
    for row in rows:
        cells = [cell.ljust(width) if i < 2 else cell.rjust(width) for i, (cell, width) in enumerate(zip(row, widths))]
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)


def print_tables(proofs, ranges):
    rows = [["lobe", "profile", "proven/ulp", "measured/ulp", "ratio", "inputs"]]
    for proof in proofs:
        proven = "-" if proof.proven is None else f"{math.ceil(proof.proven * 10**4) / 10**4:.4f}"
        row = [proof.script.lobe, proof.script.profile, proven, "-", "-", "-"]
        if proof.measured is not None:
            row[3] = f"{proof.measured.ulp:.4f}"
            row[4] = f"{proof.measured.ulp / float(proof.proven):.3f}" if proof.proven else "-"
            row[5] = str(proof.measured.inputs)
        rows.append(row)
    print(table(rows))
    for lobe in dict.fromkeys(proof.script.lobe for proof in proofs) if ranges else ():
        of_lobe = [proof for proof in proofs if proof.script.lobe == lobe]
        names = dict.fromkeys(name for proof in of_lobe for name in proof.script.asked)
        rows = [["lobe", "range of"] + [proof.script.profile for proof in of_lobe]]
        rows += [[lobe, name] + [interval(proof.ranges.get(name)) for proof in of_lobe] for name in names]
        print("\n" + table(rows))


def interval(ends):
    if ends is None:
        return "-"
    low, high = outward(ends)
    return f"{low:.6f} .. {high:.6f}"


def write(path, text):
    temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    try:
        temporary.write_text(text)
        temporary.replace(path)
    except OSError as error:
        raise UsageError(f"--json {path} cannot be written: {error.strerror}") from error


def main():
    parser = argparse.ArgumentParser(description="Bounds of the rounding error and of every intermediate, by Gappa.",
                                     epilog="Example: run.py --measured sweep.json --json proofs.json")
    parser.add_argument("paths", nargs="*", type=pathlib.Path, default=[HERE / "generated"], metavar="PATH",
                        help="scripts, or folders of them (default: the committed ones)")
    parser.add_argument("--measured", action="append", type=pathlib.Path, default=[], metavar="FILE",
                        help="results of glint sweep, glint-cosim or glint-wide --json; may be given several times")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write the same facts as JSON")
    parser.add_argument("--bounds-only", action="store_true", help="print the bounds, not the ranges")
    parser.add_argument("--gappa", default="gappa", metavar="PROGRAM", help="the Gappa program (default: gappa)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N", help="scripts at a time")
    options = parser.parse_args()
    if options.jobs < 1:
        raise UsageError(f"--jobs {options.jobs} is not legal: at least 1")
    gappa = shutil.which(options.gappa)
    if not gappa:
        raise UsageError(f"program '{options.gappa}' not found; install the package `gappa`")

    scripts = find_scripts(options.paths)
    measured = read_measured(options.measured)
    if not scripts:
        print(f"FAILED: no script in {', '.join(map(str, options.paths))}")
        return 1
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        proofs = list(pool.map(lambda script: Proof(script, gappa), scripts))

    failures = []
    for proof in proofs:
        key = (proof.script.lobe, proof.script.profile)
        if key in measured:
            proof.compare(measured.pop(key))
        failures += [f"{key[0]} {key[1]}: {failure}" for failure in proof.failures]
    if options.measured and all(proof.measured is None for proof in proofs):
        failures.append("nothing measured could be compared with a proof")
    print_tables(proofs, not options.bounds_only)
    for lobe, profile in measured:
        print(f"measured, but no proof here: {lobe} {profile}")
    if options.json:
        write(options.json, json.dumps({"tool": TOOL, "command": " ".join([TOOL, *sys.argv[1:]]),
                                        "proofs": [p.to_json() for p in proofs]}, indent=1) + "\n")
    for failure in failures:
        print(f"FAILED: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except UsageError as error:
        print(f"run.py: {error}", file=sys.stderr)
        sys.exit(2)
