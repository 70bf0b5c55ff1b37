"""`glint report` and `glint study`: the joined JSON, the page and the pictures made of it, and what they refuse. Run by
cli_test.py; how the page behaves in a browser is for tests/page."""

import html
import json
import math
import os
import re
import sys
import xml.etree.ElementTree

from case import Case, ROOT
from choose_test import write_prices


class Inputs(Case):
    """Small files of every kind that `glint report` reads."""

    def save(self, name, content):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(content if isinstance(content, str) else json.dumps(content))

    def load(self, name):
        return json.loads(self.read(name))

    def results(self, **changes):
        self.good("sweep", "--profile", "p8", "--n", "1:20", "--cos", "0:65536:16", "--json", "sweep.json")
        results = self.load("sweep.json")
        results["runs"][0].update(changes)
        self.save("sweep.json", results)
        return results["runs"][0]

    def proofs(self, bound="73395e-5"):
        """proofs.json as proofs/gappa/run.py writes it, with a program that answers as Gappa does."""
        self.save("bps.g", "# lobe: bps\n# profile: p8\n{ C in [0, 1] -> error in ? }\n")
        self.save("gappa", f"#!/bin/sh\necho '  error in [-68e-2, {bound}]'\n")
        (self.folder / "gappa").chmod(0o755)
        done = self.run_tool(ROOT / "proofs/gappa/run.py", "bps.g", "--gappa", "./gappa", "--measured", "sweep.json",
                             "--json", "proofs.json", tool=sys.executable)
        self.true((self.folder / "proofs.json").exists(), done.stderr)

    def prices(self):
        """cpu.json of three functions, with numbers that are plain to follow."""
        def point(lobe, kind, form, ns, latency, **more):
            return {"lobe": lobe, "type": kind, "form": form, "formula": f"{lobe}(c, n)", "throughput_ns": ns,
                    "throughput_q1_ns": ns, "throughput_q3_ns": 1.5 * ns, "latency_ns": latency, "instructions": 10 * ns,
                    **more}

        points = [point("schlick", "double", "scalar", 2.0, 8.0), point("schlick", "double", "batch", 0.5, None),
                  point("bps", "double", "scalar", 3.0, 15.0), point("bps", "double", "batch", 1.0, None),
                  point("pow", "float", "scalar", 9.0, 20.0), point("bps", "fixed", "batch", 4.0, None, profile="p8")]
        return {"format": "glint-cost-cpu-1", "command": "bench/run.py --bench glint-bench", "points": points,
                "machine": {"cpu": "a <processor>", "compiler": "GNU 1", "flags": "-O2", "date": "2026-01-02"}}

    def model_prices(self):
        """cpu-models.json with numbers that are plain to follow: ns of the models in double, half of it in float."""
        times = {"lambert": 1, "phong": 8, "blinn_phong": 7, "cook_torrance": 20, "ward": 12, "oren_nayar": 30,
                 "oren_nayar_no_trigonometry": 2, "modified_angle": 25, "modified_half": 10}
        points = [{"model": model, "type": kind, "form": "scalar", "formula": "f", "throughput_ns": scale * ns,
                   "throughput_q1_ns": scale * ns, "throughput_q3_ns": scale * ns,
                   "latency_ns": (3.2 if model == "modified_half" else 2) * scale * ns, "instructions": 10 * ns}
                  for kind, scale in (("double", 1), ("float", 0.5)) for model, ns in times.items()]
        return {**self.prices(), "format": "glint-cost-cpu-models-1", "points": points}

    def effect_prices(self):
        def point(effect, luts, **more):
            return {"effect": effect, "profile": "p12", "device": "hx8k", "dsp": False, "luts": luts, "registers": 10 * luts,
                    "carries": 0, "dsps": 0, "brams": 2, "fits": True, "cells": luts, "clock_mhz_seeds": [50.0],
                    "latency": 40, "interval": 1, "hash": "00", **more}

        points = [point("cook_torrance", 400), point("cook_torrance", 500, device="up5k"), point("lambert", 4),
                  point("cook_torrance_modified", 300, latency=20, clock_mhz_seeds=[60.0]),
                  point("cook_torrance", 800, device="ecp5-25k", fits=False, why="too many", clock_mhz_seeds=[]),
                  point("cook_torrance_modified", 600, device="ecp5-25k")]
        return {"format": "glint-cost-effects-1", "tools": {"yosys": "0.0"}, "points": points}

    def table(self, heading, *row):
        """The rows of the page's tables that have a heading, as dictionaries, with the text of each cell up to its
        first small print; with `row`, the one that begins with these texts."""
        out = []
        for table in re.findall(r"<table.*?</table>", self.read("page/index.html"), re.DOTALL):
            head, body = table.split("</thead>")
            names = [html.unescape(re.sub("<[^>]*>", "", cell)) for cell in re.findall(r"<th[ >].*?</th>", head, re.DOTALL)]
            if heading not in names:
                continue
            for cells in re.findall(r"<tr[ >].*?</tr>", body, re.DOTALL):
                texts = [re.sub("<[^>]*>", "", re.split("<small>", cell)[0]) for cell in re.findall(r"<t[hd][ >].*?</t[hd]>", cells, re.DOTALL)]
                self.equal(len(texts), len(names))
                texts = [" ".join(html.unescape(text).split()) for text in texts]
                if tuple(texts[:len(row)]) == row:
                    out.append(dict(zip(names, texts)))
        return out

    def text(self):
        """The page without its scripts and tags."""
        page = re.sub(r"<(script|style).*?</\1>", "", self.read("page/index.html"), flags=re.DOTALL)
        return " ".join(html.unescape(re.sub("<[^>]*>", "", page)).split())


