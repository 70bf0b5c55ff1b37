#!/usr/bin/env python3
"""`glint cost --fpga` on the command line: refusals, the cache, tools that fail, the committed prices.

    cost_test.py --glint build/glint [Refusals Cache Failures Committed ...]

Exit status: 0 if every check held, 77 if the tools here are not those of the committed prices.
"""

import argparse
import json
import os
import shutil
import sys
import unittest

from case import Case, OPTIONS, ROOT

SMALL = ["--lobe", "quadratic", "--profile", "p8"]
RTL = ["--rtl", ROOT / "rtl"]


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
            ("--fpga", []),
            ("device 'hx9k' is not known: hx8k, up5k, ecp5-25k, xc7", ["--fpga", "--device", "hx9k"]),
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
            ("folder 'nowhere' has no glint_bps.v", ["--fpga", "--rtl", "nowhere"]),
            ("'missing/x.json' cannot be written", ["--fpga", "--json", "missing/x.json"]),
            ("--jobs '-1' is not legal", ["--fpga", "--jobs", "-1"]),
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
        with (rtl / "glint_quadratic.v").open("a") as file:
            file.write("// changed\n")
        self.cost(*small, "--rtl", "rtl", env=environment)
        self.equal(len(self.calls()), 1, "the unit alone")
        changed = json.loads(self.read("x.json"))["points"]
        was = json.loads(prices)["points"]
        self.equal(len(changed), 1)
        self.true(changed[0]["hash"] != was[0]["hash"], "another hash")
        self.equal({**changed[0], "hash": 0}, {**was[0], "hash": 0})


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


class Committed(Cost):
    def test_prices_are_those_of_the_verilog(self):
        committed = json.loads((ROOT / "cost" / "fpga.json").read_text())
        self.equal(committed["format"], "glint-cost-fpga-1")
        points = {(p["lobe"], p["profile"], p["architecture"], p["device"], p["dsp"]): p for p in committed["points"]}
        self.true(len(points) == len(committed["points"]) > 0, "points, each once")
        for price in points.values():
            seeds = sorted(price["clock_mhz_seeds"])
            if seeds:
                middle = len(seeds) // 2
                median = seeds[middle] if len(seeds) % 2 else (seeds[middle - 1] + seeds[middle]) / 2
                self.near(price["clock_mhz"], median, 0.011)
            # Every lobe has products; where DSPs may be used one holds at least one of them.
            if price["dsp"] and price["lobe"] != "table":
                self.true(price["dsps"] >= 1, f"no DSP: {price}")

        for device, exact in (("xc7", []), ("hx8k", ["--seeds", "1"])):
            self.cost(*SMALL, *RTL, "--device", device, "--json", f"{device}.json", *exact)
            found = json.loads(self.read(f"{device}.json"))
            for tool, version in found["tools"].items():
                if committed["tools"].get(tool) != version:
                    self.skipTest(f"the committed prices are of {tool} {committed['tools'].get(tool)}, not {version}")
            self.equal(len(found["points"]), 1)
            here = found["points"][0]
            there = points[tuple(here[name] for name in ("lobe", "profile", "architecture", "device", "dsp"))]
            for name in ("luts", "registers", "carries", "dsps", "brams", "latency", "interval"):
                self.equal(here[name], there[name], f"{device}: {name}")
            if here["clock_mhz_seeds"]:
                self.equal(here["clock_mhz_seeds"][0], there["clock_mhz_seeds"][0], f"{device}: clock of seed 1")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--glint", type=os.path.abspath, required=True)
    parser.add_argument("tests", nargs="*", help="classes, or Class.test_name; none: all")
    parser.parse_args(namespace=OPTIONS)
    loader = unittest.TestLoader()
    here = sys.modules[__name__]
    suite = loader.loadTestsFromNames(OPTIONS.tests, here) if OPTIONS.tests else loader.loadTestsFromModule(here)
    result = unittest.TextTestRunner(stream=sys.stdout).run(suite)
    print(f"{Case.count} checks in {result.testsRun} tests, {len(result.failures) + len(result.errors)} tests failed")
    if not result.wasSuccessful() or Case.count == 0:
        return 1
    return 77 if result.skipped else 0


if __name__ == "__main__":
    sys.exit(main())
