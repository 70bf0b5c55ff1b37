#!/usr/bin/env python3
"""A refit goes to Verilog in one step: `glint fit`, the `glint emit` line that it prints, and a replay of vectors in Icarus.

    refit_test.py GLINT
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from icarus import Failed
from replay import replay

FITS = (
    ["--variable", "schlick", "--degree", "2", "--method", "qr"],
    ["--variable", "symmetric", "--degree", "4", "--method", "least-squares", "--zero-at-0", "--one-at-1"],
    ["--variable", "schlick", "--degree", "6", "--method", "qr"],
)


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise Failed(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    glint = sys.argv[1]
    try:
        for fit in FITS:
            line = run(glint, "fit", *fit, "--n", "8:1000:16", "--theta", "0:1.57:0.01").splitlines()[-1].split()
            if line[:3] != ["glint", "emit", "--lobe"] or line[-2] != "-o":
                raise Failed(f"the last line is no `glint emit`: {line}")
            with tempfile.TemporaryDirectory() as folder:
                run(glint, *line[1:-1], folder)
                run(glint, "vectors", "--lobe", line[3], "--profile", "p12", "--count", "1500", "--format", "hex",
                    "-o", folder)
                vectors = list(Path(folder).glob("*.hex"))
                if len(vectors) != 1:
                    raise Failed(f"{len(vectors)} vector files, not one")
                for unit in ("core", "axis"):
                    replay(vectors[0], unit, Path(folder))
    except Failed as failed:
        print(f"refit_test.py: FAILED: {failed}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
