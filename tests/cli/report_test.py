"""`glint report`: its page, its pictures, its data, and what it refuses. Run by cli_test.py."""

import csv
import html
import json
import math
import re
import sys
import xml.etree.ElementTree

from case import Case, ROOT
from choose_test import write_prices


class Report(Case):
    """The page of results: whole, self-contained, and refused where it would say nothing."""

    def results(self, **changes):
        self.good("sweep", "--profile", "p8", "--n", "1:20", "--cos", "0:65536:16", "--json", "sweep.json")
        results = json.loads(self.read("sweep.json"))
        results["runs"][0].update(changes)
        (self.folder / "sweep.json").write_text(json.dumps(results))

    def test_page(self):
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        names = [*(f"figure-{number}" for number in range(3, 9)), "paper-2-figure-1", "paper-2-figure-2", "paper-2-phong"]
        figures = [f"page/figures/{name}.csv" for name in names]
        self.equal(self.files(), [*figures, "page/index.html", "page/overview-dark.svg", "page/overview-light.svg",
                                  "sweep.json"])
        page = self.read("page/index.html")
        total = json.loads(self.read("sweep.json"))["runs"][0]["accuracy"]["total"]
        self.true(f"{total['inputs']:,}" in page, "the number of inputs is not on the page")
        self.true(f"{total['rounding']['max_ulp']:.4f}" in page, "the rounding error is not on the page")
        self.true("glint sweep --profile p8 --n 1:20" in re.sub("</?span>", "", page), "the command behind the figures is not on the page")
        self.equal(re.findall(r'(?:src|href|srcset)="(?!data:|#)[^"]*"', page), [], "resources outside the page")
        for name in ("page/overview-dark.svg", "page/overview-light.svg"):
            xml.etree.ElementTree.fromstring(self.read(name))

    def proofs(self, bound="73395e-5"):
        """proofs.json as proofs/gappa/run.py writes it, with a program that answers as Gappa does."""
        (self.folder / "bps.g").write_text("# lobe: bps\n# profile: p8\n{ C in [0, 1] -> error in ? }\n")
        gappa = self.folder / "gappa"
        gappa.write_text(f"#!/bin/sh\necho '  error in [-68e-2, {bound}]'\n")
        gappa.chmod(0o755)
        done = self.run_tool(ROOT / "proofs/gappa/run.py", "bps.g", "--gappa", "./gappa", "--measured", "sweep.json",
                             "--json", "proofs.json", tool=sys.executable)
        self.true((self.folder / "proofs.json").exists(), done.stderr)
        return done.returncode

    def section(self, name):
        """The text of a section of the page, without the tags, and the cells of its tables, row by row."""
        def text(html_text):
            return html.unescape(re.sub(r"<[^>]*>", "", html_text))

        section = re.search(rf'<h2 id="{name}">.*?(?=<h2|\Z)', self.read("page/index.html"), re.DOTALL)[0]
        rows = re.findall(r"<tr>(.*?)</tr>", section)
        return text(section), [[text(cell) for cell in re.findall(r"<t[hd].*?</t[hd]>", row)] for row in rows]

    def test_proofs(self):
        self.results()
        self.equal(self.proofs(), 0)
        self.good("report", "--results", "sweep.json", "--proofs", "proofs.json", "-o", "page")
        text, (heading, row) = self.section("proven")
        self.equal(heading, ["profile", "proven, ulp", "measured, ulp", "measured / proven", "inputs measured"])
        total = json.loads(self.read("sweep.json"))["runs"][0]["accuracy"]["total"]
        worst = total["rounding"]
        place = f"n = {worst['n']}, cos {worst['cos_code'] / 65536:.6f}code {worst['cos_code']}"
        self.equal(row, ["bps p8", "0.7340", f"{worst['max_ulp']:.4f}{place}", f"{worst['max_ulp'] / 0.73395:.3f}",
                         f"{total['inputs']:,}"])
        self.true("[2]" in text, "no reference to the command that proved it")
        self.true("run.py bps.g --gappa ./gappa --measured sweep.json" in self.section("commands")[0], "nor the command")
        self.equal(self.read("page/index.html").count('class="bad"'), 0)

    def test_proofs_of_all_inputs(self):
        self.results(exhaustive=True)
        self.proofs()
        self.good("report", "--results", "sweep.json", "--proofs", "proofs.json", "-o", "page")
        self.matches(self.section("proven")[1][1][-1], r"\A[\d,]+every legal one\Z")

    def test_no_proofs(self):
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        text, rows = self.section("proven")
        self.equal(rows, [])
        self.true("proofs/gappa/run.py" in text and "--proofs" in text, f"how to get the table: {text}")

    def test_proofs_that_failed(self):
        """What failed stands on the page; so does a bound that the results of the page exceed."""
        self.results()
        self.equal(self.proofs("1001e-3"), 1)
        self.good("report", "--results", "sweep.json", "--proofs", "proofs.json", "-o", "page")
        self.matches(self.section("proven")[0], r"\nbps p8: proven bound 1\.0010 ulp is not below 1\n")
        proofs = json.loads(self.read("proofs.json"))
        del proofs["proofs"][0]["proven_ulp"], proofs["proofs"][0]["measured_ulp"]
        (self.folder / "proofs.json").write_text(json.dumps(proofs))
        self.good("report", "--results", "sweep.json", "--proofs", "proofs.json", "-o", "page")
        self.equal(self.section("proven")[1][1], ["bps p8", *"––––"])
        self.proofs("5e-1")
        proofs = json.loads(self.read("proofs.json"))
        proofs["proofs"][0].update(proven_ulp=0.5, ok=True, failures=[])
        (self.folder / "proofs.json").write_text(json.dumps(proofs))
        self.good("report", "--results", "sweep.json", "--proofs", "proofs.json", "-o", "page")
        self.matches(self.section("proven")[0], r"bps p8: the rounding error of the results, 0\.\d+ ulp, is above")

    def test_cost(self):
        """The rows that are not dominated, of each device, with the errors for n from 8 to 1000; and the plots."""
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        text, rows = self.section("cost")
        self.equal(rows, [])
        self.true("--cost" in text and "glint cost --accuracy" in text, f"how to get the section: {text}")
        write_prices(self.folder)
        self.good("report", "--results", "sweep.json", "--cost", "cost/data", "-o", "page")
        text, rows = self.section("cost")
        for device in ("hx8k", "up5k", "xc7"):
            self.good("cost", "--device", device, "--n", "8:1000", "--json", "out.json")
            front = [c for c in json.loads(self.read("out.json"))["configurations"] if not c["dominated"]]
            self.true(len(front) > 0, device)
            for c in front:
                found = [row for row in rows if row[:2] == [f"{c['lobe']} {c['profile']}", c["architecture"]]]
                self.true(any(row[3] == str(c["luts"]) for row in found), f"{c} in {rows}")
                self.near(float(found[0][2]) / c["error"], 1, 0.005)
        self.true(not any(row[0].startswith("gauss") for row in rows), "a row that is dominated")
        self.equal(self.read("page/index.html").count("no other beats in both"), 3 + 3)  # text, and for who cannot see

    def test_cost_plots(self):
        write_prices(self.folder)
        self.good("cost", "--n", "8:1000", "--plots", "plots")
        names = [f"cost-{axis}-{theme}-{layout}.svg" for axis in ("latency", "luts", "ns") for theme in ("dark", "light")
                 for layout in ("narrow", "wide")]
        self.equal(self.files(), ["cost/data/accuracy.json", "cost/data/fpga.json",
                                  *sorted(f"plots/{name}" for name in [*names, "pareto-dark.svg", "pareto-light.svg"])])
        for name in names:
            text = "".join(xml.etree.ElementTree.fromstring(self.read(f"plots/{name}")).itertext())
            self.true("blinn_phong p12" in text, f"{name}: {text}")

    def test_hard_cases(self):
        """Each row that `glint cases` prints for the lobe and for the streams, cell by cell, and its explanation."""
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        text, rows = self.section("hard-cases")
        cases = self.good("cases")
        parts = re.split(r"^## ", cases, flags=re.MULTILINE)
        wanted = [part for part in parts[1:] if part.startswith(("bps\n", "Streams\n"))]
        self.equal(len(wanted), 2)
        lines = [line for part in wanted for line in part.splitlines() if line.startswith("| ")]
        self.true(len(lines) >= 20, f"{len(lines)} rows")
        self.equal(rows, [line[2:-2].split(" | ") for line in lines])
        legend = parts[0][parts[0].index("For each"):].replace("`", "").strip()
        self.true(legend in text, f"{legend} is not in {text[:400]}")

    PAPER = ("schlick", "cosine_power", "quadratic", "cubic", "bps")

    def lobe_names(self):
        return re.findall(r"^GLINT_LOBE\((\w+)\)$", (ROOT / "model/include/glint/lobes.def").read_text(), re.MULTILINE)

    def figure(self, number, paper=""):
        with open(self.folder / f"page/figures/{paper}figure-{number}.csv", newline="") as file:
            heading, *rows = csv.reader(file)
        return heading, [[float(cell) for cell in row] for row in rows]

    def cells(self, name):
        """The rows of the tables of a section as dictionaries, with the text of each cell up to its first small print."""
        section = re.search(rf'<h2 id="{name}">.*?(?=<h2|\Z)', self.read("page/index.html"), re.DOTALL)[0]
        out = []
        for table in re.findall(r"<table>.*?</table>", section, re.DOTALL):
            heading = [html.unescape(cell) for cell in re.findall(r'<th scope="col"[^>]*>(.*?)</th>', table)]
            for row in re.findall(r'<tr>(<th scope="row".*?)</tr>', table):
                texts = [re.split("<small>", cell)[0] for cell in re.findall(r"<t[hd].*?</t[hd]>", row)]
                self.equal(len(texts), len(heading))
                out.append({label: html.unescape(re.sub("<[^>]*>", "", text)).replace("\xa0", " ")
                            for label, text in zip(heading, texts)})
        return out

    def test_paper_figures(self):
        """The figures of the paper as CSV: whole, and the same numbers as on the page."""
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        heading, rows = self.figure(3)
        self.equal((heading, len(rows)), (["theta_rad", "f_bps", "f_s", "f_b"], 9001))
        self.equal(rows[0], [0, 0.992737, 1, 1])
        self.near(rows[-1][0], math.pi / 2, 1e-6)
        for theta, _, schlick, blinn_phong in rows[::500]:
            self.near(blinn_phong, max(0.0, math.cos(theta)) ** 50, 1e-5)
            self.near(schlick, math.cos(theta) / (50 - 49 * math.cos(theta)), 1e-5)
        for number, name, first, (least, most) in ((4, "f_bps", 1, (0, 0.9928)), (6, "delta_bps_percent", 8, (0, 3)),
                                                   (8, "Delta_bps", 8, (0, 0.03))):
            heading, rows = self.figure(number)
            self.equal((heading, len(rows)), (["n", "theta_rad", name], 240 * 160))
            self.equal((rows[0][0], rows[-1][0]), (first, 1000))
            self.true(all(least <= row[2] <= most for row in rows), f"figure {number}: a value is out of range")
            self.true(max(row[2] for row in rows) > 0.9 * most, f"figure {number}: all values are small")
        lobes = self.lobe_names()
        order = [*self.PAPER, *sorted(set(lobes) - set(self.PAPER))]
        claims = self.cells("paper")
        for number, symbol, prefix, suffix in ((5, "δ", "delta_", "_percent"), (7, "Δ", "Delta_", "")):
            heading, rows = self.figure(number)
            self.equal(heading, ["n", *(prefix + lobe + suffix for lobe in order)])
            self.equal([row[0] for row in rows], list(range(8, 1001)))
            for column, lobe in enumerate(order, 1):
                errors = sorted(row[column] for row in rows)
                if errors[-1] < 1e-9:  # c^n itself
                    continue
                found = [claim for claim in claims if (claim["lobe"], claim["error"]) == (lobe, symbol)]
                self.true(found, f"{lobe}: no row for {symbol}")
                self.near(float(found[0]["largest"].split()[0]), errors[-1], 0.0006 if suffix else 0.000006)
                self.near(float(found[0]["median"].split()[0]), errors[len(errors) // 2], 0.0006 if suffix else 0.000006)
                self.near(errors[-1], next(row[column] for row in rows if row[0] == int(found[0]["at n"])), 1e-9)

    def test_paper_claims(self):
        """What the paper prints, beside what is measured; each difference over 5 % has its reason."""
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        claims = [claim for claim in self.cells("paper") if claim["printed"] != "–"]
        self.equal([(claim["lobe"], claim["printed"]) for claim in claims],
                   [("schlick", "11 %"), ("cosine_power", "1.8 %"), ("quadratic", "3 %"), ("cubic", "3 %"), ("bps", "1.1 %"),
                    ("bps", "1.05 %"), ("bps", "0.02")])
        for claim in claims:
            printed = float(claim["printed"].split()[0])
            measured = [float(claim[label].split()[0]) for label in ("largest", "median")]
            difference = float(claim["difference"].split()[0])
            self.true(any(abs(100 * (value / printed - 1) - difference) < 0.2 for value in measured),
                      f"{claim}: the difference is that of no value")
            self.equal(claim["remark"].startswith("Agrees"), abs(difference) <= 5)
            self.true("Not explained" not in claim["remark"], f"{claim}")
        costs = self.cells("costs")
        self.equal([(row["operations, printed"], row["cycles, printed"]) for row in costs if row["cycles, printed"] != "–"],
                   [("1 1 2 0 0", "15"), ("4 1 0 2 0", "24"), ("4 0 2 0 1", "15"), ("5 1 2 0 0", "27"), ("4 1 4 1 1", "28")])
        for row in costs:
            self.true(row["cycles, Zen 4 double"] == "–" or int(row["cycles, Zen 4 double"]) > int(row["cycles, same sum"]),
                      f"{row}")

    def test_paper_2_claims(self):
        """What the second paper prints, beside what is counted and computed; the verdicts are those of the numbers."""
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        rows = self.cells("paper-2")
        claims = {row["claim"]: row for row in rows if "claim" in row}
        self.equal(len(claims), 7)
        models = {row["model"]: row for row in rows if "model" in row}
        self.equal([(name, row["instructions, printed"], row["pixels/s, printed"]) for name, row in models.items()
                    if row["instructions, printed"] != "–"],
                   [("Phong", "32", "640 M"), ("Blinn-Phong", "30", "640 M"), ("Cook-Torrance", "113", "200 M"),
                    ("Ward", "62", "320 M"), ("Oren-Nayar", "86", "320 M")])
        kinds = ("multiplications", "divisions", "additions", "comparisons", "calls")
        for name, row in models.items():
            self.equal(int(row["operations"]), sum(int(row[kind]) for kind in kinds))
            self.true(name == "Cook-Torrance" or int(row["operations"]) < int(models["Cook-Torrance"]["operations"]), f"{row}")
        full, modified = (models[name]["operations"] for name in ("Cook-Torrance", "modified Cook-Torrance"))
        self.equal(claims["Fewer instructions"]["printed"], "113 to about 60")
        self.equal(claims["Fewer instructions"]["measured"], f"{full} to {modified} operations")
        ratio = int(full) / int(modified)
        self.true(f"{ratio:.2f} times, not 1.88" in claims["Fewer instructions"]["verdict"], f"{claims['Fewer instructions']}")
        self.equal(claims["77 % faster"]["measured"], f"{ratio:.2f} times fewer operations")
        order = ["Blinn-Phong", "Phong", "Ward", "Oren-Nayar", "Cook-Torrance"]
        self.equal(claims["Order of the five models"]["printed"], " < ".join(order))
        counts = [int(models[name]["operations"]) for name in order]
        in_order = sum(a < b for i, a in enumerate(counts) for b in counts[i + 1:])
        self.equal(claims["Order of the five models"]["measured"], f"{in_order} of 10 pairs in this order")
        cases = [row for row in rows if "RMS" in row]
        self.equal(len(cases), 18)
        close = sum(float(row["largest"].split()[0]) <= 5 for row in cases)
        self.true(0 < close < 18 and f"in {close} of the 18 cases" in claims["Almost identical look"]["verdict"], f"{claims}")
        for row in cases:
            self.true(0 < float(row["RMS"].split()[0]) < float(row["largest"].split()[0]), f"{row}")

    def test_paper_2_hardware(self):
        """Both forms of Cook-Torrance from cost/data/effects.json where they are there, else what writes them."""
        def point(effect, luts, **more):
            return {"effect": effect, "profile": "p12", "device": "hx8k", "dsp": False, "luts": luts, "registers": 10 * luts,
                    "carries": 0, "dsps": 0, "brams": 2, "fits": True, "cells": luts, "clock_mhz_seeds": [50.0],
                    "latency": 40, "interval": 1, "hash": "00", **more}

        def rows():
            return [row for row in self.cells("paper-2") if "form" in row]

        self.results()
        write_prices(self.folder)
        report = ["report", "--results", "sweep.json", "--cost", "cost/data", "-o", "page"]
        self.good(*report)
        self.equal(rows(), [])
        self.true("glint cost --fpga --effect cook_torrance," in self.section("paper-2")[0], "how to get the table")
        points = [point("cook_torrance", 400), point("cook_torrance", 500, device="up5k"), point("lambert", 4),
                  point("cook_torrance_modified", 300, latency=20, clock_mhz_seeds=[60.0]),
                  point("cook_torrance", 800, device="ecp5-25k", fits=False, why="too many", clock_mhz_seeds=[]),
                  point("cook_torrance_modified", 600, device="ecp5-25k")]
        prices = {"format": "glint-cost-effects-1", "tools": {"yosys": "0.0"}, "points": points}
        (self.folder / "cost/data/effects.json").write_text(json.dumps(prices))
        self.good(*report)
        self.equal([(row["form"], row["device"], row["LUTs"], row["latency, clocks"], row["latency, ns"], row["M results/s"])
                    for row in rows()],
                   [("full", "hx8k", "400", "40", "800", "50.0"), ("modified", "hx8k", "300", "20", "333", "60.0"),
                    ("full", "ecp5-25k", "800", "40", "does not fit", "does not fit"),
                    ("modified", "ecp5-25k", "600", "40", "800", "50.0")])
        text = self.section("paper-2")[0].replace("\N{NO-BREAK SPACE}", " ")
        self.true("At p12 on hx8k: 75 % of the LUTs of the full form, 75 % of its registers, 0 DSPs instead of 0, 20 clocks "
                  "of latency instead of 40; 0.42 times the latency in ns, 1.20 times the results a second." in text, text)
        prices["points"][0]["luts"] = "many"
        (self.folder / "cost/data/effects.json").write_text(json.dumps(prices))
        self.refused("price file 'cost/data/effects.json'.*luts", *report)

    def test_paper_2_figures(self):
        """Beckmann's distribution, Fresnel's reflectance and both highlights, against the formulas of the paper."""
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        heading, rows = self.figure(1, "paper-2-")
        roughness = (0.2, 0.4, 0.8)
        self.equal(heading, ["theta_rad", *(name + f"{m:g}" for m in roughness for name in ("m2D_m", "cubic_angle_m", "cubic_half_m"))])
        self.equal(len(rows), 901)
        self.near(rows[-1][0], math.pi / 2, 1e-6)
        for theta, *values in rows[:-1]:
            for m, (distribution, angle, half) in zip(roughness, zip(*[iter(values)] * 3)):
                self.near(distribution, math.exp(-(math.tan(theta) / m) ** 2) / math.cos(theta) ** 4, 2e-5)
                self.true(abs(angle - distribution) < 0.08 and abs(half - distribution) < 0.05, f"m {m}, angle {theta}")
        heading, rows = self.figure(2, "paper-2-")
        indices = (1.33, 1.5, 2.5, 4)
        self.equal((heading, len(rows)), (["vh", *(f"F_index{index:g}" for index in indices)], 901))
        for vh, *values in rows:
            for index, value in zip(indices, values):
                g = math.sqrt(index ** 2 + vh ** 2 - 1)
                ratio = (vh * (g + vh) - 1) / (vh * (g - vh) + 1)
                self.near(value, 0.5 * ((g - vh) / (g + vh)) ** 2 * (1 + ratio ** 2), 1e-5)
        with open(self.folder / "page/figures/paper-2-phong.csv", newline="") as file:
            heading, *rows = csv.reader(file)
        self.equal((heading, len(rows)), (["theta_rad", "phong_n50", "blinn_phong_n50", "blinn_phong_n200"], 901))
        for theta, phong, blinn_phong, narrow in ([float(cell) for cell in row] for row in rows):
            self.near(phong, max(0.0, math.cos(theta)) ** 50, 5e-5)
            self.near(blinn_phong, math.cos(theta / 2) ** 50, 5e-5)
            self.near(narrow, phong, 0.004)
        text = html.unescape(self.section("paper-2")[0])
        self.true(f"1/2 at {2 * math.degrees(math.acos(0.5 ** (1 / 50))):.2f}°" in text, text[-3000:])

    def prices(self):
        """cpu.json of three functions, with numbers that are plain to follow."""
        def point(lobe, kind, form, ns, latency, **more):
            return {"lobe": lobe, "type": kind, "form": form, "formula": f"{lobe}(c, n)", "throughput_ns": ns,
                    "throughput_q1_ns": ns, "throughput_q3_ns": 1.5 * ns, "latency_ns": latency, "instructions": 10 * ns,
                    **more}

        points = [point("schlick", "double", "scalar", 2.0, 8.0), point("schlick", "double", "batch", 0.5, None),
                  point("bps", "double", "scalar", 3.0, 15.0), point("bps", "double", "batch", 1.0, None),
                  point("pow", "float", "scalar", 9.0, 20.0),
                  point("bps", "fixed", "batch", 4.0, None, profile="p8")]
        prices = {"format": "glint-cost-cpu-1", "command": "bench/run.py --bench glint-bench", "points": points,
                  "machine": {"cpu": "a <processor>", "compiler": "GNU 1", "flags": "-O2", "date": "2026-01-02"}}
        (self.folder / "cpu.json").write_text(json.dumps(prices))
        return prices

    def test_cpu_prices(self):
        """Table 1 with the measured ratios, the table of all prices, and the price of cosimulation beside them."""
        self.results(unit="core", mismatches=0, seconds=2.0, inputs=50_000_000, architecture="radix4:r2")
        self.prices()
        self.good("report", "--results", "sweep.json", "--cpu", "cpu.json", "-o", "page")
        costs = self.cells("costs")
        bps = next(row for row in costs if row["lobe"] == "bps" and "cycles, printed" in row)
        self.equal([bps[label] for label in ("latency, ns", "throughput, ns", "instructions", "batch, ns")],
                   ["15.00", "3.00", "30.00", "1.00"])
        ratios = next(row for row in costs if row["lobe"] == "bps" and "printed" in row)
        self.equal([ratios[label] for label in ("printed", "latency", "throughput", "instructions", "batch", "latency, float")],
                   ["1.87", "1.88", "1.50", "1.50", "2.00", "–"])
        text = self.section("costs")[0]
        self.true("within 10 % of that: latency 1.88, batch 2.00. Not so: throughput 1.50, instructions 1.50." in text, text)
        self.true("a <processor>" in text and "2026-01-02" in text, text)
        speed = self.cells("speed")
        self.equal([row["throughput, ns"] for row in speed if row.get("lobe or rival") == "pow"], ["9"])
        self.equal([(row["lobe"], row["architecture"], row["cosimulation, M/s"], row["golden batch, M/s"],
                     row["golden scalar, M/s"], row["batch / cosimulation"]) for row in speed if "cosimulation, M/s" in row],
                   [("bps p8", "radix4:r2", "25.0", "250.0", "–", "10.0")])
        self.true("neither in latency nor in throughput" in self.section("choosing")[0], "no verdict on times")

    def test_no_cpu_prices(self):
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        for name, program, option in (("costs", "glint-bench", "--cpu"), ("speed", "glint-bench", "--cpu"),
                                      ("paper-2", "glint-bench-models", "--cpu-models")):
            text = self.section(name)[0]
            self.true("bench/run.py" in text and f"release/{program} " in text and f"{option} " in text,
                      f"how to get the table: {text}")
        self.true("None of the result files holds a run of simulated hardware." in self.section("speed")[0], "cosimulation")
        self.true("neither in latency nor in throughput" not in self.section("choosing")[0], "a verdict on no times")

    def test_refused_cpu_prices(self):
        def refused(pattern):
            self.refused(pattern, "report", "--results", "sweep.json", "--cpu", "cpu.json", "-o", "page")

        self.results()
        refused(r"file of CPU prices 'cpu\.json' cannot be read")
        for index, key, value, pattern in ((0, "type", "half", r"points\[0\]\.type \"half\" is not legal: double, float or fixed"),
                                           (2, "form", "loop", r"points\[2\]\.form \"loop\" is not legal: scalar or batch"),
                                           (2, "throughput_ns", 0, "throughput_ns 0 is not legal: a number above 0"),
                                           (2, "throughput_q3_ns", 2, "throughput_q3_ns 2 is not legal: no less than"),
                                           (2, "latency_ns", -1, "latency_ns -1 is not legal"),
                                           (1, "lobe", "bps", "does not hold the lobe schlick")):
            prices = self.prices()
            prices["points"][index][key] = value
            (self.folder / "cpu.json").write_text(json.dumps(prices))
            refused(pattern)
        prices = self.prices()
        prices["format"] = "glint-cost-cpu-2"
        (self.folder / "cpu.json").write_text(json.dumps(prices))
        refused("format \"glint-cost-cpu-2\" is not legal")
        self.equal([name for name in self.files() if name.startswith("page")], [], "a page was left behind")

    def model_prices(self):
        """cpu-models.json with numbers that are plain to follow: ns of the models in double, half of it in float."""
        times = {"lambert": 1, "phong": 8, "blinn_phong": 7, "cook_torrance": 20, "ward": 12, "oren_nayar": 30,
                 "oren_nayar_no_trigonometry": 2, "modified_angle": 25, "modified_half": 10}
        points = [{"model": model, "type": kind, "form": "scalar", "formula": "f", "throughput_ns": scale * ns,
                   "throughput_q1_ns": scale * ns, "throughput_q3_ns": scale * ns, "latency_ns": (3.2 if model == "modified_half" else 2) * scale * ns,
                   "instructions": 10 * ns} for kind, scale in (("double", 1), ("float", 0.5)) for model, ns in times.items()]
        prices = {"format": "glint-cost-cpu-models-1", "command": "bench/run.py --bench glint-bench-models", "points": points,
                  "machine": {"cpu": "a <processor>", "compiler": "GNU 1", "flags": "-O2", "date": "2026-01-02"}}
        (self.folder / "models.json").write_text(json.dumps(prices))
        return prices

    def test_model_prices(self):
        """The claims of the second paper on a processor, whose verdicts are those of the numbers, and the models."""
        self.results()
        self.model_prices()
        self.good("report", "--results", "sweep.json", "--cpu-models", "models.json", "-o", "page")
        rows = self.cells("paper-2")
        claims = {row["claim"]: row for row in rows if "claim" in row}
        for claim, printed, verdict in (("77 % faster: throughput", "1.77 times", "more than printed"),
                                        ("77 % faster: latency", "1.77 times", "less than printed"),
                                        ("Fewer machine instructions", "113 to about 60, 1.88 times", "true")):
            times = {"more than printed": "2.00", "less than printed": "1.25", "true": "2.00"}[verdict]
            self.equal((claims[claim]["printed"], claims[claim]["measured"], claims[claim]["verdict"]),
                       (printed, "Full / modified. Cubic of the angle: 0.80 in double, 0.80 in float. Cubic of N.H: "
                                 f"{times} in double, {times} in float.",
                        "Cubic of the angle: not true in double, not true in float. Cubic of N.H: "
                        f"{verdict} in double, {verdict} in float."))
        order = claims["Order of the five models: throughput, float"]
        self.equal((order["measured"], order["verdict"]),
                   ("Blinn-Phong < Phong < Ward < Cook-Torrance < Oren-Nayar", "Not the same: 9 of 10 pairs in the printed order."))
        printed = [row["printed: instructions / full"] for row in rows if row.get("model") == "modified Cook-Torrance"
                   and "throughput, ns" in row]
        self.equal(printed, ["0.53", "0.53"])
        ward = [row for row in rows if row.get("model") == "Ward" and "throughput, ns" in row]
        self.equal([[row[label] for label in ("printed: instructions / full", "printed: time / full", "throughput, ns",
                                              "/ Lambert", "/ full", "latency, ns", "instructions")] for row in ward],
                   [["0.55", "0.62", "12.00", "12.00", "0.60", "24.0", "120"], ["0.55", "0.62", "6.00", "12.00", "0.60", "12.0", "120"]])
        self.true("a <processor>" in self.section("paper-2")[0], "what measured them")

    def test_committed_model_prices(self):
        """The page takes cost/data/cpu-models.json as it is."""
        self.results()
        self.good("report", "--results", "sweep.json", "--cpu-models", ROOT / "cost/data/cpu-models.json", "-o", "page")
        measured = [row["model"] for row in self.cells("paper-2") if "latency / full" in row]
        self.equal((len(measured), len(set(measured))), (18, 9))

    def test_refused_model_prices(self):
        def refused(pattern, prices):
            (self.folder / "models.json").write_text(json.dumps(prices))
            self.refused(pattern, "report", "--results", "sweep.json", "--cpu-models", "models.json", "-o", "page")

        self.results()
        refused('format "glint-cost-cpu-1" is not legal: glint-cost-cpu-models-1', self.prices())
        prices = self.model_prices()
        refused(r"points\[0\]\.throughput_ns 0 is not legal: a number above 0",
                {**prices, "points": [{**prices["points"][0], "throughput_ns": 0}]})
        refused("does not hold the model modified_half in float, scalar", {**prices, "points": prices["points"][:-1]})
        self.equal([name for name in self.files() if name.startswith("page")], [], "a page was left behind")

    def test_choosing(self):
        """The engineer's table has every lobe, from the least to the largest error; then the small exponents."""
        self.results()
        self.good("report", "--results", "sweep.json", "-o", "page")
        rows = self.cells("choosing")
        lobes = [row for row in rows if "lobe" in row]
        self.equal(sorted(row["lobe"] for row in lobes), sorted(self.lobe_names()))
        errors = [float(row["Δ, n from 8"]) for row in lobes]
        self.equal(errors, sorted(errors))
        bps = next(row for row in lobes if row["lobe"] == "bps")
        self.equal((bps["at c = 1"], bps["at c = 0"]), ("0.9927", "0.0027"))
        small = [row for row in rows if "n" in row]
        self.equal([row["n"] for row in small], [str(n) for n in range(1, 9)])
        self.equal(small[0]["Δ of bps"], bps["Δ, n below 8"])
        text = self.section("choosing")[0]
        self.true("0.9927" in text and "0.0027" in text and small[0]["Δ of bps"][:6] in text, text[:1500])

    def test_refused_proofs(self):
        def refused(pattern):
            self.refused(pattern, "report", "--results", "sweep.json", "--proofs", "proofs.json", "-o", "page")

        self.results()
        refused(r"proofs file 'proofs\.json' cannot be read")
        (self.folder / "proofs.json").write_text("{")
        refused(r"proofs file 'proofs\.json' is not JSON")
        (self.folder / "proofs.json").write_text("[]")
        refused(r"proofs file 'proofs\.json' is not a JSON object")
        (self.folder / "proofs.json").write_text(self.read("sweep.json"))
        refused("proofs is missing")
        self.proofs()
        good = self.read("proofs.json")
        for key, value, pattern in (("proven_ulp", -1, r"proofs\[0\]\.proven_ulp -1 is not legal: a number, 0 or more"),
                                    ("proven_ulp", None, r"proven_ulp null is not legal"),
                                    ("profile", "<p8>", r"profile \"<p8>\" is not legal"),
                                    ("measured_inputs", 0, "measured_inputs 0 is not legal"),
                                    ("ok", False, "ok false is not legal"),
                                    ("failures", [1], r"failures \[1\] is not legal: a list of texts")):
            proofs = json.loads(good)
            proofs["proofs"][0][key] = value
            (self.folder / "proofs.json").write_text(json.dumps(proofs))
            refused(pattern)
        proofs["proofs"] = []
        (self.folder / "proofs.json").write_text(json.dumps(proofs))
        refused("holds no proofs")
        self.equal([name for name in self.files() if name.startswith("page")], [], "a page was left behind")

    def test_refused(self):
        self.results(lobe="none")
        self.refused(r"runs\[0\]\.lobe \"none\" is not legal", "report", "--results", "sweep.json", "-o", "page")
        self.refused("missing.json", "report", "--results", "missing.json", "-o", "page")
        (self.folder / "broken.json").write_text("{")
        self.refused("broken.json", "report", "--results", "broken.json", "-o", "page")
        self.results(inputs=0)
        self.refused("inputs", "report", "--results", "sweep.json", "-o", "page")
        self.results()
        (self.folder / "empty").mkdir()
        self.refused("gnuplot", "report", "--results", "sweep.json", "-o", "page", env={"PATH": str(self.folder / "empty")})
        self.equal([name for name in self.files() if name.startswith("page")], [], "a page was left behind")
