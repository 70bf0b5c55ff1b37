#!/usr/bin/env python3
"""How `glint` and `glint-cosim` behave on the command line: what they print, write, refuse, and with which exit status.

    cli_test.py --glint build/glint [--cosim build/glint-cosim --cosim-profile p8 ...] [Help Eval ...]

What the numbers are is for other tests; here they are compared with each other. Exit status: 0 if every check held.
"""

import csv
import itertools
import json
import os
import re
import xml.etree.ElementTree
from pathlib import Path

from case import BITS, Case, OPTIONS, PROFILES, main
from arguments_test import Arguments, Stdin  # noqa: F401, chosen by name
from files_test import Emit, Files, Vectors  # noqa: F401, chosen by name
from failures_test import Failures  # noqa: F401, chosen by name
from choose_test import Choose, Cost, Prices  # noqa: F401, chosen by name
from report_test import Report, Study  # noqa: F401, chosen by name
from shards_test import Shards  # noqa: F401, chosen by name


class Variants(Case):
    def test_real_function_of_the_variant(self):
        """The real function beside a result is that of the model, whatever its profile and options make of the lobe."""
        for lobe, profile in (("cayley", "18,2,18,12"), ("cosine_power", "18,2,16,12"),
                              ("polynomial:symmetric:0:0.5:0.5", "p12"), ("taylor", "p12"), ("bps", "18,14,14,12")):
            for n, code in ((1, 131072), (50, 256901), (1000, 262100)):
                text = self.good("eval", "--lobe", lobe, "--profile", profile, "--n", n, "--cos-code", code, "--json",
                                 "eval.json")
                found = json.loads(self.read("eval.json"))
                self.true(abs(found["y"] / 2**12 - found["real"]) < 2**-12, f"{lobe} {profile}: {text}")
                self.equal(found["values"][-1]["code"], found["y"])

    def test_output_is_checked_first(self):
        self.refused("file 'none/out.json' cannot be written", "sweep", "--profile", "p16", "--json", "none/out.json")
        self.refused("file 'none/out.csv' cannot be written", "sweep", "--profile", "p16", "--csv", "none/out.csv")


class Fit(Case):
    def test_published(self):
        """The regression of the paper, from its own data set: its coefficients to the digits printed there."""
        for method in ("least-squares", "qr"):
            text = self.good("fit", "--method", method, "--json", "fit.json")
            found = json.loads((self.folder / "fit.json").read_text())
            self.equal(found["rows"], 1571000)
            self.equal([f"{found['coefficients'][0]:.6f}"] + [f"{x:.3f}" for x in found["coefficients"][1:]],
                       ["0.002737", "-0.374", "2.995", "-1.631"])
            for x in found["coefficients"]:
                self.true(f"{x:.9g}" in text, f"{x} in {text}")

    def test_refusals(self):
        for arguments, line in (
                (("--variable", "phong"), "variable 'phong' is not legal"),
                (("--method", "remez"), "method 'remez' is not legal"),
                (("--degree", "9"), "--degree"),
                (("--degree", "1", "--zero-at-0", "--one-at-1"), "degree 1"),
                (("--n", "0:3"), "--n '0:3' is not legal"),
                (("--theta", "0:2:0.1"), "--theta '0:2:0.1' is not legal"),
                (("--n", "5", "--theta", "0.5"), "do not determine")):
            self.refused(line, "fit", *arguments)


class Help(Case):
    def subcommands(self):
        text = self.good("--help")
        return re.findall(r"^  (\w+) ", text.split("Subcommands:\n")[1], re.MULTILINE)

    def test_glint(self):
        names = self.subcommands()
        self.true({"eval", "sweep", "vectors", "emit"} <= set(names), f"{names}")
        for name in names:
            text = self.good(name, "--help")
            self.fits_a_screen(text, f"glint {name}")
            self.equal(self.good(name, "-h"), text)

    def test_version(self):
        self.matches(self.good("--version"), r"\A\d+\.\d+\.\d+\n\Z")

    def test_examples(self):
        """The examples are commands that work; that of sweep, with fewer inputs."""
        (self.folder / "docs").mkdir()
        names = self.subcommands()
        for name in ("eval", "sweep", "vectors", "cases"):
            self.true(name in names, f"{name} in {names}")
            example = re.search(r"^Example: glint (.*)$", self.good(name, "--help"), re.MULTILINE)[1]
            example = example.replace("1:1000", "50:51").replace("--cos all", "--cos 0:100")
            self.good(*example.split())
        written = ["docs/hard-cases.md", "out.csv", "vectors/glint_bps_p12.json", "vectors/glint_bps_p12.tv"]
        self.equal(self.files(), written)


