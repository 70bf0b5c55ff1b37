#!/usr/bin/env python3
"""The bound of the rounding error of the lobes with tables: from every input of their blocks to every input of the lobe.

    bound.py [--profile p8]      blinn_phong, spherical_gaussian, gauss; default: p8, p12, p16

The blocks are those of the oracle (tests/oracle: docs/exp-log.md in exact integers, no line of the model). The argument is that of
docs/exp-log.md, "Bounds", and each of its steps is a line here. For a legal n and C let a be the real exponent n w and b = t / 2^S:

    1. abs(b - a) <= n Du + q = x         Du: how far the block is off at this C, every C is tried; q = 2^-(S+1), from rounding t
    2. abs(2^-b - 2^-a) <= x ln 2 2^-(a-x)        mean value theorem: the slope is greatest at the lesser of the two, at least a - x
    3. n 2^(-n v) over all real n in [1, 1023] is greatest at 1 / (v ln 2), or at the end next to it;  v = w - Du >= 0, checked
    4. abs(p / 2^S - 2^-f) <= Dp           every fraction f is tried;  the shift by i >= 0 makes it no greater
    5. y is 2^O 2^-t off by 1/2 from its rounding, and where i is above O + 1 both are below 1/2

Numbers are doubles, rounded away from what they bound: the C library's logarithm, power and arc sine are trusted to 2^-45, each product and sum
of bounds gets 2^-40. What comes out has to be at most the bound that docs/exp-log.md and the lobe's page state, above the worst error that
the page states as measured, and below 1. Exit status: 0, 1 a bound does not hold, 2 bad arguments.
"""

import argparse
import importlib
import math
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/oracle"), str(ROOT / "tests/oracle/lobes")]
import exp_log  # noqa: E402

PROFILES = {"p8": (16, 8), "p12": (18, 12), "p16": (20, 16)}
LOBES = ("blinn_phong", "spherical_gaussian", "gauss")
LIBRARY, BOUND = 2.0**-45, 1 + 2.0**-40
LN2 = math.log(2) * (1 + LIBRARY)
MOST_N = 1023


def up(x):
    return x * BOUND


def greatest_slope(v):
    """At least the greatest n 2^(-n v) of 1 <= n <= MOST_N; v >= 0."""
    least, most = 1 / up(LN2), 1 / (LN2 / BOUND)
    if v * MOST_N <= least:
        return up(MOST_N * 2.0 ** (-MOST_N * v))
    if v >= most:
        return up(2.0**-v)
    return up(1 / (math.e * v * (LN2 / BOUND)))


def exp2_error(exp2, spoiled):
    """Step 4: the greatest error of p, over every fraction."""
    exp2(0)
    if spoiled:
        c0, c1, c2 = exp2.pieces.entries[1]
        exp2.pieces.entries[1] = c0, c1 + (1 << exp2.S - exp2.E - 3), c2
    worst = 0.0
    for f in range(1 << exp2.S):
        p = exp2.pieces.value(f >> exp2.pieces.R, f % (1 << exp2.pieces.R))
        assert 1 << exp2.S - 1 <= p <= 1 << exp2.S, "p is not within 1/2 .. 1"
        worst = max(worst, abs(p / 2**exp2.S - 2.0 ** -(f / 2**exp2.S)) + LIBRARY)
    return worst


def exponent_of_blinn_phong(lobe, F):
    """u and w at every C; C = 0 and 2^F apart, where u is what it stands for."""
    log2 = exp_log.Log2(F, lobe.T, lobe.L)
    assert log2(1 << F)[2] == 0 and log2(0)[2] == 31 << lobe.L
    for C in range(1, 1 << F):
        yield log2(C)[2] / 2**lobe.L, F - math.log2(C)


