#!/usr/bin/env python3
"""Writes the shipped scenes: models (.obj, .mtl) and scene files (.json), into the folder of this file or another.

    scenes/make.py [FOLDER]

Shadows are not rendered; what darkens the ground around an object is stored as the colours of the ground's vertices.
"""

import colorsys
import json
import math
import random
import sys
from pathlib import Path

from shapes import apple, bowl, ground, knot, obj, pear, pot, sphere, vase

LOBES = ("bps", "schlick", "quadratic", "cubic", "cosine_power", "gauss", "spherical_gaussian", "cayley", "taylor",
         "polynomial", "blinn_phong")


def scene(about, **parts):
    return json.dumps({"about": about, **parts}, indent=1) + "\n"


# ------------------------------------------------------------------------------------------------------ the still life

STILL_LIGHT = (-3.0, 3.8, 2.9)
STILL_LIFE = [  # file, material, place, turn, scale, spheres that stand for it
    ("vase.obj", "glaze", (-0.72, 0, -0.35), 0, 1.0, [(0, 0.42, 0, 0.42), (0, 0.85, 0, 0.64), (0, 1.6, 0, 0.24)]),
    ("bowl.obj", "brass", (0.62, 0, -0.20), 0, 1.0, [(0, 0.16, 0, 0.24), (0, 0.5, 0, 0.60)]),
    ("apple.obj", "fruit", (0.42, 0.36, -0.28), 40, 0.86, []),
    ("apple.obj", "fruit", (0.94, 0.38, -0.16), 170, 0.78, []),
    ("apple.obj", "fruit", (-0.10, 0, 0.62), 250, 0.86, [(0, 0.35, 0, 0.37)]),
    ("pear.obj", "fruit", (1.44, 0, 0.36), 200, 0.92, [(0, 0.33, 0, 0.37), (0, 0.8, 0, 0.2)]),
    ("sphere.obj", "pearl", (0.62, 0.17, 0.86), 0, 0.17, [(0, 0, 0, 1)]),
    ("sphere.obj", "pearl", (0.98, 0.12, 0.96), 0, 0.12, [(0, 0, 0, 1)]),
    ("sphere.obj", "pearl", (-1.30, 0.15, 0.55), 0, 0.15, [(0, 0, 0, 1)]),
]


def blockers(objects):
    return [(x + scale * bx, y + scale * by, z + scale * bz, scale * r)
            for _, _, (x, y, z), _, scale, spheres in objects for bx, by, bz, r in spheres]


def placed(objects, material=None):
    out = []
    for file, name, place, turn, scale, _ in objects:
        entry = {"file": file, "material": material or name, "translate": place}
        if turn:
            entry["turn"] = turn
        if scale != 1.0:
            entry["scale"] = scale
        out.append(entry)
    return out


def still_life():
    return scene(
        "A still life: a glazed vase, a brass bowl, fruit, pearls, on matte paper.",
        objects=[{"file": "still_life_ground.obj", "material": "paper"}, *placed(STILL_LIFE)],
        materials={
            "paper": {"Ka": [0.44, 0.39, 0.35], "Kd": [0.44, 0.39, 0.35]},
            "glaze": {"Ka": [0.02, 0.10, 0.16], "Kd": [0.02, 0.13, 0.22], "Ks": [0.62, 0.66, 0.70], "Ns": 180},
            "brass": {"Ka": [0.30, 0.19, 0.05], "Kd": [0.34, 0.20, 0.05], "Ks": [1.0, 0.72, 0.30], "Ns": 12},
            "fruit": {"Ka": [0.9, 0.9, 0.9], "Kd": [0.9, 0.9, 0.9], "Ks": [0.22, 0.22, 0.20], "Ns": 40},
            "pearl": {"Ka": [0.05, 0.04, 0.05], "Kd": [0.06, 0.05, 0.06], "Ks": [0.75, 0.72, 0.78], "Ns": 600,
                      "brdf": "phong"},
        },
        lights=[
            {"position": STILL_LIGHT, "colour": [1.0, 0.93, 0.82], "intensity": 15, "attenuation": [1, 0, 0.5]},
            {"position": [3.6, 1.7, 2.0], "colour": [0.50, 0.66, 1.0], "intensity": 2.4, "attenuation": [1, 0, 0.45]},
            {"direction": [-0.55, -0.42, 1.0], "colour": [1.0, 0.84, 0.66], "intensity": 0.55},
        ],
        ambient=[0.13, 0.14, 0.17],
        background=[0.03, 0.03, 0.035],
        camera={"eye": [0.35, 1.75, 5.4], "target": [0.18, 0.84, 0.0], "fov": 30.5},
    )


