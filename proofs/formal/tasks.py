"""What is proven: the tasks of run.py."""

import pathlib
import sys
from dataclasses import dataclass, field

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tests/rtl"))
import bugs  # noqa: E402
import units  # noqa: E402

UNITS = units.units()
MODULES = units.modules()

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
DIVIDERS = {"p8": (28, 26, 12), "p12": (34, 28, 16), "p16": (40, 30, 20)}  # X_W, Y_W, Q_W in bps

HANDSHAKE = "no item lost, repeated or reordered; stable in a stall; tag kept; reset"

# In the proofs of units their outputs may be any number; in those of effects, whose pipelines are long, more.
NUMBERS = ("multiplier", "divider", "log2", "parabola")
EFFECT_NUMBERS = (*NUMBERS, "sqrt", "attenuation", "delay")


@dataclass
class Task:
    name: str
    shows: str
    top: str                       # the module under proof
    kind: str                      # unit, axis (its wrapper), or a shared module: skid, delay, divider, sqrt; lemmas: top.smt2
    parameters: dict
    method: str                    # induction, cover or bug
    depth: int                     # induction: the largest k tried; else the clocks looked at
    only: str = ""                 # the properties in question, as a regular expression; else all
    given: str = ""                # properties that another task proves by themselves, which this one may assume
    defines: tuple = ()
    edit: tuple = ()               # bug: module, text, what stands there instead; lemmas: the last two
    sidebands: bool = False        # axis: with all of them, as the command `glint` writes it
    failures: list = field(default_factory=list)
    result: str = ""
    seconds: float = 0.0

    @property
    def emitted(self):
        """Whether the command `glint` writes the wrapper."""
        return self.sidebands or self.kind == "lanes"


def in_stream(unit):
    """Whether a lobe's core stands in glint_stream, as an effect does, and not in glint_ports."""
    return any(path.name == "glint_stream.v" for path in MODULES[unit])


