#!/usr/bin/env python3
"""The benches of the dividers, glint_sqrt, glint_multiplier, glint_delay and glint_skid in Icarus, and bugs planted in
copies of these modules, which the benches must find.

    units_test.py [--long] [UNIT...]      default: all units; --long: more operands of dividers and multipliers
"""

import sys
import tempfile
from pathlib import Path

import icarus
from icarus import RTL
from units import modules, read

HERE = Path(__file__).parent
LONG = sys.argv[1:2] == ["--long"]
RANDOM_DIVISIONS = 10000 if LONG else 500
RANDOM_ROOTS = 2000
PRODUCTS = 10000 if LONG else 1000


def exhaustive(X_W, Y_W, Q_W):
    """How many legal operands there are."""
    return sum(min(divisor << Q_W, 1 << X_W) for divisor in range(1, 1 << Y_W))


def clocks(which, Q_W, rows=1, stages=1):
    """The latency of a divider, as docs/rtl.md has it."""
    if which == 0:
        return -(-Q_W // rows)
    if which == 1:
        return 1 + -(-(-(-Q_W // 2)) // rows)
    return 1 + stages + -(-Q_W // 16) * (2 * stages + 1)


def divider(X_W, Y_W, Q_W, divisions=0, which=0, rows=1, stages=1):
    return {"X_W": X_W, "Y_W": Y_W, "Q_W": Q_W, "DIVISIONS": divisions, "DIVIDER": which, "REGISTER_EVERY": rows,
            "MULTIPLIER_STAGES": stages, "LATENCY": clocks(which, Q_W, rows, stages)}, divisions or exhaustive(X_W, Y_W, Q_W)


def of_lobe(F, S):
    """The widths of the divider of a lobe that divides C 2^S by D, as glint_bps has it."""
    return F + 1 + S, F + 10, S + 1


# The least Q_W, the least and the greatest X_W, a divisor of one bit, more and fewer quotient bits than divisor bits.
SMALL = ((3, 1, 2), (3, 2, 2), (4, 2, 2), (3, 4, 2), (7, 5, 2), (6, 1, 5), (10, 5, 5), (9, 6, 5), (11, 3, 8),
         *(((9, 7, 3), (12, 6, 6), (9, 8, 3)) if LONG else ()))
LARGE = tuple(of_lobe(F, S) for F, S in ((16, 11), (18, 15), (20, 19), (8, 4), (30, 30)))


def dividers(which, variants=()):
    """Every operand at small widths, random ones at those of the lobes; variants: rows and stages."""
    return [*(divider(*widths, which=which) for widths in SMALL),
            *(divider(*widths, RANDOM_DIVISIONS, which) for widths in LARGE),
            *(divider(*widths, RANDOM_DIVISIONS, which, rows, stages) for rows, stages in variants for widths in LARGE)]


# Per unit: its bench, the file that holds it, what its bench counts, its parameters with the count that is expected, and
# the planted bugs.
UNITS = {
    "restoring": (
        "divider_tb", "glint_divider_restoring",
        "divisions",
        dividers(0, ((2, 1), (3, 1), (32, 1))),
        [
            (r"fits = ~difference\[Y_W\+1\]", "fits = ~difference[Y_W+1] & |difference[Y_W:1]"),
            (r"shifted = \{remainder, bits\[Q_W-1\]\}", "shifted = {1'b0, remainder[Y_W-2:0], bits[Q_W-1]}"),
            (r"beside_q     <= beside;", "beside_q     <= beside_i;"),
            (r"if \(enable_i\) begin", "begin"),
            (r"assign quotient_o  = row\[Q_W-1\]", "assign quotient_o  = row[Q_W-2]"),
            (r"assign remainder_o = row\[Q_W-1\].remainder_next", "assign remainder_o = head"),
            (r"1'b1\} \+ \{1'b1, complement, 1'b1\}", "1'b1} + {1'b1, complement, 1'b0}"),
        ],
    ),
    "radix4": (
        "divider_tb", "glint_divider_radix4",
        "divisions",
        dividers(1, ((2, 1), (3, 1))),
        [
            (r"fits_3 = ~less_3\[R_W\+1\]", "fits_3 = ~less_3[R_W+1] & |less_3[R_W:1]"),
            (r"fits_2 \? fits_3 : fits_1\}", "fits_2 ? fits_3 : ~fits_1}"),
            (r"<= ~three", "<= ~three + 1'b1"),
            (r"beside_q    <= beside;", "beside_q    <= beside_i;"),
            (r"\{2'b11, complement, 2'b11\}", "{2'b11, complement, 2'b10}"),
        ],
    ),
    "iterative": (
        "divider_iterative_tb", "glint_divider_iterative",
        "divisions",
        [({"X_W": X_W, "Y_W": Y_W, "Q_W": Q_W, "DIVISIONS": 1000}, 1000) for X_W, Y_W, Q_W in SMALL + LARGE],
        [
            (r"fits = ~difference\[Y_W\+1\]", "fits = ~difference[Y_W+1] & |difference[Y_W:1]"),
            (r"left_q == 6'd1\)", "left_q == 6'd2)"),
            (r"~start_i & \(left_q", "(left_q"),
            (r"else if \(left_q != 6'd0\)", "else"),
            (r"if \(enable_i\) begin", "begin"),
        ],
    ),
    "reciprocal": (
        "divider_tb", "glint_divider_reciprocal",
        "divisions",
        dividers(3, ((1, 2), (1, 4))),
        [
            (r"fits_2 = ~left_2\[L_W-1\]", "fits_2 = 1'b0"),
            (r"fits_1 = ~left_1\[L_W-1\]", "fits_1 = ~left_1[L_W-1] & |left_1"),
            (r"digit_1_q <= estimate \+ .*;", "digit_1_q <= estimate;"),
            (r"whole_1_q <= whole - .*;", "whole_1_q <= whole;"),
            (r"dividend_wide << shift;", "dividend_wide << (shift ^ 6'd1);"),
            (r"<< DROP\) - 64'd1\) >> DROP\) - 64'd1;", "<< DROP) - 64'd1) >> DROP) + 64'd99;"),
            (r"beside_q  <= beside_2", "beside_q  <= beside_1"),
        ],
    ),
    "multiplier": (
        "multiplier_tb", "glint_multiplier",
        "products",
        [({"A_W": a, "B_W": b, "SIGNED": signed, "STAGES": stages, "PRODUCTS": PRODUCTS}, PRODUCTS)
         for a, b in ((1, 1), (3, 2), (18, 16), (19, 10), (11, 31), (33, 31)) for signed in (0, 1) for stages in (1, 2, 3, 4)],
        [
            (r"\{\{SLICE_W\{a_i\[A_W-1\]\}\}, a_i\}", "{{SLICE_W{1'b0}}, a_i}"),
            (r"sign = SIGNED != 0 \? low\[A_W\+LOW_W-1\] : 1'b0", "sign = 1'b0"),
            (r"high = level\[j-1\].node\[2\*k\+1\]", "high = level[j-1].node[2*k]"),
            (r"if \(enable_i\) product_q <= \{high", "product_q <= {high"),
        ],
    ),
    "sqrt": (
        "sqrt_tb", "glint_sqrt",
        "roots",
        [
            *(({"Y_W": bits, "ROOTS": 0}, 4**bits) for bits in (2, 3, 4, 7)),
            *(({"Y_W": bits, "ROOTS": RANDOM_ROOTS}, RANDOM_ROOTS) for bits in (16, 19, 24, 32)),
        ],
        [
            (r"fits = shifted >= trial", "fits = shifted > trial"),
            (r"stage\[i-1\].root_q, 2'b01\}", "stage[i-1].root_q, 2'b00}"),
            (r"if \(enable_i\) remainder_q <= reduced", "remainder_q <= reduced"),
            (r"if \(enable_i\) root_q <= \{stage", "root_q <= {stage"),
            (r"bits_q <= stage\[i-1\].waiting.bits_q", "bits_q <= stage[0].waiting.bits_q"),
            (r"assign root_o      = stage\[Y_W-1\].root_q", "assign root_o      = {stage[Y_W-2].root_q, 1'b0}"),
            (r"assign remainder_o = stage\[Y_W-1\].remainder_q", "assign remainder_o = {(Y_W + 1) {1'b0}}"),
        ],
    ),
    "delay": (
        "delay_tb", "glint_delay",
        "items",
        [
            ({"WIDTH": width, "STAGES": stages, "ITEMS": 10000}, 10000)
            for width, stages in ((1, 1), (7, 1), (1, 2), (17, 3), (1, 28), (64, 40))
        ],
        [
            (r"assign data_o = stage\[STAGES-1\]", "assign data_o = stage[STAGES-2]"),
            (r"if \(enable_i\) data_q <= data_i", "data_q <= data_i"),
            (r"if \(enable_i\) data_q <= stage", "data_q <= stage"),
        ],
    ),
    "skid": (
        "skid_tb", "glint_skid",
        "items",
        [({"WIDTH": width, "ITEMS": 10000}, 10000) for width in (1, 8, 47, 64)],
        [
            (r"assign ready_o = ready_q", "assign ready_o = ready_q | ready_i"),
            (r"assign valid_o = valid_q", "assign valid_o = valid_q & ready_i"),
            (r"assign valid_o = valid_q", "assign valid_o = valid_q & rst_ni"),
            (r"spare_full_q \? spare_q : data_i", "data_i"),
            (r"ready_q      <= ~spare_full;", "ready_q      <= 1'b1;"),
            (r"ready_q      <= ~spare_full;", "ready_q      <= ~spare_full & leave;"),
            (r"spare_full_q <= 1'b0;", ""),
            (r"valid_q      <= 1'b0;", ""),
            (r"ready_q      <= 1'b0;", "ready_q      <= 1'b1;"),
            (r"if \(accept\) spare_q", "if (valid_i) spare_q"),
        ],
    ),
}
# Planted bugs are looked for with these parameters, an index of the list above.
LARGER = len(SMALL) + 1  # of LARGE
HUNTED = {"restoring": (6, LARGER), "radix4": (6, LARGER), "iterative": (6, LARGER), "reciprocal": (8, LARGER), "multiplier": (15,),
          "sqrt": (3, 5), "delay": (3,), "skid": (1,)}


def of_family(family, files):
    """The same files, with those that a family has in their place, and the models of its primitives."""
    own = read()["families"][family]
    taken = {name: paths for name, paths in own.items() if name != "simulation"}
    kept = [file for file in files if file.stem not in taken]
    return list(dict.fromkeys([RTL / name for paths in own.values() for name in paths] + kept))


# What families have in the place of a unit's module: the family, DIVIDER, planted bugs. By the contract of that for any device.
FAMILIES = {
    "restoring": (
        ("ecp5", 0, [(r"\? \{Y_W\{1'b0\}\} : row", "? row[Q_W-1].divisor_next : row")]),
        ("ice40", 0, [(r"\? row\[i-1\]\.less_next :", "? row[i-1].kept_next :"), (r">> \(Y_W - R_W\)", ">> (Y_W - R_W + 1)")]),
    ),
    "radix4": (
        ("ecp5", 1, [(r"fits_twice == subtract", "fits_twice"), (r"\.b_i       \(triple\)", ".b_i({2'b00, divisor})"),
                     (r"subtract  = row\[i-1\]\.bits_next\[0\]", "subtract  = row[i-1].bits_next[1]")]),
    ),
    "iterative": (("up5k", 2, [(r"fits_q <= 1'b0;", ""), (r"kept_q <= shifted", "kept_q <= difference")]),),
    "multiplier": (("ice40", None, [(r"single \+ twice", "single | twice"), (r"SIGNED != 0 & a_i", "1'b0 & a_i")]),),
}


def check_family(unit, folder):
    """The module of each family; with one set of parameters the bench must find each planted bug."""
    bench, module = UNITS[unit][0], UNITS[unit][1]
    top = module if unit == "multiplier" else "glint_divider"
    for family, which, bugs in FAMILIES.get(unit, ()):
        hunted = -1
        if unit == "multiplier":
            runs = [run for run in UNITS[unit][3] if run[0]["A_W"] in (18, 19)]
        elif unit == "iterative":
            runs = UNITS[unit][3]
        else:
            hunted = 1
            runs = [divider(10, 5, 5, which=which, rows=4), divider(9, 6, 5, which=which),
                    *(divider(*widths, RANDOM_DIVISIONS, which) for widths in LARGE)]
            if LONG:
                runs += [divider(9, 7, 3, which=which), divider(9, 8, 3, which=which), divider(12, 6, 6, which=which, rows=4)]
        files = [*of_family(family, modules()[top]), HERE / f"{bench}.v"]
        total = 0
        for parameters, expected in runs:
            icarus.build(Path(folder) / "bench", bench, files, parameters)
            icarus.require(icarus.run(Path(folder) / "bench"), UNITS[unit][2], expected)
            total += expected
        for pattern, replacement in bugs:
            planted = icarus.with_bug(folder, files, module, pattern, replacement)
            icarus.build(Path(folder) / "bench", bench, planted, runs[hunted][0])
            if icarus.counts(icarus.run(Path(folder) / "bench"), UNITS[unit][2])[1] == 0:
                raise icarus.Failed(f"not found: '{replacement}' for '{pattern}' in {module} of {family}")
        print(f"{module} of {family}: {total} {UNITS[unit][2]}, 0 mismatches; {len(bugs)} planted bugs found")


def simulate(folder, rtl, unit, parameters):
    executable = Path(folder) / "bench"
    bench, top = UNITS[unit][0], "glint_divider" if "DIVISIONS" in parameters else UNITS[unit][1]
    icarus.build(executable, bench, [*modules(rtl)[top], HERE / f"{bench}.v"], parameters)
    return icarus.run(executable)


def check(unit, folder):
    _, module, things, runs, bugs = UNITS[unit]
    done = 0
    total = 0
    for parameters, expected in runs:
        icarus.require(simulate(folder, icarus.RTL, unit, parameters), things, expected)
        done += 1
        total += expected
    found = 0
    for number, (pattern, replacement) in enumerate(bugs):
        rtl = icarus.planted(Path(folder) / f"{unit}{number}", f"{module}.v", pattern, replacement)
        for index in HUNTED[unit]:
            output = simulate(folder, rtl, unit, runs[index][0])
            if icarus.counts(output, things)[1] == 0 or "FAILED: " not in output:
                bug = f"'{replacement}' for '{pattern}' in {module}.v"
                raise icarus.Failed(f"not found with {runs[index][0]}: {bug}\n{output}")
            found += 1
    print(f"{module}: {done} sets of parameters, {total} {things}, 0 mismatches; {found} planted bugs found")
    if done == 0 or total == 0 or found == 0:
        raise icarus.Failed(f"nothing was checked of {module}")


def main(*words):
    with tempfile.TemporaryDirectory() as folder:
        for unit in words[LONG:] or UNITS:
            if unit not in UNITS:
                raise icarus.Failed(f"unit '{unit}' is not legal: {', '.join(UNITS)}")
            check(unit, folder)
            check_family(unit, folder)


if __name__ == "__main__":
    icarus.main(main)
