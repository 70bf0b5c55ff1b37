#!/usr/bin/env python3
"""docs/contract.md against itself: its tables, figures and formats, recomputed by the oracle.

Exit status: 0 all hold, 1 some do not, 2 the document cannot be read.
"""

import math
import re
import sys
from fractions import Fraction

import oracle
from arithmetic import rnd
from checks import by_name
from document import CONTRACT, check, integer


def check_arithmetic(document, checks):
    rows = document.table("Arithmetic", "x", "3")
    for row in rows[1:]:
        k = int(re.fullmatch(r"rnd\(x, ([0-9]+)\)", row[0])[1])
        for x, value in zip(rows[0][1:], row[1:], strict=True):
            checks.equal(f"rnd({x}, {k})", integer(value), rnd(integer(x), k))


def check_profiles(document, checks):
    rows = document.table("Profiles", "profile", "F", "O")
    checks.equal("shipped profiles", [row[0] for row in rows[1:]], list(oracle.SHIPPED))
    for row, (name, (F, O)) in zip(rows[1:], oracle.SHIPPED.items()):
        checks.equal(name, [integer(x) for x in row[1:]], [F, O, 1023 * ((1 << F) + 1)])


def check_epicentre(document, checks):
    """The edge of the epicentre zone: no code nearer than said, the double's edge nearer than that."""
    F, code_bits, double_bits = map(int, document.find(
        r"for `F <= ([0-9]+)` no `c` comes nearer to `sqrt\(\(n-1\)/n\)` than `2\^-([0-9]+)`, "
        r"and the double is off by less than `2\^-([0-9]+)`"))
    checks.true("the double is nearer than the codes", double_bits > code_bits)
    scale = 200
    for n in range(2, 1024):
        edge = math.isqrt(((n - 1) << 2 * scale) // n)  # 2^200 times the edge, rounded down
        nearest = round(Fraction(edge, 2 ** (scale - F)))
        # An edge rounded down by less than 2^-199 cannot hide a distance of 2^-52.
        distance = abs(Fraction(nearest, 2**F) - Fraction(edge, 2**scale))
        slack = Fraction(1, 2 ** (scale - 1))
        checks.true(f"codes around the edge of n={n}", distance > Fraction(1, 2**code_bits) + slack)
        double = abs(Fraction(math.sqrt((n - 1) / n)) - Fraction(edge, 2**scale))
        checks.true(f"double's edge of n={n}", double < Fraction(1, 2**double_bits) - slack)
        checks.true(f"no code at the edge of n={n}", math.isqrt(n * (n - 1)) ** 2 != n * (n - 1))


def check_formats(document, checks):
    title = document.find(r"`(n = -?[0-9]+, cos_code = -?[0-9]+)` at `(\w+)` in the three formats")
    n, code = map(int, re.findall("-?[0-9]+", title[0]))
    profile = oracle.Profile("bps", title[1])
    lines = [formatted(n, code, *oracle.answer(profile, n, code)) for formatted in oracle.FORMATS.values()]
    checks.equal("a vector in the three formats", document.blocks("File formats")[0], lines)
    checks.equal("formats", [row[0] for row in document.table("File formats", "format")[1:]], list(oracle.FORMATS))


PARTS = by_name(check_arithmetic, check_profiles, check_epicentre, check_formats)


if __name__ == "__main__":
    sys.exit(check(PARTS, CONTRACT))
