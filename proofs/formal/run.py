#!/usr/bin/env python3
"""Proves the stream handshake, the divider and the square root of the Verilog in rtl/, with Yosys and z3.

A task copies the modules that it needs, adds the property file of each before its `endmodule`, and hands the result to
yosys-smtbmc. `induction` holds for any length of run, `cover` shows that what the properties speak of does happen, and
a planted bug is an edit of the copy that the property named for it has to find. What is proven at which parameters:
README.md. Exit status: 0, 1 (a check failed), 2 (bad arguments, or a program is missing).
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field

HERE = pathlib.Path(__file__).resolve().parent
RTL = HERE.parent.parent / "rtl"
sys.path.append(str(RTL.parent / "tests/rtl"))
import axis  # noqa: E402
import units  # noqa: E402

UNITS = units.units()
MODULES = units.modules()
MOST_SECONDS = 120  # of processor time, for one way of asking the solver
PROGRAMS = {"yosys": "yosys", "yosys-smtbmc": "yosys", "z3": "z3"}  # and the package of each


class UsageError(Exception):
    """What was asked cannot be done: one line, exit status 2."""


@dataclass
class Task:
    name: str
    shows: str
    top: str                       # the module under proof
    kind: str                      # unit, axis (its wrapper), or a shared module: skid, delay, divider, sqrt
    parameters: dict
    method: str                    # induction, cover or bug
    depth: int                     # induction: the largest k tried; else the clocks looked at
    only: str = ""                 # the properties in question, as a regular expression; else all
    given: str = ""                # properties that another task proves by themselves, which this one may assume
    defines: tuple = ()
    edit: tuple = ()               # bug: module, text, what stands there instead
    sidebands: bool = False        # axis: with all of them, as the command `glint` writes it
    failures: list = field(default_factory=list)
    result: str = ""
    seconds: float = 0.0


# ---- what is proven -------------------------------------------------------------------------------------------------

# Every lobe of the registry is proven at the word lengths of its generated wrappers. For covers and planted bugs, which
# want a short latency, bps has the smallest that are legal; other lobes are covered at p8.
LOBES = list(dict.fromkeys(unit["lobe"] for unit in UNITS.values() if unit["kind"] == "lobe"))
SMALL = {"bps": {"F": 8, "S": 4, "K": 4, "O": 4}}
BUGGED = "bps"  # proven at every shipped profile, the others at p12; bugs of what the lobes share are planted here
SHORT = ("lambert", "ambient", "tint")  # effects of a few clocks; bugs of what they share are planted in the first
EFFECTS = list(dict.fromkeys(unit["effect"] for unit in UNITS.values() if unit["kind"] == "effect"))
KINDS = ("unit", "axis", "effect", "highlight")  # each has its property file
TAG_W = 16
WRAPPER_PARAMETERS = ("USER_W", "WORD_W", "ID_W", "DEST_W")  # of an AXI4-Stream wrapper itself
GLINT = None  # the command, for wrappers that are not committed
DIVIDERS = {"p8": (28, 26, 12), "p12": (34, 28, 16), "p16": (40, 30, 20)}  # X_W, Y_W, Q_W in bps

HANDSHAKE = "no item lost, repeated or reordered; stable in a stall; tag kept; reset"

# In the proofs of units their outputs may be any number; in those of effects, whose pipelines are long, more.
NUMBERS = ("multiplier", "divider", "log2", "parabola")
EFFECT_NUMBERS = (*NUMBERS, "sqrt", "attenuation", "delay")

# Planted bugs: what breaks, the property that finds it, text, what stands there instead.
PORTS_BUGS = [
    ("stall_ignored", "stable", "wire              advance = ready_i | ~valid_q[CLOCKS-1];",
     "wire              advance = 1'b1;"),
    ("valid_waits_for_ready", "valid_does_not_wait", "advance = ready_i | ~valid_q[CLOCKS-1];", "advance = ready_i;"),
    ("item_lost", "delivered", "valid_q[CLOCKS-2:0], valid_i & room}", "valid_q[CLOCKS-2:0], valid_i & room & ready_i}"),
    ("bubble_comes_out", "nothing_invented", "valid_q[CLOCKS-2:0], valid_i & room}", "valid_q[CLOCKS-2:0], 1'b1}"),
    ("survives_reset", "nothing_invented", "if (!rst_ni) valid_q <= {CLOCKS{1'b0}};\n        else if (advance)",
     "if (advance)"),
    ("ready_in_reset", "silent_in_reset", "assign ready_o   = rst_ni & advance & room;", "assign ready_o   = advance & room;"),
    ("every_second_clock", "full_rate", "assign ready_o   = rst_ni & advance & room;",
     "assign ready_o   = rst_ni & advance & ~valid_q[0];"),
    ("accepts_when_full", "capacity", "assign ready_o   = rst_ni & advance & room;", "assign ready_o   = rst_ni;"),
    ("tag_stays_behind", "in_turn", ") delay_tag (\n                .clk_i   (clk_i),\n                .enable_i(advance),",
     ") delay_tag (\n                .clk_i   (clk_i),\n                .enable_i(ready_i),"),
]
STREAM_BUGS = [
    ("stall_ignored", "stable", "wire               advance = ready_i | ~valid_q[LATENCY-1];",
     "wire               advance = 1'b1;"),
    ("valid_waits_for_ready", "valid_does_not_wait", "advance = ready_i | ~valid_q[LATENCY-1];", "advance = ready_i;"),
    ("item_lost", "delivered", "valid_q[LATENCY-2:0], valid_i}", "valid_q[LATENCY-2:0], valid_i & ready_i}"),
    ("bubble_comes_out", "nothing_invented", "valid_q[LATENCY-2:0], valid_i}", "valid_q[LATENCY-2:0], 1'b1}"),
    ("survives_reset", "nothing_invented", "if (!rst_ni) valid_q <= {LATENCY{1'b0}};\n        else if (advance)",
     "if (advance)"),
    ("ready_in_reset", "silent_in_reset", "assign ready_o   = rst_ni & advance;", "assign ready_o   = advance;"),
    ("every_second_clock", "full_rate", "assign ready_o   = rst_ni & advance;",
     "assign ready_o   = rst_ni & advance & ~valid_q[0];"),
    ("accepts_when_full", "capacity", "assign ready_o   = rst_ni & advance;", "assign ready_o   = rst_ni;"),
    ("tag_stays_behind", "in_turn", ".enable_i(advance),", ".enable_i(ready_i),"),
    ("clamped_of_the_next", "in_turn", "        .data_o  ({clamped_o, tag_o})\n    );",
     "        .data_o  ({clamped_late, tag_o})\n    );\n    wire clamped_late;\n    assign clamped_o = clamped_i;"),
]
HIGHLIGHT_BUGS = [
    ("facing_and_clamped_swapped", "in_turn", "{facing, clamped_o, tag_o} =", "{clamped_o, facing, tag_o} ="),
    ("grazing_is_lit", "in_turn", "{~nl_i[F+1] & (|nl_i[F:0]),", "{~nl_i[F+1],"),
    ("lit_from_behind", "dark_behind", "lobe_y_i & {(O + 1) {facing}}", "lobe_y_i"),
]
SHADE_BUGS = {
    "glint_effect_shade": [
        ("one_too_many", "capacity", "rst_ni & ~held_q[LOG_DEPTH] &", "rst_ni &"),
        ("joins_early", "terms_kept", "join_valid = &here;", "join_valid = here[0];"),
        ("clamped_unasked", "clamped_right", "clamped & asked[k+1];", "clamped;"),
        ("light_of_another", "sums_right", "i_q <= i;", "i_q <= i_i;"),
    ],
}
ITERATIVE_BUGS = [
    ("second_item", "capacity", "room = ITERATIVE ? ~|valid_q[CLOCKS-2:0] : 1'b1;", "room = 1'b1;"),
    ("tag_of_another", "in_turn", "if (advance & load) begin\n                    negative_q",
     "if (advance) begin\n                    negative_q"),
]
AXIS_BUGS = [
    ("sidebands_swapped", "in_turn", "({s_axis_tuser, s_axis_tlast,", "({s_axis_tlast, s_axis_tuser,"),
    ("cos_off_by_a_bit", "operands_kept", "s_axis_tdata[COS+F+1:COS]", "s_axis_tdata[COS+F:COS-1]"),
    ("y_shifted", "result_kept", "{(30 - O) {1'b0}}, y}", "{(29 - O) {1'b0}}, y, 1'b0}"),
    ("result_while_ready", "stable", "{clamped, {(30", "{clamped & m_axis_tready, {(30"),
    ("item_taken_twice", "nothing_invented", ".ready_i(ready_i),", ".ready_i(ready_i & m_axis_tready),"),
    ("output_not_reset", "silent_in_reset", ") skid_out (\n        .clk_i  (aclk),\n        .rst_ni (aresetn),",
     ") skid_out (\n        .clk_i  (aclk),\n        .rst_ni (1'b1),"),
]
WRAPPER_BUGS = [
    ("core_never_stalls", "in_turn", ".ready_i  (out_ready),", ".ready_i  (1'b1),"),
    ("core_not_reset", "nothing_invented", ".rst_ni   (aresetn),", ".rst_ni   (1'b1),"),
]
WORDS_BUGS = [
    ("sidebands_swapped", "in_turn", "({s_axis_tuser, s_axis_tlast,", "({s_axis_tlast, s_axis_tuser,"),
    ("field_off_by_a_bit", "operands_kept", "s_axis_tdata[19:0]", "s_axis_tdata[20:1]"),
    ("result_shifted", "result_kept", "18'd0, shown_y_o}", "17'd0, shown_y_o, 1'b0}"),
    ("core_never_stalls", "in_turn", ".ready_i  (out_ready),", ".ready_i  (1'b1),"),
    ("core_not_reset", "nothing_invented", ".rst_ni   (aresetn),", ".rst_ni   (1'b1),"),
    ("item_taken_twice", "nothing_invented", ".ready_i(in_ready),", ".ready_i(in_ready & m_axis_tready),"),
]
SKID_BUGS = [
    ("spare_forgotten", "delivered", "valid_q <= spare_full_q | accept;", "valid_q <= accept;"),
    ("shown_twice", "nothing_invented", "valid_q <= spare_full_q | accept;", "valid_q <= valid_q | accept;"),
    ("order_lost", "in_turn", "data_q <= spare_full_q ? spare_q : data_i;", "data_q <= data_i;"),
    ("stall_ignored", "stable", "leave  = ready_i | ~valid_q;", "leave  = 1'b1;"),
    ("ready_after_reset", "silent_in_reset", "ready_q      <= 1'b0;", "ready_q      <= 1'b1;"),
    ("every_second_clock", "full_rate", "ready_q      <= ~spare_full;", "ready_q      <= ~spare_full & ~accept;"),
    ("accepts_when_full", "capacity", "ready_q      <= ~spare_full;", "ready_q      <= 1'b1;"),
    ("valid_pauses", "valid_does_not_wait", "assign valid_o = valid_q;", "assign valid_o = valid_q & ready_q;"),
]
FIFO_BUGS = [
    ("pushed_and_shown", "in_turn", "written_q <= write_q;", "written_q <= write_q + {{LOG_DEPTH{1'b0}}, push_i};"),
    ("pop_ignored", "nothing_invented", "read_q    <= read;", "read_q    <= read_q;"),
    ("push_forgotten", "valid_does_not_wait", "{{LOG_DEPTH{1'b0}}, push_i};", "{{LOG_DEPTH{1'b0}}, push_i & ~pop_i};"),
    ("full_is_empty", "valid_does_not_wait", "valid_o = written_q != read_q;",
     "valid_o = written_q[LOG_DEPTH-1:0] != read_q[LOG_DEPTH-1:0];"),
    ("read_late", "in_turn", "data_q <= memory[read[LOG_DEPTH-1:0]];", "data_q <= memory[read_q[LOG_DEPTH-1:0]];"),
    ("output_runs_on", "stable", "read_q + {{LOG_DEPTH{1'b0}}, pop_i};", "read_q + {{LOG_DEPTH{1'b0}}, valid_o};"),
    ("not_reset", "silent_in_reset", "written_q <= {(LOG_DEPTH + 1) {1'b0}};", "written_q <= write_q;"),
]
DELAY_BUGS = [
    ("stage_skipped", "comes_out", "data_q <= stage[i-1].data_q;", "data_q <= stage[0].data_q;"),
    ("enable_ignored", "holds", "if (enable_i) data_q <= stage[i-1].data_q;", "data_q <= stage[i-1].data_q;"),
]
DIVIDER_BUGS = [
    ("equal_does_not_fit", "one_stage", "fits = ~difference[Y_W+1];", "fits = ~difference[Y_W+1] & |difference[Y_W:1];"),
    ("stage_skips", "stage_moves", "remainder_q  <= reduced;", "remainder_q  <= remainder;"),
    ("quotient_inverted", "divides", "bits_q       <= {bits[Q_W-2:0], fits};",
     "bits_q       <= {bits[Q_W-2:0], ~fits};"),
    ("divisor_of_another", "divides|beside_kept", "complement_q <= complement;", "complement_q <= ~divisor_i;"),
    ("beside_of_another", "beside_kept", "beside_q     <= beside;", "beside_q     <= beside_i;"),
    ("enable_ignored", "holds", "if (enable_i) begin", "if (enable_i | fits) begin"),
]

SQRT_BUGS = [
    ("equal_does_not_fit", "one_stage", "fits = shifted >= trial;", "fits = shifted > trial;"),
    ("root_inverted", "stage_moves", "root_q <= {stage[i-1].root_q, fits};", "root_q <= {stage[i-1].root_q, ~fits};"),
    ("bits_of_another", "is_root", "bits_q <= stage[i-1].waiting.bits_q[2*(Y_W-1-i)-1:0];",
     "bits_q <= radicand_i[2*(Y_W-1-i)-1:0];"),
    ("enable_ignored", "holds", "if (enable_i) remainder_q <= reduced;", "remainder_q <= reduced;"),
]


def bugs(group, top, kind, parameters, depth, module, table, defines=()):
    return [Task(f"bugs.{group}.{name}", f"`{prop}` fails", top, kind, parameters, "bug", depth,
                 rf"(.*\.)?{prop}", "", defines, (module, text, instead)) for name, prop, text, instead in table]


def word_lengths(lobe, profile):
    """The integer parameters that the generated wrapper of a unit sets."""
    numbers = UNITS[f"glint_{lobe}_{profile}"]["core"]["parameters"]
    return {name: int(value) for name, value in numbers.items() if value.isdigit()}


def divider(x, y, q):
    return {"X_W": x, "Y_W": y, "Q_W": q}


def tasks():
    out = [Task("skid.handshake", HANDSHAKE, "glint_skid", "skid", {"WIDTH": 64}, "induction", 2),
           Task("skid.cover", "not vacuous", "glint_skid", "skid", {"WIDTH": 8}, "cover", 10),
           Task("skid.cover_full", "the bounds are reached", "glint_skid", "skid", {"WIDTH": 8}, "cover", 14,
                defines=("DEEP_COVER",)),
           *bugs("skid", "glint_skid", "skid", {"WIDTH": 8}, 8, "glint_skid", SKID_BUGS)]
    for stages in (1, 21, 30):
        out.append(Task(f"delay.{stages}", "comes out STAGES enabled clocks later; holds without enable", "glint_delay",
                        "delay", {"WIDTH": TAG_W + 1, "STAGES": stages}, "induction", 2))
    out += [Task("delay.cover", "not vacuous", "glint_delay", "delay", {"WIDTH": 4, "STAGES": 5}, "cover", 12),
            *bugs("delay", "glint_delay", "delay", {"WIDTH": 4, "STAGES": 5}, 9, "glint_delay", DELAY_BUGS)]
    fifo = {"WIDTH": 4, "LOG_DEPTH": 2}
    for log_depth in (1, 6):
        out.append(Task(f"fifo.{log_depth}", "no item lost, repeated or reordered, where no more are pushed than it holds",
                        "glint_fifo", "fifo", {"WIDTH": 87, "LOG_DEPTH": log_depth}, "induction", 1))
    out += [Task("fifo.cover", "not vacuous", "glint_fifo", "fifo", fifo, "cover", 14),
            *bugs("fifo", "glint_fifo", "fifo", fifo, 9, "glint_fifo", FIFO_BUGS)]
    small = divider(10, 6, 5)
    for name, widths in DIVIDERS.items():
        out.append(Task(f"divider.stage.{name}", "one stage: 2 remainder + bit = fits divisor + reduced < divisor",
                        "glint_divider_restoring", "divider", divider(*widths), "induction", 1, "one_stage|stage_moves",
                        defines=("TWO_STAGES",)))
    for name in ("p8", "p12"):  # at p16 z3 does not answer in 300 s
        out.append(Task(f"divider.{name}", "whole divider, by bookkeeping; holds without enable", "glint_divider_restoring",
                        "divider", divider(*DIVIDERS[name]), "induction", 1))
    out += [Task("divider.multiply", "quotient divisor + remainder = dividend, remainder < divisor, as written",
                 "glint_divider_restoring", "divider", small, "induction", 1, defines=("MULTIPLY",)),
            Task("divider.cover", "not vacuous", "glint_divider_restoring", "divider", small, "cover", 12),
            *bugs("divider", "glint_divider_restoring", "divider", small, 9, "glint_divider_restoring", DIVIDER_BUGS, ("MULTIPLY",))]
    for bits in (16, 19, 24):
        out.append(Task(f"sqrt.stage.{bits}", "each stage: 4 remainder + bits = fits (4 root + 1) + reduced", "glint_sqrt",
                        "sqrt", {"Y_W": bits}, "induction", 1))
    out += [Task("sqrt.multiply", "root^2 + remainder = radicand, remainder <= 2 root, as written; holds without enable",
                 "glint_sqrt", "sqrt", {"Y_W": 5}, "induction", 1, defines=("MULTIPLY",)),
            Task("sqrt.cover", "not vacuous", "glint_sqrt", "sqrt", {"Y_W": 5}, "cover", 12, defines=("MULTIPLY",)),
            *bugs("sqrt", "glint_sqrt", "sqrt", {"Y_W": 5}, 9, "glint_sqrt", SQRT_BUGS, ("MULTIPLY",))]
    for lobe in LOBES:
        small = {**word_lengths(lobe, "p8"), **SMALL.get(lobe, {})}
        unit, wrapper = f"glint_{lobe}", f"glint_{lobe}_axis_p12"
        kind = "effect" if in_stream(unit) else "unit"  # which frame its numbers stand in
        for profile in ("p8", "p12", "p16") if lobe == BUGGED else ("p12",):
            numbers = word_lengths(lobe, profile)
            out += [Task(f"{lobe}.{profile}", HANDSHAKE, unit, kind, {**numbers, "TAG_W": TAG_W}, "induction", 2),
                    Task(f"axis.{lobe}.{profile}", HANDSHAKE + "; operands and result kept",
                         wrapper, "axis", {**numbers, "USER_W": TAG_W}, "induction", 3)]
        core = {**small, "TAG_W": 2}
        axis = {**small, "USER_W": 1}
        out += [Task(f"{lobe}.cover", "not vacuous", unit, kind, core, "cover", 60),
                Task(f"{lobe}.cover_full", "the bounds are reached", unit, kind, core, "cover", 120,
                     defines=("DEEP_COVER",)),
                Task(f"axis.{lobe}.cover", "not vacuous", wrapper, "axis", axis, "cover", 60)]
        if lobe == BUGGED:
            packed = {**word_lengths(lobe, "p12"), "USER_W": TAG_W, "WORD_W": 32}
            out += [Task(f"axis32.{lobe}.p12", HANDSHAKE + "; operands and result kept", wrapper, "axis", packed, "induction", 3),
                    Task(f"sidebands.{lobe}.p12", HANDSHAKE + "; tid, tdest, tkeep pass along", wrapper, "axis",
                         {**packed, "ID_W": 8, "DEST_W": 4}, "induction", 3, sidebands=True)]
            one = {"DIVIDER": 2, **core}
            out += [Task(f"{lobe}.iterative.{profile}", HANDSHAKE + "; one item at a time", unit, "unit",
                         {**word_lengths(lobe, profile), "DIVIDER": 2, "TAG_W": TAG_W}, "induction", 2, defines=("ITERATIVE",))
                    for profile in ("p8", "p12", "p16")]
            out += [Task(f"{lobe}.iterative.cover", "not vacuous", unit, "unit", one, "cover", 60, defines=("ITERATIVE",)),
                    *bugs(f"{lobe}.iterative", unit, "unit", one, 40, "glint_ports", ITERATIVE_BUGS, ("ITERATIVE",))]
            out += [*bugs(lobe, unit, "unit", core, 22, "glint_ports", PORTS_BUGS),
                    *bugs(f"axis.{lobe}", wrapper, "axis", axis, 24, "glint_axis", AXIS_BUGS),
                    *bugs(f"axis.{lobe}", wrapper, "axis", axis, 24, wrapper, WRAPPER_BUGS)]
    out += of_shade()
    for effect in EFFECTS:
        out += of_axis(effect)
    for effect in (e for e in EFFECTS if e != "shade"):
        out += of_effect(effect)
    return out


def of_axis(effect):
    """The AXI4-Stream unit of an effect, around any unit of its ports that keeps the rules."""
    wrapper = next(name for name, unit in UNITS.items() if unit["kind"] == "effect_axis" and unit["effect"] == effect)
    out = [Task(f"axis.effect.{effect}.p12", HANDSHAKE + "; operands and result kept", wrapper, "axis", {"USER_W": TAG_W},
                "induction", 3)]
    if effect == SHORT[0]:
        out += [Task(f"axis.effect.{effect}.cover", "not vacuous", wrapper, "axis", {"USER_W": 1}, "cover", 20),
                *bugs(f"axis.effect.{effect}", wrapper, "axis", {"USER_W": 1}, 16, wrapper, WORDS_BUGS)]
    return out


def of_shade():
    """The tasks of the effect shade, a few properties at a time: each may assume those that are proven before it."""
    name, top, kind = "effect.shade", "glint_effect_shade", "shade"
    small = {"O": 2, "N": 2, "MASK": 7, "DIFFUSE": 2, "LOG_DEPTH": 1, "TAG_W": 1}  # ambient, a diffuse and a specular term
    order = (r"(scoreboard|fifo_tag|fifo_total|unit\[\d+\]\.built\.fifo)\..*|terms_kept|asked_kept|joined|shown|"
             "inv_(count|inside|mark|outstanding|waiting|last)")
    memories = r"(lit|with_\w+)\..*fifo\..*|inv_same"
    colours = "colours_kept|inv_colours"
    steps = [("order", "no item lost, repeated or reordered; terms of one item meet; no memory overflows", order),
             ("memories", "those of the colours keep in step", memories),
             ("colours", "the colours are those of the item", colours),
             ("sums", "the sums saturate as a whole, beside their colours", "sums_right"),
             ("clamped", "`clamped` is that of the item and of what it asks for", "clamped_right|inv_(clamped|between|total|last_clamped)")]
    # What is given is what the step needs, no more, so that it closes fast.
    given = {"memories": order, "colours": rf"inv_(count|inside|mark|outstanding|waiting)|(fifo_tag|scoreboard)\..*|{memories}",
             "sums": f"{order}|{memories}|{colours}", "clamped": f"{order}|{memories}|{colours}|sums_right"}
    out = [Task(f"{name}.{step}", shows, top, kind, small, "induction", 1, only, given.get(step, "")) for step, shows, only in steps]
    out.append(Task(f"{name}.cover", "not vacuous", top, kind, small, "cover", 24))
    for module, table in SHADE_BUGS.items():
        out += bugs(name, top, kind, small, 20, module, table)
    return out


def of_effect(effect):
    """The tasks of an effect: proven at p12; those of a few clocks, and one around a lobe, covered at p8."""
    unit = f"glint_effect_{effect}"
    if unit in MODULES:
        kind, tops = "effect", {profile: unit for profile in ("p8", "p12")}
        numbers = {profile: word_lengths(f"effect_{effect}", profile) for profile in tops}
    else:  # it stands around a lobe
        kind, tops = "highlight", {profile: f"{unit}_{BUGGED}_{profile}" for profile in ("p8", "p12")}
        numbers = {profile: {} for profile in tops}
    small = {**numbers["p8"], "TAG_W": 2}
    # The 28 clocks of a lobe's unit at p12 close too, in minutes.
    profile, tag_w = ("p8", 2) if kind == "highlight" else ("p12", TAG_W)
    out = [Task(f"effect.{effect}.{profile}", HANDSHAKE, tops[profile], kind, {**numbers[profile], "TAG_W": tag_w}, "induction", 2)]
    if effect in (*SHORT, "phong"):
        out.append(Task(f"effect.{effect}.cover", "not vacuous", tops["p8"], kind, small, "cover", 60))
    if effect in SHORT:
        out.append(Task(f"effect.{effect}.cover_full", "the bounds are reached", tops["p8"], kind, small, "cover", 120,
                        defines=("DEEP_COVER",)))
    if effect == SHORT[0]:
        out += bugs(f"effect.{effect}", unit, kind, small, 9, "glint_stream", STREAM_BUGS)
    if effect == "phong":
        out += bugs(f"effect.{effect}", tops["p8"], kind, small, 40, "glint_effect_highlight", HIGHLIGHT_BUGS)
    return out


# ---- how ------------------------------------------------------------------------------------------------------------

def needed(*tops):
    """The modules and all that they instantiate, directly or not."""
    return {path.stem: path.read_text() for top in tops for path in MODULES[top]}


def around_lobe(module):
    """The generated wrapper of phong or blinn_phong, around the unit in the place of its wrapper; that unit, and its numbers."""
    unit = UNITS[module]
    lobe, profile = unit["lobe"], unit["profile"]
    numbers = word_lengths(lobe, profile)
    passed = "".join(f".{name}({value}), " for name, value in numbers.items())
    text = axis.edited(module, unit["files"][-1].read_text(), f"glint_{lobe}_{profile} #(", f"glint_{lobe} #({passed}")
    return text, f"glint_{lobe}", numbers


def declared_result(top, numbers):
    """RESULT_W and result: the outputs of an effect's unit but those of the handshake, side by side."""
    unit = next(unit for unit in UNITS.values() if unit["name"] == top or unit["core"]["module"] == top
                and all(unit["core"]["parameters"][name] == str(value) for name, value in numbers.items()))
    ports = [port for port in unit["ports"] if port["direction"] == "output"
             and port["name"] not in ("valid_o", "ready_o", "tag_o", "clamped_o")]
    return (f"localparam RESULT_W = {sum(port['width'] for port in ports)};\n"
            f"wire [RESULT_W-1:0] result = {{{', '.join(port['name'] for port in ports)}}};\n")