class Report(Inputs):
    def test_results_alone(self):
        """A page that needs nothing else, and says which command writes what is missing."""
        total = self.results()["accuracy"]["total"]
        self.good("report", "--results", "sweep.json", "-o", "page")
        names = [*(f"figure-{number}" for number in range(3, 9)), "paper-2-figure-1", "paper-2-figure-2", "paper-2-phong"]
        self.equal(self.files(), [*(f"page/figures/{name}.csv" for name in names), "page/index.html",
                                  "page/overview-dark.svg", "page/overview-light.svg", "page/report.json", "sweep.json"])
        for name in ("page/overview-dark.svg", "page/overview-light.svg"):
            xml.etree.ElementTree.fromstring(self.read(name))
        page, text = self.read("page/index.html"), self.text()
        self.true(len(page) < 5_000_000, f"{len(page)} bytes")
        markup = re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)
        self.equal(re.findall(r'(?:src|href|srcset)=["\'](?!data:|#)[^"\']*', markup), [], "resources outside the page")
        row = self.table("rounding, ulp")[0]
        self.equal((row["inputs tried"], row["rounding, ulp"]), (f"{total['inputs']:,}", f"{total['rounding']['max_ulp']:.4f}"))
        self.equal(self.table("rounding, ulp")[1]["n"], "8 to 20")
        for words in ("glint sweep --profile p8 --n 1:20", "None of the result files holds a run of simulated hardware.",
                      "proofs/gappa/run.py --measured RESULTS", "glint report --cost cost/data", "build/release/glint-bench --json",
                      "build/release/glint-bench-models --json", "glint cost --fpga --effect cook_torrance,"):
            self.true(words in text, f"{words}: not on the page")
        self.equal(self.load("page/report.json")["problems"], [])

        # The hard cases are those of `glint cases`, cell by cell.
        parts = re.split(r"^## ", self.good("cases"), flags=re.MULTILINE)
        lines = [line for part in parts[1:] if part.startswith(("bps\n", "Streams\n"))
                 for line in part.splitlines() if line.startswith("| ")]
        rows = [row for table in self.load("page/report.json")["hard_cases"]["tables"] for row in (table["columns"], *table["rows"])]
        self.equal(rows, [line[2:-2].split(" | ") for line in lines])
        self.true(len(rows) > 20 and all(row[0].replace("`", "") in text for row in rows), "a case is not on the page")

    def test_all_inputs(self):
        """Every kind of file; the numbers of the page are theirs."""
        self.results(unit="core", mismatches=0, seconds=2.0, inputs=50_000_000, architecture="radix4:r2")
        self.proofs()
        write_prices(self.folder)
        self.save("cost/data/effects.json", self.effect_prices())
        self.save("cpu.json", self.prices())
        self.save("models.json", self.model_prices())
        self.good("report", "--results", "sweep.json", "--proofs", "proofs.json", "--cpu", "cpu.json", "--cpu-models",
                  "models.json", "--cost", "cost/data", "-o", "page")
        text, total = self.text(), self.load("sweep.json")["runs"][0]["accuracy"]["total"]
        for words in ("50,000,000inputs tried", "0mismatches", "1 of 1proofs hold", "a <processor>", "2026-01-02"):
            self.true(words in text, f"{words}: not on the page")
        self.equal(self.table("proven, ulp"),
                   [{"profile": "bps p8", "proven, ulp": "0.7340", "measured, ulp": f"{total['rounding']['max_ulp']:.4f}",
                     "measured / proven": f"{total['rounding']['max_ulp'] / 0.73395:.3f}", "inputs measured": f"{total['inputs']:,}"}])

        # Units: those of `glint cost`, each with the command that emits it.
        self.good("cost", "--device", "all", "--n", "8:1000", "--json", "out.json")
        units = self.load("page/report.json")["cost"]["configurations"]
        self.equal([{**unit, "emit": 0} for unit in units],
                   [{**unit, "emit": 0} for unit in self.load("out.json")["configurations"]])
        self.equal(len(self.table("ns a result")), len(units))
        for unit in units:
            self.equal(unit["emit"] is None, unit["lobe"] == "table")  # a rival is no lobe
        for command in {unit["emit"] for unit in units if unit["emit"]}:
            self.good(*command.split()[1:])

        # Paper 1 on a processor: ratios to schlick, and the claims about them.
        self.equal([self.table("cycles, same sum", "bps")[0][name] for name in ("latency, ns", "throughput, ns", "instructions", "batch, ns")],
                   ["15.00", "3.00", "30.00", "1.00"])
        self.equal([self.table("latency, float", "bps")[0][name] for name in ("printed", "latency", "throughput", "batch", "latency, float")],
                   ["1.87", "1.88", "1.50", "2.00", "–"])
        study = self.load("page/report.json")["study"]
        self.equal([(claim["id"], claim["verdict"]) for claim in study["paper_1"]["claims"] if claim["id"].startswith("time")],
                   [("time-latency", "true"), ("time-throughput", "not true"), ("time-instructions", "not true"), ("time-batch", "true")])
        self.equal([row["throughput, ns"] for row in self.table("batch, instructions", "pow")], ["9.00"])
        self.equal([self.table("cosimulation, M/s")[0][name] for name in ("lobe", "architecture", "cosimulation, M/s", "golden batch, M/s", "golden scalar, M/s", "batch / cosimulation")],
                   ["bps p8", "radix4:r2", "25.0", "250.0", "–", "10.0"])

        # Paper 2: the verdicts are those of the numbers.
        claims = {claim["id"]: claim for claim in study["paper_2"]["processor_claims"]}
        for what, times, verdict in (("throughput", 2.0, "more than printed"), ("latency", 1.25, "less than printed"),
                                     ("instructions", 2.0, "true")):
            for kind in ("double", "float"):
                claim = claims[f"gain-{what}-modified_half-{kind}"]
                self.near(claim["measured"], times, 1e-9)
                self.equal((claim["verdict"], claims[f"gain-{what}-modified_angle-{kind}"]["verdict"]), (verdict, "not true"))
        order = claims["order-throughput-float"]
        self.equal((order["measured"], order["verdict"], order["numbers"]["right"]),
                   ("Blinn-Phong < Phong < Ward < Cook-Torrance < Oren-Nayar", "true in part", 9))
        ward = [row for row in self.table("/ Lambert", "Ward")]
        self.equal([[row[name] for name in ("printed: instructions / full", "printed: time / full", "throughput, ns", "/ Lambert", "/ full", "latency, ns", "instructions")] for row in ward],
                   [["0.55", "0.62", "12.00", "12.00", "0.60", "24.0", "120"], ["0.55", "0.62", "6.00", "12.00", "0.60", "12.0", "120"]])
        self.equal([(row["form"], row["device"], row["LUTs"], row["latency, clocks"], row["latency, ns"], row["M results/s"]) for row in self.table("form")],
                   [("full", "hx8k", "400", "40", "800", "50.0"), ("modified", "hx8k", "300", "20", "333", "60.0"),
                    ("full", "ecp5-25k", "800", "40", "does not fit", "does not fit"), ("modified", "ecp5-25k", "600", "40", "800", "50.0")])
        self.true("0.42 times the latency in ns, 1.20 times the results a second" in text, "the forms compared")

    def test_problems(self):
        """What must not be stands on the page, and the exit status is 1."""
        self.results(unit="core", mismatches=3)
        self.proofs("1001e-3")
        proofs = self.load("proofs.json")
        low = {**proofs["proofs"][0], "proven_ulp": 0.25, "ok": True, "failures": []}
        self.save("proofs.json", {**proofs, "proofs": [proofs["proofs"][0], low]})
        done = self.run_tool("report", "--results", "sweep.json", "--proofs", "proofs.json", "-o", "page")
        self.equal((done.returncode, done.stderr), (1, ""))
        self.equal([problem["kind"] for problem in self.load("page/report.json")["problems"]], ["mismatches", "proof", "contradiction"])
        for words in ("bps p8: 3 results differ", "bps p8: proven bound 1.0010 ulp is not below 1", "is above the proven bound", "1 of 2proofs hold"):
            self.true(words in self.text(), words)

    def test_refused(self):
        def refused(pattern, file, content, *options):
            self.save(file, content)
            self.refused(pattern, "report", "--results", "sweep.json", *options, "-o", "page")

        def changed(content, key, value, index=0):
            name = next(name for name in ("runs", "proofs", "points") if name in content)
            items = [dict(item) for item in content[name]]
            items[index][key] = value
            return {**content, name: items}

        self.results()
        self.proofs()
        results, proofs, prices, models = self.load("sweep.json"), self.load("proofs.json"), self.prices(), self.model_prices()
        self.refused("missing.json", "report", "--results", "missing.json", "-o", "page")
        refused("sweep.json' is not JSON", "sweep.json", "{")
        refused("holds no runs", "sweep.json", {**results, "runs": []})
        refused(r"runs\[0\]\.lobe \"none\" is not legal", "sweep.json", changed(results, "lobe", "none"))
        refused("inputs 0", "sweep.json", changed(results, "inputs", 0))
        self.save("sweep.json", results)
        for file, option, cases in (
                ("proofs.json", "--proofs", (
                    ("is not JSON", "{"), ("is not a JSON object", "[]"), ("proofs is missing", results),
                    (r"proofs\[0\]\.proven_ulp -1 is not legal: a number, 0 or more", changed(proofs, "proven_ulp", -1)),
                    ("proven_ulp null is not legal", changed(proofs, "proven_ulp", None)),
                    (r"profile \"<p8>\" is not legal", changed(proofs, "profile", "<p8>")),
                    ("measured_inputs 0 is not legal", changed(proofs, "measured_inputs", 0)),
                    ("ok false is not legal", changed(proofs, "ok", False)),
                    (r"failures \[1\] is not legal: a list of texts", changed(proofs, "failures", [1])),
                    ("holds no proofs", {**proofs, "proofs": []}))),
                ("cpu.json", "--cpu", (
                    (r"points\[0\]\.type \"half\" is not legal: double, float or fixed", changed(prices, "type", "half")),
                    (r"points\[2\]\.form \"loop\" is not legal: scalar or batch", changed(prices, "form", "loop", 2)),
                    ("throughput_ns 0 is not legal: a number above 0", changed(prices, "throughput_ns", 0, 2)),
                    ("throughput_q3_ns 2 is not legal: no less than", changed(prices, "throughput_q3_ns", 2, 2)),
                    ("latency_ns -1 is not legal", changed(prices, "latency_ns", -1, 2)),
                    ("does not hold the lobe schlick", changed(prices, "lobe", "bps", 1)),
                    ("format \"glint-cost-cpu-2\" is not legal", {**prices, "format": "glint-cost-cpu-2"}))),
                ("models.json", "--cpu-models", (
                    ('format "glint-cost-cpu-1" is not legal: glint-cost-cpu-models-1', prices),
                    (r"points\[0\]\.throughput_ns 0 is not legal", changed(models, "throughput_ns", 0)),
                    ("does not hold the model modified_half in float, scalar", {**models, "points": models["points"][:-1]})))):
            self.refused("cannot be read", "report", "--results", "sweep.json", option, "missing.json", "-o", "page")
            for pattern, content in cases:
                refused(pattern, file, content, option, file)
        write_prices(self.folder)
        refused("effects.json'.*luts", "cost/data/effects.json", changed(self.effect_prices(), "luts", "many"), "--cost", "cost/data")

        # Without what the page is made with, one line names the package, and nothing is left behind.
        (self.folder / "empty").mkdir()
        self.save("none/jinja2.py", "raise ImportError(name='jinja2')")
        for pattern, environment in (("`python3-jinja2`", {"PYTHONPATH": str(self.folder / "none"), "GLINT_PAGE_PYTHON": "1"}),
                                     ("`esbuild`|`gnuplot-nox`", {"PATH": str(self.folder / "empty")})):
            self.refused(pattern, "report", "--results", "sweep.json", "-o", "page", env={**os.environ, **environment})
        self.equal([name for name in self.files() if name.startswith("page")], [], "a page was left behind")


