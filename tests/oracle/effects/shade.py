"""docs/effects/shade.md in exact integers: the other effects' oracles, put together."""

import check_effects
from oracle import SHIPPED

TERMS = {"lambert": "diffuse", "phong": "specular", "blinn_phong": "specular", "oren_nayar": "diffuse", "ward": "specular",
         "cook_torrance": "specular", "cook_torrance_modified": "specular"}
SHARED = {"nl", "nv", "nh", "rv", "lv", "ht", "hb", "vh", "n"}


class Effect:
    outputs = ("r", "g", "b")

    def __init__(self, F, O):
        (profile,) = (name for name, widths in SHIPPED.items() if widths == (F, O))
        self.F, self.O = F, O
        self.parts = {name: check_effects.Subject(name, profile) for name in (*TERMS, "ambient", "tint")}

    def answer(self, ports):
        most = 2 ** (self.O + 8) - 1

        def colours(k, i):
            return [ports[f"{name}_{c}"] for name in (k, i) for c in "rgb"]

        asked = [bit for bit in range(1 + len(TERMS)) if ports["effects"] >> bit & 1]
        sums, clamped, values = {"diffuse": 0, "specular": 0}, 0, {}
        for bit, (name, kind) in enumerate(TERMS.items(), 1):
            values[name] = 0
            if bit in asked:
                part = self.parts[name]
                own = [ports[port if port in SHARED else f"{name}_{port}"] for port in part.ports]
                answer = part.answer(own)
                values[name] = answer["y"]
                sums[kind] = min(most, sums[kind] + answer["y"])
                clamped |= answer["clamped"]
        total = dict.fromkeys("rgb", 0)
        if 0 in asked:
            answer = self.parts["ambient"].answer(colours("ka", "ia"))
            total = {c: answer[c] for c in "rgb"}
            clamped |= answer["clamped"]
        values.update({f"ambient_{c}": total[c] for c in "rgb"})
        for kind, k in (("diffuse", "kd"), ("specular", "ks")):
            answer = self.parts["tint"].answer([sums[kind], *colours(k, "i")])
            for c in "rgb":
                values[f"{kind}_{c}"] = answer[c]
                total[c] += answer[c]
            if any(bit in asked for bit, own in enumerate(TERMS.values(), 1) if own == kind):
                clamped |= answer["clamped"]
        return {**values, **sums, **{c: min(most, total[c]) for c in "rgb"}, "clamped": clamped}

    def inputs(self):
        """Nothing beyond the corners and the random ones."""
        return ()
