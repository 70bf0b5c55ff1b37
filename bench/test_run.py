#!/usr/bin/env python3
"""Tests of bench/run.py, glint-bench and glint-bench-models, and of the committed cost/data/cpu.json and
cost/data/cpu-models.json. None depends on a time.

Without Valgrind the tests of instruction counts are skipped, with the reason.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
OPTIONS = argparse.Namespace(bench=None, models=None)
LOBES = {unit["lobe"] for unit in json.loads((ROOT / "rtl/units.json").read_text())["units"]
         if unit["kind"] == "lobe"}
MODELS = re.findall(r'string_view name = "(\w+)"', (ROOT / "studies/lighting.hpp").read_text())
needs_valgrind = unittest.skipUnless(shutil.which("valgrind"), "Valgrind not found; install the package `valgrind`")


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    bench = property(lambda self: OPTIONS.bench)  # the program that the case is about

    def run_py(self, *arguments, bench=True):
        command = [sys.executable, HERE / "run.py", *(["--bench", self.bench] if bench else []), *arguments]
        return subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=250, cwd=self.folder)

    def good(self, *arguments):
        done = self.run_py(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def refused(self, pattern, *arguments, **settings):
        done = self.run_py(*arguments, **settings)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertRegex(done.stderr, rf"\Abench/run\.py: [^\n]*{pattern}[^\n]*\n\Z")
        self.assertEqual(list(self.folder.iterdir()), [], "a file was left behind")

    def described(self):
        return json.loads(subprocess.run([self.bench, "--describe"], check=True, stdout=subprocess.PIPE).stdout)


class Committed:
    """A file of prices is whole, and of the functions of this project."""

    def setUp(self):
        super().setUp()
        self.file = json.loads((ROOT / "cost/data" / self.name).read_text())
        self.points = self.file["points"]

    def test_schema(self):
        described = self.described()
        self.assertEqual(self.file["format"], described["format"])
        self.assertEqual(self.file["inputs"], described["inputs"])
        for key in ("cpu", "compiler", "flags", "library", "valgrind", "date"):
            self.assertTrue(isinstance(self.file["machine"][key], str) and self.file["machine"][key], key)
        self.assertRegex(self.file["machine"]["date"], r"\A\d{4}-\d\d-\d\d\Z")
        self.assertGreaterEqual(self.file["repetitions"], 9)
        for point in self.points:
            self.assertIn(point["type"], self.types, point)
            self.assertIn(point["form"], ("scalar", "batch"), point)
            self.assertEqual(point.get("profile"), "p12" if point["type"] == "fixed" else None, point)
            self.assertTrue(0 < point["throughput_q1_ns"] <= point["throughput_ns"] <= point["throughput_q3_ns"], point)
            self.assertGreater(point["instructions"], 0, point)
            if point["form"] == "batch":
                self.assertIsNone(point["latency_ns"], point)
            else:
                self.assertTrue(0 < point["latency_q1_ns"] <= point["latency_ns"] <= point["latency_q3_ns"], point)
        self.assertEqual(sorted(self.file["dependency_ns"]), sorted(self.types))
        for kind in self.types:
            self.assertGreater(self.file["dependency_ns"][kind], 0)

    def test_current(self):
        """The functions of the file are some of this build, but for what a build may lack."""
        def keys(entries):
            return {(entry[self.subject], entry["type"], entry["form"], entry["formula"]) for entry in entries
                    if "libmvec" not in entry[self.subject]}

        self.assertLessEqual(keys(self.points), keys(self.described()["cases"]))


class CommittedLobes(Committed, Case):
    name, subject, types = "cpu.json", "lobe", ("double", "float", "fixed")

    def test_whole(self):
        there = [(point["lobe"], point["type"], point["form"]) for point in self.points]
        self.assertGreater(len(there), 80)
        self.assertEqual(len(there), len(set(there)), "a point stands twice")
        self.assertGreater(len(LOBES), 0)
        for lobe in LOBES & {point["lobe"] for point in self.points}:  # `glint cost --check` names the others
            for kind in ("double", "float", "fixed"):
                for form in ("scalar", "batch"):
                    self.assertIn((lobe, kind, form), there)
        for rival in ("pow", "pow_integer", "exp_log", "squaring"):
            self.assertIn((rival, "float", "scalar"), there)
        self.assertIn(("pow_libmvec", "double", "batch"), there)


class CommittedModels(Committed, Case):
    name, subject, types = "cpu-models.json", "model", ("double", "float")
    bench = property(lambda self: OPTIONS.models)

    def test_whole(self):
        """Each model of studies/lighting.hpp, of which the paper's five are some, once in each type."""
        self.assertLess({"lambert", "phong", "blinn_phong", "cook_torrance", "ward", "oren_nayar", "modified_angle"}, set(MODELS))
        self.assertEqual(sorted((point["model"], point["type"], point["form"]) for point in self.points),
                         sorted((model, kind, "scalar") for model in MODELS for kind in self.types))


