#!/usr/bin/env python3
"""The benches of glint_divider, glint_sqrt, glint_delay and glint_skid in Icarus, and bugs planted in copies of these
modules, which the benches must find. With an argument, the unit of that name only."""

import sys
import tempfile
from pathlib import Path

import icarus

HERE = Path(__file__).parent
RANDOM_DIVISIONS = 10000
RANDOM_ROOTS = 10000


def exhaustive(X_W, Y_W, Q_W):
    """How many legal operands there are."""
    return sum(min(divisor << Q_W, 1 << X_W) for divisor in range(1, 1 << Y_W))


def divider(X_W, Y_W, Q_W, divisions=0):
    return {"X_W": X_W, "Y_W": Y_W, "Q_W": Q_W, "DIVISIONS": divisions}, divisions or exhaustive(X_W, Y_W, Q_W)


def divider_of(F, S):
    """The divider of a lobe that divides C 2^S by D, as glint_bps has it."""
    return divider(F + 1 + S, F + 10, S + 1, RANDOM_DIVISIONS)


# Per unit: what its bench counts, its parameters with the count that is expected, and the planted bugs.
UNITS = {
    "divider": (
        "divisions",
        [
            # The least Q_W, the least and the greatest X_W, a divisor of one bit, more and fewer quotient bits than
            # divisor bits.
            *(divider(*widths) for widths in ((3, 1, 2), (3, 2, 2), (4, 2, 2), (3, 4, 2), (7, 5, 2), (6, 1, 5))),
            *(divider(*widths) for widths in ((10, 5, 5), (9, 6, 5), (11, 3, 8), (9, 7, 3), (12, 6, 6), (9, 8, 3))),
            *(divider_of(F, S) for F, S in ((16, 11), (18, 15), (20, 19), (8, 4), (30, 30))),
        ],
        [
            (r"shifted >= \{1'b0, divisor\}", "shifted > {1'b0, divisor}"),
            (r"shifted = \{remainder, bits\[Q_W-1\]\}", "shifted = {1'b0, remainder[Y_W-2:0], bits[Q_W-1]}"),
            (r"divisor_q   <= divisor;", "divisor_q   <= divisor_i;"),
            (r"if \(enable_i\) begin", "begin"),
            (r"assign quotient_o  = stage\[Q_W-1\]", "assign quotient_o  = stage[Q_W-2]"),
            (r"assign remainder_o = stage\[Q_W-1\].remainder_q", "assign remainder_o = head"),
            (r"\{bits\[Q_W-2:0\], fits\}", "{bits[Q_W-2:0], fits | divisor == 6}"),
        ],
    ),
    "sqrt": (
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
HUNTED = {"divider": (6, 13), "sqrt": (3, 5), "delay": (3,), "skid": (1,)}


def simulate(folder, rtl, unit, parameters):
    executable = Path(folder) / "bench"
    bench = f"{unit}_tb"
    icarus.build(executable, bench, [HERE / f"{bench}.v", rtl / f"glint_{unit}.v"], parameters)
    return icarus.run(executable)


def check(unit, folder):
    things, runs, bugs = UNITS[unit]
    done = 0
    total = 0
    for parameters, expected in runs:
        icarus.require(simulate(folder, icarus.RTL, unit, parameters), things, expected)
        done += 1
        total += expected
    found = 0
    for number, (pattern, replacement) in enumerate(bugs):
        rtl = icarus.planted(Path(folder) / f"{unit}{number}", f"glint_{unit}.v", pattern, replacement)
        for index in HUNTED[unit]:
            output = simulate(folder, rtl, unit, runs[index][0])
            if icarus.counts(output, things)[1] == 0 or "FAILED: " not in output:
                bug = f"'{replacement}' for '{pattern}' in glint_{unit}.v"
                raise icarus.Failed(f"not found with {runs[index][0]}: {bug}\n{output}")
            found += 1
    print(f"glint_{unit}: {done} sets of parameters, {total} {things}, 0 mismatches; {found} planted bugs found")
    if done == 0 or total == 0 or found == 0:
        raise icarus.Failed(f"nothing was checked of glint_{unit}")


def main():
    units = sys.argv[1:] or list(UNITS)
    try:
        with tempfile.TemporaryDirectory() as folder:
            for unit in units:
                if unit not in UNITS:
                    raise icarus.Failed(f"unit '{unit}' is not legal: {', '.join(UNITS)}")
                check(unit, folder)
    except icarus.Failed as failed:
        print(f"FAILED: {failed}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
