"""docs/effects/cook_torrance_modified.md in exact integers."""

from arithmetic import rnd
from effects.cook_torrance import Attenuation, ScaledPower, dots


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        self.F, self.O, self.S, self.L, self.K = F, O, O + 4, O + 9, O + 5
        self.attenuation = Attenuation(F, O)
        self.power = ScaledPower(self.K, O)

    def steps(self, nl, nv, nh, vh, level, stretch, c0, c1, c2, c3):
        F, S, L, K = self.F, self.S, self.L, self.K
        values = dict.fromkeys("ul uv uh uc loss gain x z h1 h2 h3 factor p y".split(), 0)
        if nl <= 0 or nv <= 0 or nh <= 0:
            return values
        values |= self.attenuation.steps(nl, nv, nh, max(0, vh))
        x = (2**F - nh) * stretch // 2 ** (F + 8 - K)
        z = -level - rnd(values["gain"], L - S)
        values |= dict(x=x, z=z)
        if x >= 2**K:
            return values
        h1 = c2 + rnd(c3 * x, K)
        h2 = c1 + rnd(h1 * x, K)
        h3 = c0 + rnd(h2 * x, K)
        factor = min(2 ** (K + 1), max(0, h3))
        return values | dict(h1=h1, h2=h2, h3=h3, factor=factor) | self.power.steps(z, factor)

    def inputs(self):
        """Where logarithms change; both sides of the cubic's end, of 0 and of 2; the greatest shifts."""
        O, S, K, one = self.O, self.S, self.K, 1 << self.F
        cubic = [round(x * 2**K) for x in (0.99, -3.2, 3.7, -1.5)]
        for vectors in dots(self.F):
            yield *vectors, 1 << S, 5 << 8, *cubic
        for off in range(-40, 40):
            for m in range(1, 60, 7):
                yield one, one, one - one // m + off, one, 0, m << 8, *cubic
                yield one >> m % self.F, one >> m % self.F, one, one, min(16 << S, (m - 30) << S), 1 << 8, off, 0, 0, 0
            yield one, one, one, one, 0, 1 << 8, min((8 << K) - 1, (2 << K) + off), 0, 0, 0
            yield one, one, one // 2, one, 0, 1 << 8, (1 << K) + off, -2 << K, 0, 0
