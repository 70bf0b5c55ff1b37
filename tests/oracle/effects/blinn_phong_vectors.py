"""docs/effects/blinn_phong_vectors.md in exact integers."""

from arithmetic import rnd
from exp_log import Exp2, Log2
from vectors import inputs, products


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        self.W, self.L, self.S = 16, O + 15, O + 4
        T = O // 4 + 4
        self.log2_p, self.log2_s = Log2(self.L, T, self.L, 1), Log2(self.L + 2, T, self.L, 3)
        self.exp2 = Exp2(O // 4, self.S, O)
        assert all(block.refusal() is None for block in (self.log2_p, self.log2_s, self.exp2))

    def answer(self, given):
        W, L, S = self.W, self.L, self.S
        n = given["n"] or 1
        p, aa, bb, s, j = products(given, W)
        if s == 0:
            zeros = dict.fromkeys(("cp", "cs", "up", "us", "w", "t", "y"), 0)
            return dict(p=p, aa=aa, bb=bb, j=j, clamped=1, **zeros)
        cp = max(0, p) * 4**j * 2**L // 2 ** (2 * W)
        cs = s * 16**j * 2 ** (L + 2) // 2 ** (4 * W)
        up, us = self.log2_p(cp)[2], self.log2_s(cs)[2]
        w = max(0, 2 * up - us)
        t = rnd(n * w, L + 1 - S)
        y = self.exp2(t)[1] if p >= 0 else 0
        return dict(p=p, aa=aa, bb=bb, j=j, cp=cp, cs=cs, up=up, us=us, w=w, t=t, y=y, clamped=int(given["n"] == 0))

    def inputs(self):
        return inputs()
