"""docs/lobes/schlick.md in exact integers."""

from arithmetic import rnd


class Lobe:
    guards = ()
    shipped = {"p8": (), "p12": (), "p16": ()}
    names = ("D", "quotient", "y")

    def __init__(self, F, guards, O):
        self.F, self.O = F, O

    def steps(self, n, C):
        D = n * 2**self.F - (n - 1) * C
        quotient = C * 2 ** (self.O + 1) // D
        return D, quotient, rnd(quotient, 1)

    def refusal(self):
        return None

    def inputs(self):
        """Halves: quotients that are odd round up."""
        for C in range(0, (1 << self.F) + 1, 1 << max(0, self.F - self.O - 1)):
            yield 1, C
