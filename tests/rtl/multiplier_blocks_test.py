#!/usr/bin/env python3
"""Products go into the multiplier blocks of devices that have them: iCE40 UltraPlus (SB_MAC16) and ECP5 (MULT18X18D).

    multiplier_blocks_test.py YOSYS FOLDER     the folder of the wrappers

Every lobe's unit at p12, with products of one clock, is synthesized as far as Yosys chooses such blocks; a unit without one is a
failure, and so is one with blocks where they are switched off, which shows that the count counts.
"""

import re
import subprocess
import sys
from pathlib import Path

RTL = Path(__file__).resolve().parents[2] / "rtl"
FLOWS = {"SB_MAC16": ("synth_ice40 -dsp", "synth_ice40"), "MULT18X18D": ("synth_ecp5", "synth_ecp5 -nodsp")}


def blocks(yosys, wrapper, flow, block):
    """How many blocks the flow makes of a unit."""
    sources = " ".join(str(file) for file in [*sorted(RTL.glob("*.v")), wrapper])
    script = f"read_verilog -defer -D SYNTHESIS {sources}; {flow} -top {wrapper.stem} -run begin:map_ram; stat"
    done = subprocess.run([yosys, "-p", script], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{flow} of {wrapper.stem}: exit status {done.returncode}\n{done.stderr}")
    found = re.findall(rf"^ +{block} +(\d+)$|^ +(\d+) +{block}$", done.stdout, re.MULTILINE)
    return int("".join(found[-1])) if found else 0


def main():
    yosys, folder = sys.argv[1:]
    lobes = re.findall(r"^GLINT_LOBE\((\w+)\)$", (RTL.parent / "model/include/glint/lobes.def").read_text(), re.MULTILINE)
    wrappers = [Path(folder) / f"glint_{lobe}_p12.v" for lobe in lobes]
    try:
        for block, (on, off) in FLOWS.items():
            for wrapper in wrappers:
                count = blocks(yosys, wrapper, on, block)
                print(f"{wrapper.stem}: {count} {block}")
                if count == 0:
                    raise RuntimeError(f"{on}: {wrapper.stem} has no {block}")
            if blocks(yosys, wrappers[0], off, block) != 0:
                raise RuntimeError(f"{off}: {wrappers[0].stem} has a {block}")
    except RuntimeError as error:
        print(f"FAILED: {error}", file=sys.stderr)
        return 1
    return 0 if wrappers else 1


if __name__ == "__main__":
    sys.exit(main())
