#!/usr/bin/env python3
"""Every unit through a tool with all its warnings on: it must print nothing.

    lint.py verilator|iverilog|yosys FOLDER...     the folders of the wrappers

The files of a unit are those that docs/rtl.md, docs/lobes and docs/effects list. Also linted: the shared modules by
themselves, with parameters at the ends of what is legal, and what rtl/*.f lists. At last, damaged copies of every unit,
about which the tool must print something: a lint that finds nothing there finds nothing.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl"

DIVIDER_WIDTHS = ((3, 1, 2), (3, 2, 2), (4, 2, 2), (3, 4, 2), (10, 5, 5), (9, 6, 5), (28, 26, 12), (34, 28, 16),
                  (40, 30, 20), (61, 40, 31))
MODULES = {
    "glint_divider": ("X_W Y_W Q_W DIVIDER BESIDE_W", [(*w, d, 1 + 2 * d) for w in DIVIDER_WIDTHS[::2] for d in range(4)]),
    "glint_divider_restoring": ("X_W Y_W Q_W REGISTER_EVERY", [(*w, r) for w in DIVIDER_WIDTHS[2::3] for r in (2, 3, 32)]),
    "glint_divider_radix4": ("X_W Y_W Q_W REGISTER_EVERY", [(*w, r) for w in DIVIDER_WIDTHS[2::3] for r in (2, 3, 32)]),
    "glint_divider_reciprocal": ("X_W Y_W Q_W ZEROS MULTIPLIER_STAGES",
                                 ((34, 28, 16, 9, 1), (34, 28, 16, 0, 2), (61, 40, 31, 39, 4))),
    "glint_multiplier": ("A_W B_W SIGNED STAGES", [(a, b, signed, stages) for a, b in ((1, 1), (18, 16), (31, 40))
                                                   for signed in (0, 1) for stages in (1, 2, 3, 4)]),
    "glint_horner": ("S K O I DEGREE CLAMP ITERATIVE MULTIPLIER_STAGES",
                     [(*w, clamp, iterative, stages) for w in ((15, 15, 12, 2, 3), (4, 4, 4, 1, 2), (30, 30, 28, 4, 6))
                      for clamp in (0, 1) for iterative in (0, 1) for stages in (1, 3)]),
    "glint_delay": ("WIDTH STAGES", ((1, 0), (1, 1), (1, 2), (17, 1), (64, 40))),
    "glint_skid": ("WIDTH", ((1,), (47,))),
    "glint_ports": ("F LATENCY PRODUCTS QUOTIENT_W DIVIDER REGISTER_EVERY MULTIPLIER_STAGES TAG_W",
                    ((8, 2, 0, 0, 0, 1, 1, 1), (18, 9, 4, 16, 0, 3, 3, 17), (30, 9, 0, 31, 1, 1, 1, 64),
                     (18, 9, 4, 16, 2, 1, 1, 1), (18, 9, 4, 16, 3, 1, 4, 16))),
    "glint_ratio": ("F S DIVIDER MULTIPLIER_STAGES", [(F, S, d, 1 + d) for F, S in ((8, 1), (8, 30), (18, 15), (30, 1), (30, 30))
                                                      for d in range(4)]),
    "glint_ratio_symmetric": ("F S DIVIDER MULTIPLIER_STAGES", [(F, S, d, 1 + d) for F, S in ((8, 1), (18, 15), (30, 30))
                                                                for d in range(4)]),
    "glint_power": ("S O SQUARES CHOICE MULTIPLIER_STAGES", ((4, 4, 2, 1, 1), (30, 28, 2, 1, 4), (30, 4, 2, 1, 1),
                                                             (17, 12, 0, 0, 2), (17, 12, 5, 0, 1))),
    "glint_log2": ("F T L CUT MULTIPLIER_STAGES", ((8, 4, 9, 0, 1), (18, 5, 25, 0, 3), (30, 10, 31, 0, 1), (30, 4, 40, 0, 2),
                                                   (22, 4, 17, 6, 1), (29, 6, 25, 5, 1))),
    "glint_exp2": ("I_W E S O MULTIPLIER_STAGES", ((6, 2, 6, 4, 1), (15, 3, 16, 12, 3), (12, 6, 30, 28, 1), (8, 3, 16, 20, 1),
                                                   (8, 2, 6, 28, 1), (8, 3, 13, 12, 2))),
    "glint_parabola": ("R G V_W C1_W C2_W MULTIPLIER_STAGES", ((1, 0, 10, 10, 10, 1), (12, 0, 25, 22, 16, 2),
                                                               (13, 2, 17, 16, 14, 4))),
    "glint_square": ("S R MULTIPLIER_STAGES", ((1, 1, 1), (4, 1, 2), (4, 7, 1), (17, 17, 3), (30, 4, 1), (30, 30, 4))),
    "glint_sqrt": ("Y_W", ((2,), (3,), (19,), (32,))),
    "glint_stream": ("LATENCY TAG_W", ((2, 1), (25, 17), (50, 64))),
    "glint_dot": ("F", ((8,), (18,), (30,))),
    "glint_colour": ("O", ((4,), (12,), (28,))),
    "glint_effect_lambert": ("F O TAG_W", ((8, 8, 1), (9, 8, 1), (8, 4, 16), (30, 28, 64))),
    "glint_effect_highlight": ("F O TAG_W", ((8, 4, 1), (30, 28, 64))),
    "glint_effect_ambient": ("O TAG_W", ((4, 1), (27, 64))),
    "glint_effect_tint": ("O TAG_W", ((4, 1), (16, 64))),
    "glint_attenuation": ("F T L", ((11, 4, 17), (17, 4, 17), (18, 5, 21), (25, 6, 25))),
    "glint_scaled_power": (
        "I_W E S K BELOW O", ((10, 2, 12, 12, 0, 8), (8, 2, 12, 13, 13, 8), (10, 4, 20, 20, 0, 16), (8, 4, 20, 21, 21, 16))),
    "glint_effect_cook_torrance": ("F T E O TAG_W", ((11, 4, 2, 8, 1), (17, 4, 2, 8, 16), (15, 6, 4, 16, 1), (25, 6, 4, 16, 64))),
    "glint_effect_cook_torrance_modified": (
        "F T E O TAG_W", ((11, 4, 2, 8, 1), (17, 4, 2, 8, 16), (15, 6, 4, 16, 1), (25, 6, 4, 16, 64))),
    "glint_effect_oren_nayar": ("F O TAG_W", ((7, 4, 1), (8, 4, 16), (30, 27, 64))),
    "glint_effect_ward": ("F T E O TAG_W", ((8, 4, 2, 4, 1), (30, 4, 2, 4, 16), (30, 6, 5, 20, 64))),
    "glint_fifo": ("WIDTH LOG_DEPTH", ((1, 1), (47, 6), (300, 16))),
    "glint_axis": ("F O USER_W", ((8, 4, 1), (8, 28, 16), (30, 4, 1), (30, 28, 64))),
}
# The wrappers, with every divider, and with products of several clocks.
ARCHITECTURES = [{"DIVIDER": d, "MULTIPLIER_STAGES": m} for d, m in ((1, 1), (2, 3), (3, 2), (0, 4))]


class Failed(Exception):
    pass


def command(tool, top, files, parameters):
    files = [str(file) for file in files]
    if tool == "verilator":
        return ["verilator", "--lint-only", "-Wall", "--top-module", top,
                *(f"-G{name}={value}" for name, value in parameters.items()), *files]
    if tool == "iverilog":
        return ["iverilog", "-g2005", "-Wall", "-t", "null", "-s", top,
                *(f"-P{top}.{name}={value}" for name, value in parameters.items()), *files]
    chosen = "".join(f" -set {name} {value}" for name, value in parameters.items())
    chosen = f"chparam{chosen} {top}; " if chosen else ""
    script = f"read_verilog {' '.join(files)}; {chosen}hierarchy -check -top {top}; proc; opt; check -assert"
    return ["yosys", "-q", "-e", ".*", "-p", script]


def complaints(arguments, folder=ROOT):
    done = subprocess.run(arguments, capture_output=True, text=True, cwd=folder)
    # A summary that newer Verilators end with is not about the files.
    output = re.sub(r"^- (V e r i l a t i o n|Verilator:).*\n", "", done.stdout + done.stderr, flags=re.M).lstrip("\n")
    return f"{' '.join(arguments)}: exit status {done.returncode}\n{output}" if done.returncode or output else ""


def silent(arguments, folder=ROOT):
    text = complaints(arguments, folder)
    if text:
        raise Failed(text)


def file_table():
    """From docs/rtl.md, docs/lobes and docs/effects: the name of a unit, P in the place of its profile, and its files."""
    table = {}
    pages = [ROOT / "docs/rtl.md", *sorted((ROOT / "docs/lobes").glob("*.md")),
             *sorted((ROOT / "docs/effects").glob("*.md"))]
    text = "\n".join(page.read_text() for page in pages)
    for unit, files in re.findall(r"^\| `(glint_\w+_P)` \| (rtl/generated/.*) \|$", text, re.MULTILINE):
        table[unit] = files.split(", ")
    if not table:
        raise Failed("docs/rtl.md has no table of files")
    return table


def units(folder, table):
    """The units of the wrappers in a folder: their names and files."""
    found = []
    for wrapper in sorted(Path(folder).glob("*.v")):
        profile = re.search(r"_(p\d+|\d+(?:_\d+)+)$", wrapper.stem)
        unit = wrapper.stem[: profile.start()] + "_P" if profile else ""
        if unit not in table:
            raise Failed(f"{wrapper} is no unit that docs/rtl.md lists")
        files = [Path(folder) / Path(file.replace("_P.v", f"{profile[0]}.v")).name if "/generated/" in file else ROOT / file
                 for file in table[unit]]
        found.append((wrapper.stem, files))
    if not found:
        raise Failed(f"folder '{folder}' holds no wrappers")
    return found


def with_parts(module):
    """The files of a module in rtl/ and of all that it contains."""
    files, left = [], [module]
    while left:
        file = RTL / f"{left.pop()}.v"
        if file not in files:
            files.append(file)
            left += re.findall(r"^ +(glint_\w+) #\($", file.read_text(), re.MULTILINE)
    return files


def lint_file_lists(tool, table):
    """rtl/glint_bps.f and its like: the files of both units, one a line, relative to its folder."""
    done = 0
    for listing in sorted(RTL.glob("*.f")):
        lines = [line for line in listing.read_text().splitlines() if line and not line.startswith("//")]
        needed = {file for unit in table for file in table[unit] if unit.startswith(f"{listing.stem}_")}
        if {f"rtl/{line}" for line in lines} != {file for file in needed if "/generated/" not in file}:
            raise Failed(f"{listing} lists {lines}, docs/rtl.md other files")
        core, axis = (f"{listing.stem}_p12", f"{listing.stem}_axis_p12")
        for top, names in ((core, [core]), (axis, [core, axis])):
            wrappers = [f"generated/{name}.v" for name in names]
            if tool == "verilator":
                from_root = [f"rtl/{wrapper}" for wrapper in wrappers]
                silent(["verilator", "--lint-only", "-Wall", "--top-module", top, *from_root, "-F", str(listing)])
                silent(["verilator", "--lint-only", "-Wall", "--top-module", top, *wrappers, "-f", listing.name], RTL)
            elif tool == "iverilog":
                silent(["iverilog", "-g2005", "-Wall", "-t", "null", "-s", top, *wrappers, "-f", listing.name], RTL)
            else:
                silent(command(tool, top, [*wrappers, *lines], {}), RTL)
            done += 1
    if done == 0:
        raise Failed("there is no rtl/*.f")
    return done


def lint_damaged(tool, top, files, folder):
    """One port of the core too narrow: all three tools know that."""
    damaged = Path(folder) / f"{top}.v"
    text, found = re.subn(r"\((?:y_o|r_o|m_axis_tdata)\)", lambda port: port[0][:-1] + "[3:0])", files[0].read_text())
    if found != 1:
        raise Failed(f"{files[0]}: {found} results, not one")
    damaged.write_text(text)
    if not complaints(command(tool, top, [damaged, *files[1:]], {})):
        raise Failed(f"{tool} says nothing about a port of {top} that is too narrow")


def lint(tool, folders):
    table = file_table()
    done = damaged = 0
    with tempfile.TemporaryDirectory() as scratch:
        for folder in folders:
            for top, files in units(folder, table):
                silent(command(tool, top, files, {}))
                lint_damaged(tool, top, files, scratch)
                done += 1
                damaged += 1
                if top.endswith("_p12") and "_axis_" not in top:
                    text = files[0].read_text()
                    pipelines = [{"MULTIPLIER_STAGES": 3}] if "parameter MULTIPLIER_STAGES" in text else []
                    for parameters in ARCHITECTURES if "parameter DIVIDER" in text else pipelines:
                        silent(command(tool, top, files, parameters))
                        done += 1
    modules = 0
    for top, (names, sets) in MODULES.items():
        for values in sets:
            silent(command(tool, top, with_parts(top), dict(zip(names.split(), values))))
            modules += 1
    # shade with some of its effects; Verilator and Yosys want the number sized.
    top = "glint_effect_shade_bps_p12"
    files = [ROOT / file.replace("_P.v", "_p12.v") for file in table["glint_effect_shade_bps_P"]]
    bits = int(re.search(r"parameter \[(\d+):0\] MASK", files[0].read_text())[1]) + 1
    for mask in (0, *(1 << bit for bit in range(bits)), (1 << bits) - 2):
        silent(command(tool, top, files, {"MASK": mask if tool == "iverilog" else f"{bits}'d{mask}"}))
        modules += 1
    linted = {Path(file).stem for files in table.values() for file in files} | set(MODULES)
    for file in RTL.glob("*.v"):
        if file.stem not in linted:
            raise Failed(f"{file} is in no unit that docs/rtl.md lists")
    lists = lint_file_lists(tool, table)
    print(f"{tool}: {done} units and architectures, {modules} modules with parameters, {lists} lists of files: silent")
    print(f"{tool}: {damaged} damaged units: found")
    if damaged == 0 or modules == 0:
        raise Failed("nothing was linted")


def main():
    tool, *folders = sys.argv[1:]
    if tool not in ("verilator", "iverilog", "yosys") or not folders:
        print(f"lint.py: '{tool}' with {len(folders)} folders is not legal; see the head of this file", file=sys.stderr)
        return 2
    try:
        lint(tool, folders)
    except Failed as failed:
        print(f"lint.py: FAILED: {failed}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
