"""docs/lobes/cubic.md in exact integers; its memory from decimals of 60 digits."""

from decimal import ROUND_HALF_UP, Decimal, localcontext
from functools import lru_cache
from math import ceil

from arithmetic import rnd


@lru_cache(maxsize=None)
def row(n, F, K):
    """cut, g1, g2, g3."""
    with localcontext() as context:
        context.prec = 60
        one, m = Decimal(1), Decimal(n)
        if n <= 3:
            g = (-one, (Decimal(0), one / 4, one / 3)[n - 1], -one / 27 if n == 3 else Decimal(0))
            cut = 2**F + 1
        else:
            # The three conditions as linear equations in g1, g2, g3, by Cramer's rule; t = n (1 - c).
            points = [(m * (1 - (one / 2) ** (1 / m)), one / 2), (m * (1 - (one / 18) ** (1 / m)), one / 18), (m, one * 0)]
            matrix = [[t, t * t, t**3] for t, _ in points]
            right = [y - 1 for _, y in points]
            whole = determinant(matrix)
            g = [determinant([[right[i] if k == j else matrix[i][k] for k in range(3)] for i in range(3)]) / whole
                 for j in range(3)]
            root = (g[1] * g[1] - 3 * g[0] * g[2]).sqrt()
            cut = ceil(min(t for t in ((-g[1] + root) / (3 * g[2]), (-g[1] - root) / (3 * g[2])) if t > 0) / m * 2**F)
        return (cut, *(int((x * 2**K).to_integral_value(ROUND_HALF_UP)) for x in g))


def determinant(m):
    return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))


class Lobe:
    guards = ("S", "K")
    shipped = {"p8": (12, 14), "p12": (16, 18), "p16": (20, 22)}
    names = ("X", "T", "h2", "h1", "y")

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.S, self.K = guards

    def steps(self, n, C):
        F, S, K, O = self.F, self.S, self.K, self.O
        cut, g1, g2, g3 = row(n, F, K)
        X = 2**F - C
        T = 0 if X >= cut else rnd(n * X, F - S)
        h2 = g2 + rnd(g3 * T, S)
        h1 = g1 + rnd(h2 * T, S)
        y = 0 if X >= cut else max(0, rnd(2 ** (K + S) + h1 * T, K + S - O))
        return X, T, h2, h1, y

    def refusal(self):
        if not self.O <= self.S <= self.F:
            return f"S = {self.S}, legal is {self.O} .. {self.F}"
        if not self.O <= self.K <= 30:
            return f"K = {self.K}, legal is {self.O} .. 30"
        return None

    def inputs(self):
        """Both sides of the cut of every n."""
        for n in range(4, 1024):
            cut = row(n, self.F, self.K)[0]
            for X in range(cut - 2, cut + 2):
                yield n, 2**self.F - X
