#!/usr/bin/env python3
"""Architectures that rtl/ does not hold: `glint emit` writes each, and Icarus replays vectors through it.

    forms_test.py GLINT
"""

import tempfile
from pathlib import Path

import icarus
from replay import replay

# With and without a row for each n; tables that share a block memory of ECP5, and a table of both its ports; tables that
# ask for block memory. Blocks of ECP5 in the place of those for any device, products of one clock and of three.
FORMS = (
    ("decay", "p8", "pipelined:deep"),
    ("decay", "16,4,8,8,4,1,4,0,9", "pipelined:deep:m3"),
    ("decay", "p8", "pipelined:deep:m2:ecp5"),
    ("decay", "p12", "pipelined:deep:m2:ecp5"),
    ("blinn_phong", "p12", "pipelined:block"),
    ("gauss", "p12", "pipelined:block:m2"),
    ("spherical_gaussian", "p12", "pipelined:block:ecp5"),
    ("blinn_phong", "p12", "pipelined:ecp5"),
    ("blinn_phong", "p12", "pipelined:m3:ecp5"),
    ("bps", "p12", "radix4:ecp5"),
    ("cayley", "p12", "restoring:m3:ecp5"),
    ("cayley", "p8", "reciprocal:ecp5"),
)


def main(glint):
    for lobe, profile, architecture in FORMS:
        print(lobe, profile, architecture)
        with tempfile.TemporaryDirectory() as folder:
            of = ("--lobe", lobe, "--profile", profile, "-o", folder)
            icarus.command(glint, "emit", "--architecture", architecture, "--target", "verilog", *of)
            icarus.command(glint, "vectors", "--count", "1000", "--format", "hex", *of)
            [vectors] = Path(folder).glob("*.hex")
            replay(vectors, "core", Path(folder))


if __name__ == "__main__":
    icarus.main(main)
