#!/usr/bin/env python3
"""`glint choose` over a folder of few prices, whose answers are computed by hand.

    choose_test.py --glint build/glint

Exit status: 0 if every check held.
"""

import json

from case import Case, main

# Of each lobe at p8 the error at every n, in units of 2^-16.
ERRORS = {"schlick": 256, "bps": 512, "cubic": 128, "cayley": 384, "gauss": 512}
# Lobe, architecture, device, DSPs allowed, DSPs, LUTs, MHz, clocks; no LUTs: it does not fit.
PRICES = (("schlick", "restoring", "hx8k", False, 0, 300, 50, 10), ("schlick", "restoring", "hx8k", True, 0, 300, 50, 10),
          ("bps", "restoring", "hx8k", False, 0, 200, 100, 25), ("gauss", "restoring", "hx8k", True, 0, 500, 50, 25),
          ("rival", "plain", "hx8k", False, 0, 1, 100, 1), ("cubic", "pipelined", "hx8k", False, 0, None, None, None),
          ("schlick", "restoring", "up5k", False, 0, 310, 20, 10), ("cubic", "pipelined", "up5k", False, 0, 100, 30, 5),
          ("cayley", "pipelined", "up5k", False, 0, 90, 25, 5), ("cayley", "pipelined", "xc7", False, 0, 95, None, 5),
          ("schlick", "restoring", "ecp5-25k", True, 4, 50, 100, 10), ("bps", "restoring", "ecp5-25k", True, 0, 250, 100, 25))


