#!/usr/bin/env python3
"""The reciprocal in glint_divider_reciprocal, for every number of quotient bits a round and every entry of its table.

For a divisor 1 <= D < 2, a reciprocal r and an x of K + 2 bits that stands for X' < 2^K D with one fraction bit, the
quotient X' / D is never below x r and less than 2 above it: so the estimate floor(x r) is 0, 1 or 2 too small. In exact
integers: r is the same for all D of an interval, D r is at most 1 even at its upper end, and X' / D - x r is below
2^K (1 - D r) + r / 2, which is largest at the lower end.
"""

import re
from pathlib import Path

import icarus
from icarus import Failed

SOURCE = Path(__file__).resolve().parents[2] / "rtl/blocks/glint_divider_reciprocal.v"


def widths(K):
    """T, W, V, G, U, DROP by the expressions of the Verilog."""
    names = {"K": K}
    for name, text in re.findall(r"^    localparam (T|W|V|G|U|DROP) += (.*?);", SOURCE.read_text(), re.MULTILINE):
        text = re.sub(r"(.*) \? (.*) : (.*)", r"(\2) if \1 else (\3)", text).replace("/", "//")
        names[name] = eval(text, {}, names)
    return [names[name] for name in ("T", "W", "V", "G", "U", "DROP")]


def largest_gap(K):
    """The largest bound of X' / D - x r, in units of 2^-(G + T + W + 1), that unit, and how many reciprocals there are."""
    T, W, V, G, U, DROP = widths(K)
    worst = count = 0
    for address in range(1 << T):
        middle = (1 << (T + 1)) + 2 * address + 1
        square = middle * middle
        slope = ((1 << (V + 2 * T + 2)) + square - 1) // square
        offset = ((middle + 1) << (U + T + 1)) // square - ((slope + (1 << DROP) - 1) >> DROP) - 1
        for part in range(1 << W):
            r = (offset - (slope * part >> DROP)) >> (U - G)
            low = (1 << (T + W)) + (address << W) + part  # the lower end of D, in units of 2^-(T + W)
            if not 0 <= r < 1 << G or r * (low + 1) > 1 << (G + T + W):
                raise Failed(f"K {K}, address {address}, part {part}: reciprocal {r} is too large")
            worst = max(worst, (((1 << (G + T + W)) - r * low) << (K + 1)) + (r << (T + W)))
            count += 1
    return worst, 1 << (G + T + W + 1), count


def main():
    total = 0
    for K in range(2, 17):
        worst, unit, count = largest_gap(K)
        print(f"K {K}: {count} reciprocals, estimate less than {worst / unit:.4f} below the quotient")
        if worst >= 2 * unit:
            raise Failed(f"K {K}: 2 or more")
        total += count
    return 0 if total > 0 else 1


if __name__ == "__main__":
    icarus.main(main)