# ---------------------------------------------------------------------------------------------------------- the others

def sphere_grid():
    exponents = (4, 10, 25, 60, 200, 1000)
    materials, objects = {}, []
    for i, lobe in enumerate(LOBES):
        hue = colorsys.hsv_to_rgb(0.56 + 0.72 * i / len(LOBES), 0.75, 0.42)
        for j, n in enumerate(exponents):
            name = f"{lobe}, n = {n}"
            materials[name] = {"Ka": [round(c, 3) for c in hue], "Kd": [round(c, 3) for c in hue],
                               "Ks": [0.65, 0.65, 0.65], "Ns": n, "lobe": lobe}
            objects.append({"file": "sphere.obj", "material": name, "scale": 0.44,
                            "translate": [i - (len(LOBES) - 1) / 2, (len(exponents) - 1) / 2 - j, 0]})
    return scene(
        "Columns are lobes in the order of the README's figures, from bps to blinn_phong; rows are n = 4, 10, 25, 60, 200, 1000.",
        objects=objects, materials=materials,
        lights=[{"direction": [0.45, -0.55, -1.0], "colour": [1, 0.97, 0.92], "intensity": 0.9}],
        ambient=[0.2, 0.2, 0.22], background={"top": [0.04, 0.045, 0.055], "bottom": [0.015, 0.016, 0.02]},
        camera={"eye": [0, 0, 22], "target": [0, 0, 0], "fov": 16.2})


MATTE_LIGHT = (-3.2, 4.0, 2.9)
MATTE = [
    ("vase.obj", "terracotta", (-0.95, 0, -0.30), 0, 1.0, STILL_LIFE[0][5]),
    ("bowl.obj", "sage", (0.35, 0, -0.45), 0, 1.05, STILL_LIFE[1][5]),
    ("knot.obj", "chalk", (1.42, 0.50, 0.30), 25, 0.72, [(0, 0, 0, 0.62)]),
    ("sphere.obj", "ochre", (-0.10, 0.30, 0.62), 0, 0.30, [(0, 0, 0, 1)]),
    ("sphere.obj", "slate", (0.52, 0.20, 0.86), 0, 0.20, [(0, 0, 0, 1)]),
    ("sphere.obj", "terracotta", (-1.62, 0.24, 0.55), 0, 0.24, [(0, 0, 0, 1)]),
]


def matte():
    colours = {"paper": (0.66, 0.62, 0.58), "terracotta": (0.55, 0.20, 0.11), "sage": (0.28, 0.38, 0.26),
               "chalk": (0.80, 0.78, 0.74), "ochre": (0.66, 0.42, 0.10), "slate": (0.16, 0.20, 0.27)}
    return scene(
        "Clay and paper: no highlights, so no unit of a highlight is needed.",
        objects=[{"file": "matte_ground.obj", "material": "paper"}, *placed(MATTE)],
        materials={name: {"Ka": c, "Kd": c} for name, c in colours.items()},
        lights=[
            {"position": MATTE_LIGHT, "colour": [1.0, 0.95, 0.86], "intensity": 9, "attenuation": [1, 0, 0.35]},
            {"position": [3.6, 2.0, 2.0], "colour": [0.6, 0.74, 1.0], "intensity": 2.2, "attenuation": [1, 0, 0.35]},
        ],
        ambient=[0.16, 0.17, 0.20],
        camera={"eye": [0.2, 1.9, 5.6], "target": [0.05, 0.78, 0.0], "fov": 29})