def in_stream(unit):
    """Whether a lobe's core stands in glint_stream, as an effect does, and not in glint_ports."""
    return any(path.name == "glint_stream.v" for path in MODULES[unit])


def latency(unit, parameters, folder, frame="ports"):
    """The clocks from an input of the unit to its result: as many as its glint_ports or glint_stream has valid bits."""
    chosen = " ".join(f"-chparam {name} {value}" for name, value in parameters.items())
    (folder / "latency.ys").write_text(
        f"read_verilog -formal -defer -D SYNTHESIS {' '.join(map(str, MODULES[unit]))}\n"
        f"hierarchy -check -top {unit} {chosen}\nproc\nflatten\nwrite_rtlil latency.il\n")
    run(["yosys", "-q", "-l", "latency.log", "latency.ys"], folder, "Yosys")
    return int(re.search(rf"^  wire width (\d+) \\{frame}\.valid_q$", (folder / "latency.il").read_text(), re.M).group(1))


def prepare(task, folder):
    """Writes the copies of the modules and runs Yosys; the result is model.smt2."""
    parameters = dict(task.parameters)
    added = ""
    if task.kind == "axis":
        wrapper, core = UNITS[task.top], UNITS[UNITS[task.top]["core"]["module"]]
        of_effect, unit = wrapper["kind"] == "effect_axis", core["core"]["module"]
        text = axis.emitted(GLINT, wrapper, folder) if task.sidebands else wrapper["files"][-1].read_text()
        if of_effect:
            modules = {**needed("glint_skid", "glint_stream"), core["name"]: axis.stand_in(core), task.top: text}
        else:
            numbers = {name: value for name, value in parameters.items() if name not in WRAPPER_PARAMETERS}
            modules = {**needed("glint_axis", unit), task.top: axis.at_any_size(UNITS, wrapper, text, numbers)}
        added = axis.beside(task.sidebands) + (axis.words_of_effect(core) if of_effect else axis.words_of_lobe())
    elif task.kind == "highlight":
        text, unit, numbers = around_lobe(task.top)
        modules = {**needed("glint_effect_highlight", unit), task.top: text}
    else:
        modules = needed(task.top)
    if task.edit:
        module, text, instead = task.edit
        modules[module] = axis.edited(module, modules[module], text, instead)
    if task.kind in ("unit", "effect", "highlight"):
        if task.kind != "highlight":
            unit, numbers = task.top, {name: value for name, value in parameters.items() if name != "TAG_W"}
        frame = "stream" if task.kind == "effect" else "ports"
        added += f"localparam CLOCKS = {latency(unit, numbers, folder, frame)};\n"
        if task.kind != "unit":
            added += declared_result(task.top, {} if task.kind == "highlight" else numbers)
    modules[task.top] = modules[task.top].replace("endmodule", f"{added}endmodule")
    for name, text in modules.items():
        properties = HERE / f"{task.kind if name == task.top and task.kind in KINDS else name}.vh"
        end = text.rindex("endmodule")
        text = text[:end] + (properties.read_text() if properties.exists() else "") + text[end:]
        (folder / f"{name}.v").write_text(text)
    if task.kind == "axis":
        if not of_effect:
            parameters["CORE_CLOCKS"] = latency(unit, numbers, folder, "stream" if in_stream(unit) else "ports")
        copy = folder / f"{task.top}.v"
        copy.write_text(axis.frame(copy.read_text(), of_effect or in_stream(unit), of_effect))
    for name in ("glint_scoreboard.v", "pipeline.vh", "glint_ports.vh"):
        shutil.copy(HERE / name, folder)
    defines = " ".join(f"-D {name}" for name in ("SYNTHESIS", f"PROVE_{task.kind.upper()}") + task.defines)
    chosen = " ".join(f"-chparam {name} {value}" for name, value in parameters.items())
    script = f"read_verilog -formal -defer {defines} *.v\nhierarchy -check -top {task.top} {chosen}\n"
    if task.kind == "shade":
        script += "cutpoint t:$mul\n"
    if task.kind in KINDS and not (task.kind == "axis" and of_effect):
        # Any product, quotient, logarithm, ... will do, and whatever waits for it beside: the handshake must not depend on
        # them.
        names = EFFECT_NUMBERS if task.kind == "effect" else NUMBERS
        script += (f"select -set numbers {' '.join(f't:*glint_{name}*' for name in names)} t:$mul t:$shr\n"
                   "select -set frame *glint_ports*/* *glint_stream*/*\ncutpoint @numbers @frame %d\n")
    # What nothing drives, such as the entries of tables beside a unit, may be anything: before `opt` chooses a value.
    script += "proc\nflatten\nsetundef -undriven -anyseq\nopt -full\ndffunmap\nopt_clean\n"
    script += "delete t:$assert\n" if task.method == "cover" else "delete t:$cover\n"
    script += "check -assert\nwrite_rtlil model.il\nwrite_smt2 -wires model.smt2\n"
    (folder / "model.ys").write_text(script)
    run(["yosys", "-q", "-l", "yosys.log", "model.ys"], folder, "Yosys")
    if task.only:
        sets = {}
        for name, pattern in (("kept", task.only), ("given", task.given)):
            sets[name] = [n for n in cells(folder, "assert") if pattern and re.fullmatch(pattern, n)]
            if pattern and not sets[name]:
                raise RuntimeError(f"no property `{pattern}` in the model")
        script = "read_rtlil model.il\n"
        script += "".join(f"chtype -set $assume c:{n}\n" for n in sets["given"] if n not in sets["kept"])
        script += f"select -set kept {' '.join(f'c:{n}' for n in sets['kept'])}\ndelete t:$assert @kept %d\n"
        (folder / "only.ys").write_text(script + "opt_clean\nwrite_rtlil model.il\nwrite_smt2 -wires model.smt2\n")
        run(["yosys", "-q", "-l", "only.log", "only.ys"], folder, "Yosys")


