"""docs/effects/pixel.md in exact integers: dot products, then shade's oracle."""

from math import isqrt

import check_effects
from effects import cosine
from oracle import SHIPPED

W = 16
DOTS = ("nl", "nv", "lv", "rv", "nh", "vh", "ht", "hb")


class Effect:
    outputs = ("r", "g", "b")
    corners = 4000  # shade has its own

    def __init__(self, F, O):
        (profile,) = (name for name, widths in SHIPPED.items() if widths == (F, O))
        self.F, self.O = F, O
        self.shade = check_effects.Subject("shade", profile)
        self.angle = cosine.Effect(F, O)
        self.angle.W = W + 1

    def dots(self, ports):
        F = self.F
        light, view, normal, tangent, bitangent = (
            [ports[f"{name}_{axis}"] for axis in "xyz"] for name in ("light", "view", "normal", "tangent", "bitangent"))
        half = [a + b for a, b in zip(light, view)]

        def cut(x):
            return min(2**F, max(-(2**F), x))

        def dot(a, b):
            return sum(x * y for x, y in zip(a, b))

        def plain(a, b):
            return cut((2 * dot(a, b) + 2 ** (2 * W - 2 - F)) // 2 ** (2 * W - 1 - F))

        def angle(a):
            return self.angle.answer({f"{name}_{axis}": x for name, v in (("a", a), ("b", half)) for axis, x in zip("xyz", v)})["c"]

        nl, nv, lv = plain(normal, light), plain(normal, view), plain(light, view)
        rv = cut((2 * nl * nv + 2 ** (F - 1)) // 2**F - lv)
        vh = min(2**F, (isqrt(dot(half, half) * 2 ** (2 * F + 2 - 2 * W)) + 1) // 2)
        return dict(zip(DOTS, (nl, nv, lv, rv, angle(normal), vh, angle(tangent), angle(bitangent))))

    def answer(self, ports):
        dots = self.dots(ports)
        values = self.shade.answer([dots[name] if name in dots else ports[name] for name in self.shade.ports])
        return {**values, **dots, **{c: min(2**self.O, values[c]) for c in "rgb"}}

    def inputs(self):
        """Nothing beyond the corners and the random ones."""
        return ()
