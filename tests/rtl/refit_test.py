#!/usr/bin/env python3
"""A refit goes to Verilog in one step: `glint fit`, the `glint emit` line that it prints, and a replay of vectors in Icarus.

    refit_test.py GLINT
"""

import tempfile
from pathlib import Path

import icarus
from replay import replay

FITS = (
    ["--variable", "schlick", "--degree", "2", "--method", "qr"],
    ["--variable", "symmetric", "--degree", "4", "--method", "least-squares", "--zero-at-0", "--one-at-1"],
    ["--variable", "schlick", "--degree", "6", "--method", "qr"],
)


def main(glint):
    for fit in FITS:
        line = icarus.command(glint, "fit", *fit, "--n", "8:1000:16", "--theta", "0:1.57:0.01").splitlines()[-1].split()
        if line[:3] != ["glint", "emit", "--lobe"] or line[-2] != "-o":
            raise icarus.Failed(f"the last line is no `glint emit`: {line}")
        with tempfile.TemporaryDirectory() as folder:
            icarus.command(glint, *line[1:-1], folder)
            icarus.command(glint, "vectors", "--lobe", line[3], "--profile", "p12", "--count", "1500", "--format",
                           "hex", "-o", folder)
            vectors = list(Path(folder).glob("*.hex"))
            if len(vectors) != 1:
                raise icarus.Failed(f"{len(vectors)} vector files, not one")
            for unit in ("core", "axis"):
                replay(vectors[0], unit, Path(folder))


if __name__ == "__main__":
    icarus.main(main)
