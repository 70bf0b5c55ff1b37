#!/usr/bin/env python3
"""Planted faults in the Verilog: which test of the cosimulation finds which.

    mutants.py --build build/release                    every unit that the record does not hold yet, or holds of other files
    mutants.py --build build/release --unit bps-radix4  one unit
    mutants.py --build build/release --part 1/4         a quarter of the units
    mutants.py --build build/release --sample 100       as many faults of bps p8; each is to be found as the record says
    mutants.py --build build/release --changed          units whose files changed: are as many faults found as before?
    mutants.py --check                                  counts the record; fails for a survivor or a file that has changed

Yosys lists faults (`mutate -list`) of a flattened unit: a bit that is inverted, stuck, or inverted by a neighbour. Some of
each file are chosen, and put into one netlist, each behind a comparison with the input mutant_i. Faults of table words are
written into a copy of the table. glint-mutants then runs the tests with one fault after another. faults.jsonl, the record,
has a line for each. Exit status: 0 all found or equivalent, 1 not, 2 bad arguments.
"""

import argparse
import json
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path

import exhaust
import unroll
from faults import HERE, RTL, Failed, Faults, Manifest, digest, plan

RECORD = HERE / "faults.jsonl"
STEPS = ["short", "middle", "solver", "exhaust", "unroll", "long", "all"]


