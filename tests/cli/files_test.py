"""What `glint vectors` and `glint emit` write, and what happens where a file cannot be written."""

import itertools
import json
import os
import re
import resource
import signal
import stat

from case import Case, PROFILES, ROOT


class Vectors(Case):
    def vectors(self, format, count=500, seed=1, profile="p12", folder=None):
        """The bytes of the vector file, and its manifest."""
        folder = self.folder / (folder or f"{format}-{count}-{seed}-{profile}")
        text = self.good("vectors", "--lobe", "bps", "--profile", profile, "--count", count, "--seed", seed,
                         "--format", format, "-o", folder)
        name = f"glint_bps_{profile.replace(',', '_')}"
        self.equal(sorted(path.name for path in folder.iterdir()), sorted([f"{name}.json", f"{name}.{format}"]))
        self.equal(text, f"{folder}/{name}.{format}: {count} vectors, seed {seed}\n")
        return (folder / f"{name}.{format}").read_bytes(), json.loads((folder / f"{name}.json").read_text())

    def test_deterministic(self):
        for format in ("tv", "csv", "hex"):
            first, manifest = self.vectors(format, folder="a")
            again, same_manifest = self.vectors(format, folder="b")
            self.true(first == again, "the same seed gives the same bytes")
            del manifest["command"], same_manifest["command"]  # which names the folder
            self.equal(manifest, same_manifest)
            other = self.vectors(format, seed=2)[0]
            corners = manifest["corners"] + (format == "csv")
            lines, others = first.splitlines(), other.splitlines()
            self.equal(lines[:corners], others[:corners])
            differing = sum(a != b for a, b in zip(lines[corners:], others[corners:]))
            self.true(differing > 350, f"another seed gives other vectors: {differing} of {len(lines) - corners}")
            longer = self.vectors(format, count=600)[0]
            self.true(longer.startswith(first), "more vectors begin with the same ones")
            for folder in ("a", "b"):
                for path in (self.folder / folder).iterdir():
                    path.unlink()

    def test_formats_agree(self):
        for profile, bits in PROFILES.items():
            lines = self.vectors("tv", profile=profile)[0].decode().splitlines()
            tv = [tuple(map(int, line.split())) for line in lines]
            header, *lines = self.vectors("csv", profile=profile)[0].decode().splitlines()
            self.equal(header, "n,cos_code,y,clamped")
            self.equal([tuple(map(int, line.split(","))) for line in lines], tv)
            words = self.vectors("hex", profile=profile)[0].decode().splitlines()
            packed = [(code % (1 << 32)) << 64 | n << 48 | clamped << 32 | y for n, code, y, clamped in tv]
            self.equal(words, [f"{word:024x}" for word in packed])
            one = 1 << bits["F"]
            self.equal(len(tv), 500)
            for n, code, y, clamped in tv:
                self.true(0 <= n <= 1023 and -2 * one <= code < 2 * one and 0 <= y <= 1 << bits["O"], f"{n} {code} {y}")
                self.equal(clamped, int(n == 0 or code < 0 or code > one))
            self.true({0, 1} == {vector[3] for vector in tv}, "legal inputs and others")

    def test_manifest(self):
        for format, profile in (("hex", "p8"), ("tv", "18,14,14,12")):
            manifest = self.vectors(format, count=300, seed=9, profile=profile)[1]
            name = profile.replace(",", "_")
            self.equal({key: manifest[key] for key in manifest if key not in ("command", "version", "corners")},
                       {"file": f"glint_bps_{name}.{format}", "format": format, "lobe": "bps", "profile": name,
                        "F": PROFILES[profile]["F"], "O": PROFILES[profile]["O"], "count": 300, "seed": 9})
            self.true(0 < manifest["corners"] < 300, f"{manifest}")
            self.matches(manifest["command"], rf"^glint\S* vectors .*--profile {profile} .*--seed 9 ")
            self.equal(manifest["version"], self.good("--version").strip())

    def test_corners_alone(self):
        corners = self.vectors("tv")[1]["corners"]
        lines = self.vectors("tv", count=corners)[0].decode().splitlines()
        self.equal(len(lines), corners)
        seen = {tuple(map(int, line.split()[:2])) for line in lines}
        for n, code in itertools.product((0, 1, 2, 50, 1023), (-524288, -1, 0, 1, 262143, 262144, 262145, 524287)):
            self.true((n, code) in seen, f"{n} {code} is a corner")

    def test_effect(self):
        self.good("vectors", "--effect", "blinn_phong", "--lobe", "cayley", "--profile", "p8,p12", "--count", "400",
                  "--format", "csv", "-o", self.folder)
        for profile in ("p8", "p12"):
            name = f"glint_effect_blinn_phong_{profile}"
            manifest = json.loads((self.folder / f"{name}.json").read_text())
            self.equal([manifest[key] for key in ("effect", "lobe", "profile", "count")],
                       ["blinn_phong", "cayley", profile, 400])
            header, *lines = (self.folder / f"{name}.csv").read_text().splitlines()
            self.equal(header.split(","), manifest["fields"])
            self.equal(len(lines), 400)
        self.refused("effect 'frob' is not known", "vectors", "--effect", "frob")


