#!/usr/bin/env python3
"""examples/sphere by its own script, in a copy of what it reads.

    sphere_test.py --library FOLDER Quick|Pictures|Icebreaker|Ulx3s        where libglint-c.so is
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = ""


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        for part in ("examples/sphere", "rtl", "model/include"):
            shutil.copytree(ROOT / part, self.tree / part)

    def make(self, *arguments):
        tools = f"{os.environ['PATH']}:{ROOT}/build/venv/bin"
        return subprocess.run([self.tree / "examples/sphere/make.sh", *arguments], capture_output=True, text=True, check=False,
                              env={**os.environ, "GLINT_LIBRARY": LIBRARY, "PATH": tools})

    def simulate(self, board, pictures):
        done = self.make("simulate", board, str(pictures))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        words = " and as many words of DVI" if board.startswith("ulx3s") else ""
        self.assertEqual(done.stdout, f"{pictures} pictures, {pictures * 420000} clocks{words}: 0 differ\n")
        for number in range(pictures):
            png = (self.tree / f"build/sphere/{board}/sphere{number}.png").read_bytes()
            self.assertEqual(png[:8] + png[16:24], b"\x89PNG\r\n\x1a\n" + (640).to_bytes(4, "big") + (480).to_bytes(4, "big"))


class Quick(Case):
    def test_a_picture(self):
        self.simulate("ulx3s-85k", 1)

    def test_arguments(self):
        for arguments in ((), ("simulate",), ("simulate", "ulx3s-85k", "1", "2"), ("ulx3s-12k",), ("icebreaker", "1")):
            done = self.make(*arguments)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
        self.assertIn("ulx3s-85k, ulx3s-25k or icebreaker", self.make("--help").stdout)


class Pictures(Case):
    def test_every_material(self):
        for board in ("ulx3s-85k", "ulx3s-25k", "icebreaker"):
            self.simulate(board, 8)

    def test_faults_are_found(self):
        # The turn, which starts with the second picture; the balance of DVI; one material of four.
        for file, text, fault, pictures in (("sphere_turn.v", "y_q + (x_q", "y_q - (x_q", 3),
                                            ("ulx3s/sphere_tmds.v", "wire              flip = even", "wire flip = 1'b1 | even", 1),
                                            ("sphere_material.v", "{4'd0, digit[3]}", "{4'd0, &digit}", 3)):
            path = self.tree / "examples/sphere" / file
            whole = path.read_text()
            self.assertEqual(whole.count(text), 1, file)
            path.write_text(whole.replace(text, fault))
            done = self.make("simulate", "ulx3s-25k", str(pictures))
            self.assertEqual(done.returncode, 1, f"{file}: {done.stdout}{done.stderr}")
            self.assertRegex(done.stderr, "bench: ", file)
            path.write_text(whole)


class Board(Case):
    def bitstream(self, clocks, *arguments):
        done = self.make(*arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        *_, name = done.stdout.split()
        self.assertGreater((self.tree / name).stat().st_size, 50000)
        passed = re.findall(r"^Max frequency for clock .*\(PASS at ([\d.]+) MHz\)$", done.stdout, re.MULTILINE)
        self.assertEqual(sorted(passed), sorted(clocks), done.stdout)

    def need(self, *tools):
        for tool in tools:
            if not any(shutil.which(name, path=f"{os.environ['PATH']}:{ROOT}/build/venv/bin") for name in (tool, f"yowasp-{tool}")):
                self.skipTest(f"there is no {tool}")


class Icebreaker(Board):
    def test_bitstream(self):
        self.need("yosys", "nextpnr-ice40", "icepack")
        self.bitstream(["25.12"], "icebreaker")


class Ulx3s(Board):
    def test_bitstream(self):
        self.need("yosys", "nextpnr-ecp5", "ecppack")
        for board in ("ulx3s-25k", "ulx3s-85k"):
            self.bitstream(["25.00", "125.00"], board)


if __name__ == "__main__":
    if sys.argv[1:2] != ["--library"]:
        sys.exit("sphere_test.py: --library FOLDER is wanted")
    LIBRARY = str(Path(sys.argv[2]).resolve())
    result = unittest.main(argv=sys.argv[:1] + sys.argv[3:], exit=False).result
    for _, reason in result.skipped:
        print(f"skipped: {reason}")
    sys.exit(1 if not result.wasSuccessful() or result.testsRun == 0 else 77 if result.skipped else 0)
