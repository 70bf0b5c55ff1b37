"""docs/effects/cosine.md in exact integers."""

from math import isqrt


class Effect:
    outputs = ("c",)

    def __init__(self, F, O):
        self.F, self.W = F, 16

    def answer(self, x):
        F, W = self.F, self.W
        a, b = ([x[f"{name}_{axis}"] for axis in "xyz"] for name in "ab")
        p, aa, bb = (sum(u * v for u, v in zip(*pair)) for pair in ((a, b), (a, a), (b, b)))
        s = aa * bb
        if s == 0:
            return dict(p=p, aa=aa, bb=bb, j=0, r=0, c=0, clamped=1)
        j = (4 * W - s.bit_length()) // 4
        r = isqrt(s * 16**j * 2 ** (2 * F + 4) // 2 ** (4 * W))
        c = (p * 4**j * 2 ** (2 * F + 3) // 2 ** (2 * W) + r) // (2 * r + 1)
        return dict(p=p, aa=aa, bb=bb, j=j, r=r, c=c, clamped=0)

    def inputs(self):
        """Parallel, opposite and perpendicular vectors of all lengths, and their neighbours; one component; the highlight."""
        for length in (*range(1, 200), *(2**k + off for k in range(8, 15) for off in (-1, 0, 1)), 32767):
            for other in (1, 3, length, 32767):
                for off in (-1, 0, 1):
                    yield length, 0, 0, other, off, 0
                    yield 0, -length, 0, 0, other, off
                    yield length, length, -length, other, other, max(-32768, off - other)
                    yield length, -1, 0, 1, max(-32768, min(32767, length + off)), 0
        for k in range(2000):
            yield 20000, 10000, 20000, 20000 + k % 23, 10000 - k // 23, 20001
