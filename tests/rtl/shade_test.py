#!/usr/bin/env python3
"""What is not in MASK makes no logic: netlists of shade, by Yosys.

For each term: the wrapper with MASK without it holds no unit of it; and glint_effect_shade itself, with MASK without it, has
the same cells, of the same widths, as one for a term less, and fewer than the whole. Likewise without ambient.
"""

import json
import tempfile
from pathlib import Path

import icarus
from icarus import Failed
from units import modules, units

WRAPPER = "glint_effect_shade_bps_p12"


def yosys(files, top, parameters, commands):
    chosen = "".join(f" -set {name} {value}" for name, value in parameters.items())
    script = f"read_verilog {' '.join(map(str, files))}; chparam{chosen} {top}; hierarchy -check -top {top}; {commands}"
    icarus.command("yosys", "-q", "-p", script)


def frame(N, mask, diffuse):
    """The cells of glint_effect_shade, without the units, by type and width. Numbers are sized, as in the wrapper."""
    parameters = {"N": N, "MASK": f"{N + 1}'d{mask}", "DIFFUSE": f"{N + 1}'d{diffuse}"}
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "stat.json"
        yosys(modules()["glint_effect_shade"], "glint_effect_shade", parameters,
              f"proc; flatten; opt -full; opt_clean -purge; tee -q -o {file} stat -width -json")
        text = file.read_text()
        data = json.loads(text[text.index("{"):])["design"]
    if not data["num_cells_by_type"]:
        raise Failed("a netlist without cells")
    return {**data["num_cells_by_type"], "memory bits": data["num_memory_bits"]}


def total(cells):
    return sum(count for name, count in cells.items() if name != "memory bits")


def main():
    unit = units()[WRAPPER]
    files = unit["files"]
    N = int(unit["core"]["parameters"]["N"])
    diffuse = int(unit["core"]["parameters"]["DIFFUSE"].split("'d")[1])
    # The units of the terms, in the order of their bits.
    terms = [file.stem for file in files if file.parent.name == "generated" and file.stem.startswith("glint_effect_")]
    slots = {bit: term for bit, term in enumerate(terms[:-1], 1)}
    if len(slots) != N:
        raise Failed(f"{len(slots)} slots for {N} terms")
    everything = (2 << N) - 1
    whole = frame(N, everything, diffuse)
    print(f"{N} terms: {total(whole)} cells, {whole['memory bits']} bits of memory")
    for bit, unit in sorted(slots.items()):
        mask = everything - (1 << bit)
        for built, instances in ((everything, 1), (mask, 0)):
            yosys(files, WRAPPER, {"MASK": f"{N + 1}'d{built}"},
                  f"cd {WRAPPER}; select -assert-count {instances} t:*{unit}*")
        below = (1 << bit) - 1
        masked = frame(N, mask, diffuse)
        never = frame(N - 1, everything >> 1, (diffuse & below) | (diffuse >> 1 & ~below))
        print(f"without {unit}: {total(masked)} cells, {masked['memory bits']} bits; for {N - 1} terms {total(never)}, "
              f"{never['memory bits']}")
        if masked != never:
            raise Failed(f"MASK {mask}: {masked}; where it never was: {never}")
        if total(masked) >= total(whole) or masked["memory bits"] >= whole["memory bits"]:
            raise Failed(f"MASK {mask} saves nothing")
    dark = frame(N, everything - 1, diffuse)
    print(f"without ambient: {total(dark)} cells, {dark['memory bits']} bits")
    products = sum(count for name, count in whole.items() if name.startswith("$mul"))
    if products - sum(count for name, count in dark.items() if name.startswith("$mul")) != 3:
        raise Failed(f"without ambient: {dark}, with it: {whole}")


if __name__ == "__main__":
    icarus.main(main)
