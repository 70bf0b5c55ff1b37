#!/usr/bin/env python3
"""`glint render` as a command: scenes, engines, files, refusals.

    render_test.py --glint build/glint [--rtl] [--models FOLDER] [Scenes Engines ...]

--rtl: the build has all simulated units of effects at p12. Exit status: 0 if every check held.
"""

import json
import math
import re
import struct
import subprocess
import sys
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from case import Case, OPTIONS, ROOT, main  # noqa: E402

SCENES = ROOT / "scenes"
SHIPPED = ("still_life", "sphere_grid", "matte", "many_lights", "figure", "models", "brushed_metal", "clay", "metals",
           "everything")


def decode_png(data):
    """Width, height and rows of RGB triples of an 8-bit PNG, by the standard library alone."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, pixels, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            pixels += body
        at += 12 + length
    width, height, depth, colour, _, _, interlace = header
    assert (depth, colour, interlace) == (8, 2, 0)
    raw, rows, above = zlib.decompress(pixels), [], bytes(3 * width)
    for y in range(height):
        line = bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
        kind = raw[y * (3 * width + 1)]
        for i in range(3 * width):
            left = line[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            if kind == 1:
                line[i] = (line[i] + left) & 255
            elif kind == 2:
                line[i] = (line[i] + above[i]) & 255
            elif kind == 3:
                line[i] = (line[i] + (left + above[i]) // 2) & 255
            elif kind == 4:
                nearest = min((left, above[i], corner), key=lambda p: abs(left + above[i] - corner - p))
                line[i] = (line[i] + nearest) & 255
        rows.append([tuple(line[i:i + 3]) for i in range(0, 3 * width, 3)])
        above = bytes(line)
    return width, height, rows


TRIANGLE = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\n"


class RenderCase(Case):
    def render(self, scene, *arguments, status=0):
        """Runs glint render; returns what it printed."""
        done = self.run_tool("render", scene, *arguments)
        self.equal(done.returncode, status, f"{scene} {arguments}: {done.stdout}{done.stderr}")
        return done

    def write(self, name, text):
        (self.folder / name).write_text(text if isinstance(text, str) else json.dumps(text))
        return name

    def picture(self, name):
        return decode_png((self.folder / name).read_bytes())

    def json(self, name):
        return json.loads(self.read(name))


class Scenes(RenderCase):
    def test_script_wrote_them(self):
        """scenes/ holds what scenes/make.py writes."""
        subprocess.run([sys.executable, SCENES / "make.py", self.folder], check=True)
        written = self.files()
        self.true(len(written) >= 10, f"{written}")
        for name in written:
            self.equal(self.read(name), (SCENES / name).read_text(), name)
            self.true(len(self.read(name)) < 200_000, name)

    def test_every_scene(self):
        for name in SHIPPED:
            done = self.render(SCENES / f"{name}.json", "--size", "96x54", "-o", f"{name}.png", "--json", f"{name}.json")
            self.equal(done.stderr, "", name)
            width, height, rows = self.picture(f"{name}.png")
            self.equal((width, height), (96, 54))
            self.true(len({pixel for row in rows for pixel in row}) > 100, f"{name} shows something")
            found = self.json(f"{name}.json")
            self.true(found["fragments"] > 500, f"{name}: {found['fragments']} fragments")
            planned = sum(unit["evaluations"] for unit in found["plan"]["units"])
            self.equal(found["engines"][0]["evaluations"], planned)

    def test_still_life_has_five_materials(self):
        self.render(SCENES / "still_life.json", "--size", "96x54", "-o", "a.png", "--json", "a.json")
        self.equal(len(self.json("a.json")["plan"]["materials"]), 5)

    def test_matte_needs_no_highlight(self):
        done = self.render(SCENES / "matte.json", "--size", "96x54", "-o", "a.png", "--json", "a.json")
        plan = self.json("a.json")["plan"]
        self.equal([unit["effect"] for unit in plan["units"]], ["ambient", "lambert", "tint"])
        self.true({"phong", "blinn_phong"} <= set(plan["not_needed"]), f"{plan}")
        self.matches(done.stdout, "not needed: .*phong, blinn_phong")
        fragments = self.json("a.json")["fragments"]
        self.equal([unit["evaluations"] for unit in plan["units"]], [fragments, 2 * fragments, 2 * fragments])

    def test_cheapest_shade(self):
        """MASK of shade: the bits of all effects that are seen, and no other."""
        table = re.search(r"^\| effect \| (.*) \|$", (ROOT / "docs/effects/shade.md").read_text(), re.MULTILINE)[1].split(" | ")
        masks = {}
        for name in SHIPPED:
            done = self.render(SCENES / f"{name}.json", "--size", "96x54", "-o", "a.png", "--json", "a.json")
            found = self.json("a.json")
            effects = {effect for material in found["plan"]["materials"] for effect in material["effects"]}
            lobes = {unit["lobe"] for unit in found["plan"]["units"] if "lobe" in unit}
            self.equal({unit.get("lobe") for unit in found["plan"]["shade"]}, lobes or {None}, name)
            self.equal(set().union(*(unit["effects"] for unit in found["plan"]["shade"])), effects, name)
            self.equal(sum(unit["fragments"] for unit in found["plan"]["shade"]),
                       sum(material["fragments"] for material in found["plan"]["materials"] if material["effects"]), name)
            for unit in found["plan"]["shade"]:
                self.equal(unit["mask"], sum(1 << table.index(effect) for effect in unit["effects"]), name)
                lobe = rf" \({re.escape(unit['lobe'])}\)" if "lobe" in unit else ""
                self.matches(done.stdout, rf"as one unit: shade{lobe}, MASK {unit['mask']} \({', '.join(unit['effects'])}\)\n")
            masks[name] = [unit["mask"] for unit in found["plan"]["shade"]]
        self.equal(masks["matte"], [3])
        for name in ("models", "everything"):
            self.equal(masks[name], [2 ** len(table) - 1])

    def test_everything_calls_for_every_effect(self):
        """Those that the build has, as its own list says, but for units of several and those that take vectors."""
        done = self.run_tool("emit", "--effect", "none", "--profile", "p12", "-o", ".")
        effects = set(re.search("is not known: (.*)", done.stderr)[1].split(", ")) - {
            "shade", "pixel", "cosine", "lobe_select", "bps_vectors", "blinn_phong_vectors"}
        self.true({"ambient", "tint", "ward", "cook_torrance"} <= effects, f"{effects}")
        self.render(SCENES / "everything.json", "--size", "96x54", "-o", "a.png", "--json", "a.json")
        plan = self.json("a.json")["plan"]
        self.equal({unit["effect"] for unit in plan["units"]}, effects)
        self.true(all(unit["evaluations"] > 0 for unit in plan["units"]), f"{plan['units']}")
        self.equal(plan["not_needed"], [])
        self.true(all(material["fragments"] > 10 for material in plan["materials"]), f"{plan['materials']}")

    def test_shade_of_two_lobes(self):
        """A unit of shade has one lobe; a material without any goes where it adds least."""
        self.write("a.mtl", "".join(f"newmtl {name}\nKd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nNs 20\n" for name in "abcd"))
        faces = "".join(f"usemtl {name}\nf {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i, name in enumerate("abcd"))
        self.write("a.obj", "mtllib a.mtl\n" + "".join(f"v {x} 0 0\nv {x + 1} 0 0\nv {x} 2 0\n" for x in range(4)) + faces)
        materials = {"a": {"brdf": "lambert phong", "lobe": "cayley"}, "b": {"brdf": "lambert blinn_phong"},
                     "c": {"brdf": "oren_nayar ward"}, "d": {"brdf": "oren_nayar blinn_phong"}}
        self.write("a.json", {"objects": [{"file": "a.obj"}], "materials": materials})
        self.render("a.json", "--size", "60x40", "-o", "a.png", "--json", "out.json")
        found = self.json("out.json")["plan"]["shade"]
        self.equal([(unit["lobe"], unit["effects"]) for unit in found],
                   [("cayley", ["lambert", "phong"]), ("bps", ["lambert", "blinn_phong", "oren_nayar", "ward"])])
        self.equal([unit["mask"] for unit in found], [0b110, 0b111010])

    def test_model_alone(self):
        """A model without a scene file: framed, lit, its materials as its MTL file says."""
        self.write("a.mtl", "newmtl red\nKd 0.8 0 0\nKs 0.5 0.5 0.5\nNs 2.5\nillum 4\n")
        self.write("a.obj", "mtllib a.mtl\n" + TRIANGLE + "usemtl red\nf 1 2 3\n")
        done = self.render("a.obj", "--size", "60x40", "-o", "a.png", "--json", "a.json")
        self.matches(done.stderr, r"\Aglint: warning: material 'red': illum 4 [^\n]*\n\Z")
        found = self.json("a.json")
        self.equal(found["plan"]["materials"][0]["effects"], ["lambert", "blinn_phong"])
        self.true(found["fragments"] > 60 * 40 / 8, "the triangle fills the picture")
        middle = self.picture("a.png")[2][25][30]
        self.true(middle[0] > 1.5 * middle[1], f"{middle} is red")

    def test_change_of_a_material(self):
        self.write("a.mtl", "newmtl red\nKd 0.8 0 0\nKs 0.5 0.5 0.5\nNs 20\n")
        self.write("a.obj", "mtllib a.mtl\n" + TRIANGLE + "usemtl red\nf 1 2 3\n")
        self.write("a.json", {"objects": [{"file": "a.obj"}],
                              "materials": {"red": {"Kd": [0, 0.8, 0], "brdf": "phong", "lobe": "cayley"}}})
        self.render("a.json", "--size", "60x40", "-o", "a.png", "--json", "out.json")
        units = [(unit["effect"], unit.get("lobe")) for unit in self.json("out.json")["plan"]["units"]]
        self.true(("phong", "cayley") in units, f"{units}")
        middle = self.picture("a.png")[2][25][30]
        self.true(middle[1] > 2 * middle[0], f"{middle} is green")

    def test_objects_are_placed(self):
        """Scale, turn, translation: a triangle turned to its edge is not seen, moved aside it is seen there."""
        self.write("a.obj", TRIANGLE + "f 1 2 3\n")
        camera = {"eye": [0, 0, 10], "target": [0, 0, 0], "fov": 40}

        def columns(**placing):
            self.write("a.json", {"objects": [{"file": "a.obj", **placing}], "camera": camera})
            self.render("a.json", "--size", "80x40", "-o", "a.png", "--json", "out.json")
            rows = self.picture("a.png")[2]
            return [x for x in range(80) if any(row[x] != (0, 0, 0) for row in rows)]

        plain = columns()
        self.true(plain and abs(plain[0] + plain[-1] - 79) <= 1, f"{plain} is in the middle")
        self.equal(columns(turn=90), [])
        moved = columns(translate=[2, 0, 0])
        self.true(moved[0] > plain[0] + 5, f"{moved}")
        self.true(len(columns(scale=0.5)) < 0.6 * len(plain) + 2, "half as wide")


class Engines(RenderCase):
    def test_compare(self):
        """The engines agree: rtl with fixed in every pixel, both with float to 50 dB."""
        for name in SHIPPED:
            self.render(SCENES / f"{name}.json", "--compare", "--size", "120x68", "-o", "c.png", "--json", "c.json")
            found = self.json("c.json")
            self.true(found["against_float"]["psnr_db"] >= 50.0, f"{name}: {found['against_float']}")
            self.true(found["against_float"]["ssim"] > 0.99, f"{name}: {found['against_float']}")
            last = "fixed"
            if OPTIONS.rtl:
                self.equal(found["rtl_against_fixed"], {"pixels": 120 * 68, "unequal": 0}, name)
                clocks = {engine["engine"]: engine.get("clocks", 0) for engine in found["engines"]}
                evaluations = sum(unit["evaluations"] for unit in found["plan"]["units"])
                self.true(clocks["rtl"] > evaluations, f"{name}: {clocks} for {evaluations} evaluations")
                last = "rtl"
            self.equal(self.files(), ["c.json", "c_difference.png", f"c_{last}.png", "c_float.png"]
                       if last == "fixed" else ["c.json", "c_difference.png", "c_float.png", "c_rtl.png"])
            self.equal(self.picture("c_difference.png")[:2], (120, 68 + 24))
            # The figures are those of the pictures.
            a, b = (self.picture(f"c_{engine}.png")[2] for engine in (last, "float"))
            apart = [abs(x - y) for p, q in zip(a, b) for u, v in zip(p, q) for x, y in zip(u, v)]
            self.equal(max(apart), found["against_float"]["largest"])
            mean = sum(d * d for d in apart) / len(apart)
            self.near(10 * math.log10(255 * 255 / mean), found["against_float"]["psnr_db"], 1e-6)

    def test_vectors(self):
        """Pixels from vectors: the engines agree as from dot products, and no input is corrected."""
        for name in SHIPPED:
            self.render(SCENES / f"{name}.json", "--from", "vectors", "--compare", "--size", "64x36", "-o", "c.png", "--json", "c.json")
            found = self.json("c.json")
            self.equal({unit["effect"] for unit in found["plan"]["units"]}, {"pixel"}, name)
            self.true(found["against_float"]["psnr_db"] >= 50.0, f"{name}: {found['against_float']}")
            self.equal([engine["corrected"] for engine in found["engines"][1:]], [0] * (len(found["engines"]) - 1), name)
            if OPTIONS.rtl and len(found["plan"]["units"]) == 1:  # the build has pixel around one lobe
                self.equal(found["rtl_against_fixed"], {"pixels": 64 * 36, "unequal": 0}, name)
        # As from dot products, but for the rounding of vectors.
        self.render(SCENES / "figure.json", "--from", "vectors", "--size", "64x36", "-o", "v.png")
        self.render(SCENES / "figure.json", "--size", "64x36", "-o", "d.png")
        a, b = (self.picture(name)[2] for name in ("v.png", "d.png"))
        apart = max(abs(x - y) for p, q in zip(a, b) for u, v in zip(p, q) for x, y in zip(u, v))
        self.true(0 < apart <= 2, f"{apart} of 255")

    def test_profiles(self):
        """More bits, less error."""
        psnr = {}
        for profile in ("p8", "p12", "p16"):
            self.render(SCENES / "figure.json", "--compare", "--profile", profile, "--size", "96x54", "-o", "c.png",
                        "--json", "c.json")
            psnr[profile] = self.json("c.json")["against_float"]["psnr_db"] or math.inf
        self.true(psnr["p8"] < psnr["p12"] < psnr["p16"], f"{psnr}")

    def test_against(self):
        """f_bps against Blinn-Phong: the paper's figure 9. The lobe is further away than its fixed point."""
        for lobe, most in (("bps", 60), ("schlick", 45)):
            self.render(SCENES / "figure.json", "--compare", "--lobe", lobe, "--against", "blinn_phong", "--size",
                        "96x54", "-o", "c.png", "--json", "c.json")
            found = self.json("c.json")["against_float"]
            self.equal(found["lobe"], "blinn_phong")
            self.true(20 < found["psnr_db"] < most, f"{lobe}: {found}")
            self.true(found["largest_linear"] < 0.21, f"{lobe}: {found}")

    def test_against_model(self):
        """The float picture by another model: as a scene whose materials name it."""
        scene = json.loads((SCENES / "metals.json").read_text())
        for part in scene["objects"]:
            part["file"] = str(SCENES / part["file"])
        for material in scene["materials"].values():
            if "Ks" in material:
                material["brdf"] = "lambert cook_torrance"
        self.write("full.json", scene)
        self.render("full.json", "--engine", "float", "--size", "96x54", "-o", "a.png")
        psnr = {}
        for model in ("cook_torrance", "cook_torrance_modified", "phong", "oren_nayar"):
            done = self.render("full.json", "--compare", "--against-model", model, "--size", "96x54", "-o", "c.png",
                               "--json", "c.json")
            self.matches(done.stdout, f"against float with {model}: PSNR")
            found = self.json("c.json")["against_float"]
            self.equal(found["model"], model)
            psnr[model] = found["psnr_db"]
        self.true(psnr["cook_torrance"] > 50 > psnr["cook_torrance_modified"] > psnr["phong"], f"{psnr}")
        self.true(psnr["oren_nayar"] < 50, f"{psnr}")
        self.render(SCENES / "metals.json", "--compare", "--against-model", "cook_torrance", "--size", "96x54", "-o", "c.png")
        self.equal((self.folder / "c_float.png").read_bytes(), (self.folder / "a.png").read_bytes())

    def test_engine_pictures(self):
        """A picture by one engine is that of --compare."""
        self.render(SCENES / "figure.json", "--compare", "--size", "64x36", "-o", "c.png")
        for engine in ("float", "fixed") + (("rtl",) if OPTIONS.rtl else ()):
            self.render(SCENES / "figure.json", "--engine", engine, "--size", "64x36", "-o", "a.png")
            other = "c_float.png" if engine == "float" else "c_rtl.png" if OPTIONS.rtl else "c_fixed.png"
            self.equal((self.folder / "a.png").read_bytes(), (self.folder / other).read_bytes(), engine)

    def test_all_effects(self):
        """More evaluations, the same picture."""
        engine = "rtl" if OPTIONS.rtl else "fixed"
        counts = []
        for extra in ((), ("--all-effects",)):
            self.render(SCENES / "matte.json", "--engine", engine, "--size", "96x54", "-o", f"{len(extra)}.png", "--json",
                        "a.json", *extra)
            counts.append(self.json("a.json")["engines"][0]["evaluations"])
        self.true(counts[1] > 2 * counts[0], f"{counts}")
        self.equal((self.folder / "0.png").read_bytes(), (self.folder / "1.png").read_bytes())

    def test_threads(self):
        for threads in (1, 3):
            self.render(SCENES / "still_life.json", "--samples", 4, "--size", "80x45", "--threads", threads, "-o",
                        f"{threads}.png")
        self.equal((self.folder / "1.png").read_bytes(), (self.folder / "3.png").read_bytes())