class Counts(Case):
    FEW = r"^(schlick|bps|pow)/(double|float)/|^bps/fixed/"

    def counts(self, name, only=FEW):
        self.good("--counts-only", "--only", only, "--json", name)
        points = json.loads((self.folder / name).read_text())["points"]
        return {(point["lobe"], point["type"], point["form"]): point["instructions"] for point in points}

    @needs_valgrind
    def test_repeat(self):
        """Exactly, from run to run, and whatever else is counted in the same run."""
        counts = self.counts("first.json")
        self.assertEqual(len(counts), 14)
        self.assertEqual(self.counts("second.json"), counts)
        alone = self.counts("alone.json", "^bps/double/batch$")
        self.assertEqual(alone, {("bps", "double", "batch"): counts["bps", "double", "batch"]})

    @needs_valgrind
    def test_plausible(self):
        """At least an instruction for each operation of the formula; vector instructions do several at once."""
        counts = self.counts("counts.json")
        self.assertGreaterEqual(counts["schlick", "double", "scalar"], 1 + 1 + 2)
        self.assertGreaterEqual(counts["bps", "double", "scalar"], 4 + 1 + 4 + 1 + 1)
        self.assertGreater(counts["pow", "double", "scalar"], 2 * counts["bps", "double", "scalar"])
        for lobe in ("schlick", "bps"):
            self.assertLess(counts[lobe, "double", "batch"], counts[lobe, "double", "scalar"] / 2)
            self.assertLess(counts[lobe, "float", "batch"], counts[lobe, "double", "batch"])

    def test_without_valgrind(self):
        done = self.good("--valgrind", "./none", "--only", "^schlick/double/batch$", "--json", "times.json",
                         "--repetitions", "3", "--min-time", "0.001")
        self.assertRegex(done.stderr, r"\Ainstruction counts: OFF \('\./none' not found; install the package `valgrind`\)\n\Z")
        (point,) = json.loads((self.folder / "times.json").read_text())["points"]
        self.assertEqual((point["lobe"], point["instructions"], point["latency_ns"]), ("schlick", None, None))
        self.assertGreater(point["throughput_ns"], 0)
        self.assertRegex(done.stdout, r"(?m)^schlick/double/batch +\d")


class ModelCounts(Case):
    bench = property(lambda self: OPTIONS.models)

    @needs_valgrind
    def test_plausible(self):
        """At least an instruction for each operation of the formula; the modified form in N.H has fewer than the full one."""
        self.good("--counts-only", "--json", "models.json")
        results = json.loads((self.folder / "models.json").read_text())
        self.assertEqual(results["format"], "glint-cost-cpu-models-1")
        counts = {(point["model"], point["type"]): point["instructions"] for point in results["points"]}
        self.assertEqual(len(counts), 2 * len(MODELS))
        for kind in ("double", "float"):
            for model in set(MODELS) - {"lambert"}:
                self.assertGreater(counts[model, kind], counts["lambert", kind], model)
            self.assertGreaterEqual(counts["lambert", kind], 8)
            self.assertGreaterEqual(counts["modified_half", kind], 47)
            self.assertLess(counts["modified_half", kind], counts["cook_torrance", kind])

    def test_times(self):
        self.good("--valgrind", "./none", "--only", "^(lambert|cook_torrance)/double/", "--json", "times.json",
                  "--repetitions", "3", "--min-time", "0.001")
        points = json.loads((self.folder / "times.json").read_text())["points"]
        self.assertEqual([point["model"] for point in points], ["lambert", "cook_torrance"])
        for point in points:
            self.assertTrue(point["throughput_ns"] > 0 and point["latency_ns"] > 0, point)


class Vectors(Case):
    @unittest.skipUnless(shutil.which("nm"), "nm not found; install the package `binutils`")
    def test_libmvec(self):
        """What is said to run on libmvec calls its vector functions of pow, in double and in float."""
        if "pow_libmvec" not in {case["lobe"] for case in self.described()["cases"]}:
            self.skipTest("this build is without libmvec")
        symbols = subprocess.run(["nm", "-D", "-u", OPTIONS.bench], check=True, stdout=subprocess.PIPE, text=True).stdout
        for name in ("pow", "powf"):
            self.assertRegex(symbols, rf"\b_ZGV[bcde]N\d+vv_{name}\b")


class Refusals(Case):
    def test_run(self):
        self.refused("the following arguments are required: --bench", bench=False)
        self.refused(r"--bench './none' is not legal", "--bench", "./none", bench=False)
        self.refused(r"--only 'nothing' is not legal", "--only", "nothing")
        self.refused(r"'\[' is not legal: a regular expression", "--only", "[")
        self.refused("'2' is not legal: a whole number, 3 to 1000", "--repetitions", "2")
        self.refused("'0' is not legal: seconds, 0.001 to 10", "--min-time", "0")
        self.refused("--json 'none/cpu.json' is not legal: its folder does not exist", "--json", "none/cpu.json")
        self.refused("--counts-only: './none' not found", "--counts-only", "--valgrind", "./none")
        self.refused("unrecognized arguments: --color", "--color")

    def test_bench(self):
        for program in (OPTIONS.bench, OPTIONS.models):
            name = Path(program).name
            for arguments, pattern in ((("--passes", "0"), f"{name}: --passes '0' is not legal: a whole number, 1 to 1000"),
                                       (("--passes",), "--passes '' is not legal"),
                                       (("--passes", "1", "bps"), f"{name}: 'bps' is not legal: a name that --describe lists"),
                                       (("--none",), "none")):
                done = subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertRegex(done.stderr, pattern)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    for program in ("bench", "models"):
        parser.add_argument(f"--{program}", required=True, type=lambda text: str(Path(text).resolve()), metavar="FILE",
                            help=f"the program glint-bench{'-models' if program == 'models' else ''}")
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], "-v", *rest])