def exponent_of_gauss(lobe, F):
    lobe.steps(1, 0)
    pieces = lobe.pieces
    assert pieces.value(0, 0) == 0
    for d in range(1, (1 << F) + 1):
        index = min(d >> pieces.R, 2**lobe.T - 1)
        yield pieces.value(index, d - (index << pieces.R)) / 2**lobe.L, (2 * math.asin(math.sqrt(d / 2 ** (F + 1)))) ** 2 / (2 * math.log(2))


def slope_of_tables(lobe, F, exponent):
    """Steps 1 and 3: the greatest Du max(n 2^(-n (w - Du))), over every C."""
    worst, count = 0.0, 0
    for u, w in exponent(lobe, F):
        off = abs(u - w) + 2 * LIBRARY  # absolute: the two may be next to 0
        assert w >= off, "the exponent is off by more than itself"
        worst = max(worst, up(off * greatest_slope((w - off) / BOUND)))
        count += 1
    return worst, count


def slope_of_spherical_gaussian(lobe, F):
    """The same where g holds n: w = d g, Du = d Dg, over every n; of d in [0, 1] d 2^(-d v) is greatest at 1 / (v ln 2), or at 1."""
    worst = 0.0
    for n in range(1, MOST_N + 1):
        g, real = (n * lobe.a + lobe.b) / 2**lobe.K, (n + 0.775) / math.log(2)
        off = abs(g - real) + real * 8 * LIBRARY
        v = (real - off) / BOUND
        assert v * (LN2 / BOUND) >= 1, "the greatest is at the end"
        worst = max(worst, up(off / (math.e * v * (LN2 / BOUND))))
    return worst, MOST_N


def bound(name, profile, spoiled=False):
    """The bound in ulp, and how many inputs of the blocks it was made from."""
    F, O = PROFILES[profile]
    oracle = importlib.import_module(name)
    lobe = oracle.Lobe(F, oracle.Lobe.shipped[profile], O)
    p_off = exp2_error(lobe.exp2, spoiled)
    slope, count = (slope_of_spherical_gaussian(lobe, F) if name == "spherical_gaussian" else
                    slope_of_tables(lobe, F, exponent_of_gauss if name == "gauss" else exponent_of_blinn_phong))
    q = 2.0 ** -(lobe.S + 1)
    # Steps 2 and 5; 2^(-n v) is at most 1 beside q, and the x of the exponent a - x has a q of its own.
    return up(0.5 + 2**O * p_off + 2**O * up(2.0**q * LN2 * up(slope + q))), count + (1 << lobe.S)


def stated(name, profile):
    """The bound of docs/exp-log.md, and of the lobe's page the bound and the worst error that was measured."""
    row = re.search(rf"^\| `{name}` \| `{profile}` \| .* \| ([0-9.]+) \|$", (ROOT / "docs/exp-log.md").read_text(), re.M)
    page = re.search(rf"^\| `{profile}`\s+\| ([0-9.]+) \| [0-9]+, [0-9]+ \| ([0-9.]+) \|", (ROOT / f"docs/lobes/{name}.md").read_text(), re.M)
    if not row or not page:
        raise SystemExit(f"bound.py: no bound of {name} at {profile} in the documents")
    return float(row[1]), float(page[2]), float(page[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--profile", choices=list(PROFILES))
    parser.add_argument("--spoiled", action="store_true", help="with a wrong entry in the table of exp2: 0 if no bound holds")
    options = parser.parse_args()
    wrong = tried = 0
    for profile in [options.profile] if options.profile else PROFILES:
        for name in LOBES:
            tried += 1
            try:
                found, inputs = bound(name, profile, options.spoiled)
            except AssertionError as error:
                print(f"FAILED: {name} {profile}: {error}")
                wrong += 1
                continue
            table, page, measured = stated(name, profile)
            good = found <= table == page < 1 and measured <= found
            wrong += not good
            print(f"{'ok' if good else 'FAILED':6} {name} {profile}: {found:.6f} ulp from {inputs} inputs of the blocks; stated {table} and {page}, "
                  f"measured {measured}")
    if options.spoiled:
        wrong = tried - wrong
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
