"""docs/lobes/polynomial.md in exact integers."""

from fractions import Fraction

from arithmetic import quantize, rnd


class Lobe:
    guards = ("S", "K")
    shipped = {"p8": (11, 11), "p12": (15, 15), "p16": (19, 19)}
    names = ("D", "quotient", "h1", "h2", "r", "y")
    coefficients = [Fraction(x) for x in ("0", "-0.3444", "2.8786", "-1.5342")]

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.S, self.K = guards
        self.k = [quantize(x, self.K) for x in self.coefficients]

    def steps(self, n, C):
        one = 2**self.F
        numerator = one + C
        D = numerator + 2 * n * (one - C)
        quotient = numerator * 2**self.S // D
        h1 = self.k[2] + rnd(self.k[3] * quotient, self.S)
        h2 = self.k[1] + rnd(h1 * quotient, self.S)
        r = rnd(h2 * quotient + self.k[0] * 2**self.S, self.S + self.K - self.O)
        return D, quotient, h1, h2, r, min(2**self.O, max(0, r))

    def refusal(self):
        for name, value in (("S", self.S), ("K", self.K)):
            if not self.O <= value <= 30:
                return f"{name} = {value}, legal is {self.O} .. 30"
        return None

    def inputs(self):
        """Quotients near the polynomial's zero and minimum, at t = 0.1284 and 0.0630, for every n that reaches them."""
        for n in range(4, 1024):
            for t in (Fraction("0.1284"), Fraction("0.0630"), Fraction(1, 2)):
                c = (2 * n * t + t - 1) / (2 * n * t - t + 1)
                if c >= 0:
                    C = int(c * 2**self.F)
                    for near in range(C, min(C + 3, 2**self.F) + 1):
                        yield n, near
        for C in range(0, 2**self.F + 1, 1 << max(0, self.F - 17)):
            yield 1, C
