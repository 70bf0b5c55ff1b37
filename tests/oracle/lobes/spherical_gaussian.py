"""docs/lobes/spherical_gaussian.md in exact integers."""

from decimal import Decimal, localcontext
from math import e, log2

from arithmetic import rnd
from exp_log import DIGITS, Exp2, constant, edges, in_range


class Lobe:
    guards = ("K", "E", "S")
    shipped = {"p8": (9, 2, 12), "p12": (13, 3, 16), "p16": (17, 4, 20)}
    names = ("g", "t", "p", "y")

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.K, self.E, self.S = guards
        self.exp2 = Exp2(self.E, self.S, O)
        with localcontext() as context:
            context.prec = DIGITS
            self.a = constant(1 / Decimal(2).ln(), self.K)
            self.b = constant(Decimal("0.775") / Decimal(2).ln(), self.K)

    def steps(self, n, C):
        g = n * self.a + self.b
        t = rnd(g * (2**self.F - C), self.K + self.F - self.S)
        return g, t, *self.exp2(t)

    def refusal(self):
        return in_range(K=(self.K, 4, 51 - self.F)) or self.exp2.refusal() or in_range(
            S=(self.S, self.O + 1, self.K + self.F - 1))

    def inputs(self):
        yield from edges(self.F, lambda c, n: (n + 0.775) * (1 - c) * log2(e))
