"""docs/lobes/taylor.md in exact integers."""

from arithmetic import rnd

FACTORS = {1: ("1", "r"), 2: ("r", "r"), 3: ("r2", "r"), 4: ("r2", "r2"), 5: ("r4", "r"), 6: ("r4", "r2"),
           8: ("r4", "r4")}


class Lobe:
    guards = ("a", "E", "S")
    shipped = {"p8": (16, 20, 14), "p12": (16, 24, 18), "p16": (16, 30, 22)}

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.a, self.E, self.S = guards
        self.chain = ["r2", "r4", "r8", "r16"][:max(2, self.a.bit_length() - 2)]
        self.names = ("e", "x", "v", "r", *self.chain, "y")

    def steps(self, n, C):
        F, E, S, a = self.F, self.E, self.S, self.a
        d = 2**F - C
        e = rnd(8 * d * 2**F + 5 * d * d, 2 * F + 3 - E)
        x = n * e
        log_a = a.bit_length() - 1
        v = rnd(a * 2**E - x, E + log_a - S) if x < a * 2**E else 0
        if n in FACTORS:
            r = rnd(C * 2**S, F)
        elif x < a * 2**E:
            r = 2 ** (S - 1) + rnd(v * v, S + 1)
        else:
            r = 0
        powers, before = {"1": 2**S, "r": r}, "r"
        for name in self.chain:
            powers[name] = rnd(powers[before] ** 2, S)
            before = name
        half = f"r{a // 2}"
        left, right = FACTORS.get(n, (half, half))
        return (e, x, v, r, *(powers[name] for name in self.chain), rnd(powers[left] * powers[right], 2 * S - self.O))

    def refusal(self):
        if self.a not in (8, 16, 32):
            return "a is 8, 16 or 32"
        if self.F > 29:
            return "F is 29 at most"
        if not self.O <= self.S <= 30:
            return "S is O .. 30"
        if not max(self.F, self.S) <= self.E <= min(2 * self.F, 50):
            return "E is max(F, S) .. min(2 F, 50)"
        return None

    def inputs(self):
        """Small n at cosines of both ends and between; both sides of the jump."""
        one = 2**self.F
        for n in range(1, 34):
            for C in (0, 1, one // 3, one // 2, one * 3 // 4, one - 3, one - 2, one - 1):
                yield n, C
        for n in range(10, 1024, 7):
            low, high = 0, one
            while low < high:
                middle = (low + high) // 2
                if n * (8 * middle * one + 5 * middle * middle) < 8 * self.a * one * one:
                    low = middle + 1
                else:
                    high = middle
            for d in range(max(0, low - 2), min(one, low + 2)):
                yield n, one - d
