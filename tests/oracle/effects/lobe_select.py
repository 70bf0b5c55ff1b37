"""docs/effects/lobe_select.md in exact integers: the lobes' oracles, by number."""

import oracle

LOBES = ("bps", "schlick", "cubic", "cayley", "cosine_power", "quadratic", "polynomial", "taylor", "blinn_phong",
         "spherical_gaussian", "gauss", "decay")


class Effect:
    outputs = ("y",)

    def __init__(self, F, O):
        (profile,) = (name for name, widths in oracle.SHIPPED.items() if widths == (F, O))
        self.profiles = [oracle.Profile(lobe, profile) for lobe in LOBES]

    def answer(self, ports):
        number = min(ports["select"], len(LOBES) - 1)
        y, clamped = oracle.answer(self.profiles[number], ports["n"], ports["cosine"])
        return {"y": y, "clamped": int(clamped or number != ports["select"])}

    def inputs(self):
        """Of each lobe a few of its own."""
        for number, profile in enumerate(self.profiles):
            for k, (n, C) in enumerate(profile.lobe.inputs()):
                if k % 64 == 0:
                    yield number, n, C