def run(command, folder, what):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{what} ended with status {done.returncode}: {' '.join(done.stdout.split())[-300:]}")


def cells(folder, kind):
    """The names of the properties of a kind (assert, cover) in the model."""
    return re.findall(rf"^  cell \${kind} \\(\S+)$", (folder / "model.il").read_text(), re.M)


solvers = set()  # the process groups of yosys-smtbmc and its z3, which would outlive this program


def stop(number, _):
    for group in solvers:
        os.killpg(group, signal.SIGKILL)
    os._exit(128 + number)


def ask(command, folder, limit):
    """What the solver printed, or None when it had no answer after so many seconds of processor time."""
    process = subprocess.Popen(["sh", "-c", 'ulimit -t "$0" && exec "$@"', str(limit), *command], cwd=folder,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
    solvers.add(process.pid)
    try:
        output = process.communicate()[0]
    finally:
        solvers.discard(process.pid)
    return None if "Unexpected EOF response from solver" in output or process.returncode == -signal.SIGKILL else output


def solve(task, folder, *arguments):
    """One run of yosys-smtbmc: whether it ended with PASSED, and what it printed."""
    # Which way of asking z3 answers fast differs by factors of a hundred, either way, and with any edit of the Verilog:
    # the one that did so far gets some time, each other a little, then each more.
    ways = [["--unroll", "--noincr"], ["--noincr"], ["--unroll"], []]
    fast = {"unit": ["--noincr"], "axis": ["--unroll"], "effect": ["--unroll"], "highlight": ["--unroll"]}
    if task.method == "induction" and task.kind in fast:
        ways.sort(key=lambda way: way != fast[task.kind])
    tries = [(ways[0], 60), *((way, 15) for way in ways[1:]), *((way, MOST_SECONDS) for way in ways)]
    for way, limit in tries:
        output = ask(["yosys-smtbmc", "--noprogress", *way, "-s", "z3", *arguments, "model.smt2"], folder, limit)
        if output is None:
            continue
        found = re.search(r"Status: (\w+)", output)
        if not found:
            raise RuntimeError(f"no status from yosys-smtbmc: {' '.join(output.split())[-300:]}")
        return found.group(1) == "PASSED", output
    raise RuntimeError(f"no answer from the solver, asked in {len(ways)} ways for {MOST_SECONDS} s each")


def failed_property(output):
    found = re.findall(r"(?:Assert failed in \S+: |Unreached cover statement at )(\S+?)\.?$", output, re.M)
    return ", ".join(dict.fromkeys(found)) or "no property named"


def prove(task, folder):
    prepare(task, folder)
    count = len(cells(folder, "cover" if task.method == "cover" else "assert"))
    if count == 0:
        raise RuntimeError("no property in the model")
    if task.method == "cover":
        passed, output = solve(task, folder, "-c", "-t", str(task.depth))
        reached = len(re.findall(r"Reached cover statement", output))
        if not passed or reached != count:
            raise RuntimeError(f"reached {reached} of {count} covers in {task.depth} clocks: {failed_property(output)}")
        steps = [int(n) for n in re.findall(r"Reached cover statement at \S+ in step (\d+)", output)]
        task.result = f"{count} reached, the last at clock {max(steps)}"
    elif task.method == "bug":
        passed, output = solve(task, folder, "-t", str(task.depth))
        if passed:
            raise RuntimeError(f"the planted bug is not found in {task.depth} clocks: {task.shows.split()[0]} holds")
        if not re.fullmatch(task.only, failed_property(output)):
            raise RuntimeError(f"the planted bug fails {failed_property(output)}, not {task.shows.split()[0]}")
        clock = re.findall(r"in step (\d+)", output)[-1]
        task.result = f"found at clock {clock}"
    else:
        passed, output = solve(task, folder, "-t", str(task.depth))  # the base case
        if not passed:
            raise RuntimeError(f"fails after reset: {failed_property(output)}")
        passed, output = solve(task, folder, "-i", "-t", str(task.depth))
        if not passed:
            raise RuntimeError(f"the induction does not close: {failed_property(output)}")
        k = task.depth - min(int(n) for n in re.findall(r"Trying induction in step (\d+)", output))
        task.result = f"proven, {count} properties, k = {max(k, 1)}"


def carry_out(task, build):
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="glint-formal-") as temporary:
        folder = pathlib.Path(temporary)
        if build:
            folder = build / task.name
            folder.mkdir(parents=True, exist_ok=True)
        try:
            prove(task, folder)
        except RuntimeError as error:
            task.failures.append(str(error))
    task.seconds = time.monotonic() - start
    parameters = " ".join(f"{name}={value}" for name, value in task.parameters.items())
    print(f"{'FAILED' if task.failures else 'ok':6}  {task.name:34}  {task.shows}  [{parameters}]  {task.method}: "
          f"{task.result or '; '.join(task.failures)}  {task.seconds:.1f} s", flush=True)
    return task