def bulbs():
    """Where the small lights are: place, and which of the colours."""
    rng = random.Random(7)
    out = []
    while len(out) < 40:
        x, z = rng.uniform(-3.4, 3.4), rng.uniform(-2.6, 2.4)
        if all((x - u) ** 2 + (z - w) ** 2 > 0.42 for (u, _, w), _ in out):
            out.append(((round(x, 3), round(rng.uniform(0.22, 0.75), 3), round(z, 3)), len(out) % 6))
    return out


BULB_COLOURS = [(1.0, 0.42, 0.10), (1.0, 0.72, 0.30), (0.95, 0.22, 0.30), (0.25, 0.55, 1.0), (0.35, 0.95, 0.60),
                (0.75, 0.35, 1.0)]


def bulb_model():
    """The bulbs themselves, as small octahedra cut to spheres, in materials of `illum 0`."""
    vertices, faces, current = [], [], None
    for (x, y, z), colour in sorted(bulbs(), key=lambda b: b[1]):
        if colour != current:
            faces.append(f"usemtl bulb_{colour}")
            current = colour
        first = len(vertices)
        down, across = 6, 10
        for j in range(1, down):
            for i in range(across):
                a, b = 2 * math.pi * i / across, math.pi * j / down
                vertices.append((x + 0.04 * math.sin(b) * math.sin(a), y + 0.04 * math.cos(b),
                                 z + 0.04 * math.sin(b) * math.cos(a)))
        for j in range(down - 2):
            for i in range(across):
                n = (i + 1) % across
                a, b = first + 1 + j * across, first + 1 + (j + 1) * across
                faces.append((a + i, b + i, b + n, a + n))
        faces.append(tuple(range(first + 1, first + 1 + across)))
        faces.append(tuple(range(len(vertices), len(vertices) - across, -1)))
    return obj("bulbs of many_lights.json", vertices, faces, header="mtllib bulbs.mtl")


def bulb_materials():
    out = "# Written by scenes/make.py: shown as they are, whatever the light\n"
    for i, colour in enumerate(BULB_COLOURS):
        out += f"newmtl bulb_{i}\nillum 0\nKd " + " ".join(f"{min(1, 0.12 + c):g}" for c in colour) + "\n"
    return out


def many_lights():
    rng = random.Random(11)
    objects = [{"file": "many_lights_floor.obj", "material": "floor"}, {"file": "bulbs.obj"}]
    placed_spheres = []
    lamps = [p for p, _ in bulbs()]
    while len(placed_spheres) < 26:
        x, z, r = rng.uniform(-3.2, 3.2), rng.uniform(-2.4, 2.2), rng.uniform(0.14, 0.34)
        apart = all((x - u) ** 2 + (z - w) ** 2 > (r + s + 0.05) ** 2 for u, w, s in placed_spheres)
        if apart and all((x - u) ** 2 + (r - v) ** 2 + (z - w) ** 2 > (r + 0.1) ** 2 for u, v, w in lamps):
            placed_spheres.append((x, z, r))
            objects.append({"file": "sphere.obj", "material": ("black", "white", "steel")[len(placed_spheres) % 3],
                            "scale": round(r, 3), "translate": [round(x, 3), round(r, 3), round(z, 3)]})
    return scene(
        "Forty small lights over a dark floor.",
        objects=objects,
        materials={
            "floor": {"Ka": [0.14, 0.14, 0.16], "Kd": [0.22, 0.22, 0.24], "Ks": [0.35, 0.35, 0.35], "Ns": 40},
            "black": {"Ka": [0.05, 0.05, 0.06], "Kd": [0.03, 0.03, 0.03], "Ks": [0.8, 0.8, 0.8], "Ns": 320},
            "white": {"Ka": [0.6, 0.6, 0.6], "Kd": [0.65, 0.65, 0.65], "Ks": [0.3, 0.3, 0.3], "Ns": 80},
            "steel": {"Ka": [0.1, 0.1, 0.11], "Kd": [0.12, 0.12, 0.13], "Ks": [0.7, 0.7, 0.72], "Ns": 30},
        },
        lights=[{"position": place, "colour": BULB_COLOURS[colour], "intensity": 4.0, "attenuation": [1, 2, 14]}
                for place, colour in bulbs()],
        ambient=[0.10, 0.10, 0.13],
        background={"top": [0.004, 0.005, 0.01], "bottom": [0.01, 0.01, 0.015]},
        camera={"eye": [0.2, 1.9, 5.0], "target": [0, 0, -0.1], "fov": 40})