class Choose(Case):
    def setUp(self):
        super().setUp()
        folder = self.folder / "data"
        folder.mkdir()
        accuracy = [{"lobe": lobe, "profile": "p8", "F": 16, "O": 8, "inputs": 1023 * 65537, "rounding_ulp": 0.5,
                     "error_rounded_cosine": [error] * 1023, "error_exact_cosine": [2 * error] * 1023}
                    for lobe, error in ERRORS.items()]
        points = []
        for lobe, architecture, device, dsp, dsps, luts, mhz, latency in PRICES:
            point = {"lobe": lobe, "profile": "p8", "architecture": architecture, "device": device, "dsp": dsp}
            if luts is None:
                point["fits"] = False
            else:
                point |= {"luts": luts, "registers": 0, "carries": 0, "dsps": dsps, "brams": 0, "clock_mhz": mhz,
                          "latency": latency, "interval": 1}
            if lobe == "rival":
                point["error"] = {"max": 0.001, "max_n8": 0.001}
            points.append(point)
        for name, of, some in (("accuracy", "accuracy", accuracy), ("fpga", "fpga", points)):
            (folder / f"{name}.json").write_text(json.dumps({"format": f"glint-cost-{of}-1", "tools": {}, "points": some}))

    def choose(self, *arguments, status=0):
        """What it prints and what it writes."""
        done = self.run_tool("choose", "--data", "data", "--json", "out.json", *arguments)
        self.equal((done.returncode, done.stderr), (status, ""), arguments)
        return done.stdout, json.loads((self.folder / "out.json").read_text())

    def best(self, *arguments):
        best = self.choose(*arguments)[1]["best"]
        return f"{best['lobe']} {best['luts']}"

    def commands(self, *unpriced, device="hx8k", more=""):
        return [f"glint cost --fpga --lobe {lobe} --profile p8 --architecture pipelined --device {device}{more}" for lobe in unpriced]

    def test_best(self):
        """A rival is no choice, and a price with leave to use DSPs counts once where it uses none."""
        text, json_ = self.choose("--n", "5:10")
        self.equal((json_["configurations"], json_["feasible"], json_["wanted"]), (3, 3, []))
        self.equal(json_["n"], {"first": 5, "last": 10, "step": 1})
        self.equal((json_["device"], json_["minimize"], json_["cosine"]), ("hx8k", "luts", "rounded"))
        self.equal((json_["best"]["lobe"], json_["best"]["luts"], json_["best"]["error"]), ("bps", 200, 512 / 65536))
        self.equal(json_["best"]["emit"], "glint emit --lobe bps --profile p8 --target verilog -o out")
        against = "+50 % LUTs, error 0.00391 instead of 0.00781, latency 200 ns instead of 250, a result in 20.0 ns instead of 10.0"
        self.equal([(r["lobe"], r["against_best"]) for r in json_["runners_up"]], [("schlick", against)])
        self.matches(text, r"against the first:\n  schlick p8 restoring: \+50 % LUTs")
        self.matches(text, "3 of the 3 priced configurations will do; 2 of those are not beaten")
        # Of the others cubic does not fit here, and that with the fewest LUTs is priced on two devices.
        self.equal([(u["command"], u["luts"], u["priced_on"], u["error"]) for u in json_["unpriced"]],
                   [(*self.commands("cayley"), 90, "up5k", 384 / 65536)])
        self.matches(text, r"1 without a price on hx8k could be better, by their prices elsewhere; these price them:\n  glint cost")
        self.equal(self.choose("--runners-up", "0")[1]["runners_up"], [])

    def test_wishes(self):
        """Units of quantities, each option, and both ends of a bound."""
        for arguments, option, metric, bound, best in (
                (["--clock", "0.1GHz"], "--clock", "clock", 100, "bps 200"),
                (["--clock", "50MHz"], "--clock", "clock", 50, "bps 200"),
                (["--latency-ns", "0.2us"], "--latency-ns", "latency", 200, "schlick 300"),
                (["--latency-clocks", "10"], "--latency-clocks", "latency-clocks", 10, "schlick 300"),
                (["--throughput", "60M"], "--throughput", "throughput", 60e6, "bps 200"),
                (["--max-error", "0.0039063"], "--max-error", "error", 0.0039063, "schlick 300"),
                (["--no-dsp", "--minimize", "error"], "--no-dsp", "dsps", 0, "schlick 300"),
                (["--max-luts", "100000000"], "--max-luts", "luts", 100000000, "bps 200"),
                (["--min-output-bits", "8"], "--min-output-bits", "output-bits", 8, "bps 200")):
            wanted = self.choose(*arguments)[1]["wanted"]
            self.equal([(w["option"], w["metric"], w["bound"]) for w in wanted], [(option, metric, bound)])
            self.equal(self.best(*arguments), best, arguments)
        self.equal(self.best("--device", "ecp5"), "schlick 50")
        for option, value in (("--max-luts", 100000001), ("--latency-clocks", 0), ("--min-output-bits", 29), ("--runners-up", 101)):
            self.equal(self.run_tool("choose", "--data", "data", option, value).returncode, 2, option)
        self.matches(self.good("choose", "--help"), r"Example: glint choose --max-error 0\.005")

    def test_none(self):
        """Which one change is enough: of one constraint, rounded to where it holds, or of the device."""
        text, json_ = self.choose("--max-error", "0.003", "--max-luts", "310", status=1)
        self.equal(json_["best"], None)
        self.equal([(r["option"], r["configuration"]["lobe"]) for r in json_["relaxations"]],
                   [("--max-error 0.003907", "schlick"), ("--device up5k", "cubic")])
        self.matches(text, "none of the 3 priced configurations will do:\n")
        self.equal(json_["unpriced"], [])
        text, json_ = self.choose("--max-luts", "100", status=1)
        self.equal([(r["option"], r["configuration"]["lobe"]) for r in json_["relaxations"]],
                   [("--max-luts 200", "bps"), ("--device up5k", "cayley"), ("--device ecp5-25k", "schlick"), ("--device xc7", "cayley")])
        self.equal([u["command"] for u in json_["unpriced"]], self.commands("cayley"))
        text, json_ = self.choose("--max-error", "0.0001", "--max-luts", "1", status=1)
        self.equal(json_["relaxations"], [])
        self.matches(text, ", and no change of one constraint or of the device is enough\n")

    def test_no_dsp(self):
        """A price that was allowed DSPs and took none is one without."""
        self.equal(self.choose("--device", "ecp5-25k")[1]["unpriced"], [])
        _, json_ = self.choose("--device", "ecp5-25k", "--no-dsp")
        self.equal((json_["best"]["lobe"], json_["best"]["luts"]), ("bps", 250))
        self.equal([u["command"] for u in json_["unpriced"]], self.commands("cayley", "cubic", device="ecp5-25k", more=" --dsp off"))
        _, json_ = self.choose("--device", "ecp5-25k", "--no-dsp", "--max-error", "0.004", status=1)
        self.equal([r["option"] for r in json_["relaxations"]][:2], ["--max-error 0.007813", "without --no-dsp"])

    def test_without_clocks(self):
        """A device whose prices have no clock: one line says what is asked in vain."""
        line = "prices on xc7 are resources alone, without a clock: {} says nothing there\n"
        for option, value in (("--clock", "10MHz"), ("--latency-ns", "100"), ("--throughput", "1M")):
            self.matches(self.choose("--device", "xc7", option, value, status=1)[0], line.format(option))
        for metric in ("clock", "latency", "ns", "throughput"):
            self.matches(self.choose("--device", "xc7", "--minimize", metric)[0], line.format(f"--minimize {metric}"))
        for arguments in (["--device", "xc7"], ["--clock", "50MHz"], ["--minimize", "ns"]):
            self.true("resources alone" not in self.choose(*arguments)[0], arguments)


if __name__ == "__main__":
    main()
