"""docs/lobes/bps.md in exact integers."""

from fractions import Fraction
from functools import cached_property
from math import floor

from arithmetic import quantize, rnd


def last_equal(f, low, high):
    """The last x in low .. high with f(x) = f(low), for a monotone f."""
    value = f(low)
    while low < high:
        middle = (low + high + 1) // 2
        if f(middle) == value:
            low = middle
        else:
            high = middle - 1
    return low


class Lobe:
    guards = ("S", "K")
    shipped = {"p8": (11, 11), "p12": (15, 15), "p16": (19, 19)}
    published = {
        "a": Fraction("-1.631"),
        "b": Fraction("2.995"),
        "c1": Fraction("-0.374"),
        "d0": Fraction("0.002737"),
    }
    names = ("D", "quotient", "h1", "h2", "r", "y")
    unnamed = ("r",)
    landmarks = (Fraction("0.00780379"), Fraction("0.06599512"), Fraction("0.12633238"))  # zero, minimum, zero

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.S, self.K = guards
        self.constants = {name: quantize(x, self.K) for name, x in self.published.items()}
        a, b, c1, d0 = self.constants.values()
        self.codes = 1 << F, self.S, self.S + self.K - O, a, b, c1, d0 << self.S

    def steps(self, n, C):
        one, S, last, a, b, c1, d0 = self.codes
        D = n * one - (n - 1) * C
        quotient = (C << S) // D
        h1 = b + rnd(a * quotient, S)
        h2 = c1 + rnd(h1 * quotient, S)
        r = rnd(h2 * quotient + d0, last)
        return D, quotient, h1, h2, r, max(0, r)

    @cached_property
    def of_quotient(self):
        """The same lobe at F = S, where n = 1 has C for its quotient: `steps(1, q)` is all that follows from q."""
        return Lobe(self.S, (self.S, self.K), self.O)

    def real(self, n, C):
        """max(0, f_bps) as numerator and denominator; s = C / D exactly."""
        a, b, c1, d0 = (int(x * 10**6) for x in self.published.values())
        D = (n << self.F) - (n - 1) * C
        return max(0, ((a * C + b * D) * C + c1 * D * D) * C + d0 * D**3), 10**6 * D**3

    def greatest_y(self):
        """The greatest y over every quotient in 0 .. 2^S. h1 is constant on stretches of quotients, within each h2 is,
        and within each of those h2 * quotient is greatest at an end: a few thousand stretches whatever S is."""
        unity, greatest, start = 1 << self.S, 0, 0
        f = self.of_quotient.steps
        while start <= unity:
            end = last_equal(lambda q: f(1, q)[2], start, unity)
            while start <= end:
                stop = last_equal(lambda q: f(1, q)[3], start, end)
                greatest = max(greatest, f(1, start)[5], f(1, stop)[5])
                start = stop + 1
        return greatest

    def refusal(self):
        """Rules 2 and 4. Rule 3 follows from 1 and 2 for the published constants (check_bps.py proves it)."""
        for name, value in (("S", self.S), ("K", self.K)):
            if not self.O <= value <= 30:
                return f"{name} = {value}, legal is {self.O} .. 30"
        # Each of four constants and two roundings is off by at most 2^-K / 2, so this bounds the sum before the last
        # rounding, and no y above 2^O can come from below 1 + 2^-(O+1).
        if sum(self.published.values()) + Fraction(3, 2**self.K) >= 1 + Fraction(1, 2 ** (self.O + 1)):
            greatest = self.greatest_y()
            if greatest > 1 << self.O:
                return f"y reaches {greatest}, above 2^O = {1 << self.O}"
        return None

    def inputs(self):
        """Each quotient once (at n = 1 it is floor(C / 2^(F-S))), or 2^19 of them; and both sides of each landmark."""
        for C in range(0, (1 << self.F) + 1, 1 << max(0, self.F - min(self.S, 19))):
            yield 1, C
        for n in (1, 2, 3, 8, 50, 512, 1000, 1022, 1023):
            for s in self.landmarks:
                C = floor(s * n / (1 + (n - 1) * s) * 2**self.F)
                for near in range(-3, 5):
                    yield n, min(max(0, C + near), 1 << self.F)