def floor():
    """One rectangle: every pixel of it is lit by itself."""
    vertices = [(x, 0, z) for z in (3, -5) for x in (-8, 8)]
    return obj("a floor", vertices, [(1, 2, 4, 3)])


def figure():
    return scene(
        "The test figure: one light, one material, n = 50.",
        objects=[{"file": "knot.obj", "material": "figure", "turn": 20}],
        materials={"figure": {"Ka": [0.30, 0.10, 0.06], "Kd": [0.42, 0.12, 0.07], "Ks": [0.85, 0.85, 0.85], "Ns": 50}},
        lights=[{"direction": [0.5, -1.0, -0.8], "colour": [1, 1, 1]}],
        ambient=[0.25, 0.25, 0.28], background={"top": [0.20, 0.22, 0.25], "bottom": [0.07, 0.075, 0.085]},
        camera={"eye": [0, 2.6, 3.4], "target": [0, -0.02, 0], "fov": 31})


def models():
    """Every lighting model, in the order of the registry, by roughness."""
    highlight = {"Ka": [0.05, 0.06, 0.07], "Kd": [0.10, 0.12, 0.15], "Ks": [0.5, 0.5, 0.5]}
    matte = {"Ka": [0.30, 0.17, 0.11], "Kd": [0.62, 0.34, 0.22]}
    columns = [("lambert", matte), ("oren_nayar", matte), ("phong", highlight), ("blinn_phong", highlight),
               ("ward", {**highlight, "Ks": [0.12, 0.12, 0.12], "aniso": 0.6}), ("cook_torrance", highlight),
               ("cook_torrance_modified", highlight)]
    materials, objects = {}, []
    for i, (model, colours) in enumerate(columns):
        for j, roughness in enumerate((0.15, 0.3, 0.6)):
            name = f"{model}, Pr = {roughness}"
            materials[name] = {**colours, "brdf": model, "Pr": roughness, "Ni": 3.0, "Ns": round(2 / roughness ** 2)}
            objects.append({"file": "sphere.obj", "material": name, "scale": 0.44,
                            "translate": [i - (len(columns) - 1) / 2, 1 - j, 0]})
    return scene(
        "Columns are lighting models: lambert, oren_nayar, phong, blinn_phong, ward, cook_torrance and its modified "
        "form; rows are roughness 0.15, 0.3, 0.6.",
        objects=objects, materials=materials,
        lights=[{"direction": [0.5, -0.6, -0.8], "colour": [1, 0.97, 0.92]}],
        ambient=[0.2, 0.2, 0.22], background={"top": [0.04, 0.045, 0.055], "bottom": [0.015, 0.016, 0.02]},
        camera={"eye": [0, 0, 16], "target": [0, 0, 0], "fov": 14.2})


# ------------------------------------------------------------------------------------------ one lighting model by another

PAIR_LIGHT = (-14.0, 22.0, 24.0)  # far away, as its direction is: the sides are lit alike
PAIR = [  # the objects of one side
    ("vase.obj", "vase", (-0.42, 0, -0.62), 0, 0.92, STILL_LIFE[0][5]),
    ("pot.obj", "pot", (0.46, 0, 0.10), 0, 0.92, [(0, 0.36, 0, 0.60), (0, 0.8, 0, 0.2)]),
    ("sphere.obj", "ball", (-0.52, 0.34, 0.52), 0, 0.34, [(0, 0, 0, 1)]),
]
PAIR_CAMERA = {"eye": [0, 2.5, 5.6], "target": [0, 0.70, 0.0], "fov": 29}


def twice(objects, left, right, apart):
    """The objects on the left and on the right, in materials whose names begin with the side's."""
    return [(file, f"{side} {material}", (round(x + offset, 3), y, z), turn, scale, spheres)
            for side, offset in ((left, -apart / 2), (right, apart / 2))
            for file, material, (x, y, z), turn, scale, spheres in objects]


