"""What the tests of the command lines share: a case in a folder of its own, that counts its checks."""

import argparse
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

OPTIONS = argparse.Namespace(glint=None, cosim=None, cosim_profiles=[])

# Fraction bits of each value that `bps` names in docs/contract.md.
BITS = {"C": "F", "D": "F", "quotient": "S", "h1": "K", "h2": "K", "y": "O"}
PROFILES = {
    "p8": dict(F=16, S=11, K=11, O=8),
    "p12": dict(F=18, S=15, K=15, O=12),
    "p16": dict(F=20, S=19, K=19, O=16),
    "18,14,14,12": dict(F=18, S=14, K=14, O=12),
    "30,30,30,28": dict(F=30, S=30, K=30, O=28),
}


class Case(unittest.TestCase):
    """A test in a folder of its own, which counts its checks: a test without any has failed."""

    count = 0

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run(self, result=None):
        def problems():
            return len(result.failures) + len(result.errors) + len(result.skipped)

        before = Case.count, problems()
        super().run(result)
        if (Case.count, problems()) == before:
            result.addFailure(self, (AssertionError, AssertionError("this test checked nothing"), None))

    def equal(self, got, want, what=None):
        Case.count += 1
        self.assertEqual(got, want, what)

    def true(self, holds, what):
        Case.count += 1
        self.assertTrue(holds, what)

    def near(self, got, want, distance):
        Case.count += 1
        self.assertLessEqual(abs(got - want), distance, f"{got} is not near {want}")

    def matches(self, text, pattern):
        Case.count += 1
        self.assertRegex(text, pattern)

    def run_tool(self, *arguments, tool=None, text=None, **settings):
        """Runs glint, or another tool, in the folder of the test."""
        command = [tool or OPTIONS.glint, *map(str, arguments)]
        if text is None:
            settings.setdefault("stdin", subprocess.DEVNULL)
        settings = {"stdout": subprocess.PIPE, "cwd": self.folder, "timeout": 120, **settings}
        return subprocess.run(command, stderr=subprocess.PIPE, text=True, input=text, **settings)

    def good(self, *arguments, **settings):
        """Exit status 0 and nothing on standard error; returns standard output."""
        done = self.run_tool(*arguments, **settings)
        self.equal((done.returncode, done.stderr), (0, ""), f"{arguments}")
        return done.stdout

    def refused(self, pattern, *arguments, **settings):
        """Exit status 2, no output, and one line on standard error that begins with the tool's name."""
        done = self.run_tool(*arguments, **settings)
        name = Path(settings.get("tool") or OPTIONS.glint).name
        self.equal((done.returncode, done.stdout or ""), (2, ""), f"{arguments}: {done.stderr}")
        self.matches(done.stderr, rf"\A{name}: [^\n]+\n\Z")
        self.matches(done.stderr, pattern)

    def fits_a_screen(self, text, example):
        lines = text.splitlines()
        self.true(len(lines) <= 40, f"{len(lines)} lines:\n{text}")
        self.true(max(map(len, lines)) <= 100, f"a line of {max(map(len, lines))} columns in\n{text}")
        self.true(f"\nExample: {example} " in text, f"no example in\n{text}")

    def files(self):
        """The files below the folder of the test."""
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if not path.is_dir())

    def read(self, name):
        return (self.folder / name).read_text()


def main(add_options=lambda parser: None):
    """Runs the tests of the program, those that the command line names or all, and ends it. 77: some were skipped."""
    module = sys.modules["__main__"]
    parser = argparse.ArgumentParser(description=module.__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--glint", type=os.path.abspath, required=True)
    add_options(parser)
    parser.add_argument("tests", nargs="*", help="classes, or Class.test_name; none: all")
    names = parser.parse_args(namespace=OPTIONS).tests
    loader = unittest.TestLoader()
    suite = loader.loadTestsFromNames(names, module) if names else loader.loadTestsFromModule(module)
    result = unittest.TextTestRunner(stream=sys.stdout).run(suite)
    print(f"{Case.count} checks in {result.testsRun} tests, {len(result.failures) + len(result.errors)} tests failed")
    sys.exit(1 if not result.wasSuccessful() or Case.count == 0 else 77 if result.skipped else 0)
