"""docs/lobes/cosine_power.md in exact integers."""

from arithmetic import rnd


class Lobe:
    guards = ("a", "S")
    shipped = {"p8": (8, 12), "p12": (8, 16), "p16": (8, 20)}

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.a, self.S = guards
        exponents = [2**i for i in range(self.a.bit_length()) if 2**i < self.a]
        self.log2_a = len(exponents)
        self.names = ("base", *(f"p{exponent}" for exponent in exponents), "y")

    def steps(self, n, C):
        base = max(0, self.a * 2**self.F - n * (2**self.F - C))
        powers = [rnd(base, self.F + self.log2_a - self.S)]
        while len(powers) < self.log2_a:
            powers.append(rnd(powers[-1] ** 2, self.S))
        return base, *powers, rnd(powers[-1] ** 2, 2 * self.S - self.O)

    def refusal(self):
        if self.a not in (2, 4, 8, 16, 32, 64):
            return f"a = {self.a}, legal is 2, 4, 8, 16, 32, 64"
        if not self.O <= self.S <= min(30, self.F + self.log2_a):
            return f"S = {self.S}, legal is O .. 30, and at most F + log2 a"
        return None

    def inputs(self):
        """Every p1 where there are not too many (n = a has C for its base); both sides of the cut at each n."""
        for C in range(0, (1 << self.F) + 1, 1 << max(0, self.F - min(self.S, 18))):
            yield self.a, C
        for n in range(self.a + 1, 1024):
            C = (1 << self.F) - (self.a << self.F) // n  # the first cosine that is not cut
            for near in range(max(0, C - 2), C + 3):
                yield n, near
