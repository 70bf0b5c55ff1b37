#!/usr/bin/env python3
"""`glint render` on what people have: models.json, a table of models with what comes of each, and single faults.

    field_test.py --glint build/glint [--models /usr/share/assimp/models] [Models Faults ...]

models.json holds, for each model, what is drawn with which warnings, or the line that refuses it: first the models of the
package assimp-testmodels, then small models with the oddities of those that a well-known loader keeps as its tests.
"""

import json
from pathlib import Path

from render_test import OPTIONS, TRIANGLE, RenderCase, main, render_options

TABLE = json.loads((Path(__file__).parent / "models.json").read_text())
CUBE = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
FACES = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"


class Models(RenderCase):
    def check(self, folder, file, entry):
        """A model gives what its entry of the table says, whole lines."""
        out = self.folder
        done = self.run_tool("render", file, "--size", "48x27", "-o", out / "a.png", "--json", out / "a.json", cwd=folder)
        lines = [line.split(f"{file}:", 1)[-1] for line in done.stderr.splitlines()]
        if "refused" in entry:
            self.equal((done.returncode, done.stdout), (2, ""), f"{entry['name']}: {done.stderr}")
            self.equal(lines[-1].removeprefix("glint: "), entry["refused"].removeprefix(":"), entry["name"])
            self.true(all("warning: " in line for line in done.stderr.splitlines()[:-1]), done.stderr)
            return
        self.equal(done.returncode, 0, f"{entry['name']}: {done.stderr}")
        found = json.loads((out / "a.json").read_text())
        names = [material["name"] for material in found["plan"]["materials"]]
        self.equal((found["triangles"], found["fragments"], names),
                   (entry["triangles"], entry["fragments"], entry["materials"]), entry["name"])
        warnings = [line.removeprefix("glint: warning:").strip() for line in lines]
        if len(warnings) > 6:
            warnings[2:] = [f"and {len(warnings) - 2} more"]
        self.equal(warnings, entry.get("warnings", []), entry["name"])

    def test_installed(self):
        """Every model of the package, by one entry each; those that only newer ones have may be missing."""
        if not (OPTIONS.models / "OBJ").is_dir():
            self.true(not OPTIONS.models.exists(), f"{OPTIONS.models} has no folder OBJ")
            return
        there = sorted(str(path.relative_to(OPTIONS.models)) for path in OPTIONS.models.rglob("*.obj"))
        entries = {entry["name"]: entry for entry in TABLE["assimp-testmodels"]}
        self.equal(there, sorted(name for name, entry in entries.items() if name in there or "newer" not in entry))
        for name in there:
            self.check(OPTIONS.models, name, entries[name])

    def test_rebuilt(self):
        self.true(len(TABLE["rebuilt"]) >= 46, f"{len(TABLE['rebuilt'])} models")
        for entry in TABLE["rebuilt"]:
            folder = self.folder / entry["name"]
            folder.mkdir()
            for name, lines in entry["files"].items():
                (folder / name).write_text("\n".join(lines) + "\n")
            self.check(folder, "model.obj", entry)


    def test_through_the_verilog(self):
        """Every model that is drawn, from dot products and from vectors: rtl equals fixed in every pixel."""
        if not OPTIONS.rtl:
            self.true(True, "this build has no Verilated units")
            return
        drawn = [(OPTIONS.models, entry["name"]) for entry in TABLE["assimp-testmodels"] if "refused" not in entry]
        drawn = [(folder, name) for folder, name in drawn if (folder / name).is_file()]
        for entry in TABLE["rebuilt"]:
            folder = self.folder / entry["name"]
            folder.mkdir()
            for name, lines in entry["files"].items():
                (folder / name).write_text("\n".join(lines) + "\n")
            if "refused" not in entry:
                drawn.append((folder, "model.obj"))
        fragments = 0
        for folder, name in drawn:
            for source in ("dots", "vectors"):
                done = self.run_tool("render", name, "--compare", "--from", source, "--size", "96x54", "-o", self.folder / "a.png",
                                     "--json", self.folder / "a.json", cwd=folder)
                self.equal(done.returncode, 0, f"{folder / name} {source}: {done.stdout}{done.stderr}")
                found = self.json("a.json")
                self.equal(found["rtl_against_fixed"]["unequal"], 0, f"{folder / name} {source}")
                self.true((found["against_float"]["psnr_db"] or 99) > 50, f"{folder / name} {source}: {found['against_float']}")
                fragments += found["fragments"]
        self.true(fragments > 40000, f"{fragments} fragments in {len(drawn)} models")


