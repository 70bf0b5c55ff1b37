"""docs/exp-log.md in exact integers; the tables from Python's decimals at 60 digits."""

from decimal import Decimal, localcontext
from fractions import Fraction

from arithmetic import quantize, rnd

DIGITS = 60


def in_range(**limits):
    """The reason why a word length is not legal: of name=(value, low, high)."""
    for name, (value, low, high) in limits.items():
        if not low <= value <= high:
            return f"{name} = {value}, legal is {low} .. {high}"
    return None


def log2(x):
    return x.ln() / Decimal(2).ln()


def arctangent(x):
    """Of 0 <= x <= 1: half the angle four times, then the series."""
    for _ in range(4):
        x = x / (1 + (1 + x * x).sqrt())
    total, power, k = Decimal(0), x, 1
    while abs(power) > Decimal(10) ** -(DIGITS + 5):
        total += power / k
        power *= -x * x
        k += 2
    return 16 * total


def constant(x, bits):
    """A Decimal as a code; an approximation so near to a half that it decides nothing is a failure."""
    code = quantize(Fraction(x), bits)
    for slack in (Fraction(1, 2**100), -Fraction(1, 2**100)):
        assert quantize(Fraction(x) + slack, bits) == code
    return code


class Pieces:
    def __init__(self, g, T, R, bits, G=0):
        self.R, self.G, self.entries = R, G, []
        with localcontext() as context:
            context.prec = DIGITS + 10
            at = [g(Decimal(x) / 2 ** (T + 1)) for x in range(2 ** (T + 1) + 1)]
            for x in range(0, 2 ** (T + 1), 2):
                begin, middle, end = at[x : x + 3]
                c0 = constant(begin, bits)
                c2 = constant(2 * begin - 4 * middle + 2 * end, bits + G)
                self.entries.append((c0, (constant(end, bits) - c0 << G) - c2, c2))

    def value(self, index, r):
        c0, c1, c2 = self.entries[index]
        h = c1 + rnd(c2 * r, self.R)
        return c0 + rnd(h * r, self.R + self.G)


class Log2:
    def __init__(self, F, T, L, cut=0):
        self.F, self.T, self.L, self.cut = F, T, L, cut
        self.pieces = None

    def refusal(self):
        F, T, L = self.F - self.cut, self.T, self.L
        return in_range(T=(T, 4, min(10, F - 2)), L=(L, max(F + 1, 2 * T + 1), 38))

    def __call__(self, C):
        """z, l, u."""
        if C == 0:
            return self.F + 1, 0, 31 << self.L
        R = self.F - self.cut - 1 - self.T
        self.pieces = self.pieces or Pieces(lambda x: log2(1 + x), self.T, R, self.L)
        z = self.F + 1 - C.bit_length()
        M = (C << z) - (1 << self.F) >> 1 + self.cut
        l = self.pieces.value(M >> R, M % (1 << R))
        return z, l, (z << self.L) - l


class Exp2:
    def __init__(self, E, S, O):
        self.E, self.S, self.O = E, S, O
        self.pieces = None

    def refusal(self):
        return in_range(E=(self.E, 2, 8), S=(self.S, 2 * self.E + 2, 32))

    def __call__(self, t):
        """p, y."""
        self.pieces = self.pieces or Pieces(lambda x: (-x * Decimal(2).ln()).exp(), self.E, self.S - self.E, self.S, 2)
        i, f = divmod(t, 1 << self.S)
        p = self.pieces.value(f >> self.pieces.R, f % (1 << self.pieces.R))
        cut = self.S - self.O + i
        return p, p << -cut if cut < 0 else rnd(p, cut)


def edges(F, exponent):
    """Inputs at which a lobe 2^-t is easily got wrong, t = exponent(c, n): around each halving of the result, for small
    and large n; every power of two; the codes next to 1."""
    for n in (1, 2, 3, 10, 50, 300, 1000, 1023):
        for halvings in range(32):
            low, high = 0, 1 << F
            while high - low > 1:
                middle = (low + high) // 2
                low, high = (middle, high) if exponent(middle / 2**F, n) > halvings else (low, middle)
            for C in range(max(0, low - 2), min(1 << F, high + 2) + 1):
                yield n, C
    for bit in range(F + 1):
        for n in (1, 2, 5):
            for C in ((1 << bit) - 1, 1 << bit, (1 << bit) + 1):
                yield n, min(C, 1 << F)
    for n in (1, 8, 255, 1023):
        for distance in range(65):
            yield n, (1 << F) - distance