def read_record(file):
    file = file if file.exists() else RECORD
    return [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []


def write_record(file, lines):
    place = {name: i for i, name in enumerate(plan())}
    lines = sorted(lines, key=lambda l: (place.get(l["unit"], 999), l["number"]))
    new = file.with_suffix(".new")
    new.write_text("".join(json.dumps(line) + "\n" for line in lines))
    new.replace(file)


def stale(name, manifest, record):
    """The files of a unit whose faults the record does not hold, or holds of another content."""
    of_file = {line["file"]: line["sha256"] for line in record if line["unit"] == name and line["kind"] != "parameter"}
    if not of_file:
        return list(manifest[name][0]["files"])
    return [file for file, sha in of_file.items() if digest(RTL / file) != sha]


def try_unit(faults, shares, record):
    """The record with the faults of a unit, as the short tests find them."""
    name, listed = faults.name, faults.list(shares)
    library = faults.library({f["number"] for f in listed})
    clean = faults.judge(library, [0], "short")[0]
    if clean["killed_by"]:
        raise Failed(f"{name} without a fault fails: {clean}")
    judged = faults.judge(library, [f["number"] for f in listed], "short")
    lines = []
    for fault in listed:
        lines.append({"unit": name, "module": Path(fault["file"]).stem, "number": fault["number"], "kind": fault["kind"],
                      "file": fault["file"], "line": fault["line"], "mutation": fault["mutation"],
                      "sha256": digest(RTL / fault["file"]), "killed_by": judged[fault["number"]]["killed_by"]})
    print(f"{name}: {len(lines)} faults, {sum(not l['killed_by'] for l in lines)} left", flush=True)
    return [line for line in record if line["unit"] != name or line["kind"] == "parameter"] + lines


def is_open(line):
    return not line["killed_by"] and not line.get("equivalent")


def try_left(faults, shares, record, step):
    """The record, in which what is left of a unit's faults has met one of STEPS more."""
    name = faults.name
    left = [line for line in record if line["unit"] == name and line["kind"] != "parameter" and is_open(line)
            and STEPS.index(line.get("tried", "short")) < STEPS.index(step)]
    fits = {"all": not faults.unit["effect"], "exhaust": exhaust.possible(faults), "unroll": unroll.possible(faults)}
    if not left or not fits.get(step, True):
        return record
    listed = {f["number"]: f for f in faults.list(shares)}
    for line in left:
        fault = listed[line["number"]]
        if (fault["file"], fault["mutation"]) != (line["file"], line["mutation"]):
            raise Failed(f"{name}: fault {line['number']} is not that of the record; take the unit out of the record")
        line["tried"] = step
    numbers = [line["number"] for line in left]
    if step == "solver":
        same = unroll.equivalent(faults, numbers)
        for line in left:
            if line["number"] in same:
                line["equivalent"] = step
    elif step in ("exhaust", "unroll"):
        found = (exhaust.exhaust if step == "exhaust" else unroll.unroll)(faults, numbers)
        for line in left:
            told = found.get(line["number"], "")  # "" where it touches more than numbers, or nobody knows
            if told == "none":
                line["equivalent"] = "every code of every port" + (", clock by clock" if step == "unroll" else "")
            elif told:
                line["killed_by"] = "exhaustive" if exhaust.legal(faults, told) else "illegal_stalls"
    else:
        judged = faults.judge(faults.library(set(numbers)), numbers, step)
        for line in left:
            line["killed_by"] = judged[line["number"]]["killed_by"]
            if step == "all" and is_open(line) and line["kind"] in ("data", "table"):
                line["equivalent"] = "every legal input, every illegal one"
    print(f"{name}: {len(left)} left, {sum(map(is_open, left))} after {step}", flush=True)
    return record


def sample(count, manifest, build, shares, record):
    """Some faults of bps at p8 that the record says are found: they have to be found again. By another test is well: what
    the registers of a unit hold at power-up depends on which faults are in it."""
    found = [line for line in record if line["unit"] == "bps" and line["killed_by"]]
    wanted = {line["number"]: line for line in found[:: max(1, len(found) // count)][:count]}
    with tempfile.TemporaryDirectory() as folder:
        faults = Faults("bps", manifest, build, folder)
        faults.list(shares["bps"])
        library = faults.library(set(wanted))
        judged = faults.judge(library, [0, *wanted], "short")
        if judged.pop(0)["killed_by"]:
            raise Failed("bps without a fault fails")
        judged |= faults.judge(library, [n for n in wanted if not judged[n]["killed_by"]], "long")
    missed = [line for n, line in wanted.items() if not judged[n]["killed_by"]]
    for line in missed:
        print(f"FAILED: not found, the record says by {line['killed_by']}: {line['file']}:{line['line']} {line['mutation']}")
    print(f"{len(wanted)} faults of bps p8, {len(wanted) - len(missed)} found")
    return 1 if missed or not wanted else 0


def summary(record):
    """Prints the counts; returns the faults that nothing finds and that are not shown to be equivalent."""
    def state(line):
        return "open" if is_open(line) else "found" if line["killed_by"] else "equivalent"

    for title in ("kind", "unit"):
        for value in dict.fromkeys(line[title] for line in record):
            counts = Counter(state(line) for line in record if line[title] == value)
            print(f"{title} {value}: " + ", ".join(f"{counts[name]} {name}" for name in ("found", "equivalent", "open")))
    tests = Counter(re.split(r"[ ,]", line["killed_by"])[0] for line in record if line["killed_by"])
    print("found by: " + ", ".join(f"{name} {count}" for name, count in tests.most_common()))
    counts = Counter(map(state, record))
    print(f"{len(record)} faults: {counts['found']} found, {counts['equivalent']} equivalent, {counts['open']} open")
    return [line for line in record if is_open(line)]


def check(manifest):
    record = read_record(RECORD)
    survivors = summary(record)
    for line in survivors:
        print(f"open: {line['unit']} {line['file']}:{line['line']} {line['kind']} {line['mutation']}")
    changed = {(name, file) for name in plan() for file in stale(name, manifest, record)}
    changed |= {(line["unit"], line["file"]) for line in record if digest(RTL / line["file"]) != line["sha256"]}
    for name, file in sorted(changed):
        print(f"not tried as it stands: {name} {file}")
    return 1 if survivors or changed or not record else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, help="a build folder with glint-mutants")
    parser.add_argument("--unit", help="one unit: " + ", ".join(plan()))
    parser.add_argument("--part", default="1/1", help="i/N: the i-th of N parts of the units")
    parser.add_argument("--changed", action="store_true",
                        help="units whose files have changed; fails where more of a unit's faults are open than in the record")
    parser.add_argument("--until", choices=STEPS, default="all",
                        help="ends with this step; what the short tests do not find meets the solver, then longer tests")
    parser.add_argument("--sample", type=int, metavar="N", help="N faults of bps p8: found as the record says?")
    parser.add_argument("--record", type=Path, default=RECORD, metavar="FILE", help="another record, begun as the committed one")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    manifest = Manifest()
    if options.check:
        return check(manifest)
    if options.unit and options.unit not in plan():
        print(f"mutants.py: --unit '{options.unit}' is not legal: {', '.join(plan())}", file=sys.stderr)
        return 2
    part = re.fullmatch(r"([1-9]\d*)/([1-9]\d*)", options.part)
    if not part or int(part[1]) > int(part[2]):
        print(f"mutants.py: --part '{options.part}' is not legal: i/N with 1 <= i <= N", file=sys.stderr)
        return 2
    if not options.build or not (options.build / "glint-mutants").exists():
        print(f"mutants.py: --build '{options.build}' has no glint-mutants: build that target", file=sys.stderr)
        return 2
    options.build = options.build.resolve()
    shares = manifest.shares()
    names = [options.unit] if options.unit else list(plan())[int(part[1]) - 1::int(part[2])]
    try:
        if options.sample:
            return sample(options.sample, manifest, options.build, shares, read_record(options.record))
    except Failed as failed:
        print(f"mutants.py: FAILED: {failed}", file=sys.stderr)
        return 1
    if options.changed:
        write_record(options.record, read_record(RECORD))
    broken = False
    before = Counter(line["unit"] for line in read_record(RECORD) if is_open(line))
    tried = []
    for name in names:
        try:
            with tempfile.TemporaryDirectory() as folder:
                faults = Faults(name, manifest, options.build, folder)
                record = read_record(options.record)
                if stale(name, manifest, record):
                    write_record(options.record, try_unit(faults, shares[name], record))
                elif options.changed:
                    continue
                tried.append(name)
                for step in STEPS[1:STEPS.index(options.until) + 1]:
                    record = read_record(options.record)
                    write_record(options.record, try_left(faults, shares[name], record, step))
        except Failed as failed:
            broken = True
            print(f"mutants.py: FAILED: {failed}", file=sys.stderr, flush=True)
    if options.changed:
        after = Counter(line["unit"] for line in read_record(options.record) if is_open(line))
        worse = [name for name in tried if after[name] > before[name]]
        print(f"{len(tried)} units with changed files; more faults than before are open in: {', '.join(worse) or 'none'}")
        return 1 if worse or broken else 0
    return 1 if summary(read_record(options.record)) or broken else 0


if __name__ == "__main__":
    sys.exit(main())
