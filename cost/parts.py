#!/usr/bin/env python3
"""What the parts of a unit of `decay` cost on the HX8K: Yosys, module by module.

    cost/parts.py --glint build/release/glint --json cost/data/parts.json 16,4,8,8,4,1,4,0,9 ...

The modules are mapped apart from each other (`synth_ice40 -noflatten`), so that their sum is a little above the unit's LUTs.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PARTS = {"glint_stream": "handshake", "glint_delay": "delays", "glint_normalise": "shift", "glint_multiplier": "products"}


def luts(glint, profile):
    """The LUTs of a format's unit by part; what is in no module of its own is `rest`: corrections, sums, the choice of y."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([glint, "emit", "--lobe", "decay", "--profile", profile, "--target", "verilog", "-o", folder],
                       check=True, stdout=subprocess.DEVNULL)
        top = "glint_decay_" + profile.replace(",", "_")
        names = [line for line in (Path(folder) / f"{top}.f").read_text().splitlines() if not line.startswith("//")]
        files = [name.replace("$(GLINT_RTL)", str(ROOT / "rtl")).replace("$(GLINT_EMITTED)", folder) for name in names]
        stat = Path(folder) / "stat"
        script = (f"read_verilog {' '.join(files)}; chparam -set TAG_W 1 {top}; synth_ice40 -noflatten -top {top}; "
                  f"tee -q -o {stat} stat")
        subprocess.run(["yosys", "-q", "-p", script], check=True, stdout=subprocess.DEVNULL)
        modules = {}
        for line in stat.read_text().splitlines():
            if line.startswith("=== "):
                cells = modules.setdefault(line.strip("= "), {})
            elif re.fullmatch(r" {5,}\S+ +\d+", line):
                cells[line.split()[0]] = int(line.split()[1])

    found = dict.fromkeys([*PARTS.values(), "rest"], 0)

    def count(module, part):
        for cell, number in modules[module].items():
            if cell == "SB_LUT4":
                found[part] += number
            elif cell in modules:
                for _ in range(number):
                    count(cell, PARTS.get(re.search(r"(\w+)$", cell)[1], part))

    count(top, "rest")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--glint", required=True)
    parser.add_argument("--json", required=True)
    parser.add_argument("profiles", nargs="+")
    options = parser.parse_args()
    points = [{"profile": profile, **luts(options.glint, profile)} for profile in options.profiles]
    for point in points:
        print(point)
    lines = ",\n".join(json.dumps(point) for point in points)
    Path(options.json).write_text(f'{{"format": "glint-cost-parts-1",\n "points": [\n{lines}\n]}}\n')
    return 0


if __name__ == "__main__":
    sys.exit(main())
