#!/usr/bin/env python3
"""A netlist by Yosys takes the place of a unit in the replay; one with a gate that is wrong must fail.

    netlist_test.py GLINT YOSYS
"""

import re
import subprocess
import tempfile
from pathlib import Path

import icarus
import replay
from units import units

UNIT, COUNT = "glint_quadratic_p8", 300


def main(glint, yosys):
    files = " ".join(map(str, units()[UNIT]["files"]))
    with tempfile.TemporaryDirectory() as folder:
        netlist = Path(folder) / "mine.v"
        subprocess.run([glint, "vectors", "--lobe", "quadratic", "--profile", "p8", "--count", str(COUNT), "--format", "hex",
                        "-o", folder], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([yosys, "-q", "-p", f"read_verilog {files}; synth -flatten -top {UNIT}; write_verilog -noattr {netlist}"],
                       check=True)
        vectors = Path(folder) / f"{UNIT}.hex"
        replay.replay(vectors, "core", replay.RTL, netlist=[netlist])
        text, found = re.subn(r"\^", "|", netlist.read_text(), count=1)
        if found != 1:
            raise icarus.Failed("no gate of the netlist to spoil")
        netlist.write_text(text)
        try:
            replay.replay(vectors, "core", replay.RTL, netlist=[netlist])
        except icarus.Failed:
            print("a netlist with a wrong gate: found")
            return 0
    raise icarus.Failed("a netlist with a wrong gate passed")


if __name__ == "__main__":
    icarus.main(main)