class Refusals(Case):
    """One line that says which argument, its value, and what is legal."""

    def test_subcommands(self):
        self.refused("subcommand", *[])
        self.refused("frob", "frob")
        self.refused("--frob", "eval", "--frob")
        self.refused("--frob", "sweep", "--frob", "3")
        self.refused("extra", "vectors", "extra")

    def test_lobe_and_profile(self):
        for command in (("eval", "--n", 1, "--cos", 1), ("sweep", "--n", 1, "--cos", 0), ("vectors",), ("emit",)):
            self.refused("lobe 'phong' is not known: .*bps", *command, "--lobe", "phong")
            self.refused("profile 'p9' is not legal: .*p8, p12, p16", *command, "--profile", "p9")
            self.refused("F = 7", *command, "--profile", "7,8,8,8")
            self.refused("S = 11.*12 to 30", *command, "--profile", "18,11,14,12")
            self.refused("K = 31.*12 to 30", *command, "--profile", "18,14,31,12")
            self.refused("18.14.14.*F,S,K,O", *command, "--profile", "18,14,14")
        self.equal(self.files(), [])

    def test_eval(self):
        self.refused("--n is missing", "eval", "--cos", 1)
        self.refused("--cos or --cos-code is missing", "eval", "--n", 1)
        for n in (0, 1024, -1, 99999):
            self.refused(f"n '?{n}'? is not legal: [01] to 1023", "eval", "--n", n, "--cos", 1)
        for code in (-1, 262145):
            self.refused(f"cos code {code} is not legal: 0 to 262144", "eval", "--n", 5, "--cos-code", code)
        self.refused(f"cos.code '?{1 << 40}'? is not legal: ", "eval", "--n", 5, "--cos-code", 1 << 40)
        self.refused("1024'? is not legal: .*0 to 1023", "eval", "--port", "--n", 1024, "--cos", 1)
        self.refused("524288 is not legal: .*-524288 to 524287", "eval", "--port", "--n", 1, "--cos-code", 524288)
        for cosine in ("2", "-2", "nan", "inf", "1e300"):
            self.refused(r"cos(ine)? '?(2|-2|nan|inf|1e\+300)'? is not legal", "eval", "--n", 5, f"--cos={cosine}")
        self.refused("1.5", "eval", "--n", 5, "--cos", 1.5)
        self.refused("-0.25", "eval", "--n", 5, "--cos", -0.25)
        self.refused("--n.*abc", "eval", "--n", "abc", "--cos", 1)
        self.refused("--n.*1.5", "eval", "--n", "1.5", "--cos", 1)
        self.refused("--cos.*abc", "eval", "--n", 1, "--cos", "abc")
        self.refused("--cos ", "eval", "--n", 1, "--cos", 1, "--cos-code", 1)
        self.refused("--stdin ", "eval", "--n", 1, "--stdin")
        self.refused("--n", "eval", "--cos", 1, "--n")

    def test_sweep(self):
        for text in ("0:5", "1:1024", "5:1", "1:5:0", "1:5:-1", "1:5:1:1", "", ":", "1:", "a", "1-5", "1.5", "-3"):
            argument = [f"--n={text}"] if text else ["--n", ""]
            self.refused(f"--n '{text}' is not legal: .*1 to 1023", "sweep", *argument, "--cos", "0:5")
        for text in ("0:262145", "-1:5", "5:4", "all:2", "99999999999999999999"):
            self.refused(f"--cos '{text}' is not legal: .*0 to 262144", "sweep", "--n", "1", f"--cos={text}")
        self.refused("--threads.*-1", "sweep", "--n", 1, "--cos", 0, "--threads", -1)
        self.refused("--threads.*1000000", "sweep", "--n", 1, "--cos", 0, "--threads", 1000000)

    def test_vectors(self):
        corners = int(json.loads(self.manifest())["corners"])
        self.refused(f"count {corners - 1} is not legal: at least {corners}", "vectors", "--count", corners - 1)
        for count in (0, -5, "x", "1e3", 1 << 50, 1 << 64):
            self.refused(f"count.*{count}", "vectors", "--count", count)
        for seed in (-1, "x", 1 << 64):
            self.refused(f"seed.*{seed}", "vectors", "--seed", seed)
        self.refused("format 'json' is not legal: tv, csv or hex", "vectors", "--format", "json")
        self.equal(self.files(), [])

    def manifest(self):
        self.good("vectors", "-o", "v")
        text = self.read("v/glint_bps_p12.json")
        for name in self.files():
            (self.folder / name).unlink()
        return text

    def test_emit(self):
        self.refused("target 'vhdl' is not legal: verilog, hls, proof or all", "emit", "--target", "vhdl")
        self.refused("--sidebands 'strb' is not legal: keep, id, dest, separated by commas", "emit", "--sidebands", "id,strb")
        self.refused("--lanes '1' is not legal: 2 to 64", "emit", "--lanes", "1")
        self.equal(self.files(), [])


