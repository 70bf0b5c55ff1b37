"""`glint cost` and `glint choose`, on prices made up so that the right answers are plain.

Errors are those of the project's own cost/data/accuracy.json.
"""

import csv
import json
import re
import shutil

from case import Case, ROOT


def point(lobe, profile, architecture, device, luts, clock, latency, interval=1, dsps=0, **more):
    return {"lobe": lobe, "profile": profile, "architecture": architecture, "device": device, "dsp": dsps > 0,
            "luts": luts, "registers": luts // 2, "carries": 100, "dsps": dsps, "brams": 0, "clock_mhz": clock,
            "clock_mhz_seeds": [clock] if clock else [], "latency": latency, "interval": interval, "hash": "0", **more}


POINTS = [
    point("quadratic", "p12", "pipelined", "hx8k", 900, 70.0, 6),
    point("bps", "p12", "restoring", "hx8k", 4200, 80.0, 25),
    point("bps", "p12", "iterative", "hx8k", 1500, 70.0, 40, interval=25),
    point("cayley", "p12", "restoring", "hx8k", 4600, 75.0, 28),
    point("cayley", "p12", "iterative", "hx8k", 1900, 71.0, 44, interval=28),
    point("blinn_phong", "p12", "pipelined", "hx8k", 3400, 60.0, 18),
    # Worse than cayley p12 in everything.
    point("gauss", "p12", "pipelined", "hx8k", 4700, 50.0, 45, interval=30),
    point("blinn_phong", "p12", "pipelined", "up5k", 1300, 22.0, 18, dsps=5),
    point("cayley", "p8", "restoring", "xc7", 1000, None, 24),
    {**point("cubic", "p16", "pipelined", "up5k", 0, None, 1), "fits": False, "why": "made up"},
    point("table", "p12", "pipelined", "hx8k", 50, 120.0, 2, error={"max": 0.3, "max_n8": 0.2}),
    point("bps", "18,19,19,12", "restoring", "hx8k", 4444, 70.0, 29),
]
def cpu_point(lobe, kind, form, ns, **more):
    return {"lobe": lobe, "type": kind, "form": form, "formula": "made up", "throughput_ns": ns, "throughput_q1_ns": ns,
            "throughput_q3_ns": ns, "latency_ns": None, "instructions": None, **more}


CPU = {"format": "glint-cost-cpu-1", "command": "made up",
       "machine": {"cpu": "Made Up 9000", "compiler": "-", "flags": "-", "date": "-"},
       "points": [cpu_point("bps", "fixed", "batch", 2.5, profile="p12"),
                  cpu_point("schlick", "double", "scalar", 12.5, latency_ns=14, instructions=99),
                  cpu_point("schlick", "double", "batch", 1.5)]}


def write_prices(folder):
    """Made-up prices beside the errors of the project."""
    (folder / "cost/data").mkdir(parents=True)
    shutil.copy(ROOT / "cost/data/accuracy.json", folder / "cost/data")
    prices = {"format": "glint-cost-fpga-1", "tools": {"yosys": "0.0"}, "points": POINTS}
    (folder / "cost/data/fpga.json").write_text(json.dumps(prices))


class CostCase(Case):
    def setUp(self):
        super().setUp()
        write_prices(self.folder)

    def write(self, name, content):
        (self.folder / f"cost/data/{name}.json").write_text(json.dumps(content))

    def error(self, lobe, profile, first, last, key="error_rounded_cosine"):
        records = json.loads(self.read("cost/data/accuracy.json"))["points"]
        found, = [r for r in records if (r["lobe"], r["profile"]) == (lobe, profile)]
        return max(found[key][first - 1:last]) / 2 ** (found["O"] + 8)