class Faults(RenderCase):
    def cube(self, name, size=1.0, at=(0.0, 0.0, 0.0), rest=""):
        lines = ["v " + " ".join(f"{a + size * x:.12g}" for a, x in zip(at, corner)) + rest for corner in CUBE]
        return self.write(name, "\n".join(lines) + "\n" + FACES)

    def pixels(self, scene, *arguments):
        self.render(scene, "--size", "96x54", "-o", "a.png", *arguments)
        return [pixel for row in self.picture("a.png")[2] for pixel in row]

    def test_far_from_the_origin(self):
        """A cube of 0.4 at map coordinates, and of any size, is the cube at the origin."""
        near = self.pixels(self.cube("near.obj", 0.4))
        for name, size, at in (("map.obj", 0.4, (500000.05, 4649776.3, 99.8)), ("tiny.obj", 1e-30, (0, 0, 0)),
                               ("huge.obj", 1e11, (-2e11, 0, 4e11)), ("far.obj", 0.4, (1e7, -1e7, 1e7))):
            far = self.pixels(self.cube(name, size, at))
            different = [pair for pair in zip(near, far) if max(abs(p - q) for p, q in zip(*pair)) > 1]
            self.true(len(different) <= 4, f"{name}: {len(different)} pixels differ")

    def test_scene_at_map_coordinates(self):
        """Camera, lights and objects move with the model."""
        self.cube("near.obj", 0.4)
        self.cube("far.obj", 0.4, (500000, 4649776, 100))
        pictures = []
        for name, (x, y, z) in (("near", (0, 0, 0)), ("far", (500000, 4649776, 100))):
            self.write(f"{name}.json", {"objects": [{"file": f"{name}.obj"}], "lights": [{"position": [x + 2, y + 1, z + 2]}],
                                        "camera": {"eye": [x + 1, y + 1.5, z + 3], "target": [x + 0.2, y + 0.2, z + 0.2]}})
            pictures.append(self.pixels(f"{name}.json"))
        different = sum(max(abs(p - q) for p, q in zip(*pair)) > 1 for pair in zip(*pictures))
        self.true(different <= 4, f"{different} pixels differ")

    def test_concave(self):
        """The notch of an L stays empty."""
        self.write("a.obj", "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 5 6\n")
        camera = {"eye": [1.5, 1.5, 5], "target": [1.5, 1.5, 0]}
        self.write("a.json", {"objects": [{"file": "a.obj"}], "camera": camera, "background": [0, 0, 1]})
        self.render("a.json", "--size", "60x60", "-o", "a.png", "--json", "out.json")
        rows = self.picture("a.png")[2]
        self.equal(rows[20][40], (0, 0, 255))
        self.true(rows[45][15] != (0, 0, 255), "the corner is there")
        # 5 of 10 squared, as 1/25 of the view, seen at a distance of 5 with 35 degrees.
        self.near(self.json("out.json")["fragments"], 5 * (60 / (2 * 5 * 0.31530)) ** 2, 40)

    def test_colours_of_255(self):
        done = self.render(self.cube("a.obj", rest=" 255 128 0"), "--size", "96x54", "-o", "a.png")
        self.matches(done.stderr, r"\Aglint: warning: a.obj: colours of vertices above 1 were taken as 0 .. 255\n\Z")
        red, green, blue = self.picture("a.png")[2][27][48]
        self.true(red > 1.2 * green > 1.2 * blue, f"{(red, green, blue)} is orange")

    def test_rim(self):
        """No pixel is black by oren_nayar that lambert shows lit: the rim of a ball of few faces."""
        ring = [(0.0, 1.0, 0.0)]
        ring += [(0.866 * x, y, 0.866 * z) for y in (0.5, -0.5) for x, z in ((1, 0), (0.5, 0.866), (-0.5, 0.866), (-1, 0),
                                                                             (-0.5, -0.866), (0.5, -0.866))]
        ring.append((0.0, -1.0, 0.0))
        faces = [(1, 2 + (i + 1) % 6, 2 + i) for i in range(6)] + [(14, 8 + i, 8 + (i + 1) % 6) for i in range(6)]
        faces += [(2 + i, 2 + (i + 1) % 6, 8 + (i + 1) % 6, 8 + i) for i in range(6)]
        self.write("ball.obj", "".join(f"v {x} {y} {z}\nvn {x} {y} {z}\n" for x, y, z in ring) +
                   "".join("f " + " ".join(f"{v}//{v}" for v in face) + "\n" for face in faces))
        scene = {"objects": [{"file": "ball.obj", "material": "m"}], "lights": [{"direction": [-1, -0.2, -0.6]}],
                 "camera": {"eye": [0, 0, 6], "target": [0, 0, 0], "fov": 25}, "background": [0, 0, 1]}
        lit = {}
        for model in ("lambert", "oren_nayar"):
            scene["materials"] = {"m": {"Kd": [0.8, 0.8, 0.8], "brdf": model, "Pr": 0.5}}
            self.write("a.json", scene)
            for engine in ("float", "fixed") + (("rtl",) if OPTIONS.rtl else ()):
                lit[model, engine] = [max(pixel) > 0 for pixel in self.pixels("a.json", "--engine", engine)]
        for engine in ("float", "fixed") + (("rtl",) if OPTIONS.rtl else ()):
            black = sum(a and not b for a, b in zip(lit["lambert", engine], lit["oren_nayar", engine]))
            self.equal(black, 0, engine)
            self.true(sum(lit["oren_nayar", engine]) > 300, "the ball is seen")

    def test_scene_files(self):
        """What is no scene is one line, exit status 2, and nothing is written."""
        self.write("a.obj", TRIANGLE + "f 1 2 3\n")
        self.write("b\ufeff.obj", "")
        start = '{"objects": [{"file": "a.obj"}], '
        for line, text in (
                ("a.json: ambient 1e309 is not legal: numbers up to 1.79769e", start + '"ambient": [1e309, 0, 0]}'),
                ("a.json: lights position -1e400 is not legal", start + '"lights": [{"position": [0, -1e400, 0]}]}'),
                ("is not legal: numbers up to", start + '"ambient": ' + "9" * 400 + "}"),
                ("nested in more than 16", '{"objects":' + "[" * 100000 + "]" * 100000 + "}"),
                ("nested in more than 16", '{"about":' * 100000 + "1" + "}" * 100000),
                (r"file \"a.obj\\u0000b.obj\" is not legal: a text without the character 0",
                 '{"objects": [{"file": "a.obj\\u0000b.obj"}]}'),
                ("key 'ambient' is there twice", start + '"ambient": [1, 1, 1], "ambient": [0, 0, 0]}'),
                (r"ambient \"x{59}\.\.\. is not legal", start + '"ambient": "' + "x" * 500 + '"}'),
                (r"key 'k{60}\.\.\.' is not known", start + '"' + "k" * 5000 + '": 1}'),
                ("this is UTF-16 text", (start + '"about": "x"}').encode("utf-16")),
                ("is not JSON: parse error", start)):
            (self.folder / "a.json").write_bytes(text if isinstance(text, bytes) else text.encode())
            self.refused(line, "render", "a.json", "-o", "a.png", "--json", "out.json")
        self.equal(self.files(), ["a.json", "a.obj", "b\ufeff.obj"])

    def test_one_file_for_two(self):
        self.write("a.obj", TRIANGLE + "f 1 2 3\n")
        self.write("a.json", {"objects": [{"file": "a.obj"}]})
        for arguments in (("-o", "a.png", "--json", "./a.png"), ("-o", "a.png", "--json", "a.json"),
                          ("-o", "a.png", "--compare", "--json", "a_fixed.png")):
            self.refused("--json '.*' is not legal: it is the scene or the picture", "render", "a.json", *arguments)
        self.write("a.mtl", "newmtl red\nKd 1 0 0\n")
        self.write("a.obj", "mtllib a.mtl\n" + TRIANGLE + "usemtl red\nf 1 2 3\n")
        for scene in ("a.json", "a.obj"):
            for file in ("./a.mtl",) + (("a.obj",) if scene == "a.json" else ()):
                self.refused("--json '.*' is not legal: it is a model or its materials", "render", scene, "-o", "a.png",
                             "--json", file)
        self.equal(self.files(), ["a.json", "a.mtl", "a.obj"])

    def test_names_in_capitals(self):
        self.write("A.OBJ", "\ufeff" + TRIANGLE + "f 1 2 3\n")
        self.write("A.JSON", {"objects": [{"file": "A.OBJ"}]})
        for scene in ("A.OBJ", "A.JSON"):
            done = self.render(scene, "--size", "16x9", "-o", "A.PNG")
            self.equal(done.stderr, "")

    def test_nothing_to_see(self):
        self.write("a.obj", TRIANGLE + "f 1 2 3\n")
        self.write("a.json", {"objects": [{"file": "a.obj"}], "camera": {"eye": [0, 0, 5], "target": [0, 0, 9]}})
        done = self.render("a.json", "--size", "16x9", "-o", "a.png")
        self.equal(done.stderr, "glint: warning: nothing is in the picture (0 fragments)\n")


if __name__ == "__main__":
    main(render_options)
