"""docs/effects/tint.md in exact integers."""

from arithmetic import rnd


class Effect:
    outputs = ("r", "g", "b")

    def __init__(self, F, O):
        self.O = O

    def steps(self, s, k_r, k_g, k_b, i_r, i_g, i_b):
        values = {}
        for channel, k, i in (("r", k_r, i_r), ("g", k_g, i_g), ("b", k_b, i_b)):
            values[f"colour_{channel}"] = k * i
            values[channel] = min(2 ** (self.O + 8) - 1, rnd(k * i * s, 2 * self.O))
        return values

    def inputs(self):
        """Halves; results on both sides of saturation."""
        one = 1 << self.O
        for s in range(1, 2000, 2):
            yield s, one, one // 2, one, one // 2, one, one // 2 - 1
        for off in range(-200, 200):
            yield 256 * one - 1, one, one, one - 1, one + off, 2 * one + off, one + 1
