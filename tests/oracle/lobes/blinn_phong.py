"""docs/lobes/blinn_phong.md in exact integers."""

from math import inf, log2

from arithmetic import rnd
from exp_log import Exp2, Log2, edges, in_range


class Lobe:
    guards = ("T", "L", "E", "S")
    shipped = {"p8": (4, 21, 2, 12), "p12": (5, 25, 3, 16), "p16": (6, 29, 4, 20)}
    names = ("z", "l", "u", "t", "p", "y")

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.T, self.L, self.E, self.S = guards
        self.log2, self.exp2 = Log2(F, self.T, self.L), Exp2(self.E, self.S, O)

    def steps(self, n, C):
        z, l, u = self.log2(C)
        t = rnd(n * u, self.L - self.S)
        return z, l, u, t, *self.exp2(t)

    def refusal(self):
        return self.log2.refusal() or self.exp2.refusal() or in_range(S=(self.S, self.O + 1, self.L - 1))

    def inputs(self):
        yield from edges(self.F, lambda c, n: -n * log2(c) if c > 0 else inf)
