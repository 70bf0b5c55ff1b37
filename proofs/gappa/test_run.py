#!/usr/bin/env python3
"""Tests of run.py: what is sound passes, and each kind of fault is refused.

The environment names the command line tool: GLINT=build/release/glint.
"""

import json
import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
GLINT = os.environ.get("GLINT", "")


def run(*arguments):
    done = subprocess.run([sys.executable, str(HERE / "run.py"), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


class RunTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def emit(self, profile="p12", pieces=16):
        """A script as the model emits it, but with fewer pieces, which a test has no time for."""
        subprocess.run([GLINT, "emit", "--lobe", "bps", "--profile", profile, "--target", "proof", "-o", self.folder],
                       stdout=subprocess.DEVNULL, check=True)
        path = self.folder / f"glint_bps_{profile.replace(',', '_')}.g"
        self.edit(path, r"s in 256", f"s in {pieces}")
        return path

    def edit(self, path, pattern, replacement):
        text, count = re.subn(pattern, replacement, path.read_text())
        self.assertEqual(count, 1, f"{pattern} is not in the script once")
        path.write_text(text)

    def refused(self, path, message):
        status, out, _ = run(path)
        self.assertEqual(status, 1, out)
        self.assertRegex(out, f"FAILED: .*{message}")

    def measured(self, ulp, profile="p12", **more):
        path = self.folder / "measured.json"
        path.write_text(json.dumps({"runs": [
            {"lobe": "bps", "profile": profile, "test": "reset"},
            {"lobe": "bps", "profile": profile,
             "accuracy": {"total": {"inputs": 10, "rounding": {"max_ulp": ulp, **more}}}}]}))
        return path

    def test_sound_script_passes(self):
        output = self.folder / "proofs.json"
        status, out, err = run(self.emit(), "--json", output)
        self.assertEqual((status, err), (0, ""), out)
        proof, = json.loads(output.read_text())["proofs"]
        self.assertTrue(proof["ok"])
        self.assertGreater(proof["proven_ulp"], 0.5)
        self.assertLess(proof["proven_ulp"], 1.0)
        self.assertEqual(set(proof["ranges"]), {"D", "s", "quotient", "product_1", "h1", "product_2", "h2",
                                                "product_3", "sum_3", "y", "error"})
        self.assertEqual(proof["ranges"]["D"], [1.0, 1023.0])

    def test_corrupted_constants(self):
        for name in ("a_K", "b_K", "c1_K", "d0_K"):
            with self.subTest(name):
                script = self.emit()
                value = int(re.search(rf"(?m)^{name} = (-?\d+)b", script.read_text()).group(1))
                self.edit(script, rf"(?m)^{name} = -?\d+b", f"{name} = {value + 8}b")  # 8 * 2^-15: off by 1 ulp
                self.refused(script, "is not below 1")

    def test_too_few_guard_bits(self):
        self.refused(self.emit("18,12,12,12"), "is not below 1")

    def test_other_rounding(self):
        script = self.emit()
        self.edit(script, r"(?m)^@rnd_O = fixed<-12, nu>", "@rnd_O = fixed<-12, dn>")
        self.refused(script, "is not below 1")

    def test_equation_that_is_not_one(self):
        script = self.emit()
        self.edit(script, r"\+ \(b_K - b\) \+", "+")
        self.refused(script, "not trivially equal")

    def test_claim_that_does_not_hold(self):
        script = self.emit()
        self.edit(script, r"h1 in \[-3, 3\]", "h1 in [-3, 2]")
        self.refused(script, r"BND\(h1\)")

    def test_missing_hypothesis(self):
        script = self.emit()
        self.edit(script, r"C in \[0, 1\] /\\ ", "")
        self.refused(script, "no bound proven for D, s, quotient")

    def test_contradicting_hypotheses(self):
        script = self.emit()
        self.edit(script, r"C in \[0, 1\] /\\ ", r"C in [0, 1] /\\ C in [2, 3] /\\ ")
        self.refused(script, "pointless")

    def test_script_that_does_not_parse(self):
        script = self.emit()
        self.edit(script, r"sum_3 = product_3", "sum_3 = product_3 product_3")
        self.refused(script, "syntax error")

    def test_measured_error(self):
        script = self.emit()
        status, out, _ = run(script, "--measured", self.measured(0.7))
        self.assertEqual(status, 0, out)
        self.assertIn("0.7000", out)
        status, out, _ = run(script, "--measured", self.measured(0.99))
        self.assertEqual(status, 1)
        self.assertIn("the error measured, 0.990000 ulp, is above the proven", out)

    def test_error_of_some_real_s(self):
        status, out, _ = run(self.emit(), "--measured", self.measured(0.7, max_ulp_any_real_s=0.98))
        self.assertEqual(status, 1)
        self.assertIn("the error of some real s, 0.980000 ulp, is above the proven", out)

    def test_measured_error_of_another_profile(self):
        status, out, _ = run(self.emit(), "--measured", self.measured(0.7, "p16"))
        self.assertEqual(status, 1)
        self.assertIn("measured, but no proof here: bps p16", out)
        self.assertIn("FAILED: nothing measured could be compared", out)

    def test_no_script(self):
        status, out, _ = run(self.folder)
        self.assertEqual(status, 1)
        self.assertIn("FAILED: no script in", out)

    def test_no_gappa(self):
        status, out, err = run("--gappa", self.folder / "gappa")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("not found; install the package `gappa`", err)
        self.assertEqual(err.count("\n"), 1)

    def test_gappa_that_proves_nothing(self):
        silent = self.folder / "silent"
        silent.write_text("#!/bin/sh\nexit 0\n")
        silent.chmod(silent.stat().st_mode | stat.S_IXUSR)
        status, out, _ = run(self.emit(), "--gappa", silent)
        self.assertEqual(status, 1)
        self.assertIn("no bound proven for D, s, quotient", out)

    def test_bad_arguments(self):
        other = self.folder / "other.g"
        other.write_text("{ x in [0, 1] -> x in ? }\n")
        for arguments in ([self.folder / "none.g"], [other], [self.emit(), "--measured", other], ["--jobs", "0"]):
            with self.subTest(arguments):
                status, out, err = run(*arguments)
                self.assertEqual((status, out), (2, ""))
                self.assertEqual(err.count("\n"), 1, err)


if __name__ == "__main__":
    if not os.access(GLINT, os.X_OK):
        sys.exit("test_run.py: the environment variable GLINT has to name the command line tool")
    unittest.main(verbosity=2)