class Files(RenderCase):
    def test_only_what_was_asked_for(self):
        done = self.render(SCENES / "figure.json", "--size", "16x9", "-o", "a.png")
        self.equal(self.files(), ["a.png"])
        self.equal(done.stderr, "")
        self.matches(done.stdout, r"written: a\.png\n\Z")

    def test_samples(self):
        """Edges become soft: more colours than without."""
        colours = []
        for samples in (1, 4, 9, 16):
            self.render(SCENES / "figure.json", "--size", "64x36", "--samples", samples, "-o", "a.png", "--json", "a.json")
            colours.append(len({pixel for row in self.picture("a.png")[2] for pixel in row}))
            self.equal(self.json("a.json")["samples"], samples)
        self.true(colours[0] < colours[1] < colours[3], f"{colours}")


class HardCases(RenderCase):
    """What a scene can hold that is no good: a finite picture, or one line."""

    def scene(self, **parts):
        self.write("a.obj", TRIANGLE + "f 1 2 3\n")
        return self.write("a.json", {"objects": [{"file": "a.obj"}], **parts})

    def finite(self, name):
        done = self.render(name, "--compare", "--size", "32x18", "-o", "a.png", "--json", "out.json")
        self.true(done.stdout.count("\n") > 5, done.stdout)
        return self.json("out.json")

    def test_no_light(self):
        found = self.finite(self.scene(lights=[]))
        self.equal([unit["effect"] for unit in found["plan"]["units"]], ["ambient"])

    def test_no_light_at_all(self):
        found = self.finite(self.scene(lights=[], ambient=[0, 0, 0]))
        self.equal(found["plan"]["units"], [])

    def test_light_inside_the_surface(self):
        (self.folder / "sphere.obj").write_text((SCENES / "sphere.obj").read_text())
        self.write("a.json", {"objects": [{"file": "sphere.obj"}], "ambient": [0, 0, 0],
                              "lights": [{"position": [0, 0, 0]}], "background": [0.5, 0.5, 0.5]})
        self.finite("a.json")
        self.equal(self.picture("a_float.png")[2][9][16], (0, 0, 0))

    def test_light_on_the_surface(self):
        self.finite(self.scene(lights=[{"position": [0, 0, 0], "attenuation": [0, 0, 1], "intensity": 15}]))

    def test_camera_inside_and_from_behind(self):
        camera = {"eye": [0, 0, -4], "target": [0, 0, 0]}
        light = [{"direction": [0, 0, 1]}]
        self.finite(self.scene(camera=camera, lights=light))
        # From behind, with the light: a surface has two sides.
        self.true(max(self.picture("a_float.png")[2][9][16]) > 100, "lit")

    def test_empty_view(self):
        scene = self.scene(camera={"eye": [0, 0, 5], "target": [0, 0, 9]}, background=[1, 0, 0])
        self.render(scene, "--size", "8x8", "-o", "a.png")
        self.equal(self.picture("a.png")[2][4][4], (255, 0, 0))
        done = self.render(scene, "--compare", "--size", "8x8", "-o", "a.png", status=1)
        self.matches(done.stdout, "FAILED: nothing was shaded")

    def test_bad_models(self):
        for text, line in (
                ("", "there are no faces with an area"),
                (TRIANGLE, "there are no faces with an area"),
                ("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj:2: 'nan' is not legal"),
                ("v 0 0 0\nv 0 0 1e13\nv 0 1 0\nf 1 2 3\n", "a.obj:2: '1e13' is not legal"),
                ("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", "there are no faces with an area"),
                (TRIANGLE + "f 1 2 4\n", "a face asks for vertex 4, there are 3"),
                (TRIANGLE + "f 0 1 2\n", "a.obj:4: a face asks for vertex 0")):
            self.write("a.obj", text)
            self.refused(line, "render", "a.obj", "-o", "a.png")
        self.equal(self.files(), ["a.obj"])


