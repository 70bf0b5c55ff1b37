"""docs/lobes/quadratic.md in exact integers."""

from fractions import Fraction

from arithmetic import quantize, rnd


class Lobe:
    guards = ("S", "K")
    shipped = {"p8": (9, 10), "p12": (13, 14), "p16": (17, 18)}
    names = ("scaled", "line", "w", "y")

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.S, self.K = guards
        self.slope = quantize(Fraction("0.786"), self.K)

    def steps(self, n, C):
        scaled = self.slope * n
        line = max(0, 2 ** (self.F + self.K) - scaled * (2**self.F - C))
        w = rnd(line, self.F + self.K - self.S)
        return scaled, line, w, rnd(C * w, self.F + self.S - self.O)

    def refusal(self):
        if not self.O <= self.K <= min(30, 52 - self.F):
            return f"K = {self.K}, legal is O .. 30, and at most 52 - F"
        if not self.O <= self.S <= min(30, self.F + self.K):
            return f"S = {self.S}, legal is O .. 30, and at most F + K"
        return None

    def inputs(self):
        """n = 1, which is never cut; both sides of the cut at each other n."""
        for C in range(0, (1 << self.F) + 1, 1 << max(0, self.F - 18)):
            yield 1, C
        for n in range(2, 1024):
            C = (1 << self.F) - (1 << (self.F + self.K)) // (self.slope * n)  # the first cosine that is not cut
            for near in range(max(0, C - 2), C + 3):
                yield n, near
