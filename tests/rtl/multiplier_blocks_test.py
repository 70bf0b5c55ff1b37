#!/usr/bin/env python3
"""Products go into the multiplier blocks of devices that have them: iCE40 UltraPlus (SB_MAC16) and ECP5 (MULT18X18D).

    multiplier_blocks_test.py YOSYS

Every lobe's unit at p12, with products of one clock, is synthesized as far as Yosys chooses such blocks; a unit without one is a
failure, and so is one with blocks where they are switched off, which shows that the count counts.
"""

import re

import icarus
from units import units

FLOWS = {"SB_MAC16": ("synth_ice40 -dsp", "synth_ice40"), "MULT18X18D": ("synth_ecp5", "synth_ecp5 -nodsp")}


def blocks(yosys, unit, flow, block):
    """How many blocks the flow makes of a unit."""
    sources = " ".join(map(str, unit["files"]))
    script = f"read_verilog -defer -D SYNTHESIS {sources}; {flow} -top {unit['name']} -run begin:map_ram; stat"
    found = re.findall(rf"^ +{block} +(\d+)$|^ +(\d+) +{block}$", icarus.command(yosys, "-p", script), re.MULTILINE)
    return int("".join(found[-1])) if found else 0


def main(yosys):
    chosen = [unit for unit in units().values() if unit["kind"] == "lobe" and unit["profile"] == "p12"]
    for block, (on, off) in FLOWS.items():
        for unit in chosen:
            count = blocks(yosys, unit, on, block)
            print(f"{unit['name']}: {count} {block}")
            if count == 0:
                raise icarus.Failed(f"{on}: {unit['name']} has no {block}")
        if blocks(yosys, chosen[0], off, block) != 0:
            raise icarus.Failed(f"{off}: {chosen[0]['name']} has a {block}")
    return 0 if chosen else 1


if __name__ == "__main__":
    icarus.main(main)
