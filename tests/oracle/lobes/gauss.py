"""docs/lobes/gauss.md in exact integers."""

from decimal import Decimal
from math import acos, log

from arithmetic import rnd
from exp_log import Exp2, Pieces, arctangent, edges, in_range


def half_square_angle(d):
    """theta^2 / (2 ln 2) with cos(theta) = 1 - d: tan(theta / 2)^2 = d / (2 - d)."""
    theta = 2 * arctangent((d / (2 - d)).sqrt())
    return theta * theta / (2 * Decimal(2).ln())


class Lobe:
    guards = ("T", "L", "E", "S")
    shipped = {"p8": (4, 21, 2, 12), "p12": (5, 25, 3, 16), "p16": (6, 29, 4, 20)}
    names = ("v", "t", "p", "y")

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.T, self.L, self.E, self.S = guards
        self.exp2 = Exp2(self.E, self.S, O)
        self.pieces = None

    def steps(self, n, C):
        self.pieces = self.pieces or Pieces(half_square_angle, self.T, self.F - self.T, self.L)
        d = 2**self.F - C
        index = min(d >> self.pieces.R, 2**self.T - 1)
        v = self.pieces.value(index, d - (index << self.pieces.R))
        t = rnd(n * v, self.L - self.S)
        return v, t, *self.exp2(t)

    def refusal(self):
        F, T, L = self.F, self.T, self.L
        return in_range(T=(T, 4, min(10, F - 1)), L=(L, max(F + 1, 2 * T + 1), 38)) or self.exp2.refusal() or in_range(
            S=(self.S, self.O + 1, self.L - 1))

    def inputs(self):
        """Also both sides of each join of two pieces."""
        yield from edges(self.F, lambda c, n: n * acos(c) ** 2 / (2 * log(2)))
        for join in range(0, 2**self.F, 2 ** (self.F - self.T)):
            for n in (1, 2, 7):
                for C in range(max(0, join - 1), join + 2):
                    yield n, C
