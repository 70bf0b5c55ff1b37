#!/usr/bin/env python3
"""The coefficients of docs/lobes/polynomial.md, found again: least squares over n = 1 .. 1000 and theta = 0 .. 1.57 rad
in steps of 1 and 0.001 (the data set of f_bps), of polynomials that are 0 at 0 and 1 at 1, against cos(theta)^n.

Prints each fit with the largest error of the cut polynomial. Exit status: 1 unless the cubic in t, rounded to four
decimals, is what the oracle computes with.
"""

import math
import sys

from lobes.polynomial import Lobe

VARIABLES = {
    "schlick": lambda c, n: c / (c + n * (1 - c)),
    "symmetric": lambda c, n: (1 + c) / ((1 + c) + 2 * n * (1 - c)),
}
DEGREES = (3, 4)


def solve(rows):
    """Gauss-Jordan with pivots, on the rows of an augmented matrix."""
    for i in range(len(rows)):
        pivot = max(range(i, len(rows)), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r, row in enumerate(rows):
            if r != i:
                rows[r] = [x - row[i] / rows[i][i] * y for x, y in zip(row, rows[i])]
    return [row[-1] / row[i] for i, row in enumerate(rows)]


def main():
    cosines = [math.cos(0.001 * step) for step in range(1571)]
    found = None
    for name, variable in VARIABLES.items():
        points = [(n, variable(c, n), c**n) for n in range(1, 1001) for c in cosines]
        powers = [0.0] * (2 * max(DEGREES) + 1)  # sums of x^i
        targets = [0.0] * (max(DEGREES) + 1)  # sums of y x^i
        for _, x, y in points:
            power = 1.0
            for i in range(len(powers)):
                powers[i] += power
                if i < len(targets):
                    targets[i] += y * power
                power *= x
        for degree in DEGREES:
            # f = x^degree + sum of k_i (x^i - x^degree), i = 1 .. degree - 1
            inner = range(1, degree)
            rows = [[powers[i + j] - powers[i + degree] - powers[j + degree] + powers[2 * degree] for j in inner]
                    + [targets[i] - targets[degree] - powers[i + degree] + powers[2 * degree]] for i in inner]
            k = solve(rows)
            k = [0.0, *k, 1 - sum(k)]
            worst = {1: 0.0, 8: 0.0, 50: 0.0}
            for n, x, y in points:
                f = 0.0
                for coefficient in reversed(k):
                    f = f * x + coefficient
                error = abs(min(1.0, max(0.0, f)) - y)
                for least in worst:
                    if n >= least and error > worst[least]:
                        worst[least] = error
            print(f"{name} {degree}: {' '.join(f'{x:.6f}' for x in k)}; largest error",
                  ", ".join(f"{error:.5f} for n >= {least}" for least, error in worst.items()))
            if (name, degree) == ("symmetric", 3):
                found = [round(x, 4) for x in k]
    return 0 if found == [float(x) for x in Lobe.coefficients] else 1


if __name__ == "__main__":
    sys.exit(main())
