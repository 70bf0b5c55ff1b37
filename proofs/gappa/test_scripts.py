#!/usr/bin/env python3
"""The committed scripts speak of the model: they are what it emits now, their arithmetic, followed in exact fractions,
gives the model's bits, and what Gappa proved of them holds at every input tried.

The environment names the command line tool, GLINT, and the proofs, PROOFS, a file that run.py --json wrote.
"""

import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
GLINT = os.environ.get("GLINT", "")
PROOFS = os.environ.get("PROOFS", "")
RANDOM_INPUTS = 2000


def rounding(bits, direction):
    """fixed<-bits, direction> of Gappa: to a multiple of 2^-bits, down or to the nearest with ties upwards."""
    half = {"dn": Fraction(0), "nu": Fraction(1, 2)}[direction]
    return lambda x: Fraction((x * 2**bits + half).__floor__(), 2**bits)


class Program:
    """The definitions of a script, ready to be evaluated."""

    def __init__(self, text):
        body = re.sub(r"#.*", "", text)
        self.environment = {"Fraction": Fraction}
        for name, bits, direction in re.findall(r"@(\w+) = fixed<-(\d+), (\w+)>;", body):
            self.environment[name] = rounding(int(bits), direction)
        definitions = re.findall(r"(?m)^(\w+) = ([^;]+);", body[:body.index("{")])
        self.steps = [(name, compile(self.python(expression), name, "eval")) for name, expression in definitions]
        # What the proof is given: `x in [low, high]` and `expression >= 0`; and, in a comment, of which n it speaks.
        given = body[body.index("{") + 1:body.index("->")].split("/\\")
        conditions = [re.sub(r"^(.*) in \[(.*), (.*)\]$", r"\2 <= \1 <= \3", item.strip()) for item in given]
        self.given = [compile(self.python(condition), condition, "eval") for condition in conditions]
        exponents = re.search(r"(?m)^# n: ([0-9., ]+)", text)
        self.exponents = [tuple(map(int, (part.split("..") * 2)[:2])) for part in
                          (exponents.group(1).strip(", ") if exponents else "1 .. 1023").split(",")]
        known = {"n", "C", *self.environment, *(name for name, _ in self.steps)}
        names = {name for condition in conditions for name in re.findall(r"[A-Za-z_]\w*", condition)}
        self.follows = names <= known  # else the proof is of more than n and C: it says of what

    @staticmethod
    def python(expression):
        def fraction(match):
            value = Fraction(match.group(1)) * Fraction(2) ** int(match.group(2) or 0)
            return f"Fraction({value.numerator}, {value.denominator})"
        return re.sub(r"(?<![\w.])(\d+(?:\.\d+)?)(?:b(-?\d+))?", fraction, expression)

    def values(self, n, C):
        known = dict(self.environment, n=Fraction(n), C=C)
        for name, code in self.steps:
            known[name] = eval(code, known)  # the scripts are our own
        return known

    def covers(self, n, values):
        """Whether the proof speaks of this input."""
        return (any(first <= n <= last for first, last in self.exponents)
                and all(eval(condition, values) for condition in self.given))


def inputs(F, seed):
    """Corners, and random inputs: half of them with C uniform, half with s = C / D uniform."""
    one = 2**F
    for n in (1, 2, 3, 8, 50, 1000, 1022, 1023):
        for code in (0, 1, 2, one // 2, one - 2, one - 1, one):
            yield n, code
    source = random.Random(seed)
    for i in range(RANDOM_INPUTS):
        n, code = source.randint(1, 1023), source.randint(0, one)
        yield n, code if i % 2 == 0 else n * code * one // (one + (n - 1) * code)


class ScriptsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        proofs = json.loads(pathlib.Path(PROOFS).read_text())["proofs"]
        cls.ranges = {proof["script"]: proof["ranges"] for proof in proofs}
        cls.scripts = sorted((HERE / "generated").glob("*.g"))
        if not cls.scripts:
            raise AssertionError("no script in proofs/gappa/generated")

    def header(self, text, name):
        return re.search(rf"(?m)^# {name}: (.+)$", text).group(1)

    def profile_argument(self, text):
        return self.header(text, "profile").replace("_", ",")

    def test_shipped_profiles_have_one(self):
        names = {script.name for script in self.scripts}
        self.assertLessEqual({"glint_bps_p8.g", "glint_bps_p12.g", "glint_bps_p16.g"}, names)

    def test_current(self):
        for script in self.scripts:
            with self.subTest(script.name), tempfile.TemporaryDirectory() as folder:
                text = script.read_text()
                subprocess.run([GLINT, "emit", "--lobe", self.header(text, "lobe"), "--profile",
                                self.profile_argument(text), "--target", "proof", "-o", folder],
                               stdout=subprocess.DEVNULL, check=True)
                self.assertEqual((pathlib.Path(folder) / script.name).read_text(), text)

    def test_says_what_the_model_does(self):
        apart = set()
        for script in self.scripts:
            with self.subTest(script.name):
                text = script.read_text()
                program = Program(text)
                lobe = self.header(text, "lobe")
                if not program.follows:
                    apart.add(lobe)
                    continue
                words = re.search(r"(?m)^# (F, .*O): (.+)$", text)
                F, O = (int(words.group(2).split(",")[i]) for i in (0, -1))
                points = list(inputs(F, seed=1))
                done = subprocess.run([GLINT, "eval", "--lobe", lobe, "--profile", self.profile_argument(text),
                                       "--stdin"], input="".join(f"{n} {code}\n" for n, code in points),
                                      stdout=subprocess.PIPE, text=True, check=True)
                model = list(map(int, done.stdout.split()))
                self.assertEqual(len(model), len(points))
                ranges = self.ranges[script.name]
                covered = 0
                for (n, code), y in zip(points, model):
                    values = program.values(n, Fraction(code, 2**F))
                    if not program.covers(n, values):
                        continue
                    covered += 1
                    self.assertEqual(min(max(0, values["y"]), 1) * 2**O, y, f"n {n}, cos code {code}")
                    for name, (low, high) in ranges.items():
                        value = values[name]
                        self.assertTrue(low <= value <= high, f"n {n}, cos code {code}: {name} = {float(value)}, "
                                                              f"proven {low} .. {high}")
                self.assertGreater(covered, len(points) // 50)
        # Their proofs are of any coefficients in given ranges, which are those of a table.
        self.assertLessEqual(apart, {"cubic"})


if __name__ == "__main__":
    if not os.access(GLINT, os.X_OK) or not os.path.isfile(PROOFS):
        sys.exit("test_scripts.py: the environment variable GLINT has to name the command line tool, and PROOFS a file "
                 "of run.py --json")
    unittest.main(verbosity=2)