def planted(group, top, kind, parameters, depth, module, table, defines=()):
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
           *planted("skid", "glint_skid", "skid", {"WIDTH": 8}, 8, "glint_skid", bugs.SKID)]
    for stages in (1, 21, 30):
        out.append(Task(f"delay.{stages}", "comes out STAGES enabled clocks later; holds without enable", "glint_delay",
                        "delay", {"WIDTH": TAG_W + 1, "STAGES": stages}, "induction", 2))
    out += [Task("delay.cover", "not vacuous", "glint_delay", "delay", {"WIDTH": 4, "STAGES": 5}, "cover", 12),
            *planted("delay", "glint_delay", "delay", {"WIDTH": 4, "STAGES": 5}, 9, "glint_delay", bugs.DELAY)]
    fifo = {"WIDTH": 4, "LOG_DEPTH": 2}
    for log_depth in (1, 6):
        out.append(Task(f"fifo.{log_depth}", "no item lost, repeated or reordered, where no more are pushed than it holds",
                        "glint_fifo", "fifo", {"WIDTH": 87, "LOG_DEPTH": log_depth}, "induction", 1))
    out += [Task("fifo.cover", "not vacuous", "glint_fifo", "fifo", fifo, "cover", 14),
            *planted("fifo", "glint_fifo", "fifo", fifo, 9, "glint_fifo", bugs.FIFO)]
    small = divider(10, 6, 5)
    for name, widths in DIVIDERS.items():
        out.append(Task(f"divider.stage.{name}", "one stage: 2 remainder + bit = fits divisor + reduced < divisor",
                        "glint_divider_restoring", "divider", divider(*widths), "induction", 1, "one_stage|stage_moves",
                        defines=("TWO_STAGES",)))
    for name in ("p8", "p12"):  # at p16 z3 does not answer in 300 s: divider.rows says it of every width
        out.append(Task(f"divider.{name}", "whole divider, by bookkeeping; holds without enable", "glint_divider_restoring",
                        "divider", divider(*DIVIDERS[name]), "induction", 1))
    out += [Task("divider.rows", "whole divider, any width: induction over the rows, in integers", "glint_divider_restoring", "lemmas", {},
                 "induction", 1),
            Task("bugs.divider.rows", "`row` fails", "glint_divider_restoring", "lemmas", {}, "bug", 1, "row:",
                 edit=("(* 2 (- M 1 Y)) 1)", "(* 2 (- M 1 Y)) 0)")),
            Task("divider.multiply", "quotient divisor + remainder = dividend, remainder < divisor, as written",
                 "glint_divider_restoring", "divider", small, "induction", 1, defines=("MULTIPLY",)),
            Task("divider.cover", "not vacuous", "glint_divider_restoring", "divider", small, "cover", 12),
            *planted("divider", "glint_divider_restoring", "divider", small, 9, "glint_divider_restoring", bugs.DIVIDER, ("MULTIPLY",))]
    for bits in (16, 19, 24):
        out.append(Task(f"sqrt.stage.{bits}", "each stage: 4 remainder + bits = fits (4 root + 1) + reduced", "glint_sqrt",
                        "sqrt", {"Y_W": bits}, "induction", 1))
    out += [Task("sqrt.multiply", "root^2 + remainder = radicand, remainder <= 2 root, as written; holds without enable",
                 "glint_sqrt", "sqrt", {"Y_W": 5}, "induction", 1, defines=("MULTIPLY",)),
            Task("sqrt.cover", "not vacuous", "glint_sqrt", "sqrt", {"Y_W": 5}, "cover", 12, defines=("MULTIPLY",)),
            *planted("sqrt", "glint_sqrt", "sqrt", {"Y_W": 5}, 9, "glint_sqrt", bugs.SQRT, ("MULTIPLY",))]
    for lobe in LOBES:
        small = {**word_lengths(lobe, "p8"), **SMALL.get(lobe, {})}
        unit, wrapper = f"glint_{lobe}", f"glint_{lobe}_axis_p12"
        kind = "effect" if in_stream(unit) else "unit"  # which frame its numbers stand in
        for profile in ("p8", "p12", "p16") if lobe == BUGGED else ("p12",):
            numbers = word_lengths(lobe, profile)
            out += [Task(f"{lobe}.{profile}", HANDSHAKE, unit, kind, {**numbers, "TAG_W": TAG_W}, "induction", 2),
                    Task(f"axis.{lobe}.{profile}", HANDSHAKE + "; operands and result kept",
                         wrapper, "axis", {**numbers, "USER_W": TAG_W}, "induction", 3)]
        if any(parameter["name"] == "DEEP" for parameter in UNITS[f"glint_{lobe}_p12"]["parameters"]):
            out.append(Task(f"{lobe}.deep.p12", HANDSHAKE, unit, kind, {**word_lengths(lobe, "p12"), "DEEP": 1, "TAG_W": TAG_W},
                            "induction", 2))
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
                    *planted(f"{lobe}.iterative", unit, "unit", one, 40, "glint_ports", bugs.ITERATIVE, ("ITERATIVE",))]
            out += [*planted(lobe, unit, "unit", core, 22, "glint_ports", bugs.PORTS),
                    *planted(f"axis.{lobe}", wrapper, "axis", axis, 24, "glint_axis", bugs.AXIS),
                    *planted(f"axis.{lobe}", wrapper, "axis", axis, 24, wrapper, bugs.WRAPPER)]
    out += of_shade()
    out += of_lobe_select()
    out += of_pixel()
    out += of_lanes()
    out += of_own()
    for effect in EFFECTS:
        out += of_axis(effect)
    for effect in (e for e in EFFECTS if e not in ("shade", "lobe_select", "pixel")):
        out += of_effect(effect)
    return out


