#!/usr/bin/env python3
"""glint_multiplier of each family of devices against that for any device, in Verilator, with models of their blocks.

    products_test.py [--seed SEED] PRODUCTS      default: a seed by the clock; it is printed

All pairs of operands up to 6 x 6 bits, then PRODUCTS random ones, corners among them, at each width in use: signed or not,
1 to 4 stages. Then a planted bug, which must be found.
"""

import argparse
import re
import subprocess
import tempfile
import time
from pathlib import Path

import icarus
from family_multiplier_test import BUGS, WIDTHS
from icarus import RTL
from units import modules, read

BENCH = Path(__file__).parent / "products_tb.v"
SMALL = [(a, b) for a in range(1, 7) for b in range(1, 7)]
FILLED = 8  # clocks before the first comparison: more than there are stages


def generic(folder):
    """The multiplier for any device, by another name."""
    [source] = modules()["glint_multiplier"]
    copy = Path(folder) / "glint_multiplier_generic.v"
    copy.write_text(re.sub(r"\bglint_multiplier\b", "glint_multiplier_generic", source.read_text()))
    return copy


def simulate(folder, files, widths, products, seed=None):
    """The multipliers that were ever wrong, of eight for each width."""
    table = "".join(f"{a:02x}{b:02x}" for a, b in reversed(widths))
    macros = {"WIDTHS": len(widths), "TABLE": f"{16 * len(widths)}'h{table}", "CLOCKS": products + FILLED, "SEED": seed or 0,
              **({} if seed is not None else {"COUNT": 1})}
    build = ["verilator", "--binary", "-O3", "-Wno-fatal", "-Wno-lint", "-Wno-style", "--top-module", "products_tb", "-Mdir",
             f"{folder}/build", *(f"-D{name}={value}" for name, value in macros.items()), *map(str, files), str(BENCH)]
    done = subprocess.run(build, capture_output=True, text=True)
    if done.returncode != 0:
        raise icarus.Failed(f"{' '.join(build)}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    done = subprocess.run([f"{folder}/build/Vproducts_tb"], capture_output=True, text=True)
    found = re.search(r"^(\d+) products, (\d+) mismatches$", done.stdout, re.MULTILINE)
    if done.returncode != 0 or not found or int(found[1]) != products:
        raise icarus.Failed(f"exit status {done.returncode}\n{done.stdout}{done.stderr}{products} products were expected")
    return int(found[2])


def check(family, products, seed):
    listed = read()["families"][family]
    with tempfile.TemporaryDirectory() as folder:
        files = [*(RTL / name for name in listed["glint_multiplier"] + listed["simulation"][:1]), generic(folder)]
        pairs = 2 ** (6 + 6)
        for widths, runs, of in ((SMALL, pairs, None), (WIDTHS, products, seed)):
            wrong = simulate(folder, files, widths, runs, of)
            if wrong:
                raise icarus.Failed(f"{family}: {wrong} of {8 * len(widths)} multipliers are wrong")
        name, pattern, replacement = BUGS[0] if len(listed["glint_multiplier"]) > 1 else (
            "glint_multiplier.v", r"SIGNED != 0 & a_i", "1'b0 & a_i")
        files = icarus.with_bug(folder, files, name.removesuffix(".v"), pattern, replacement)
        if simulate(folder, files, [(19, 16)], 10000, seed) == 0:
            raise icarus.Failed(f"not found: '{replacement}' for '{pattern}' in {name} of {family}")
    print(f"{family}: all pairs of {len(SMALL)} widths, {products} random products of {len(WIDTHS)} widths from seed {seed}, signed "
          "or not, 1 to 4 stages: 0 mismatches; a planted bug found", flush=True)


def main(*_):
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("products", type=int)
    arguments = parser.parse_args()
    print(f"seed {arguments.seed}", flush=True)
    for family in read()["families"]:
        check(family, arguments.products, arguments.seed)


if __name__ == "__main__":
    icarus.main(main)
