"""docs/lobes/decay.md in exact integers; the tables from Python's decimals at 70 digits."""

from decimal import Decimal, localcontext
from math import floor

from exp_log import DIGITS, constant, edges, in_range, log2


class Lobe:
    guards = ("A", "M", "V", "H", "G", "W", "n")
    shipped = {"p8": (4, 8, 8, 4, 2, 4, 1), "p12": (4, 12, 12, 4, 2, 4, 1), "p16": (6, 16, 16, 6, 2, 5, 1)}
    names = ("octave", "m", "w", "x", "fall", "y")

    def __init__(self, F, guards, O):
        self.F, self.O = F, O
        self.A, self.M, self.V, self.H, self.G, self.W, self.direct = guards
        self.E = (F - 1).bit_length()
        self.logarithm = None

    def tables(self):
        A, V, E, H, bits = self.A, self.V, self.E, self.H, self.O + self.G
        with localcontext() as context:
            context.prec = DIGITS + 10
            # base, by octave and piece: from the octave of the least distance on
            self.logarithm = {}
            first = max(0, 2**E - 1 - self.F)
            for octave in range(first, 2**E):
                e = 2**E - 1 - octave
                for i in range(2**A):
                    d = Decimal(2**A + i) / 2 ** (A + 1 + e)
                    self.logarithm[octave, i] = constant(log2(-(1 - d).ln()) + e + 1, V) + 1
            self.slopes = {}
            for octave in range(first, 2**E):
                for i in range(2**A):
                    base = self.logarithm[octave, i]
                    if i + 1 < 2**A:
                        rise = self.logarithm[octave, i + 1] - base
                    elif octave + 1 < 2**E:
                        rise = self.logarithm[octave + 1, 0] + 2**V - base
                    else:
                        rise = self.slopes[octave, i - 1]
                    self.slopes[octave, i] = min(rise, 2 ** (V - min(A, 4) + 2) - 1)
            most = 2**bits - 1
            self.ends = []
            for j in range(2 ** (self.W + H)):
                t = Decimal(2) ** (4 - 2**self.W + Decimal(j) / 2**H)
                self.ends.append(min(constant(1 - (-t).exp(), bits), most))
            self.ends.append(most)
            self.lambdas = [0] * 1024
            for n in range(1, 1024):
                k = n.bit_length() - 1
                self.lambdas[n] = floor((log2(Decimal(n)) - k) * 2**V) if n != 1 << k else 0

    def steps(self, n, C):
        if self.logarithm is None:
            self.tables()
        F, V, E, M, A = self.F, self.V, self.E, self.M, self.A
        if C == 2**F:
            return 0, 0, 0, 0, 0, 2**self.O
        distance = 2**F - 1 - C
        e = min(F - distance.bit_length(), 2**E - 1)
        moved = (distance + 1) * 2**e - 1
        octave = 2**E - 1 - e
        m = (moved - 2 ** (F - 1)) // 2 ** (F - 1 - M) if moved >= 2 ** (F - 1) else 0
        i, r = divmod(m, 2 ** (M - A))
        w = self.logarithm[octave, i] + self.slopes[octave, i] * r // 2 ** (M - A)
        k = n.bit_length() - 1
        x = w + self.lambdas[n] + (octave + k + 6) * 2**V
        j = x // 2 ** (V - self.H) - (2**E + 10 - 2**self.W) * 2**self.H
        q = x % 2 ** (V - self.H)
        if j < 0:
            fall = 0
        elif j >= 2 ** (self.W + self.H):
            fall = self.ends[-1]
        else:
            fall = self.ends[j] + (self.ends[j + 1] - self.ends[j]) * q // 2 ** (V - self.H)
        if C == 0:
            y = 0
        elif n == 1:
            y = C // 2 ** (F - self.O)
        else:
            y = 2**self.O - 1 - fall // 2**self.G
        return octave, m, w, x, fall, y

    def refusal(self):
        return (
            in_range(F=(self.F, 9, 30))
            or in_range(O=(self.O, 4, min(28, self.F)), A=(self.A, 1, 7))
            or in_range(M=(self.M, self.A + 1, self.F - 1), G=(self.G, 0, 4))
            or in_range(
                H=(self.H, 1, min(8, self.O + self.G - 3)),
                V=(self.V, max(self.A, self.H) + 1, 24),
                W=(self.W, 3, self.E),
                n=(self.direct, 0, 1),
            )
        )

    def inputs(self):
        """Around each halving of the result, powers of two, codes next to 1; also the joins of pieces."""
        yield from edges(self.F, lambda c, n: -n * float(log2(Decimal(c))) if c > 0 else float("inf"))
        for octave in range(self.F):
            for i in range(2**self.A):
                d = (2**self.A + i) * 2**self.F // 2 ** (self.A + 1 + octave)
                for n in (2, 3, 77, 1000):
                    for C in (2**self.F - d - 1, 2**self.F - d, min(2**self.F, 2**self.F - d + 1)):
                        yield n, C
