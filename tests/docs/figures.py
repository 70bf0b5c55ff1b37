#!/usr/bin/env python3
"""The tables of figures in README, hls/README and docs/cost.md, between marks, come from the JSON that holds the figures.

    figures.py --glint GLINT            fails where a table is not current
    figures.py --glint GLINT --write    writes them

`<!-- lobes -->`: every lobe at p12, `<!-- profiles of bps -->`: what a sweep of all inputs finds, `<!-- prices -->`: the
units that its rows name; `<!-- hls -->`: what Bambu made of every kernel, `<!-- forms -->`: of the forms of the divider;
`<!-- shells -->`: units without and with the AXI4-Stream shell; `<!-- errors -->`: the cheapest formats of `decay` for an
error, `<!-- devices -->`: on each device, `<!-- families -->`: units on every family, `<!-- parts -->`: what the parts of some of them take; `<!-- beckmann -->`: Beckmann's exponential in two forms; `<!-- blocks -->`: units with tables in block memory; `<!-- cpu -->`: `decay` on a processor; `<!-- faults -->`: the record of planted faults. The last column of the lobes and the first of
the prices are kept: they are words.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MARKED = re.compile(r"(<!-- (lobes|profiles of bps|prices|hls|forms|shells|errors|devices|families|parts|beckmann|blocks|cpu|faults) -->\n)(.*?)(<!-- end -->\n)", re.DOTALL)


def data(name):
    return json.loads((ROOT / "cost/data" / name).read_text())["points"]


def lobe_prices():
    """Those of both files; a device is in one of them."""
    return [point for name in ("fpga.json", "fpga-yowasp.json") if (ROOT / "cost/data" / name).is_file() for point in data(name)]


def accuracy(lobe, profile):
    return next(point for point in data("accuracy.json") if (point["lobe"], point["profile"]) == (lobe, profile))


def error(point, first, last=1023):
    return max(point["error_rounded_cosine"][first - 1:last]) * 2.0 ** -(point["O"] + 8)


def latency(lobe, profile):
    units = json.loads((ROOT / "rtl/units.json").read_text())["units"]
    unit = next(unit for unit in units if unit["name"] == f"glint_{lobe}_{profile}")
    return unit["architectures"][0]["latency"], unit


def significant(x):
    """Three digits, without an exponent."""
    digits = 3
    while float(f"{x:.{digits}f}") == 0 or len(f"{x:.{digits}f}".lstrip("0.")) < 3:
        digits += 1
    return f"{x:.{digits}f}"


def rows_of(text):
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines()]


def table(rows):
    return "".join("| " + " | ".join(cells) + " |\n" if not set("".join(cells)) <= set("-:") else "|" + "|".join(cells) + "|\n" for cells in rows)


def lobes(old):
    notes = {re.search(r"`(\w+)`", row[0])[1]: row[-1] for row in rows_of(old)[2:]}
    names = [point["lobe"] for point in data("accuracy.json") if point["profile"] == "p12"]
    rows = []
    for name in sorted(names, key=lambda name: error(accuracy(name, "p12"), 8)):
        point = accuracy(name, "p12")
        clocks, unit = latency(name, "p12")
        divides = "yes" if any(parameter["name"] == "DIVIDER" for parameter in unit["parameters"]) else "no"
        rows.append([f"[`{name}`](docs/lobes/{name}.md)", significant(error(point, 1)), significant(error(point, 8)),
                     f"{point['rounding_ulp']:.4f}", divides, str(len(unit["tables"])), str(clocks), notes.get(name, "")])
    return [["lobe", "error, all n", "error, n >= 8", "rounding, ulp", "divides", "tables", "latency", ""],
            ["---", "--:", "--:", "--:", "---", "--:", "--:", "---"], *rows]


def profiles(glint):
    rows = []
    for profile in ("p8", "p12", "p16"):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "sweep.json"
            subprocess.run([glint, "sweep", "--lobe", "bps", "--profile", profile, "--json", file], check=True, stdout=subprocess.DEVNULL)
            run = json.loads(file.read_text())["runs"][0]
        found = run["accuracy"]["total"]
        worst, epicentre = found["approximation"], found["epicentre"]
        rows.append([f"`{profile}`", f"{run['inputs']:,}".replace(",", " "), f"{found['rounding']['max_ulp']:.4f}",
                     f"{significant(worst['max'])}, n = {worst['n']}", significant(error(accuracy("bps", profile), 8)),
                     f"{epicentre['max']:.1%}, n = {epicentre['n']}".replace("%", " %"), str(latency("bps", profile)[0])])
    return [["profile", "legal inputs", "rounding, ulp", "error, at", "error, n >= 8", "epicentre, at", "latency"],
            ["---", "--:", "--:", "--:", "--:", "--:", "--:"], *rows]


def prices(old):
    rows = []
    for row in rows_of(old)[2:]:
        lobe, profile, architecture, device = re.match(r"`(\w+)` ([\w,]+), ([\w:]+), ([\w-]+)", row[0]).groups()
        point = next(point for point in lobe_prices() if (point["lobe"], point["profile"], point["architecture"], point["device"]) ==
                     (lobe, profile, architecture, device) and point["dsp"] == ("DSPs" in row[0]))
        rows.append([row[0], significant(error(accuracy(lobe, profile), 8, 1000)), str(point["luts"]), str(point["dsps"]),
                     f"{point['clock_mhz']:.0f}", str(point["latency"]), f"{point['latency'] * 1000 / point['clock_mhz']:.0f}"])
    return [["unit", "error", "LUTs", "DSPs", "MHz", "latency, clocks", "ns"], ["---", "--:", "--:", "--:", "--:", "--:", "--:"], *rows]


def families(_):
    """Units that are priced on Nexus or Gowin, there and on the first two families."""
    columns = (("hx8k", False), ("ecp5-25k", True), ("lifcl-40", True), ("gw2a-18", False), ("gw2a-18", True))
    points = {(p["lobe"], p["profile"], p["architecture"], p["device"], p["dsp"]): p for p in lobe_prices()}
    units = dict.fromkeys(name[:3] for name in points if name[3] in ("lifcl-40", "gw2a-18"))
    rows = []
    for unit in units:
        row = ["`{}` {}, {}".format(*unit)]
        for device, dsp in columns:
            point = points.get((*unit, device, dsp))
            cells = [] if point is None else [str(point["luts"])] + [str(point["dsps"])] * dsp
            if point and not point["fits"]:
                cells = ["does not fit"]
            elif point and (device, dsp) != ("gw2a-18", True):  # no clock there
                cells += [f"{point['clock_mhz']:.0f}", f"{point['latency'] * 1000 / point['clock_mhz']:.0f}"]
            row.append(", ".join(cells) or "-")
        rows.append(row)
    return [["unit", *(f"{device}: LUTs{', DSPs' if dsp else ''}{'' if (device, dsp) == ('gw2a-18', True) else ', MHz, ns'}"
                       for device, dsp in columns)], ["---", *["--:"] * len(columns)], *rows]


def by_hand(kernel, profile):
    """LUTs, DSPs, clocks and MHz of the hand-written unit on the ECP5 by its default architecture; nothing where unpriced."""
    unit = next(unit for unit in json.loads((ROOT / "rtl/units.json").read_text())["units"]
                if unit["name"] == f"glint_{kernel}_{profile}")
    architecture = unit["architectures"][0]
    wanted = {"profile": profile, "architecture": architecture["name"], "device": "ecp5-25k", "dsp": True,
              unit["kind"]: unit[unit["kind"]]}
    for point in data("fpga.json" if unit["kind"] == "lobe" else "effects.json"):
        if {"architecture": "default", **point}.items() >= wanted.items():
            return f"{point['luts']}, {point['dsps']}, {architecture['latency']}, {point['clock_mhz']:.0f}"
    return "-"


def cells(point):
    routed = point["clock_mhz"]
    return [str(point["cycles"]), str(point["lut4"]), str(point["ccu2c"]), str(point["mult18"]), f"{point['mhz']:.0f}",
            "-" if routed is None else f"{routed:.0f}"]


def hls(_):
    rows = [[f"`{p['kernel']}`", p["profile"], *cells(p), by_hand(p["kernel"], p["profile"])]
            for p in data("hls.json") if "form" not in p]
    return [["kernel", "profile", "cycles", "LUT4", "CCU2C", "MULT18", "MHz", "routed", "by hand: LUTs, DSPs, clocks, MHz"],
            ["---", "---", "--:", "--:", "--:", "--:", "--:", "--:", "--:"], *rows]


def forms(_):
    points = data("hls.json")
    tried = {(p["kernel"], p["profile"]) for p in points if "form" in p}
    rows = [[f"`{p['kernel']}`", p["profile"], p.get("form", "restoring"), *cells(p)]
            for p in points if (p["kernel"], p["profile"]) in tried]
    return [["kernel", "profile", "form", "cycles", "LUT4", "CCU2C", "MULT18", "MHz", "routed"],
            ["---", "---", "---", "--:", "--:", "--:", "--:", "--:", "--:"], *rows]


def shells(_):
    """What the AXI4-Stream shell adds to a unit, and lanes of it, on each device of shell.json."""
    names = ("effect", "mask", "lobe", "profile", "architecture", "device", "dsp")
    points = {(*(p.get(name) for name in names), p["unit"], p.get("lanes", 1)): p for p in data("shell.json")}
    rows = []
    for (*name, unit, lanes), shelled in points.items():
        if unit == "core":
            continue
        bare = points[(*name, "core", 1)]
        effect, mask, lobe, profile, architecture, device, dsp = name
        of = f"`{effect or lobe}`" + (f" MASK {mask}" if mask else "")
        rows.append([f"{of} {profile}, {architecture + ', ' if architecture else ''}{device}{', DSPs' if dsp else ''}", str(lanes),
                     *(f"{bare[key]}, {shelled[key]}" for key in ("luts", "registers", "latency")),
                     ", ".join(f"{p['clock_mhz']:.0f}" if p["fits"] else "does not fit" for p in (bare, shelled))])
    return [["unit", "lanes", "LUTs: without, with", "registers", "clocks", "MHz"], ["---", "--:", "--:", "--:", "--:", "--:"], *rows]


def cheapest(most, device="hx8k", dsp=False):
    """Of each error in grid.json, largest first: the format with the fewest LUTs among those of at most so many block RAMs."""
    grids = json.loads((ROOT / "cost/data/grid.json").read_text())["grids"]
    for grid in sorted((g for g in grids if "max_error" in g and (g["device"], g["dsp"]) == (device, dsp)),
                       key=lambda g: -g["max_error"]):
        formats = [form for form in grid["formats"] if form["brams"] <= most]
        yield grid["max_error"], min(formats, key=lambda form: form["luts"]) if formats else None


def devices(_):
    """Of each device, without DSP blocks and with them: the fewest LUTs for an error, with at most 8 block RAMs."""
    kinds = [("hx8k", False), ("up5k", False), ("up5k", True), ("ecp5-25k", False), ("ecp5-25k", True)]
    found = {kind: dict(cheapest(8, *kind)) for kind in kinds}
    rows = []
    for below in sorted(found["hx8k", False], reverse=True):
        forms = [found[kind].get(below) for kind in kinds]
        if all(forms):
            rows.append([f"1/{1 / below:.0f}", *(f"{form['luts']}, {form['brams']}" + (f", {form['dsps']}" if dsp else "")
                                                 for (_, dsp), form in zip(kinds, forms))])
    return [["error below", *(f"{device}{', DSPs' if dsp else ''}" for device, dsp in kinds)], ["--:"] * 6, *rows]


def errors(_):
    rows = {}
    for most in (4, 8, 16, 32):
        for error_below, form in cheapest(most):
            row = rows.setdefault(error_below, [f"1/{1 / error_below:.0f}"])
            row.append(f"{form['luts']}, {form['brams']}" if form else "-")
    return [["error below", *(f"at most {most} block RAMs" for most in (4, 8, 16, 32))], ["--:"] * 5, *rows.values()]


def parts(_):
    keys = ["handshake", "shift", "products", "rest"]
    points = json.loads((ROOT / "cost/data/parts.json").read_text())["points"]
    whole = {form["profile"]: (below, form) for below, form in cheapest(8) if form}
    rows = []
    for point in points:
        below, form = whole[point["profile"]]
        rows.append([f"1/{1 / below:.0f}", f"`{point['profile']}`", str(form["luts"]), str(form["brams"]),
                     *(str(point[key] + (point["delays"] if key == "rest" else 0)) for key in keys)])
    return [["error below", "format", "LUTs", "block RAMs", *keys], ["--:", "---", *["--:"] * 6], *rows]


def beckmann(_):
    rows = []
    for point in data("beckmann.json"):
        hx8k, ecp5 = point["hx8k"], point["ecp5-25k"]
        rows.append([f"{point['form']}, `{point['profile']}`", *(f"{point[key]:.2g}" for key in ("error", "term", "term_rough")),
                     str(point["clocks"]), f"{hx8k['luts']}, {hx8k['brams']}", f"{ecp5['luts']}, {ecp5['brams']}, {ecp5['dsps']}"])
    return [["form", "error", "of the term", "m from 0.3 on", "clocks", "hx8k: LUTs, RAMs", "ecp5-25k: LUTs, RAMs, DSPs"],
            ["---", *["--:"] * 6], *rows]


def blocks(_):
    points = {(p["lobe"], p["profile"], p["architecture"], p["device"], p["dsp"]): p for p in data("fpga.json")}
    rows = []
    points.update({(p["effect"], p["profile"], p.get("architecture", "default"), p["device"], p["dsp"]): p for p in data("effects.json")
                   if "mask" not in p and "lobe" not in p})
    for (name, profile, architecture, device, dsp), block in points.items():
        if ":block" not in architecture:
            continue
        plain = points[(name, profile, architecture.replace(":block", ""), device, dsp)]
        clocks = [p["clock_mhz"] for p in (plain, block)]
        rows.append([f"`{name}` {profile}, {architecture}, {device}{', DSPs' if dsp else ''}",
                     *(f"{plain[key]}, {block[key]}" for key in ("luts", "registers", "brams")),
                     "-" if None in clocks else f"{clocks[0]:.0f}, {clocks[1]:.0f}"])
    return [["unit", "LUTs: without, with", "registers", "block RAMs", "MHz"], ["---", "--:", "--:", "--:", "--:"], *rows]


def cpu(_):
    """Of each form that glint-bench times: decay, and its ratio to bps in the same run."""
    points = {(p["lobe"], p["type"], p.get("profile", ""), p["form"]): p for p in data("cpu-decay.json")}
    rows = []
    for (lobe, *form), point in points.items():
        if lobe != "decay":
            continue
        other = points[("bps", *form)]
        cells = ("-" if point[key] is None else f"{point[key]:.{digits}f}, {point[key] / other[key]:.2f}"
                 for key, digits in (("throughput_ns", 1), ("latency_ns", 1), ("instructions", 0)))
        rows.append([" ".join(filter(None, form)), *cells])
    return [["`decay`", "ns a result, ratio to `bps`", "latency, ns", "instructions"], ["---", "--:", "--:", "--:"], *rows]


def faults(_):
    kinds = {"data": "data: the bits of numbers", "control": "control: valid, ready, enables, choices", "reset": "reset",
             "table": "words of tables", "parameter": "parameters of instances"}
    codes = {"golden": "golden models", "meter": "meters of the error", "price": "prices and `choose`", "parser": "parsers", "kernel": "HLS kernels"}

    def counts(some):
        equivalent = sum(bool(fault.get("equivalent")) for fault in some)
        found = sum(bool(fault["killed_by"]) for fault in some)
        return [str(found), str(equivalent), str(len(some) - found - equivalent)]

    rows = [["kind", "found", "equivalent", "open"], ["---", "--:", "--:", "--:"]]
    for file, known, total in (("faults.jsonl", kinds, "all {} of the Verilog"), ("cpp_faults.jsonl", codes, "all {} of the C++")):
        record = [json.loads(line) for line in (ROOT / "tests/mutants" / file).read_text().splitlines()]
        rows += [[meaning, *counts([fault for fault in record if fault["kind"] == kind])] for kind, meaning in known.items()]
        rows.append([total.format(len(record)), *counts(record)])
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--glint", required=True)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    documents = {"README.md": {"lobes": lobes, "profiles of bps": lambda _: profiles(options.glint), "prices": prices},
                 "hls/README.md": {"hls": hls, "forms": forms}, "docs/cost.md": {"shells": shells, "blocks": blocks, "errors": errors, "devices": devices, "families": families,
                                  "parts": parts, "beckmann": beckmann},
                 "docs/cpu-cost.md": {"cpu": cpu}, "docs/evidence.md": {"faults": faults}}
    for name, makers in documents.items():
        text = (ROOT / name).read_text()
        made = MARKED.sub(lambda m: m[1] + table(makers[m[2]](m[3])) + m[4], text)
        found = [m[2] for m in MARKED.finditer(text)]
        if options.write:
            (ROOT / name).write_text(made)
        if sorted(found) != sorted(makers):
            print(f"FAILED: {name} has the tables {found}, and not {list(makers)}")
            return 1
        if made != text and not options.write:
            print(f"FAILED: the figures of {name} are not those of the JSON: tests/docs/figures.py --write")
            return 1
        print(f"{name}: {len(found)} tables are current")
    return 0


if __name__ == "__main__":
    sys.exit(main())