class Emit(Case):
    COMMITTED = {"hls": "hls/generated", "proof": "proofs/gappa/generated"}

    def test_committed(self):
        """What is committed is what the tool emits: every file, and no other."""
        for target, folder in self.COMMITTED.items():
            committed = {path.name: path.read_text() for path in (ROOT / folder).iterdir()}
            pattern = re.compile(r"glint_(\w+?)_(?:axis_)?(p\d+|\d+(?:_\d+)+)(?:_constants)?\.\w+")
            names = {pattern.fullmatch(name).groups() for name in committed}
            self.true({("bps", "p8"), ("bps", "p12"), ("bps", "p16")} <= names, f"{folder}: {names}")
            for lobe, name in names:
                profile = name.replace("_", ",")
                choice = ["--lobe", lobe]
                if lobe.startswith("effect_"):
                    choice = ["--effect", lobe.removeprefix("effect_").removesuffix("_bps")]
                self.good("emit", *choice, "--profile", profile, "--target", target, "-o", target)
            emitted = {path.name: path.read_text() for path in (self.folder / target).iterdir()}
            self.equal(sorted(committed), sorted(emitted), folder)
            for name, text in emitted.items():
                self.true(committed[name] == text, f"{folder}/{name} is not what `glint emit` writes")

    def test_manifest(self):
        """The committed manifest and lists are what the tool writes; that of a folder names what is there."""
        self.good("emit", "--committed", "-o", "rtl")
        names = self.files()
        self.equal(names, sorted(["rtl/units.json", *(f"rtl/generated/{path.name}" for path in (ROOT / "rtl/generated").iterdir())]))
        for name in names:
            self.true(self.read(name) == (ROOT / name).read_text(), f"{name} is not what `glint emit --committed` writes")
        self.good("emit", "--effect", "shade", "--lobe", "cubic", "-o", "out")
        manifest = json.loads(self.read("out/units.json"))
        self.true({"glint_effect_shade_cubic_p12", "glint_effect_phong_cubic_p12", "glint_cubic_p12"} <=
                  {unit["name"] for unit in manifest["units"]}, "the parts of a unit are units")
        for unit in manifest["units"]:
            for file in unit["files"]:
                path = ROOT / file.replace("$(GLINT_RTL)", "rtl") if "$" in file else self.folder / "out" / file
                self.true(path.is_file(), f"{unit['name']}: no {file}")
            self.true(f"$(GLINT_EMITTED)/{unit['name']}.v" in self.read(f"out/{unit['name']}.f").splitlines(), unit["name"])

    def test_packages(self):
        """A core and a VHDL package for each unit of the manifest, Bender.yml as the manifest; beside a wrapper, too."""
        self.good("emit", "--packages", "-o", "rtl")
        names = self.files()
        for unit in json.loads((ROOT / "rtl/units.json").read_text())["units"]:
            for name in (f"rtl/{unit['name']}.core", f"rtl/generated/{unit['name']}_pkg.vhd"):
                self.true(name in names, f"no {name}")
        bender = [line.removeprefix("  - ") for line in self.read("rtl/Bender.yml").splitlines() if line.startswith("  - ")]
        units = json.loads((ROOT / "rtl/units.json").read_text())["units"]
        self.equal(sorted(bender), sorted({file for unit in units for file in unit["files"]}))
        self.true(all((ROOT / "rtl" / name).is_file() for name in bender), "Bender.yml names a file that is not there")
        self.good("emit", "--lobe", "bps", "--profile", "18,14,14,12", "--target", "verilog", "-o", "out")
        self.true({"out/glint_bps_18_14_14_12.core", "out/glint_bps_18_14_14_12_pkg.vhd"} <= set(self.files()), "beside a wrapper")

    def test_list(self):
        text = self.good("emit", "--lobe", "bps", "--profile", "p8,p12,p16", "-o", "out")
        self.equal(sorted(text.splitlines()), self.files())
        self.equal(len(self.files()), 15 + 3 * 6 + 1)

    def test_targets(self):
        every = {"verilog": [*(f"glint_bps_{name}{end}" for name in ("axis_p12", "p12") for end in (".core", ".f", ".v", "_pkg.vhd")), "units.json"],
                 "hls": ["glint_bps_p12.cpp", "glint_bps_p12_constants.hpp"],
                 "proof": ["glint_bps_p12.g"]}
        self.good("emit", "--target", "all", "-o", "all")
        self.equal(self.files(), sorted(f"all/{name}" for names in every.values() for name in names))
        for target, names in every.items():
            self.good("emit", "--target", target, "-o", target)
            self.equal(sorted(path.name for path in (self.folder / target).iterdir()), sorted(names))
            for name in names:
                self.true(self.read(f"{target}/{name}") == self.read(f"all/{name}"), name)

    def test_custom(self):
        """The bound is measured where that takes seconds, and else said not to be shown."""
        for profile, inputs in (("8,4,7,4", 1023 * 257), ("10,12,13,9", 1023 * 1025), ("30,30,30,28", None)):
            name = profile.replace(",", "_")
            text = self.good("emit", "--profile", profile, "-o", "out")
            bound = rf"\d\.\d+ ulp, measured over all {inputs} inputs" if inputs else r"not shown \(.*\)"
            self.matches(text, rf"\nbps {profile}: rounding error {bound}\n\Z")
            names = (f"{name}.v", f"axis_{name}.v", f"{name}_constants.hpp", f"{name}.cpp", f"{name}.g")
            lists = ["units.json", f"glint_bps_{name}.f", f"glint_bps_axis_{name}.f",
                     *(f"glint_bps_{unit}{name}{end}" for unit in ("", "axis_") for end in (".core", "_pkg.vhd"))]
            self.equal(text.splitlines()[:-1], [f"out/{file}" for file in [f"glint_bps_{ending}" for ending in names] + lists])
            F, _, _, O = map(int, profile.split(","))
            wrapper = self.read(f"out/glint_bps_{name}.v")
            self.matches(wrapper, rf"\nmodule glint_bps_{name} #\(")
            self.matches(wrapper, rf"input  wire +\[{F + 1}:0\] cos_i,")
            self.matches(wrapper, rf"output wire +\[{O}:0\] y_o,")
            self.true(f"glint emit --lobe bps --profile {profile}`" in wrapper, "the wrapper names its command")

    def test_again(self):
        """Over files that are there, which are replaced."""
        self.good("emit", "-o", ".")
        first = {name: self.read(name) for name in self.files()}
        for name in first:
            (self.folder / name).write_text("old")
        self.good("emit", "-o", ".")
        self.equal({name: self.read(name) for name in self.files()}, first)


