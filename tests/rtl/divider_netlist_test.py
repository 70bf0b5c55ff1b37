#!/usr/bin/env python3
"""Dividers of the ECP5 as its synthesis leaves them, by the contract of glint_divider, in Icarus; a wrong netlist must fail.

    divider_netlist_test.py YOSYS

Every operand of small widths, random ones, corners among them, at those of `bps` p12. The cells are Yosys's models, that of
MULT18X18D is ours.
"""

import re
import subprocess
import tempfile
from pathlib import Path

import icarus
import units_test
from family_multiplier_test import library
from icarus import RTL
from units import modules

HERE = Path(__file__).parent
RANDOM = 500
RUNS = [run for which in (0, 1, 3) for run in (units_test.divider(9, 6, 5, which=which), units_test.divider(10, 5, 5, which=which),
                                               units_test.divider(*units_test.of_lobe(18, 15), RANDOM, which))]
PORTS = (("clk_i", "1"), ("enable_i", "1"), ("start_i", "1"), ("dividend_i", "X_W"), ("divisor_i", "Y_W"), ("beside_i", "BESIDE_W"))
OUTPUTS = (("done_o", "1"), ("quotient_o", "Q_W"), ("remainder_o", "Y_W"), ("beside_o", "BESIDE_W"))


def netlist(yosys, folder, files, parameters):
    """The netlist, and a glint_divider around it: the bench sets parameters, of which a netlist has none."""
    chosen = {name: value for name, value in parameters.items() if name not in ("DIVISIONS", "LATENCY")}
    chosen["BESIDE_W"] = chosen["Y_W"]
    values = " ".join(f"-set {name} {value}" for name, value in chosen.items())
    made = Path(folder) / "netlist.v"
    script = (f"read_verilog {' '.join(map(str, files))}; chparam {values} glint_divider; synth_ecp5 -top glint_divider; "
              f"rename -top netlist; write_verilog -noattr {made}")
    subprocess.run([yosys, "-q", "-p", script], check=True)
    wrapper = Path(folder) / "wrapper.v"
    wrapper.write_text(
        f"module glint_divider #(parameter {', '.join(f'{name} = {value}' for name, value in chosen.items())}) (\n"
        + ",\n".join([*(f"    input wire [{w}-1:0] {p}" for p, w in PORTS), *(f"    output wire [{w}-1:0] {p}" for p, w in OUTPUTS)])
        + f");\n    netlist netlist ({', '.join(f'.{p}({p})' for p, _ in (*PORTS, *OUTPUTS))});\nendmodule\n")
    return [made, wrapper]


def simulate(folder, files, parameters):
    icarus.build(Path(folder) / "bench", "divider_tb", [*files, HERE / "divider_tb.v"], parameters, strict=False)
    return icarus.run(Path(folder) / "bench")


def check(yosys):
    files = [file for file in units_test.of_family("ecp5", modules()["glint_divider"]) if "simulation" not in file.parts]
    cells = library(yosys, "ecp5", RTL / "simulation/MULT18X18D.v")
    total = 0
    with tempfile.TemporaryDirectory() as folder:
        for parameters, expected in RUNS:
            made = netlist(yosys, folder, files, parameters)
            icarus.require(simulate(folder, [*made, *cells], parameters), "divisions", expected)
            total += expected
        made = netlist(yosys, folder, files, RUNS[0][0])
        text = made[0].read_text()
        tables = [found.start(1) for found in re.finditer(r"\.INIT[01]?\(16'h(\w+)\)", text)]
        at = tables[len(tables) // 2]
        made[0].write_text(text[:at] + f"{int(text[at:at + 4], 16) ^ 0xFFFF:04x}" + text[at + 4:])
        if icarus.counts(simulate(folder, [*made, *cells], RUNS[0][0]), "divisions")[1] == 0:
            raise icarus.Failed("a netlist with a wrong look-up table passed")
    print(f"netlists of {len(RUNS)} dividers: {total} divisions, 0 mismatches; a wrong look-up table found")


if __name__ == "__main__":
    icarus.main(check)