def to_json(task):
    return {"name": task.name, "shows": task.shows, "module": task.top, "parameters": task.parameters,
            "method": task.method, "ok": not task.failures, "result": task.result, "failures": task.failures,
            "seconds": round(task.seconds, 2)}


def write(path, text):
    temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    try:
        temporary.write_text(text)
        temporary.replace(path)
    except OSError as error:
        raise UsageError(f"--json {path} cannot be written: {error.strerror}") from error


def chosen(all_tasks, only):
    """A name stands for the task of that name, or for all that begin with it and a dot."""
    out = []
    for name in only:
        found = [task for task in all_tasks if task.name == name or task.name.startswith(f"{name}.")]
        if not found:
            legal = ", ".join(dict.fromkeys(task.name.split(".")[0] for task in all_tasks))
            raise UsageError(f"--only {name} is no task; legal is a name of --list, or a group: {legal}")
        out += [task for task in found if task not in out]
    return out if only else all_tasks


def main():
    parser = argparse.ArgumentParser(description="Handshake of the stream units, divider and square root, by Yosys and z3.",
                                     epilog="Example: run.py --only bps --only bugs.bps --json formal.json")
    parser.add_argument("--only", action="append", default=[], metavar="NAME",
                        help="a task, or a group of tasks (skid, divider.stage, bugs.bps); may be given several times")
    parser.add_argument("--list", action="store_true", help="print the names of the tasks and stop")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="tasks at a time (default: 1)")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write the same facts as JSON")
    parser.add_argument("--build", type=pathlib.Path, metavar="DIR",
                        help="keep the copies, scripts and models there (default: a temporary folder)")
    parser.add_argument("--glint", type=pathlib.Path, metavar="FILE", help="the command, for the tasks of sidebands")
    options = parser.parse_args()
    global GLINT
    GLINT = options.glint
    if options.jobs < 1:
        raise UsageError(f"--jobs {options.jobs} is not legal: at least 1")
    for program, package in PROGRAMS.items():
        if not shutil.which(program):
            raise UsageError(f"program '{program}' not found; install the package `{package}`")
    wanted = chosen(tasks(), options.only)
    if not GLINT and not options.list and any(task.sidebands for task in wanted):
        if options.only:
            raise UsageError("the proof of sidebands needs --glint FILE, the command that writes the wrapper")
        wanted = [task for task in wanted if not task.sidebands]
        print("left out: the proof of sidebands, which needs --glint")
    if options.list:
        print("\n".join(task.name for task in wanted))
        return 0
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, stop)
    start = time.monotonic()
    build = options.build.resolve() if options.build else None
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        done = list(pool.map(lambda task: carry_out(task, build), wanted))
    failed = [task.name for task in done if task.failures]
    if options.json:
        write(options.json, json.dumps({"tool": "proofs/formal/run.py", "tasks": [to_json(task) for task in done]},
                                       indent=1) + "\n")
    print(f"{len(done) - len(failed)} of {len(done)} tasks passed in {time.monotonic() - start:.0f} s")
    if not done:
        print("FAILED: no task")
    for name in failed:
        print(f"FAILED: {name}")
    return 1 if failed or not done else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except UsageError as error:
        print(f"run.py: {error}", file=sys.stderr)
        sys.exit(2)
