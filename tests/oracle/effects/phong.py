"""docs/effects/phong.md in exact integers, with the lobe bps."""

from oracle import SHIPPED, Profile


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        (profile,) = (name for name, widths in SHIPPED.items() if widths == (F, O))
        self.F, self.lobe = F, Profile("bps", profile).lobe

    def steps(self, n, cosine, nl):
        C = max(0, cosine)
        values = {"C": C, **dict(zip(self.lobe.names, self.lobe.steps(n, C)))}
        if cosine < 0 or nl <= 0:
            values["y"] = 0
        return values

    def inputs(self):
        """The lobe's own, seen from in front, from the side and from behind."""
        for k, (n, C) in enumerate(self.lobe.inputs()):
            if k % 16 == 0:
                yield n, C, (-1, 0, 1, 1 << self.F)[k // 16 % 4]
