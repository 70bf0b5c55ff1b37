"""docs/lobes/cayley.md in exact integers."""

from arithmetic import rnd

FACTORS = {1: "r 1", 2: "r r", 3: "r2 r", 4: "r2 r2", 5: "r4 r", 6: "r4 r2"}


class Lobe:
    guards = ("a", "S")
    shipped = {"p8": (0, 13), "p12": (0, 17), "p16": (0, 21)}

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.a, self.S = guards
        chain = ["r2", "r4", "r8", "r16"][:max(2, self.a.bit_length() - 2)]
        self.names = ("m", "x", "num", "den", "r", *chain, "y")

    def steps(self, n, C):
        one, S = 2**self.F, self.S
        if self.a:
            m = n - self.a
            x = m * (one - C)
            num, den = 2 * self.a * C - x, 2 * self.a * one + x
        else:
            m = 0 if n in (1, 2, 3, 4, 5, 6, 8) else n - 8
            x = m * (one - C)
            t = x // 16
            num, den = 16 * C - x + t, 16 * one + x + t + t // 16
        num = max(0, num)
        r = num * 2**S // den
        powers = {"1": 2**S, "r": r}
        for square, root in ("r2", "r"), ("r4", "r2"), ("r8", "r4"), ("r16", "r8"):
            powers[square] = rnd(powers[root]**2, S)
        if self.a:
            half = "r" if self.a == 2 else f"r{self.a // 2}"
            left, right = half, half
        else:
            left, right = FACTORS.get(n, "r4 r4").split()
        y = rnd(powers[left] * powers[right], 2 * S - self.O)
        return (m, x, num, den, r, *(powers[name] for name in self.names[5:-1]), y)

    def refusal(self):
        if self.a not in (0, 2, 4, 8, 16, 32):
            return "a is 0, 2, 4, 8, 16 or 32"
        if not self.O <= self.S <= 30:
            return "S is O .. 30"
        if self.F + self.S > 56:
            return "F + S is 56 at most"
        return None

    def inputs(self):
        """Every power, at cosines of both ends and between; around the place where num turns positive."""
        one = 2**self.F
        for n in range(1, 34):
            for C in (1, one // 3, one // 2, one * 3 // 4, one - 3, one - 2, one - 1):
                yield n, C
        for n in (16, 50, 300, 1023):
            middle = one * (15 * n - 120) // (15 * n + 136)
            for C in range(max(0, middle - 8), min(one, middle + 8)):
                yield n, C