class Files(Case):
    """An output file is written whole or not at all, and nothing else is left behind."""

    OUTPUTS = (
        (("sweep", "--n", "1:300", "--cos", "0:9", "--csv"), "out.csv"),
        (("sweep", "--n", "1:300", "--cos", "0:9", "--json"), "out.json"),
    )

    def test_is_a_folder(self):
        for command, name in self.OUTPUTS:
            (self.folder / name).mkdir()
            self.refused(f"'{name}' cannot be written", *command, name)
        for name in ("glint_bps_p12.tv", "glint_bps_p12.v"):
            (self.folder / name).mkdir()
        self.refused("'./glint_bps_p12.tv' cannot be written", "vectors")
        self.refused("'./glint_bps_p12.v' cannot be written", "emit")
        self.equal(self.files(), [])

    def test_no_folder(self):
        for command, name in self.OUTPUTS:
            self.refused(f"'missing/{name}' cannot be written", *command, f"missing/{name}")
        (self.folder / "file").write_text("old")
        for command in (("vectors",), ("emit",)):
            self.refused("folder 'file'", *command, "-o", "file")
            self.refused("folder 'file/below'", *command, "-o", "file/below")
        self.equal(self.files(), ["file"])

    def test_no_space(self):
        """A write that fails half-way, here at a limit of 4096 bytes, leaves what was there before."""

        def limited():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        commands = [((*command, name), name) for command, name in self.OUTPUTS]
        commands.append((("vectors",), "./glint_bps_p12.tv"))
        for old, (command, name) in itertools.product((None, "old\n"), commands):
            if old:
                (self.folder / name).write_text(old)
            self.refused(f"'{name}' cannot be written", *command, preexec_fn=limited)
            self.equal(self.files(), [os.path.normpath(name)] if old else [])
            if old:
                self.equal(self.read(name), old)
                (self.folder / name).unlink()
            self.good(*command)  # without the limit it is more than 4096 bytes
            self.true((self.folder / name).stat().st_size > 4096, name)
            for left in self.files():
                (self.folder / left).unlink()

    def test_pipe(self):
        """A pipe, as from `--csv /dev/stdout`, is written to and not replaced."""
        for command, name in self.OUTPUTS:
            os.mkfifo(self.folder / name)
            reader = os.open(self.folder / name, os.O_RDWR | os.O_NONBLOCK)
            try:
                self.good("sweep", "--n", "1", "--cos", "0:9", command[-1], name)
                self.true(stat.S_ISFIFO((self.folder / name).stat().st_mode), f"{name} is still a pipe")
                self.true(b"bps" in os.read(reader, 65536), f"{name} has the results")
            finally:
                os.close(reader)

    def test_standard_output(self):
        """Where standard output cannot take what is written, exit status 0 would be a lie."""
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        commands = [(("eval", "--n", "1", "--cos", "1"), None), (("eval", "--stdin"), "1 2\n"),
                    (("eval", "--stdin"), "1 2\n" * 300000), (("sweep", "--n", "1", "--cos", "0:9"), None)]
        for command, text in commands:
            with open("/dev/full", "w") as full:
                self.refused("standard output", *command, text=text, stdout=full)
