"""docs/effects/cook_torrance.md in exact integers."""

from math import isqrt

from arithmetic import rnd
from exp_log import Exp2, Log2


class Attenuation:
    """Its section "Attenuation"."""

    def __init__(self, F, O):
        self.L = O + 9
        self.log2 = Log2(F, (O + 3) // 4 + 2, self.L, max(0, F + 1 - self.L))
        assert self.log2.refusal() is None

    def steps(self, nl, nv, nh, vh):
        ul, uv, uh, uc = (self.log2(x)[2] for x in (nl, nv, nh, vh))
        loss = 0 if vh == 0 else max(0, uh + max(ul, uv) - uc - 2**self.L)
        return dict(ul=ul, uv=uv, uh=uh, uc=uc, loss=loss, gain=uv - loss)


class ScaledPower:
    """Its section "Scaled power"."""

    def __init__(self, K, O):
        self.K, self.O, self.S = K, O, O + 4
        self.exp2 = Exp2((O + 3) // 4, self.S, O)
        assert self.exp2.refusal() is None

    def steps(self, z, factor):
        p = self.exp2(z % 2**self.S)[0]
        shift = self.S + self.K - self.O + z // 2**self.S
        y = rnd(p * factor, shift) if shift >= 0 else p * factor << -shift
        return dict(p=p, y=min(2 ** (self.O + 8) - 1, y))


def dots(F):
    """Powers of two and their neighbours for N.L and N.V; N.H near 1; V.H at 0 and near where it shadows."""
    one = 1 << F
    for i in range(F + 1):
        for j in range(F + 1):
            for nh in (1, 2, one // 2, one - 37, one - 1, one):
                for vh in (0, 1, one >> i, (one >> j) + 1, one):
                    yield one >> i, min(one, (one >> j) + 1), nh, vh


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        self.F, self.O, self.S, self.L, self.R, self.W = F, O, O + 4, O + 9, O + 10, O + 14
        self.attenuation = Attenuation(F, O)
        self.log2 = Log2(self.R + 3, (O + 3) // 4 + 2, self.L, self.R + 4 - self.L)
        self.power = ScaledPower(self.S, O)
        assert self.log2.refusal() is None

    def steps(self, nl, nv, nh, vh, falloff, level, excess):
        F, O, S, L, R, W = self.F, self.O, self.S, self.L, self.R, self.W
        names = ("ul uv uh uc loss gain s e t root q uq across square ratio factor z p y").split()
        x = dict.fromkeys(names, 0)
        if nl <= 0 or nv <= 0 or nh <= 0 or excess == 0:
            return x
        c = max(0, vh)
        x |= self.attenuation.steps(nl, nv, nh, c)
        x["s"] = (2 ** (2 * F) - nh * nh) // 2 ** (2 * F - W)
        x["e"] = 2**W - x["s"]
        dividend = falloff * x["s"] * 2 ** (S - O)
        beyond = dividend >= x["e"] * 2 ** (S + 7)
        x["t"] = 2 ** (S + 7) if beyond else dividend // x["e"]
        x["root"] = isqrt(excess * 2 ** (2 * R - 12) + c * c * 2 ** (2 * R - 2 * F))
        x["q"] = x["root"] + c * 2 ** (R - F)
        x["uq"] = self.log2(x["q"])[2]
        x["across"] = rnd(c * x["root"], F + R - S)
        x["square"] = rnd(c * c, 2 * F - S)
        x["ratio"] = abs(x["across"] + x["square"] - 2**S) * 2**S // (x["across"] - x["square"] + 2**S)
        x["factor"] = 2**S + rnd(x["ratio"] ** 2, S)
        x["z"] = 12 * 2**S - level - rnd(x["gain"] + 4 * (x["uh"] + x["uq"]), L - S) + x["t"]
        return x if beyond else x | self.power.steps(x["z"], x["factor"])

    def inputs(self):
        """Where logarithms, t, q and the saturation change, for a sharp, a middle and a rough material."""
        O, S, one = self.O, self.S, 1 << self.F
        for falloff, level, excess in ((577 << O, 5 << S, 15 << 12), (36 << O, 1 << S, 5120), (3 << O >> 1, -1 << S, 1)):
            for vectors in dots(self.F):
                yield *vectors, falloff, level, excess
            for off in range(-40, 40):
                yield one, one, one, one, falloff, min(16 << S, (14 << S) + (off << S - 5)), excess
                yield one, one, (one >> 3) + off, one, falloff, level, excess
                yield one, one, one, (one >> 1) + off, falloff, level, max(0, 40 + off)