class Refusals(RenderCase):
    def test_arguments(self):
        figure = SCENES / "figure.json"
        for line, arguments in (
                ("scene.*required", ("-o", "a.png")),
                ("output.*required", (figure,)),
                ("--engine 'gpu' is not legal: float, fixed, rtl", (figure, "-o", "a.png", "--engine", "gpu")),
                ("--from 'x' is not legal: dots, vectors", (figure, "-o", "a.png", "--from", "x")),
                ("--all-effects is not legal with --from vectors", (figure, "-o", "a.png", "--from", "vectors", "--all-effects")),
                ("-o 'a.jpg' is not legal", (figure, "-o", "a.jpg")),
                ("--size '10' is not legal", (figure, "-o", "a.png", "--size", "10")),
                ("--size: width '0' is not legal: 1 to 8192", (figure, "-o", "a.png", "--size", "0x5")),
                ("--samples '3' is not legal: 1, 4, 9 or 16", (figure, "-o", "a.png", "--samples", "3")),
                ("rays are not legal: at most", (figure, "-o", "a.png", "--size", "8192x8192", "--samples", "16")),
                ("lobe 'gouraud' is not known: .*bps", (figure, "-o", "a.png", "--lobe", "gouraud")),
                ("profile 'p9' is not legal", (figure, "-o", "a.png", "--profile", "p9")),
                ("--against is not legal without --compare", (figure, "-o", "a.png", "--against", "bps")),
                ("lobe 'x' is not known", (figure, "-o", "a.png", "--compare", "--against", "x")),
                ("--against-model is not legal without --compare", (figure, "-o", "a.png", "--against-model", "ward")),
                ("--against-model 'x' is not known: lambert, .*ward",
                 (figure, "-o", "a.png", "--compare", "--against-model", "x")),
                ("file 'none/a.png' cannot be written", (figure, "-o", "none/a.png")),
                ("file 'none/a.json' cannot be written", (figure, "-o", "a.png", "--json", "none/a.json")),
                ("file 'none.json' cannot be read", ("none.json", "-o", "a.png")),
                ("file 'none.obj' cannot be read", ("none.obj", "-o", "a.png")),
                ("scene 'a.ply' is not legal: a file NAME.json or NAME.obj", ("a.ply", "-o", "a.png"))):
            self.refused(line, "render", *arguments)
        self.equal(self.files(), [])

    def test_engine_that_is_not_there(self):
        text = "in this build"
        if OPTIONS.rtl:
            self.refused(text, "render", SCENES / "figure.json", "--engine", "rtl", "--profile", "17,14,14,12", "-o",
                         "a.png")
        else:
            self.refused(text, "render", SCENES / "figure.json", "--engine", "rtl", "-o", "a.png")
        self.equal(self.files(), [])

    def test_scene_files(self):
        self.write("a.obj", TRIANGLE + "f 1 2 3\n")
        good = {"objects": [{"file": "a.obj"}]}
        for line, change in (
                ("'objects' is missing or empty", {"objects": []}),
                ("key 'light' is not known: .*lights", {"light": []}),
                (r"objects\[0\]: key 'file' is missing", {"objects": [{}]}),
                (r"objects\[0\]: key 'rotate' is not known", {"objects": [{"file": "a.obj", "rotate": 3}]}),
                (r"objects\[0\]: material \"red\" is not legal", {"objects": [{"file": "a.obj", "material": "red"}]}),
                (r"objects\[0\]: scale 0 is not legal", {"objects": [{"file": "a.obj", "scale": 0}]}),
                ("file 'b.obj' cannot be read", {"objects": [{"file": "b.obj"}]}),
                (r"lights\[0\] is not legal: a light has either", {"lights": [{}]}),
                (r"lights\[0\] is not legal: a light has either",
                 {"lights": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}),
                (r"lights\[0\]: direction .* is not legal", {"lights": [{"direction": [0, 0, 0]}]}),
                (r"lights\[0\]: intensity -1 is not legal", {"lights": [{"direction": [0, 0, 1], "intensity": -1}]}),
                (r"lights\[0\]: colour .* is not legal", {"lights": [{"direction": [0, 0, 1], "colour": [1, 1]}]}),
                (r"lights\[0\]: attenuation .* is not legal",
                 {"lights": [{"position": [0, 0, 1], "attenuation": [0, 0, 0]}]}),
                ("lights is not legal: a list of at most 256", {"lights": [{"direction": [0, 0, 1]}] * 257}),
                ("camera: eye or target is missing", {"camera": {"eye": [0, 0, 1]}}),
                ("the camera has no direction", {"camera": {"eye": [0, 0, 1], "target": [0, 0, 1]}}),
                ("the camera has no direction", {"camera": {"eye": [0, 0, 0], "target": [0, 1, 0]}}),
                ("fov 0 is not legal: numbers from 1 to 150", {"camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "fov": 0}}),
                ("background .* is not legal", {"background": [2, 0, 0]}),
                ("ambient .* is not legal", {"ambient": "bright"}),
                ("materials 'm': brdf 'gouraud' is not known: lambert, phong, blinn_phong",
                 {"materials": {"m": {"brdf": "gouraud"}}}),
                ("lobe 'x' is not known", {"materials": {"m": {"lobe": "x"}}}),
                ("materials 'm': Kd .* is not legal", {"materials": {"m": {"Kd": [0, 0, 1.1]}}})):
            self.write("a.json", {**good, **change})
            self.refused(line, "render", "a.json", "-o", "a.png")
        self.write("a.json", "{\"objects\": [")
        self.refused("a.json is not JSON: parse error", "render", "a.json", "-o", "a.png")
        self.equal(self.files(), ["a.json", "a.obj"])


def render_options(parser):
    parser.add_argument("--rtl", action="store_true")
    parser.add_argument("--models", type=Path, default=Path("/usr/share/assimp/models"))


if __name__ == "__main__":
    main(render_options)