def away(place):
    """The direction in which light goes that comes from far away at a place."""
    return [-c for c in place]


BRUSHED = twice(PAIR, "brushed", "plain", 2.5)
CLAY = twice(PAIR, "clay", "lambert", 2.5)


def metal(colour, diffuse, **keys):
    return {"Ka": [round(0.5 * c, 3) for c in colour], "Kd": [round(diffuse * c, 3) for c in colour], "Ks": colour, **keys}


def brushed_metal():
    metals = {"vase": ((0.75, 0.50, 0.20), 0.26), "pot": ((0.62, 0.63, 0.66), 0.24), "ball": ((0.80, 0.42, 0.28), 0.22)}
    materials = {"bench": {"Ka": [0.06, 0.065, 0.08], "Kd": [0.06, 0.065, 0.08]}}
    for side, aniso in (("brushed", 0.92), ("plain", 0)):
        for name, (colour, roughness) in metals.items():
            materials[f"{side} {name}"] = metal(colour, 0.16, brdf="lambert ward", Pr=roughness, aniso=aniso)
    return scene(
        "Turned metal by ward: on the left brushed, so that highlights run across the grooves; on the right the same "
        "roughness in all directions.",
        objects=[{"file": "pair_ground.obj", "material": "bench"}, *placed(BRUSHED)],
        materials=materials,
        lights=[
            {"direction": away(PAIR_LIGHT), "colour": [1.0, 0.95, 0.88], "intensity": 1.7},
            {"direction": [-1.0, -0.30, -1.3], "colour": [0.62, 0.78, 1.0], "intensity": 0.8},
            {"position": [0, 3.4, -2.4], "colour": [1.0, 0.90, 0.75], "intensity": 7, "attenuation": [1, 0, 0.35]},
        ],
        ambient=[0.16, 0.17, 0.20],
        camera=PAIR_CAMERA)


def clay():
    colours = {"vase": (0.70, 0.38, 0.26), "pot": (0.62, 0.54, 0.44), "ball": (0.72, 0.66, 0.58)}
    materials = {"paper": {"Ka": [0.15, 0.18, 0.20], "Kd": [0.15, 0.18, 0.20]}}
    for side, model in (("clay", "oren_nayar"), ("lambert", "lambert")):
        for name, colour in colours.items():
            materials[f"{side} {name}"] = {"Ka": colour, "Kd": colour, "brdf": model, "Pr": 0.9}
    return scene(
        "Unglazed clay: on the left by oren_nayar, which throws light back to where it came from and stays flat up to "
        "its edge; on the right by lambert.",
        objects=[{"file": "pair_ground.obj", "material": "paper"}, *placed(CLAY)],
        materials=materials,
        lights=[
            {"direction": [0.35, -0.50, -1.0], "colour": [1.0, 0.95, 0.87], "intensity": 1.1},
            {"position": [0, 3.4, -2.6], "colour": [0.75, 0.86, 1.0], "intensity": 1.6, "attenuation": [1, 0, 0.35]},
        ],
        ambient=[0.10, 0.11, 0.13],
        camera=PAIR_CAMERA)


METALS_LIGHT = (-15.0, 22.0, 20.0)
METALS = twice([
    ("vase.obj", "copper, rough", (-0.10, 0, -0.72), 0, 0.86, STILL_LIFE[0][5]),
    ("bowl.obj", "steel, rough", (-0.66, 0, 0.20), 0, 0.74, STILL_LIFE[1][5]),
    ("knot.obj", "gold", (0.52, 0.42, 0.10), 15, 0.62, [(0, 0, 0, 0.62)]),
    ("sphere.obj", "steel, polished", (0.02, 0.22, 0.62), 0, 0.22, [(0, 0, 0, 1)]),
    ("sphere.obj", "copper, polished", (0.60, 0.17, 0.82), 0, 0.17, [(0, 0, 0, 1)]),
], "full", "modified", 2.5)


