"""docs/effects/oren_nayar.md in exact integers."""

from arithmetic import rnd


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        self.F, self.O, self.S = F, O, O + 2

    def steps(self, nl, nv, lv, a, b):
        F, O, S = self.F, self.O, self.S
        if nl <= 0 or nv <= 0:
            return dict(q=0, ratio=0, p=0, y=0)
        q = max(0, rnd(lv * 2**F - nl * nv, 2 * F - S))
        ratio = 2**S if nl >= nv else nl * 2**S // nv
        p = rnd(q * ratio, S)
        return dict(q=q, ratio=ratio, p=p, y=rnd(a * nl + b * p * 2 ** (F - S), S + F - O))

    def inputs(self):
        """Lambert's; q on both sides of 0 and of its halves; ratios on both sides of 1; grazing light and viewer."""
        one, F, S = 1 << self.F, self.F, self.S
        A, B = (1 << S) * 7 // 8, (1 << S) // 4
        for nl in range(-2, one + 2, max(1, one // 5000)):
            yield nl, one // 3, one // 5, 1 << S, 0
        for nl, nv in ((one // 3, one // 2), (one, one), (one // 2, one // 7), (1, 1), (one - 1, one)):
            near = nl * nv >> F
            for off in range(-200, 200):
                yield nl, nv, min(one, near + off), A, B
                yield nl, nv, min(one, near + (off << F - S - 1)), A, 2 * B
        for nv in range(1, 2000):
            for off in (-1, 0, 1):
                yield nv + off, nv, one // 2, A, B
                yield one - nv + off, one - nv, one, A, 2 * B
