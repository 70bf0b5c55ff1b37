#!/usr/bin/env python3
"""Every unit through a tool with all its warnings on: it must print nothing.

    lint.py verilator|iverilog|yosys [--without p8,p16 | --modules] FOLDER...

FOLDER holds a units.json; --without: profiles to leave out; --modules: the shared modules alone, the first
and the last of their parameters, and fewer damaged copies.

The files of a unit are those of its list (.f), for Yosys those of the manifest. Also linted: the shared modules by
themselves, with parameters at the ends of what is legal. At last, damaged copies of every unit of p12, about which the tool must
print something: a lint that finds nothing there finds nothing.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import icarus
import units
from icarus import Failed
from units import RTL

ROOT = RTL.parent
DIVIDERS = len(units.dividers())

DIVIDER_WIDTHS = ((3, 1, 2), (3, 2, 2), (4, 2, 2), (3, 4, 2), (10, 5, 5), (9, 6, 5), (28, 26, 12), (34, 28, 16),
                  (40, 30, 20), (61, 40, 31))
MODULES = {
    "glint_divider": ("X_W Y_W Q_W DIVIDER BESIDE_W", [(*w, d, 1 + 2 * d) for w in DIVIDER_WIDTHS[::2] for d in range(DIVIDERS)]),
    "glint_divider_restoring": ("X_W Y_W Q_W REGISTER_EVERY", [(*w, r) for w in DIVIDER_WIDTHS[2::3] for r in (2, 3, 32)]),
    "glint_divider_radix4": ("X_W Y_W Q_W REGISTER_EVERY", [(*w, r) for w in DIVIDER_WIDTHS[2::3] for r in (2, 3, 32)]),
    "glint_divider_reciprocal": ("X_W Y_W Q_W ZEROS MULTIPLIER_STAGES",
                                 ((34, 28, 16, 9, 1), (34, 28, 16, 0, 2), (61, 40, 31, 39, 4))),
    "glint_divider_iterative": ("X_W Y_W Q_W", DIVIDER_WIDTHS[2::3]),
    "glint_multiplier": ("A_W B_W SIGNED STAGES", [(a, b, signed, stages) for a, b in ((1, 1), (18, 16), (31, 40))
                                                   for signed in (0, 1) for stages in (1, 2, 3, 4)]),
    "glint_horner": ("S K O I DEGREE CLAMP ITERATIVE MULTIPLIER_STAGES",
                     [(*w, clamp, iterative, stages) for w in ((15, 15, 12, 2, 3), (4, 4, 4, 1, 2), (30, 30, 28, 4, 6))
                      for clamp in (0, 1) for iterative in (0, 1) for stages in (1, 3)]),
    "glint_normalise": ("WIDTH SHIFT_W OUT_W FILL DEEP", ((5, 3, 4, 0, 0), (10, 4, 9, 0, 1), (16, 4, 8, 1, 0), (18, 5, 12, 1, 1), (32, 5, 31, 0, 0))),
    "glint_delay": ("WIDTH STAGES", ((1, 0), (1, 1), (1, 2), (17, 1), (64, 40))),
    "glint_skid": ("WIDTH", ((1,), (47,))),
    "glint_ports": ("F LATENCY PRODUCTS QUOTIENT_W DIVIDER REGISTER_EVERY MULTIPLIER_STAGES TAG_W",
                    ((8, 2, 0, 0, 0, 1, 1, 1), (18, 9, 4, 16, 0, 3, 3, 17), (30, 9, 0, 31, 1, 1, 1, 64),
                     (18, 9, 4, 16, 2, 1, 1, 1), (18, 9, 4, 16, 3, 1, 4, 16))),
    "glint_ratio": ("F S SYMMETRIC DIVIDER MULTIPLIER_STAGES",
                    [(F, S, symmetric, d, 1 + d) for F, S in ((8, 1), (8, 30), (18, 15), (30, 1), (30, 30))
                     for symmetric in (0, 1) for d in range(DIVIDERS)]),
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
    "glint_signed_multiplier": ("WIDTH STAGES", ((8, 1), (16, 2), (18, 4))),
    "glint_dot_product": ("WIDTH MULTIPLIER_STAGES", ((8, 1), (18, 3))),
    "glint_nearest": ("ROOT_W Q_W", ((9, 8), (22, 21), (31, 30))),
    "glint_cosine": ("W F MULTIPLIER_STAGES", ((8, 7, 1), (8, 29, 2), (9, 18, 1), (18, 17, 4), (17, 29, 1))),
    "glint_wait": ("WIDTH CLOCKS", ((1, 0), (3, 7), (17, 8), (64, 64), (5, 65))),
    "glint_frame": ("W F WITH_R WITH_H WITH_V WITH_T MULTIPLIER_STAGES",
                    ((16, 18, 0, 0, 0, 0, 1), (16, 16, 1, 0, 0, 0, 2), (16, 29, 0, 1, 0, 0, 1), (8, 8, 1, 1, 1, 0, 3), (17, 20, 0, 1, 0, 1, 4))),
    "glint_effect_cosine": ("W F MULTIPLIER_STAGES TAG_W", ((8, 8, 1, 1), (18, 20, 3, 64))),
    "glint_dot": ("F", ((8,), (18,), (30,))),
    "glint_colour": ("O", ((4,), (12,), (28,))),
    "glint_effect_lambert": ("F O TAG_W", ((8, 8, 1), (9, 8, 1), (8, 4, 16), (30, 28, 64))),
    "glint_effect_highlight": ("F O TAG_W", ((8, 4, 1), (30, 28, 64))),
    "glint_effect_ambient": ("O TAG_W", ((4, 1), (27, 64))),
    "glint_effect_tint": ("O TAG_W", ((4, 1), (16, 64))),
    "glint_microfacets": ("F S", ((11, 12), (25, 20))),
    "glint_attenuation": ("F T L", ((11, 4, 17), (17, 4, 17), (18, 5, 21), (25, 6, 25))),
    "glint_scaled_power": (
        "I_W E S K BELOW O", ((10, 2, 12, 12, 0, 8), (8, 2, 12, 13, 13, 8), (10, 4, 20, 20, 0, 16), (8, 4, 20, 21, 21, 16))),
    "glint_effect_cook_torrance": ("F T E O TAG_W", ((11, 4, 2, 8, 1), (17, 4, 2, 8, 16), (15, 6, 4, 16, 1), (25, 6, 4, 16, 64))),
    "glint_effect_cook_torrance_modified": (
        "F T E O TAG_W", ((11, 4, 2, 8, 1), (17, 4, 2, 8, 16), (15, 6, 4, 16, 1), (25, 6, 4, 16, 64))),
    "glint_effect_oren_nayar": ("F O TAG_W", ((7, 4, 1), (8, 4, 16), (30, 27, 64))),
    "glint_effect_ward": ("F T E O TAG_W", ((8, 4, 2, 4, 1), (30, 4, 2, 4, 16), (30, 6, 5, 20, 64))),
    "glint_fifo": ("WIDTH LOG_DEPTH", ((1, 1), (47, 6), (300, 16))),
    "glint_axis": ("F O USER_W WORD_W", ((8, 4, 1, 64), (8, 28, 16, 32), (20, 16, 9, 32), (30, 4, 1, 64), (30, 28, 64, 64))),
}
# The wrappers, with every divider, and with products of several clocks.
ARCHITECTURES = [{"DIVIDER": d, "MULTIPLIER_STAGES": (4, 1, 3, 2)[d % 4]} for d in range(DIVIDERS)]
# Units that are linted and damaged with --modules.
DAMAGED = ("glint_bps_p12", "glint_bps_axis_p12", "glint_effect_lambert_p12")


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


def complaints(arguments, folder=ROOT, environment=None):
    done = subprocess.run(arguments, capture_output=True, text=True, cwd=folder, env=environment)
    # A summary that newer Verilators end with is not about the files.
    output = re.sub(r"^- (V e r i l a t i o n|Verilator:).*\n", "", done.stdout + done.stderr, flags=re.M).lstrip("\n")
    return f"{' '.join(arguments)}: exit status {done.returncode}\n{output}" if done.returncode or output else ""


def silent(arguments, folder=ROOT, environment=None):
    text = complaints(arguments, folder, environment)
    if text:
        raise Failed(text)


def lint_unit(tool, folder, unit, elsewhere):
    """A unit, by the list of its files, from another folder; Yosys reads no such lists."""
    if tool == "yosys":
        silent(command(tool, unit["name"], unit["files"], {}))
        return
    environment = {**os.environ, "GLINT_RTL": str(RTL), "GLINT_EMITTED": str(folder)}
    listing = Path(folder) / "generated" if folder == RTL else Path(folder)
    silent([*command(tool, unit["name"], [], {}), "-f", str(listing / f"{unit['name']}.f")], elsewhere, environment)


def lint_damaged(tool, unit, folder):
    """One port of the core too narrow: all three tools know that."""
    *parts, wrapper = unit["files"]
    damaged = Path(folder) / wrapper.name
    if unit["kind"].endswith("_lanes"):  # of lane 0; the same for the others stands below
        text, found = re.subn(r"(m_axis_tdata\[k\*\d+\+:)\d+\]", r"\g<1>4]", wrapper.read_text(), count=1)
    else:
        text, found = re.subn(r"\((?:y_o|r_o|c_o|sum|m_axis_tdata)\)", lambda port: port[0][:-1] + "[3:0])", wrapper.read_text())
    if found != 1:
        raise Failed(f"{wrapper}: {found} results, not one")
    damaged.write_text(text)
    if not complaints(command(tool, unit["name"], [*parts, damaged], {})):
        raise Failed(f"{tool} says nothing about a port of {unit['name']} that is too narrow")


def lint_timescale(folder):
    """Every file of rtl/ in Verilator before and behind a user's file with a `timescale, and one with none. Those of a
    family, whose modules have the names of others, by themselves."""
    user = Path(folder) / "user.v"
    everywhere = sorted(RTL.rglob("*.v"))
    of_family = {name: [file for file in everywhere if file.parent.name == name] for name in units.read()["families"]}
    ours = [file for file in everywhere if not any(file in files for files in of_family.values())]
    for timescale in ("`timescale 1ns/1ps\n", ""):
        user.write_text(f"{timescale}module user(input wire a, output wire b);\n    assign b = a;\nendmodule\n")
        for mine in (ours, *([*files, *RTL.glob("simulation/*.v")] for files in of_family.values())):
            for files in ([user, *mine], [*mine, user]):
                silent(command("verilator", "user", files, {}))
    bare = Path(folder) / "bare.v"
    bare.write_text("module bare(input wire a, output wire b);\n    assign b = a;\nendmodule\n")
    user.write_text("`timescale 1ns/1ps\n" + user.read_text())
    if "TIMESCALEMOD" not in complaints(command("verilator", "user", [*ours, bare, user], {})):
        raise Failed("verilator says nothing about a file that has no `timescale")


def lint(tool, without, modules_alone, folders):
    done = damaged = 0
    listed = set()
    with tempfile.TemporaryDirectory() as scratch:
        if tool == "verilator":
            lint_timescale(scratch)
        for folder in map(Path, folders):
            for unit in units.units(folder).values():
                listed.update(unit["files"])
                if unit["profile"] in without or modules_alone and unit["name"] not in DAMAGED:
                    continue
                lint_unit(tool, folder.resolve(), unit, scratch)
                done += 1
                if unit["profile"] == "p12":
                    lint_damaged(tool, unit, scratch)
                    damaged += 1
                if unit["kind"] == "lobe_axis" and unit["lobe"] == "bps" and unit["F"] <= 20:
                    silent(command(tool, unit["name"], unit["files"], {"WORD_W": 32}))
                    done += 1
                if unit["profile"] == "p12" and unit["kind"] == "lobe" and not modules_alone:
                    known = {parameter["name"] for parameter in unit["parameters"]}
                    for parameters in ARCHITECTURES if "DIVIDER" in known else [{"MULTIPLIER_STAGES": 3}]:
                        silent(command(tool, unit["name"], unit["files"], parameters))
                        done += 1
    modules = 0
    files = units.modules()
    for top, (names, sets) in MODULES.items():
        for values in sorted({tuple(sets[0]), tuple(sets[-1])}) if modules_alone else sets:
            silent(command(tool, top, files[top], dict(zip(names.split(), values))))
            modules += 1
    # The modules of families; Yosys has models of their primitives in its own libraries.
    for family in units.read()["families"].values():
        models = [RTL / name for name in family["simulation"]]
        for top in [name for name in family if name != "simulation"]:
            family_files = [RTL / name for name in family[top]]
            listed.update(models + family_files)
            names, sets = MODULES.get(top, ("", ((),)))  # glint_table_block has no parameters
            for values in [*sets[::5], sets[-1]]:
                silent(command(tool, top, models + family_files, dict(zip(names.split(), values))))
                modules += 1
    # Units of many parts with some of these; Verilator and Yosys want the number sized.
    for name, masks in () if modules_alone else (("shade_bps", ()), ("pixel_bps", (3, 4, 10, 32, 64)), ("lobe_select", (0, 1, 5, 2048))):
        unit = units.units()[f"glint_effect_{name}_p12"]
        bits = next(int(p["default"]) for p in unit["parameters"] if p["name"] == "MASK").bit_length()
        for mask in masks or (0, *(1 << bit for bit in range(bits)), (1 << bits) - 2):
            silent(command(tool, unit["name"], unit["files"], {"MASK": mask if tool == "iverilog" else f"{bits}'d{mask}"}))
            modules += 1
    for file in RTL.rglob("*.v"):
        if file not in listed and file.stem not in MODULES:
            raise Failed(f"{file} is in no unit of rtl/units.json")
    print(f"{tool}: {done} units and architectures, {modules} modules with parameters: silent")
    print(f"{tool}: {damaged} damaged units: found")
    if damaged == 0 or modules == 0:
        raise Failed("nothing was linted")


def main(tool="", *folders):
    folders = list(folders)
    without = []
    modules_alone = folders[:1] == ["--modules"]
    if modules_alone:
        del folders[0]
    if folders[:1] == ["--without"]:
        without, folders = folders[1].split(","), folders[2:]
    if tool not in ("verilator", "iverilog", "yosys") or not folders:
        print(f"lint.py: '{tool}' with {len(folders)} folders is not legal; see the head of this file", file=sys.stderr)
        return 2
    return lint(tool, without, modules_alone, folders)


if __name__ == "__main__":
    icarus.main(main)