def metals():
    colours = {"copper": (0.96, 0.50, 0.33), "gold": (1.0, 0.72, 0.28), "steel": (0.72, 0.74, 0.78)}
    roughness = {"copper, rough": 0.5, "steel, rough": 0.36, "gold": 0.22, "steel, polished": 0.12,
                 "copper, polished": 0.14}
    materials = {"slate": {"Ka": [0.06, 0.07, 0.09], "Kd": [0.06, 0.07, 0.09]}}
    for side, model in (("full", "cook_torrance"), ("modified", "cook_torrance_modified")):
        for name, m in roughness.items():
            materials[f"{side} {name}"] = metal(colours[name.split(",")[0]], 0.08, brdf=f"lambert {model}", Pr=m, Ni=4)
    return scene(
        "Rough and polished copper, gold and steel: on the left by cook_torrance, on the right by its modified form.",
        objects=[{"file": "metals_ground.obj", "material": "slate"}, *placed(METALS)],
        materials=materials,
        lights=[
            {"direction": away(METALS_LIGHT), "colour": [1.0, 0.94, 0.86], "intensity": 1.9},
            {"direction": [-1.0, -0.45, -0.8], "colour": [0.62, 0.78, 1.0], "intensity": 0.9},
            {"position": [0.0, 3.6, -2.2], "colour": [1.0, 0.92, 0.80], "intensity": 6, "attenuation": [1, 0, 0.30]},
        ],
        ambient=[0.14, 0.15, 0.18],
        camera={"eye": [0, 2.3, 5.6], "target": [0, 0.64, 0.0], "fov": 28})


# ------------------------------------------------------------------------------------------------------- all at once

EVERYTHING_LIGHT = (-3.2, 4.2, 3.2)
EVERYTHING = [
    ("vase.obj", "glaze", (-0.30, 0, -0.75), 0, 1.06, STILL_LIFE[0][5]),
    ("vase.obj", "copper", (-1.52, 0, -0.55), 0, 0.66, STILL_LIFE[0][5]),
    ("pot.obj", "brushed steel", (-1.02, 0, 0.34), 0, 0.74, [(0, 0.36, 0, 0.60), (0, 0.8, 0, 0.2)]),
    ("bowl.obj", "terracotta", (0.82, 0, -0.22), 0, 1.06, STILL_LIFE[1][5]),
    ("apple.obj", "fruit", (0.60, 0.40, -0.30), 40, 0.88, []),
    ("apple.obj", "fruit", (1.12, 0.42, -0.20), 170, 0.80, []),
    ("pear.obj", "fruit", (1.86, 0, 0.10), 200, 0.86, [(0, 0.33, 0, 0.37), (0, 0.8, 0, 0.2)]),
    ("apple.obj", "fruit", (-0.08, 0, 0.62), 250, 0.74, [(0, 0.35, 0, 0.37)]),
    ("knot.obj", "gold", (0.90, 0.22, 0.94), 15, 0.44, [(0, 0, 0, 0.62)]),
    ("sphere.obj", "pearl", (0.26, 0.12, 1.06), 0, 0.12, [(0, 0, 0, 1)]),
    ("sphere.obj", "pearl", (0.04, 0.09, 1.26), 0, 0.09, [(0, 0, 0, 1)]),
    ("sphere.obj", "pearl", (1.56, 0.13, 0.88), 0, 0.13, [(0, 0, 0, 1)]),
    ("sphere.obj", "chalk", (-1.86, 0.17, 0.55), 0, 0.17, [(0, 0, 0, 1)]),
]


