"""docs/effects/bps_vectors.md in exact integers."""

from fractions import Fraction
from math import isqrt

from arithmetic import quantize, rnd
from vectors import inputs, products


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        self.O, self.W, self.R, self.S, self.K = O, 16, O + 14, O + 3, O + 3
        published = (Fraction(x) for x in ("-1.631", "2.995", "-0.374", "0.002737"))
        self.constants = [quantize(x, self.K) for x in published]

    def answer(self, given):
        W, R, S, K, O = self.W, self.R, self.S, self.K, self.O
        n = given["n"] or 1
        p, aa, bb, s, j = products(given, W)
        if s == 0:
            zeros = dict.fromkeys(("r", "x", "C", "D", "quotient", "h1", "h2", "y"), 0)
            return dict(p=p, aa=aa, bb=bb, j=j, clamped=1, **zeros)
        r = isqrt(s * 16**j * 2 ** (2 * R) // 2 ** (4 * W))
        x = max(0, p) * 4**j * 2**R // 2 ** (2 * W)
        C = x // 128
        D = C + n * (r - x) // 128
        quotient = C * 2**S // D
        a, b, c1, d0 = self.constants
        h1 = b + rnd(a * quotient, S)
        h2 = c1 + rnd(h1 * quotient, S)
        y = max(0, rnd(h2 * quotient + d0 * 2**S, S + K - O)) if p >= 0 else 0
        return dict(p=p, aa=aa, bb=bb, j=j, r=r, x=x, C=C, D=D, quotient=quotient, h1=h1, h2=h2, y=y,
                    clamped=int(given["n"] == 0))

    def inputs(self):
        return inputs()
