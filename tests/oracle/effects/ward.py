"""docs/effects/ward.md in exact integers."""

from math import isqrt

from arithmetic import rnd
from exp_log import Exp2, Log2


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        self.F, self.O, self.H, self.L, self.S = F, O, O + 3, F + 1, O + 4
        self.log2 = Log2(F, max(4, O // 4 + 1), self.L)
        self.exp2 = Exp2(max(2, O // 4), self.S, O + 8)
        assert self.log2.refusal() is None and self.exp2.refusal() is None

    def steps(self, nl, nv, nh, ht, hb, kx, ky, log_peak):
        F, O, H, L, S = self.F, self.O, self.H, self.L, self.S
        if nl <= 0 or nv <= 0 or nh < 0:
            return dict(hx=0, hy=0, r2=0, t=0, ul=0, uv=0, e=0, y=0)
        hx = min(2 ** (H + 4) - 1, rnd(abs(ht) * kx, F + O - H))
        hy = min(2 ** (H + 4) - 1, rnd(abs(hb) * ky, F + O - H))
        r2 = min(2 ** (S + 7) - 1, rnd(hx * hx + hy * hy, 2 * H - S))
        t = r2 * 2**F // (2**F + nh)
        ul, uv = self.log2(nl)[2], self.log2(nv)[2]
        e = t + rnd(ul - uv, L + 1 - S) - log_peak + 8 * 2**S
        y = min(2 ** (O + 8) - 1, self.exp2(max(0, e))[1])
        return dict(hx=hx, hy=hy, r2=r2, t=t, ul=ul, uv=uv, e=e, y=y)

    def inputs(self):
        """Both sides of every cut, of 0 and of saturation; results around 1 ulp; powers of two of N.L over N.V."""
        one, O, S = 1 << self.F, self.O, self.S
        k = 17 << O >> 4
        for off in range(-300, 300):
            yield one, one, one, 0, 0, k, k, (8 << S) + min(0, off)
            yield one, one - one // 3 + off, one, 0, 0, k, k, 8 << S
            yield one, one, one, one, 0, (16 << O) + off, 0, 0
            yield one, one, one, one, one, (isqrt(64 << 2 * O)) + off, (isqrt(64 << 2 * O)), 8 << S
            yield one, one, one, one, 0, (isqrt(2 * (O + 1) << 2 * O)) + off, 0, off
            yield one // 2, one // 2, 0, one + min(0, off), one, k, k, 0
        for i in range(self.F + 1):
            for j in range(self.F + 1):
                for log_peak in (-8 << S, 0, 8 << S):
                    yield one >> i, one >> j, one // 2, one // 8, one // 5, k, 3 * k, log_peak