class Study(Inputs):
    PAPER = ("schlick", "cosine_power", "quadratic", "cubic", "bps")

    def test_study(self):
        """Both papers: the claims beside what is measured, and the points of the figures against their formulas."""
        text = self.good("study", "--json", "study.json")
        study = self.load("study.json")
        for paper in ("paper_1", "paper_2"):
            for claim in study[paper]["claims"]:
                self.true(f"{claim['says']} " in text and claim["verdict"] in text, f"{claim['says']}: not printed")
        lobes = [unit["lobe"] for unit in json.loads((ROOT / "rtl/units.json").read_text())["units"] if unit["kind"] == "lobe"]
        self.equal([lobe["name"] for lobe in study["lobes"]], [*self.PAPER, *sorted(set(lobes) - set(self.PAPER))])
        by_name = {lobe["name"]: lobe for lobe in study["lobes"]}
        for lobe in study["lobes"]:
            for measure in ("delta", "absolute"):
                errors = lobe[measure]["by_n"]
                self.equal(len(errors), 1000)
                self.equal((max(errors[7:]), errors[lobe[measure]["n"] - 1]) if not lobe["exact"] else (0, 0),
                           (lobe[measure]["largest"],) * 2 if not lobe["exact"] else (0, 0))
                self.equal(sorted(errors[7:])[496], lobe[measure]["median"])
        self.near(by_name["bps"]["peak"], 0.992737, 1e-9)

        # What paper 1 prints; each difference over 5 % has its reason.
        claims = {claim["id"]: claim for claim in study["paper_1"]["claims"]}
        self.equal([(name, claim["printed"]) for name, claim in claims.items() if name.startswith(("delta", "absolute"))],
                   [("delta-schlick-largest", 0.11), ("delta-cosine_power-largest", 0.018), ("delta-quadratic-largest", 0.03),
                    ("delta-cubic-largest", 0.03), ("delta-bps-largest", 0.011), ("delta-bps-median", 0.0105), ("absolute-bps-median", 0.02)])
        for name, claim in claims.items():
            if not name.startswith(("delta", "absolute")):
                continue
            measure, lobe, statistic = name.split("-")
            self.near(claim["measured"], by_name[lobe][measure][statistic], 1e-6)
            self.near(claim["difference"], claim["measured"] / claim["printed"] - 1, 1e-9)
            self.equal(claim["verdict"] == "true", abs(claim["difference"]) <= 0.05)
            self.true(claim["verdict"] == "true" or claim["reason"], f"{claim}: not explained")
        self.equal([(form["printed"]["operations"]["multiplications"], form["printed"]["cycles"]) for form in study["paper_1"]["forms"] if form["printed"]],
                   [(1, 15), (4, 24), (4, 15), (5, 27), (4, 28)])
        self.equal({claim["verdict"] for name, claim in claims.items() if name.startswith("time-")}, {"not measured"})

        # What paper 2 prints.
        paper = study["paper_2"]
        claims = {claim["id"]: claim for claim in paper["claims"]}
        models = {model["model"]: model for model in paper["models"]}
        self.equal({name: model["printed"]["instructions"] for name, model in models.items() if model["printed"]},
                   {"Phong": 32, "Blinn-Phong": 30, "Cook-Torrance": 113, "Ward": 62, "Oren-Nayar": 86})
        for model in models.values():
            self.equal(model["total"], sum(model["operations"].values()))
        times = models["Cook-Torrance"]["total"] / models["modified Cook-Torrance"]["total"]
        for name in ("instructions", "speed"):
            self.near(claims[name]["measured"], times, 1e-9)
        order = claims["order"]["printed"].split(" < ")
        self.equal(order, ["Blinn-Phong", "Phong", "Ward", "Oren-Nayar", "Cook-Torrance"])
        counts = [models[name]["total"] for name in order]
        self.equal(claims["order"]["numbers"]["right"], sum(a < b for i, a in enumerate(counts) for b in counts[i + 1:]))
        close = sum(case["largest"] <= 0.05 for case in paper["likeness"])
        self.equal((len(paper["likeness"]), claims["look"]["numbers"]["close"], claims["look"]["verdict"]), (18, close, "true in part"))

        # The points of the figures.
        curves = study["curves"]
        self.equal((len(curves["degrees"]), curves["degrees"][-1], curves["bps"][0], curves["schlick"][0]), (9001, 90, 0.992737, 1))
        for degrees, schlick, blinn_phong in list(zip(curves["degrees"], curves["schlick"], curves["blinn_phong"]))[::500]:
            c = math.cos(math.radians(degrees))
            self.near(blinn_phong, c ** 50, 1e-6)
            self.near(schlick, c / (50 - 49 * c), 1e-6)
        for name, first, most in (("highlight", 1, 0.9928), ("delta", 8, 0.03), ("absolute", 8, 0.03)):
            surface = study["surfaces"][name]
            self.equal((len(surface["value"]), surface["n"][0], surface["n"][-1]), (240 * 160, first, 1000))
            self.true(0.9 * most < max(surface["value"]) <= most and min(surface["value"]) >= 0, f"{name}: out of range")
        for figure in paper["distributions"]:
            for theta, distribution, angle, half in list(zip(figure["x"], figure["distribution"], figure["angle_cubic"], figure["half_cubic"]))[:-1]:
                self.near(distribution, math.exp(-(math.tan(theta) / figure["m"]) ** 2) / math.cos(theta) ** 4, 2e-5)
                self.true(abs(angle - distribution) < 0.08 and abs(half - distribution) < 0.05, f"m {figure['m']}, angle {theta}")
        for figure in paper["reflectances"]:
            for vh, value in zip(figure["x"], figure["reflectance"]):
                g = math.sqrt(figure["index"] ** 2 + vh ** 2 - 1)
                ratio = (vh * (g + vh) - 1) / (vh * (g - vh) + 1)
                self.near(value, 0.5 * ((g - vh) / (g + vh)) ** 2 * (1 + ratio ** 2), 1e-5)
        h = paper["highlight"]
        for theta, phong, blinn_phong, narrow in zip(h["x"], h["phong"], h["blinn_phong"], h["blinn_phong_4n"]):
            self.near(phong, max(0.0, math.cos(theta)) ** 50, 5e-5)
            self.near(blinn_phong, math.cos(theta / 2) ** 50, 5e-5)
            self.near(narrow, phong, 0.004)
        self.near(h["blinn_phong_width"], 2 * math.acos(0.5 ** (1 / 50)), 1e-6)

    def test_cost_plots(self):
        write_prices(self.folder)
        self.good("cost", "--data", "cost/data", "--n", "8:1000", "--plots", "plots")
        names = [f"plots/{name}-{theme}.svg" for name in ("cost-latency", "cost-luts", "cost-ns", "pareto") for theme in ("dark", "light")]
        self.equal([name for name in self.files() if name.startswith("plots")], names)
        for name in names:
            text = "".join(xml.etree.ElementTree.fromstring(self.read(name)).itertext())
            self.true("blinn_phong p12" in text, f"{name}: {text}")