class Cost(CostCase):
    def test_table(self):
        text = self.good("cost", "--json", "out.json", "--csv", "out.csv")
        found = json.loads(self.read("out.json"))["configurations"]
        self.equal(len(found), 8)  # of hx8k, without the one that has no error
        self.true("left out: bps 18,19,19,12" in text, text)
        self.equal([c["error"] for c in found], sorted(c["error"] for c in found))
        for c in found:
            if c["lobe"] == "table":
                self.equal(c["error"], 0.3)
                continue
            self.near(c["error"], self.error(c["lobe"], c["profile"], 1, 1023), 1e-12)
            self.near(c["latency_ns"], 1e3 * c["latency_clocks"] / c["clock_mhz"], 1e-9)
        with open(self.folder / "out.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.equal([r["lobe"] for r in rows], [c["lobe"] for c in found])
        for row, c in zip(rows, found):
            for column in ("error", "luts", "clock_mhz", "latency_ns", "ns_per_result", "results_per_second"):
                self.near(float(row[column]) / c[column], 1, 1e-8)

    def test_range_of_n_and_cosine(self):
        self.good("cost", "--n", "8:1000", "--cosine", "exact", "--json", "out.json")
        for c in json.loads(self.read("out.json"))["configurations"]:
            self.near(c["error"], self.error(c["lobe"], c["profile"], 8, 1000, "error_exact_cosine"), 1e-12)
        # What brings an error of its own has it at the rounded cosine alone, and from 8 on.
        for arguments, error in ((("--n", "8:1000"), 0.2), (("--n", "7:1000"), 0.3)):
            self.good("cost", *arguments, "--json", "out.json")
            tables = [c for c in json.loads(self.read("out.json"))["configurations"] if c["lobe"] == "table"]
            self.equal([c["error"] for c in tables], [error])

    def dominated(self, *arguments):
        self.good("cost", "--json", "out.json", *arguments)
        return {(c["lobe"], c["architecture"]) for c in json.loads(self.read("out.json"))["configurations"]
                if c["dominated"]}

    def test_dominated(self):
        self.equal(self.dominated(), {("gauss", "pipelined")})
        self.equal(self.dominated("--pareto", "luts") & {("table", "pipelined")}, set())
        self.equal(len(self.dominated("--pareto", "luts")), 7)
        self.equal(len(self.dominated("--pareto", "error")), 7)
        # Devices are not compared with each other.
        self.equal(self.dominated("--device", "all"), {("gauss", "pipelined")})

    def test_sort(self):
        for key, column, down in (("luts", "luts", False), ("latency", "latency_ns", False), ("clock", "clock_mhz", True),
                                  ("throughput", "results_per_second", True)):
            self.good("cost", "--sort", key, "--json", "out.json")
            values = [c[column] for c in json.loads(self.read("out.json"))["configurations"]]
            self.equal(values, sorted(values, reverse=down))

    def test_cpu(self):
        self.true("CPU" not in self.good("cost", "--device", "all"), "no file of CPU prices")
        self.write("cpu", CPU)
        self.true("CPU" not in self.good("cost"), "not an FPGA")
        text = self.good("cost", "--device", "all", "--json", "out.json", "--csv", "out.csv")
        self.true("Made Up 9000" in text, text)
        fixed, double, _ = json.loads(self.read("out.json"))["cpu"]
        self.near(fixed["error"], self.error("bps", "p12", 1, 1023), 1e-12)
        self.equal(double["error"], None)
        with open(self.folder / "out.csv", newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["device"] == "cpu"]
        self.equal([(r["lobe"], r["ns_per_result"], r["latency_ns"], r["luts"]) for r in rows],
                   [("bps", "2.5", "", ""), ("schlick", "12.5", "14", ""), ("schlick", "1.5", "", "")])

    def test_only(self):
        self.good("cost", "--lobe", "bps,cayley", "--json", "out.json")
        self.equal({c["lobe"] for c in json.loads(self.read("out.json"))["configurations"]}, {"bps", "cayley"})
        self.good("cost", "--device", "all", "--profile", "p8,p16", "--json", "out.json")
        self.equal([c["lobe"] for c in json.loads(self.read("out.json"))["configurations"]], ["cayley"])
        self.refused("no price on hx8k is of --lobe 'cubic'", "cost", "--lobe", "cubic")

    def test_accuracy(self):
        """Rows measured anew are those of the committed file; those of others stay."""
        committed = {(r["lobe"], r["profile"]): r for r in json.loads(self.read("cost/data/accuracy.json"))["points"]}
        self.good("cost", "--accuracy", "--lobe", "bps,cayley", "--profile", "p8", "--json", "new.json")
        self.good("cost", "--accuracy", "--lobe", "schlick", "--profile", "p8", "--json", "new.json")
        found = json.loads(self.read("new.json"))["points"]
        self.equal([r["lobe"] for r in found], ["bps", "schlick", "cayley"])
        for record in found:
            want = committed[record["lobe"], "p8"]
            self.near(record.pop("rounding_ulp"), want["rounding_ulp"], 1e-9)
            # Rounded up from a sum of doubles: the last unit may differ between compilers.
            for key in ("error_rounded_cosine", "error_exact_cosine"):
                self.equal(len(record[key]), 1023)
                self.true(max(abs(a - b) for a, b in zip(record[key], want[key])) <= 1, (record["lobe"], key))
            self.equal((record["F"], record["O"], record["inputs"]), (16, 8, 1023 * 65537))

    def test_what_is_not_measured_is_named(self):
        """In a folder without the accuracy of one lobe at one profile and one time on a processor; the rest is there."""
        folder = self.folder / "cost/data"
        shutil.copytree(ROOT / "cost/data", folder, dirs_exist_ok=True)
        for name, of in (("accuracy", {"lobe": "cubic", "profile": "p12"}),
                         ("cpu", {"lobe": "bps", "type": "fixed", "form": "batch"})):
            file = json.loads((folder / f"{name}.json").read_text())
            kept = [point for point in file["points"] if any(point.get(key) != value for key, value in of.items())]
            self.equal(len(kept), len(file["points"]) - 1)
            (folder / f"{name}.json").write_text(json.dumps({**file, "points": kept}))
        said = self.good("cost", "--check", "--rtl", ROOT / "rtl").splitlines()
        self.equal({"not measured: the errors of cubic at p12", "not measured: bps on a processor, fixed, batch"} - set(said), set())

    def test_refusals(self):
        self.refused("metric 'price' is not known: error, ", "cost", "--sort", "price")
        self.refused("metric '' is not known", "cost", "--pareto", "error,")
        self.refused("device 'de10' has no prices: hx8k, up5k, xc7", "cost", "--device", "de10")
        self.refused("--n '0:5' is not legal", "cost", "--n", "0:5")
        self.refused("--cosine 'real' is not legal", "cost", "--cosine", "real")
        self.refused("file 'none/accuracy.json' is not there: `glint cost --accuracy --json none/accuracy.json`", "cost",
                     "--data", "none")
        self.refused("file 'none/out.csv' cannot be written", "cost", "--csv", "none/out.csv")
        self.refused("together", "cost", "--accuracy", "--grid")
        self.refused("--F is not legal here: it is with --grid", "cost", "--F", "18")
        self.refused("--seeds is not legal here: it is with --fpga", "cost", "--seeds", "1")
        self.refused("--n is not legal here: it is of the table", "cost", "--accuracy", "--n", "8:1000")
        self.refused("F 'x' is not legal: 8 to 30", "cost", "--grid", "--F", "x")
        self.refused("device 'de10' is not", "cost", "--grid", "--device", "de10")
        self.refused("file 'none/g.json' cannot be written", "cost", "--grid", "--json", "none/g.json")
        self.refused("--plots with --device all", "cost", "--device", "all", "--plots", "plots")
        self.write("fpga", {"format": "glint-cost-fpga-2", "tools": {}, "points": POINTS})
        self.refused("format .* is not legal: glint-cost-fpga-1", "cost")
        for field, value, line in (("luts", -1, r"points\[0\].luts -1 is not legal"), ("latency", 0, "latency 0"),
                                   ("clock_mhz", "fast", "clock_mhz")):
            self.write("fpga", {"format": "glint-cost-fpga-1", "tools": {}, "points": [{**POINTS[0], field: value}]})
            self.refused(line, "cost")
        self.write("fpga", {"format": "glint-cost-fpga-1", "tools": {}, "points": []})
        self.refused("holds no points", "cost")
        (self.folder / "cost/data/accuracy.json").write_text("{")
        self.refused("is not JSON", "cost")


class Choose(CostCase):
    def chosen(self, *arguments):
        text = self.good("choose", "--json", "out.json", *arguments)
        found = json.loads(self.read("out.json"))
        self.true(text.endswith(found["best"]["emit"] + "\n"), text)
        return found

    def best(self, *arguments):
        best = self.chosen(*arguments)["best"]
        return best["lobe"], best["profile"], best["architecture"]

    def test_best(self):
        self.equal(self.best(), ("quadratic", "p12", "pipelined"))  # a table is a rival, which nothing emits
        self.equal(self.best("--max-error", "0.005"), ("cayley", "p12", "iterative"))
        self.equal(self.best("--max-error", "0.005", "--latency-ns", "500"), ("blinn_phong", "p12", "pipelined"))
        self.equal(self.best("--max-error", "0.005", "--latency-clocks", "20"), ("blinn_phong", "p12", "pipelined"))
        self.equal(self.best("--max-error", "0.005", "--clock", "65MHz", "--throughput", "10M"),
                   ("cayley", "p12", "restoring"))
        self.equal(self.best("--max-error", "0.005", "--minimize", "error"), ("blinn_phong", "p12", "pipelined"))
        self.equal(self.best("--minimize", "latency"), ("quadratic", "p12", "pipelined"))
        # The error of bps at small n is what keeps it out.
        self.equal(self.best("--max-error", "0.03", "--n", "8:1000", "--throughput", "70M"), ("bps", "p12", "restoring"))
        self.equal(self.best("--max-error", "0.03", "--throughput", "70M"), ("cayley", "p12", "restoring"))
        self.equal(self.best("--device", "up5k", "--min-output-bits", "12"), ("blinn_phong", "p12", "pipelined"))

    def test_hls(self):
        """Kernels count only where they are asked for, with an adder cell as two LUTs, and are emitted as kernels."""
        kernel = {"kernel": "cayley", "profile": "p12", "lut4": 300, "ccu2c": 50, "mult18": 5, "dp16kd": 0, "ff": 90,
                  "cycles": 19, "interval": 1, "clock_mhz": 70.0}
        unit = point("bps", "p12", "restoring", "ecp5-25k", 1166, 115.0, 25, dsps=4)
        self.write("fpga", {"format": "glint-cost-fpga-1", "tools": {}, "points": [*POINTS, unit]})
        self.write("hls", {"format": "glint-cost-hls-1", "points": [
            kernel, {**kernel, "form": "radix4", "lut4": 500, "cycles": 9}, {**kernel, "kernel": "effect_ward"}]})
        self.equal(self.best("--device", "ecp5"), ("bps", "p12", "restoring"))
        found = self.chosen("--device", "ecp5", "--hls")
        self.equal((found["configurations"], found["best"]["architecture"], found["best"]["luts"]), (3, "hls", 400))
        self.equal(found["best"]["emit"], "glint emit --lobe cayley --profile p12 --target hls -o out")
        self.near(found["best"]["error"], 0.000793, 1e-5)
        self.equal(self.best("--device", "ecp5", "--hls", "--minimize", "latency"), ("cayley", "p12", "hls:radix4"))
        self.write("hls", {"format": "glint-cost-hls-1", "points": [{**kernel, "cycles": 0}]})
        self.refused("cycles.* 0", "choose", "--device", "ecp5")

    def test_units(self):
        for text in ("48", "48MHz", "48e6Hz", "48000kHz", "0.048GHz"):
            found = self.chosen("--max-error", "0.005", "--clock", text)
            self.near(found["wanted"][1]["bound"], 48, 1e-9)
            # Run at the clock asked for, though it reaches more.
            self.near(found["best"]["latency_ns"], 1e3 * found["best"]["latency_clocks"] / 48, 1e-6)
        for text in ("700", "700ns", "0.7us"):
            self.near(self.chosen("--latency-ns", text)["wanted"][0]["bound"], 700, 1e-9)
        for text in ("40M", "40e6", "40000k", "0.04G/s", "40M/s"):
            self.near(self.chosen("--throughput", text)["wanted"][0]["bound"] / 40e6, 1, 1e-9)

    def test_runners_up(self):
        found = self.chosen("--max-error", "0.005")
        # cayley restoring costs more and is not as exact as blinn_phong, but a result takes less time.
        self.equal([(c["lobe"], c["architecture"]) for c in found["runners_up"]],
                   [("blinn_phong", "pipelined"), ("cayley", "restoring")])
        self.equal((found["feasible"], found["configurations"]), (3, 7))
        note = found["runners_up"][0]["against_best"]
        self.true(note.startswith("+79 % LUTs, error 0.000155 instead of 0.000793, latency 300 ns instead of 620"), note)
        self.true(note in self.good("choose", "--max-error", "0.005"), note)
        self.equal(len(self.chosen("--max-error", "0.005", "--runners-up", "1")["runners_up"]), 1)
        self.equal(self.chosen("--max-error", "0.005", "--runners-up", "0")["runners_up"], [])

    def test_words(self):
        """Names as they seem to mean, numbers without powers of ten, and what the best is the best of."""
        self.equal(self.best("--minimize", "latency-ns"), self.best("--minimize", "latency"))
        text = self.good("choose", "--throughput", "50M")
        self.matches(text, "--throughput 50M\n")
        self.matches(text, r"4 of the 7 priced configurations will do")
        for arguments in (("--throughput", "900M"), ("--max-error", "0.0000001"), ("--latency-ns", "0.001")):
            done = self.run_tool("choose", *arguments)
            self.equal(done.returncode, 1)
            self.true(not re.search(r"\de[-+]\d", done.stdout), done.stdout)
            self.matches(done.stdout, "none of the 7 priced configurations will do")

    def test_device_without_clocks(self):
        done = self.run_tool("choose", "--device", "xc7", "--clock", "50MHz")
        self.equal(done.returncode, 1)
        self.matches(done.stdout, "prices on xc7 are resources alone, without a clock: --clock says nothing there\n")
        self.true("glint cost" not in done.stdout, done.stdout)

    def test_without_a_price(self):
        """What has a price elsewhere and could win here is named, with the command that prices it."""
        found = self.chosen("--device", "up5k", "--minimize", "error", "--max-error", "0.01")
        self.equal(found["best"]["lobe"], "blinn_phong")
        found = self.chosen("--device", "up5k", "--max-error", "0.03")
        commands = [entry["command"] for entry in found["unpriced"]]
        # The others have more LUTs than the 1300 of blinn_phong.
        self.equal(commands, ["glint cost --fpga --lobe cayley --profile p8 --architecture restoring --device up5k"])
        done = self.run_tool("choose", "--device", "up5k", "--max-error", "0.03", "--no-dsp", "--json", "out.json")
        self.equal(done.returncode, 1)
        commands = [entry["command"] for entry in json.loads(self.read("out.json"))["unpriced"]]
        line = "glint cost --fpga --lobe cayley --profile p12 --architecture iterative --device up5k --dsp off"
        self.true(line in commands and line in done.stdout, done.stdout)
        self.equal([entry for entry in commands if "quadratic" in entry], [])  # its error is too large

    def test_emit(self):
        """The line printed works, and gives the architecture asked for."""
        for arguments, words in ((("--max-error", "0.005"), ["--architecture", "iterative"]),
                                 (("--max-error", "0.005", "--minimize", "error"), [])):
            line = self.chosen(*arguments)["best"]["emit"]
            for word in words:
                self.true(word in line, line)
            self.true(bool(words) or "--architecture" not in line, line)
            name, *rest = line.split()
            self.equal(name, "glint")
            self.good(*rest)
            lobe = rest[rest.index("--lobe") + 1]
            self.true(f"module glint_{lobe}_p12" in self.read(f"out/glint_{lobe}_p12.v"), lobe)

    def none(self, *arguments):
        done = self.run_tool("choose", "--json", "out.json", *arguments)
        self.equal((done.returncode, done.stderr), (1, ""))
        found = json.loads(self.read("out.json"))
        self.equal((found["best"], found["feasible"]), (None, 0))
        steps = [step["option"] for step in found["relaxations"]]
        for step in steps:
            self.true(step in done.stdout, done.stdout)
        return steps

    def test_relaxed(self):
        arguments = ["--max-error", "0.001", "--max-luts", "1000", "--latency-ns", "1us"]
        steps = self.none(*arguments)
        self.equal(steps, ["--max-error 0.2801", "--max-luts 1900"])
        # Each step opens a solution, and a hair less does not.
        for step in steps:
            option, bound = step.split()
            place = arguments.index(option) + 1
            relaxed = [*arguments[:place], bound, *arguments[place + 1:]]
            self.chosen(*relaxed)
            self.none(*arguments[:place], f"{float(bound) * 0.999:.0f}" if option == "--max-luts" else
                      str(float(bound) * 0.999), *arguments[place + 1:])
        self.equal(self.none("--max-error", "1e-6", "--clock", "1GHz"), [])
        self.true("no change of one" in self.run_tool("choose", "--max-error", "1e-6", "--clock", "1GHz").stdout, "")
        self.equal(self.none("--clock", "200"), ["--clock 80MHz"])
        self.equal(self.none("--device", "up5k", "--no-dsp"), ["without --no-dsp", "--device hx8k", "--device xc7"])
        self.equal(self.none("--device", "xc7", "--clock", "1"), ["--device hx8k", "--device up5k"])

    def test_refusals(self):
        for option, text, legal in (("--clock", "48Mhz", "MHz, GHz"), ("--clock", "0", "above 0"),
                                    ("--clock", "-5MHz", "above 0"), ("--clock", "MHz", "MHz, GHz"),
                                    ("--clock", "nan", "above 0"), ("--latency-ns", "200MHz", "ns, us, ms"),
                                    ("--latency-ns", "1e999", "above 0"), ("--max-error", "1%", "a number above 0"),
                                    ("--max-error", "0", "above 0"), ("--throughput", "fast", "M/s")):
            self.refused(f"{option} '{text}' is not legal: .*{legal}", "choose", f"{option}={text}")
        self.refused("--latency-clocks '0' is not legal: 1 to", "choose", "--latency-clocks", "0")
        self.refused("--min-output-bits '29' is not legal: 4 to 28", "choose", "--min-output-bits", "29")
        self.refused("--max-luts '1.5' is not legal", "choose", "--max-luts", "1.5")
        self.refused("metric 'beauty' is not known", "choose", "--minimize", "beauty")
        self.refused("device 'de10' has no prices", "choose", "--device", "de10")
        self.refused("--n '8:2000' is not legal", "choose", "--n", "8:2000")
        self.refused("file 'none/out.json' cannot be written", "choose", "--json", "none/out.json")
        self.refused("file 'none/accuracy.json' is not there", "choose", "--data", "none")
        self.equal(self.files(), ["cost/data/accuracy.json", "cost/data/fpga.json"])


class Prices(Case):
    """What the committed prices are held to."""

    def chosen(self, *arguments):
        self.good("choose", "--data", ROOT / "cost/data", "--json", "out.json", *arguments)
        return json.loads(self.read("out.json"))["best"]

    def interval(self, c):
        """Clocks between two results."""
        return round(1e6 * c["clock_mhz"] / c["results_per_second"])

    def test_better_than_bps_at_no_higher_cost(self):
        """12 bits with an error under 0.002 for n from 8 to 1000 cost no more LUTs of an HX8K than bps at p12, in any
        architecture that gives as many results a clock."""
        best = self.chosen("--max-error", "0.002", "--n", "8:1000", "--min-output-bits", "12", "--no-dsp",
                           "--device", "hx8k")
        self.good("cost", "--data", ROOT / "cost/data", "--lobe", "bps", "--profile", "p12", "--json", "out.json")
        bps = [c for c in json.loads(self.read("out.json"))["configurations"]
               if c["dsps"] == 0 and self.interval(c) <= self.interval(best)]
        self.true(len(bps) > 1, "bps p12 has prices")
        self.true(best["error"] < 0.002 and best["output_bits"] >= 12, f"{best}")
        for c in bps:
            self.true(best["luts"] <= c["luts"], f"{best} against {c}")

    def test_one_unit_once(self):
        """A unit that has no use for DSP blocks is priced with and without them, and stands in the list once."""
        for device in ("up5k", "xc7", "ecp5"):
            for arguments in (("--no-dsp",), ()):
                self.good("choose", "--data", ROOT / "cost/data", "--json", "out.json", "--device", device, "--runners-up",
                          "100", *arguments)
                found = json.loads(self.read("out.json"))
                units = [(c["lobe"], c["profile"], c["architecture"], c["dsps"])
                         for c in [found["best"]] + found["runners_up"]]
                self.equal(len(units), len(set(units)), f"{device} {arguments}")

    def test_none_is_unpriced(self):
        """On no device without DSP blocks could a unit be better that is priced elsewhere alone."""
        for device in ("hx8k", "up5k", "ecp5", "xc7"):
            for arguments in (("--max-error", "0.004", "--n", "8:512"), ("--max-error", "0.001"), ("--max-error", "0.0003")):
                self.good("choose", "--data", ROOT / "cost/data", "--json", "out.json", "--device", device, "--no-dsp", *arguments)
                self.equal(json.loads(self.read("out.json"))["unpriced"], [], f"{device} {arguments}")

    def test_decay(self):
        """What the lobe of tables is held to, over all n: an error, LUTs, block RAMs, MHz, clocks."""
        figures = [  # device, DSPs, error, LUTs, block RAMs, MHz, clocks
            ("hx8k", False, 1 / 256, 300, 3, 0, 99),
            ("hx8k", False, 1 / 1024, 500, 8, 100, 10),
            ("hx8k", False, 1 / 4096, 900, 32, 0, 99),
            ("up5k", True, 1 / 256, 150, 30, 0, 99),
            ("ecp5-25k", True, 1 / 1024, 150, 2, 200, 99),
        ]
        errors = {}
        for device in ("hx8k", "up5k", "ecp5-25k"):
            self.good("cost", "--data", ROOT / "cost/data", "--lobe", "decay", "--device", device, "--json", "out.json")
            errors.update({c["profile"]: c["error"] for c in json.loads(self.read("out.json"))["configurations"]})
        points = [p for p in json.loads((ROOT / "cost/data/fpga.json").read_text())["points"] if p["lobe"] == "decay"]
        for device, dsp, error, luts, brams, clock, clocks in figures:
            good = [p for p in points if p["device"] == device and p["dsp"] == dsp and errors.get(p["profile"], 1) < error
                    and p["luts"] <= luts and p["dsps"] <= 2 and p["brams"] <= brams and p.get("clock_mhz", 0) >= clock
                    and p["latency"] <= clocks and p["interval"] == 1 and p["fits"]]
            self.true(len(good) > 0, f"{device} below {error}: {luts} LUTs, {brams} block RAMs, {clock} MHz, {clocks} clocks")

    def test_family(self):
        """A family's name stands for its first device."""
        self.equal(self.chosen("--device", "ecp5"), self.chosen("--device", "ecp5-25k"))
        self.refused("device 'ecp' has no prices: hx8k", "choose", "--data", ROOT / "cost/data", "--device", "ecp")

    def test_rounding_costs_little(self):
        """The same with rounding below 1 ulp costs no more than bps at p12 as shipped."""
        self.good("cost", "--data", ROOT / "cost/data", "--n", "8:1000", "--json", "out.json")
        configurations = [c for c in json.loads(self.read("out.json"))["configurations"] if c["dsps"] == 0]
        bps = [c for c in configurations if c["lobe"] == "bps" and c["profile"] == "p12" and c["architecture"] == "restoring"]
        good = [c for c in configurations if c["error"] < 0.002 and c["output_bits"] >= 12 and c["rounding_ulp"] < 1]
        self.true(len(bps) == 1 and len(good) > 0, "there are prices of both")
        best = min(good, key=lambda c: c["luts"])
        self.true(best["luts"] <= bps[0]["luts"], f"{best} against {bps[0]}")

    def test_grid(self):
        """Each format of the word-length grid keeps the promise: of the rounding error, or of the error that was asked for."""
        grids = json.loads((ROOT / "cost/data/grid.json").read_text())["grids"]
        self.true(len(grids) > 0, "no grids")
        for grid in grids:
            for form in grid["formats"]:
                if "max_error" in grid:
                    self.true(form["error"] <= form["bound"] < grid["max_error"], f"{grid['lobe']} {form}")
                    continue
                self.true(form["rounding_ulp"] < 1, f"{grid['lobe']} {form}")
                numbers = form["profile"].split(",")
                if len(numbers) > 1:
                    self.equal((int(numbers[0]), int(numbers[-1])), (grid["F"], grid["O"]))
