#!/usr/bin/env python3
"""Netlists of glint_bps_p12 for two devices through Verilator, by the commands of docs/replay.md; a wrong one must fail.

    device_netlists_test.py GLINT        the Verilog itself, both forms, goes through Verilator, too
"""

import os
import re
import subprocess
import tempfile
from pathlib import Path

import icarus
import replay

ROOT = replay.RTL.parent
PAGE = ROOT / "docs/replay.md"


def main(glint):
    commands = re.search(r"<!-- run by tests/rtl/device_netlists_test.py -->\n```sh\n(.*?)```", PAGE.read_text(), re.DOTALL)[1]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for link in ("rtl", "tests"):
            (folder / link).symlink_to(ROOT / link)
        done = subprocess.run(["bash", "-euc", commands], cwd=folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": f"{Path(glint).parent}:{os.environ['PATH']}"})
        if done.returncode != 0 or done.stdout.count("10000 vectors, 0 mismatches\n") != 4:
            raise icarus.Failed(f"exit status {done.returncode}\n{done.stdout}{done.stderr[-2000:]}")
        print(done.stdout, end="", flush=True)
        vectors = folder / "vectors/glint_bps_p12.hex"
        for kind in ("core", "axis"):
            replay.replay(vectors, kind, replay.RTL, sim="verilator")
        cells = re.search(r"^cells=(.*)$", commands, re.MULTILINE)[1]
        files = [folder / "ecp5.v", Path(cells) / "ecp5/cells_sim.v", replay.RTL / "simulation/MULT18X18D.v"]
        text, found = re.subn(r"\.INIT\(16'h(\w+)\)", lambda init: f".INIT(16'h{int(init[1], 16) ^ 0xFFFF:04x})", files[0].read_text(), count=1)
        if found != 1:
            raise icarus.Failed("no look-up table of the netlist to spoil")
        files[0].write_text(text)
        try:
            replay.replay(vectors, "core", replay.RTL, netlist=files, sim="verilator")
        except icarus.Failed as failed:
            if "FAILED: " not in str(failed) or "mismatches" not in str(failed):
                raise
            print("a netlist with a wrong look-up table: found")
            return 0
    raise icarus.Failed("a netlist with a wrong look-up table passed")


if __name__ == "__main__":
    icarus.main(main)
