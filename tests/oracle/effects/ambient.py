"""docs/effects/ambient.md in exact integers."""

from arithmetic import rnd


class Effect:
    outputs = ("r", "g", "b")

    def __init__(self, F, O):
        self.O = O

    def steps(self, k_r, k_g, k_b, i_r, i_g, i_b):
        return {"r": rnd(k_r * i_r, self.O), "g": rnd(k_g * i_g, self.O), "b": rnd(k_b * i_b, self.O)}

    def inputs(self):
        """Products that are halves, one more and one less in the other channels."""
        half = 1 << (self.O - 1)
        for i in range(1, 2000, 2):
            yield half, half + 1, half - 1, i, i, i