def of_axis(effect):
    """The AXI4-Stream unit of an effect, around any unit of its ports that keeps the rules."""
    wrapper = next(name for name, unit in UNITS.items() if unit["kind"] == "effect_axis" and unit["effect"] == effect)
    out = [Task(f"axis.effect.{effect}.p12", HANDSHAKE + "; operands and result kept", wrapper, "axis", {"USER_W": TAG_W},
                "induction", 3)]
    if effect == SHORT[0]:
        out += [Task(f"axis.effect.{effect}.cover", "not vacuous", wrapper, "axis", {"USER_W": 1}, "cover", 20),
                *planted(f"axis.effect.{effect}", wrapper, "axis", {"USER_W": 1}, 16, wrapper, bugs.WORDS)]
    return out


def of_lanes():
    """The lanes of every AXI4-Stream unit."""
    out = []
    for name, unit in UNITS.items():
        if unit["kind"] not in ("lobe_axis", "effect_axis"):
            continue
        group = f"lanes.effect.{unit['effect']}" if unit["effect"] else f"lanes.{unit['lobe']}"
        top = name.replace("_axis_", "_lanes_")
        out.append(Task(f"{group}.p12", "all lanes keep step, whatever their numbers", top, "lanes", {}, "induction", 1))
        if unit["lobe"] == BUGGED and not unit["effect"]:
            out.append(Task(f"{group}.iterative.p12", out[-1].shows, top, "lanes", {"DIVIDER": 2}, "induction", 1))
        if unit["effect"] == SHORT[0]:
            out.append(Task(f"{group}.cover", "not vacuous", top, "lanes", {}, "cover", 20))
            for module, table in ((top, bugs.LANES), (name, bugs.LANES_UNIT), ("glint_skid", bugs.LANES_SKID)):
                out += planted(group, top, "lanes", {}, 16, module, table)
    return out


def of_own():
    """A lobe's `y` and `clamped` come from its own input alone."""
    top, kind, parameters = "glint_quadratic_p8", "own", {"TAG_W": 1}
    bugged = [task for module, table in bugs.OWN.items() for task in planted("own.quadratic", top, kind, parameters, 12, module, table)]
    return [*bugged, Task("own.quadratic.cover", "not vacuous", top, kind, parameters, "cover", 14)] + [Task(f"own.{lobe}.p8", "y and clamped belong to their own input", f"glint_{lobe}_p8", "own", {"TAG_W": 1}, "induction", 1)
            for lobe in LOBES if not in_stream(f"glint_{lobe}")]  # own.vh stands on glint_ports


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
    for module, table in bugs.SHADE.items():
        out += planted(name, top, kind, small, 20, module, table)
    return out


def of_lobe_select():
    """The tasks of the effect lobe_select, with any units of the latencies that it was told."""
    name, top, kind = "effect.lobe_select", "glint_effect_lobe_select", "lobe_select"
    small = {"O": 2, "N": 3, "MASK": 5, "CLOCKS": 4 << 16 | 9 << 8 | 2, "LOG_DEPTH": 2, "TAG_W": 2}  # the second is not built
    return [Task(f"{name}.order", HANDSHAKE + "; each result is that of its lobe", top, kind, small, "induction", 2),
            Task(f"{name}.cover", "not vacuous", top, kind, small, "cover", 24),
            *planted(name, top, kind, small, 24, top, bugs.LOBE_SELECT)]


def of_pixel():
    """The tasks of what stands before and behind shade in the effect pixel."""
    name, top, kind = "effect.pixel", "glint_effect_pixel", "pixel"
    small = {"W": 2, "F": 0, "O": 2, "WIDE": 1, "TAG_W": 1}  # 15 clocks, a memory of 16
    return [Task(f"{name}.order", HANDSHAKE + "; what waits leaves with it; a pixel is cut", top, kind, small, "induction", 2),
            Task(f"{name}.cover", "not vacuous", top, kind, small, "cover", 24),
            *planted(name, top, kind, small, 40, top, bugs.PIXEL),
            *planted(name, top, kind, small, 40, "glint_wait", bugs.PIXEL_WAIT)]


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
        out += planted(f"effect.{effect}", unit, kind, small, 9, "glint_stream", bugs.STREAM)
    if effect == "phong":
        out += planted(f"effect.{effect}", tops["p8"], kind, small, 40, "glint_effect_highlight", bugs.HIGHLIGHT)
    return out
