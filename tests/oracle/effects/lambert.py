"""docs/effects/lambert.md in exact integers."""

from arithmetic import rnd


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        self.F, self.O = F, O

    def steps(self, nl):
        return {"y": rnd(max(0, nl), self.F - self.O)}

    def inputs(self):
        """Halves, and their neighbours."""
        half = 1 << (self.F - self.O - 1)
        for y in range(0, 1 << self.O, 1 + (1 << self.O) // 1000):
            for near in (-1, 0, 1):
                yield ((2 * y + 1) * half + near,)