def everything():
    return scene(
        "A still life that calls for every effect: terracotta and chalk (oren_nayar), glaze and fruit (lambert, "
        "blinn_phong), pearls (phong), brushed steel (ward), copper (cook_torrance), gold (cook_torrance_modified).",
        objects=[{"file": "everything_ground.obj", "material": "paper"}, *placed(EVERYTHING)],
        materials={
            "paper": {"Ka": [0.20, 0.17, 0.18], "Kd": [0.22, 0.19, 0.20]},
            "glaze": {"Ka": [0.03, 0.09, 0.20], "Kd": [0.02, 0.10, 0.24], "Ks": [0.62, 0.66, 0.70], "Ns": 180},
            "terracotta": {"Ka": [0.55, 0.22, 0.12], "Kd": [0.66, 0.27, 0.15], "brdf": "oren_nayar", "Pr": 0.8},
            "chalk": {"Ka": [0.6, 0.56, 0.5], "Kd": [0.70, 0.65, 0.58], "brdf": "oren_nayar", "Pr": 0.9},
            "brushed steel": metal((0.80, 0.81, 0.84), 0.14, brdf="lambert ward", Pr=0.22, aniso=0.92),
            "copper": metal((0.96, 0.50, 0.33), 0.14, brdf="lambert cook_torrance", Pr=0.36, Ni=4),
            "gold": metal((1.0, 0.72, 0.28), 0.12, brdf="lambert cook_torrance_modified", Pr=0.22, Ni=4),
            "fruit": {"Ka": [0.9, 0.9, 0.9], "Kd": [0.8, 0.8, 0.8], "Ks": [0.25, 0.25, 0.23], "Ns": 60},
            "pearl": {"Ka": [0.42, 0.40, 0.42], "Kd": [0.46, 0.43, 0.44], "Ks": [0.75, 0.72, 0.78], "Ns": 200,
                      "brdf": "lambert phong"},
        },
        lights=[
            {"position": EVERYTHING_LIGHT, "colour": [1.0, 0.90, 0.76], "intensity": 14, "attenuation": [1, 0, 0.5]},
            {"position": [3.8, 1.9, 2.0], "colour": [0.42, 0.62, 1.0], "intensity": 4.5, "attenuation": [1, 0, 0.45]},
            {"direction": [-0.55, -0.55, 1.0], "colour": [1.0, 0.66, 0.42], "intensity": 0.9},
            {"direction": [0.15, -0.30, -1.0], "colour": [1.0, 0.92, 0.84], "intensity": 0.20},
        ],
        ambient=[0.10, 0.10, 0.14],
        camera={"eye": [0.15, 1.95, 5.5], "target": [0.12, 0.82, 0.0], "fov": 31})


def files():
    return {
        "sphere.obj": sphere(), "vase.obj": vase(), "bowl.obj": bowl(), "apple.obj": apple(), "pear.obj": pear(),
        "knot.obj": knot(), "pot.obj": pot(),
        "still_life_ground.obj": ground("the paper of still_life.json", blockers(STILL_LIFE), STILL_LIGHT, 6.5, 3.4, -3.6, 5.0, 66, 44),
        "matte_ground.obj": ground("the paper of matte.json", blockers(MATTE), MATTE_LIGHT, 6.5, 3.4, -3.6, 5.0, 66, 44),
        "pair_ground.obj": ground("the ground of brushed_metal.json and clay.json", blockers(BRUSHED), PAIR_LIGHT, 6.5, 3.4, -3.6, 5.0, 56, 32),
        "metals_ground.obj": ground("the ground of metals.json", blockers(METALS), METALS_LIGHT, 6.5, 3.4, -3.6, 5.0, 56, 32),
        "everything_ground.obj": ground("the paper of everything.json", blockers(EVERYTHING), EVERYTHING_LIGHT, 6.5, 3.4, -3.6, 5.0, 66, 44),
        "many_lights_floor.obj": floor(), "bulbs.obj": bulb_model(), "bulbs.mtl": bulb_materials(),
        "still_life.json": still_life(), "sphere_grid.json": sphere_grid(), "matte.json": matte(),
        "many_lights.json": many_lights(), "figure.json": figure(), "models.json": models(),
        "brushed_metal.json": brushed_metal(), "clay.json": clay(), "metals.json": metals(),
        "everything.json": everything(),
    }


def main():
    if len(sys.argv) > 2 or sys.argv[1:] in (["-h"], ["--help"]):
        print(__doc__.strip())
        return 0 if len(sys.argv) == 2 else 2
    folder = Path(sys.argv[1]) if len(sys.argv) == 2 else Path(__file__).resolve().parent
    if not folder.is_dir():
        print(f"make.py: folder '{folder}' is not there", file=sys.stderr)
        return 2
    for name, text in files().items():
        (folder / name).write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