class Eval(Case):
    def values(self, text):
        """name -> (code, fraction bits, real), of the table that eval prints; each name once."""
        rows = re.findall(r"^(\w+) +(-?\d+) +(\d+) +(-?\d+\.\d+)$", text, re.MULTILINE)
        self.equal([row[0] for row in rows], list(BITS), text)
        return {name: (int(code), int(bits), real) for name, code, bits, real in rows}

    def test_intermediates(self):
        for profile, bits in PROFILES.items():
            one = 1 << bits["F"]
            for n, code in itertools.product((1, 2, 50, 1023), (0, 1, one // 3, one - 1, one)):
                text = self.good("eval", "--lobe", "bps", "--profile", profile, "--n", n, "--cos-code", code)
                self.matches(text, rf"\Abps {profile.replace(',', '_')} n {n} cos code {code} \(c = [\d.]+\)\n")
                values = self.values(text)
                self.equal({name: value[1] for name, value in values.items()}, {x: bits[BITS[x]] for x in BITS})
                for code_here, fraction_bits, real in values.values():
                    self.equal(real, f"{code_here / 2**fraction_bits:.9f}")
                self.equal(values["C"][0], code)
                self.equal(values["D"][0], n * one - (n - 1) * code)

    def test_corrections(self):
        """Each name once, y the answer, and the first line says that something was corrected."""
        for n, code, C in ((0, 5, 5), (50, -1, 0), (50, 262145, 262144), (0, 524287, 262144), (0, -524288, 0)):
            text = self.good("eval", "--port", "--n", n, "--cos-code", code)
            self.matches(text, rf"\Abps p12 n {n} cos code {code} .*, clamped\n")
            values = self.values(text)
            self.equal(values["C"][0], C)
            answer, clamped = self.good("eval", "--port", "--stdin", text=f"{n} {code}\n").split()
            self.equal((values["y"][0], clamped), (int(answer), "1"))
        self.true("clamped" not in self.good("eval", "--port", "--n", 1, "--cos-code", 0), "nothing was corrected")

    def test_cosine(self):
        text = self.good("eval", "--n", 50, "--cos", 0.98)
        self.equal(text, self.good("eval", "--lobe", "bps", "--profile", "p12", "--n", 50, "--cos-code", 256901))
        self.matches(text, r"rounding error 0\.\d+ ulp; .*approximation error 0\.\d+\n\Z")


class Sweep(Case):
    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_csv(self):
        table = self.good("sweep", "--lobe", "bps", "--profile", "p8,18,14,14,12", "--n", "2:30:7",
                          "--cos", "60000:65536:3", "--csv", "out.csv")
        rows = self.rows("out.csv")
        exponents = [2, 9, 16, 23, 30]
        codes = len(range(60000, 65537, 3))
        names = [*map(str, exponents), "total"]
        self.equal([(row["lobe"], row["profile"], row["n"]) for row in rows],
                   [("bps", profile, n) for profile in ("p8", "18_14_14_12") for n in names])
        for block in (rows[: len(names)], rows[len(names) :]):
            *parts, total = block
            self.equal([int(row["inputs"]) for row in parts], [codes] * len(exponents))
            self.equal(int(total["inputs"]), codes * len(exponents))
            for key, place in (("rounding_max_ulp", "rounding_cos_code"), ("error_max", "error_cos_code"),
                               ("error_exact_cosine_max", "error_exact_cosine_cos_code"),
                               ("epicentre_max", "epicentre_cos_code")):
                seen = [row for row in parts if row[key]]
                if not seen:
                    self.equal((total[key], total[place]), ("", ""))
                    continue
                worst = max(seen, key=lambda row: float(row[key]))
                self.equal((total[key], total[place]), (worst[key], worst[place]), key)
                self.true((int(total[place]) - 60000) % 3 == 0, f"{place} {total[place]} is one of the inputs")
            for key in ("rounding_rms_ulp", "error_rms"):
                mean = (sum(float(row[key]) ** 2 for row in parts) / len(parts)) ** 0.5
                self.true(abs(float(total[key]) - mean) <= 1e-7 * mean, f"{key} {total[key]}, of the rows {mean}")
        self.matches(table, rf"(?m)^bps +p8 +{codes * 5 // 1000} {codes * 5 % 1000:03} ")
        self.equal(self.files(), ["out.csv"])

    def test_json(self):
        for profile, n, cos, exhaustive in (("p8", "50:52", "65000:65100", False), ("8,4,7,4", "all", "all", True)):
            arguments = ("sweep", "--profile", profile, "--n", n, "--cos", cos, "--csv", "out.csv",
                         "--json", "out.json")
            self.good(*arguments)
            document = json.loads(self.read("out.json"))
            self.equal(document["tool"], "glint sweep")
            self.equal(document["command"], f"{Path(OPTIONS.glint).name} {' '.join(arguments)}")
            self.equal(document["version"], self.good("--version").strip())
            (run,) = document["runs"]
            keys = {"lobe": str, "profile": str, "F": int, "O": int, "unit": str, "test": str, "exhaustive": bool,
                    "inputs": int, "seconds": float, "vectors_per_second": float, "accuracy": dict}
            self.equal({key: type(value) for key, value in run.items()}, keys)
            self.equal((run["profile"], run["unit"], run["test"]), (profile.replace(",", "_"), "model", "sweep"))
            self.equal(run["exhaustive"], exhaustive)
            rows = self.rows("out.csv")
            self.equal(run["inputs"], int(rows[-1]["inputs"]))
            accuracies = [*run["accuracy"]["rows"], run["accuracy"]["total"]]
            self.equal(len(accuracies), len(rows))
            for row, accuracy in zip(rows, accuracies):
                self.same(row, accuracy)

    def same(self, row, accuracy):
        """A row of CSV and its JSON."""
        self.equal(str(accuracy["inputs"]), row["inputs"])
        self.equal(str(accuracy.get("n", "total")), row["n"])
        for key, greatest, column, place in (
            ("rounding", "max_ulp", "rounding_max_ulp", "rounding_cos_code"),
            ("approximation", "max", "error_max", "error_cos_code"),
            ("approximation_exact_cosine", "max", "error_exact_cosine_max", "error_exact_cosine_cos_code"),
            ("epicentre", "max", "epicentre_max", "epicentre_cos_code"),
        ):
            worst = accuracy[key]
            shown = ("", "") if worst is None else (f"{worst[greatest]:.9g}", str(worst["cos_code"]))
            self.equal((row[column], row[place]), shown, key)
        self.equal(row["rounding_rms_ulp"], f"{accuracy['rounding']['rms_ulp']:.9g}")
        self.equal(row["error_rms"], f"{accuracy['approximation']['rms']:.9g}")

    def test_threads(self):
        documents = []
        for threads in (1, 2, 3, 0):
            self.good("sweep", "--profile", "p8", "--n", "1:20", "--threads", threads, "--csv", f"{threads}.csv",
                      "--json", f"{threads}.json")
            document = json.loads(self.read(f"{threads}.json"))
            for key in ("seconds", "vectors_per_second"):
                del document["runs"][0][key]
            documents.append(document["runs"])
            self.equal(self.read(f"{threads}.csv"), self.read("1.csv"))
            self.true(documents[-1] == documents[0], f"JSON of {threads} threads")


class Cosim(Case):
    def setUp(self):
        super().setUp()
        if not OPTIONS.cosim:
            self.skipTest("--cosim is not given")

    def cosim(self, *arguments):
        return self.good(*arguments, tool=OPTIONS.cosim)

    def refused(self, pattern, *arguments, **settings):
        super().refused(pattern, *arguments, tool=OPTIONS.cosim, **settings)

    def test_help(self):
        self.fits_a_screen(self.cosim("--help"), "glint-cosim")
        self.equal(self.cosim("--version"), self.good("--version"))

    def test_results(self):
        profiles = OPTIONS.cosim_profiles
        for profile in profiles:
            table = self.cosim("--lobe", "bps", "--profile", profile, "--unit", "core,axis", "--n", "50",
                               "--cos", "0:1000", "--json", "out.json", "--junit", "out.xml")
            name = profile.replace(",", "_")
            for unit in ("core", "axis"):
                self.matches(table, rf"(?m)^bps +{name} +{unit} +restoring +stream +1 001 +0 ")
            self.matches(table, r"\n2 of 2 runs passed, seed 1\n\Z")
            runs = json.loads(self.read("out.json"))["runs"]
            self.equal([(run["lobe"], run["profile"], run["unit"]) for run in runs],
                       [("bps", name, "core"), ("bps", name, "axis")])
            for run in runs:
                self.equal((run["mismatches"], run["inputs"], run["exhaustive"]), (0, 1001, False))
                self.true(run["latency_cycles"] > 0 and run["interval_cycles"] == 1 and run["architecture"] == "restoring", f"{run}")
            # Measured on the hardware's own results, the errors are those of the model.
            self.good("sweep", "--profile", profile, "--n", "50", "--cos", "0:1000", "--json", "model.json")
            (model,) = json.loads(self.read("model.json"))["runs"]
            for run in runs:
                self.equal(run["accuracy"], model["accuracy"])
            suite = xml.etree.ElementTree.parse(self.folder / "out.xml").getroot()
            self.equal((suite.tag, suite.get("tests"), suite.get("failures")), ("testsuite", "2", "0"))
            self.equal([case.get("name") for case in suite], [f"bps {name} {unit} restoring stream" for unit in ("core", "axis")])
            for case in suite:
                self.equal(case.tag, "testcase")
                self.true(float(case.get("time")) >= 0.0 and len(case) == 0, xml.etree.ElementTree.tostring(case))

    def test_kinds(self):
        profile = OPTIONS.cosim_profiles[0]
        for arguments in (("--count", 1000), ("--count", 1000, "--stall-probability", 0.5), ("--resets", 3)):
            table = self.cosim("--profile", profile, *arguments, "--seed", 5, "--json", "out.json")
            self.matches(table, r"\n1 of 1 runs passed, seed 5\n\Z")
            (run,) = json.loads(self.read("out.json"))["runs"]
            self.equal((run["mismatches"], run["seed"]), (0, 5))
            self.true(run["inputs"] >= 1000 or "--resets" in arguments, f"{run}")
            self.true(run["inputs"] > 0, f"{run}")

    def test_refused(self):
        profile = OPTIONS.cosim_profiles[0]
        name = profile.replace(",", "_")
        few = ("--n", "50", "--cos", "0:5", "--profile", profile)
        self.refused("nothing to run: .*--exhaustive", "--profile", profile)
        self.refused(rf"'bps 12_11_10_9 core restoring' is not in this build, which has: .*bps {name} core.*GLINT_PROFILES",
                     *few[:4], "--profile", "12,11,10,9")
        self.refused(rf"'bps {name} pci restoring' is not in this build, which has: .*bps {name} axis", *few, "--unit", "pci")
        self.refused("lobe 'phong' is not known: .*bps", *few, "--lobe", "phong")
        self.refused("profile 'p9' is not legal", *few[:4], "--profile", "p9")
        self.refused("--n '0' is not legal: .*1 to 1023", "--profile", profile, "--n", 0)
        self.refused("--cos '5:4' is not legal", "--profile", profile, "--n", 1, "--cos", "5:4")
        self.refused("--count.*0", "--count", 0)
        self.refused("--count.*-1", "--count", -1)
        self.refused("--resets.*0", "--resets", 0)
        self.refused("--stall-probability.*1.5", *few, "--stall-probability", 1.5)
        self.refused("--exhaustive", *few, "--exhaustive")
        self.refused("--illegal", "--illegal", "--resets", 3)
        self.refused("frob", *few, "frob")
        self.refused("'missing/out.xml' cannot be written", *few, "--junit", "missing/out.xml")
        self.refused("'missing/out.json' cannot be written", *few, "--json", "missing/out.json")
        self.equal(self.files(), [])


def cosim_options(parser):
    parser.add_argument("--cosim", type=os.path.abspath, help="glint-cosim, if it is built")
    parser.add_argument("--cosim-profile", dest="cosim_profiles", action="append", help="a profile that it has")


if __name__ == "__main__":
    main(cosim_options)
