#!/usr/bin/env python3
"""glint_fifo, glint_effect_tint and glint_ratio of the ECP5 against those for any device, in Icarus; then planted bugs, which
must be found."""

import re
import tempfile
from pathlib import Path

import icarus
from icarus import RTL
from units import modules, read

BENCH = Path(__file__).parent / "family_blocks_tb.v"
MODULES = ("glint_fifo", "glint_effect_tint", "glint_ratio")
CLOCKS = 1500
NAMES = ("O", "F", "S", "SYMMETRIC", "DIVIDER", "STAGES", "LOG_DEPTH")
WIDTHS = ((12, 18, 15, 0, 1, 1, 2), (8, 16, 11, 1, 0, 1, 1), (16, 20, 19, 0, 0, 3, 6), (4, 8, 4, 1, 3, 2, 3), (15, 30, 30, 0, 3, 1, 2))
BUGS = (("glint_fifo", r"pop_i \| ~valid_q", "pop_i"), ("glint_fifo", r"valid_q <= more", "valid_q <= 1'b1"),
        ("glint_effect_tint", r"\{\(O \+ 8\) \{\|rounded\[O\+11:O\+8\]\}\}", "{(O + 8) {rounded[O+8]}}"),
        ("glint_effect_tint", r"\(s_q\),", "(s_i),"), ("glint_ratio", r"NARROW == 1 && distance_i\[F\]", "1'b0"))


def of_any_device(folder):
    """One file of the modules for any device, by other names."""
    files = dict.fromkeys(file for name in MODULES for file in modules()[name])
    copy = Path(folder) / "any.v"
    copy.write_text(re.sub(r"\bglint_", "any_glint_", "".join(file.read_text() for file in files)))
    return copy


def simulate(folder, files, widths):
    icarus.build(Path(folder) / "bench", "family_blocks_tb", [*files, BENCH], dict(zip(NAMES, widths), CLOCKS=CLOCKS))
    return icarus.counts(icarus.run(Path(folder) / "bench"), "results")


def main():
    total = found = 0
    family = read()["families"]["ecp5"]
    files = list(dict.fromkeys(RTL / file for name in (*MODULES, "simulation") for file in family[name]))
    with tempfile.TemporaryDirectory() as folder:
        files.append(of_any_device(folder))
        for widths in WIDTHS:
            results, mismatches = simulate(folder, files, widths)
            if mismatches or results < 2 * CLOCKS:
                raise icarus.Failed(f"{dict(zip(NAMES, widths))}: {results} results, {mismatches} mismatches")
            total += results
        for name, pattern, replacement in BUGS:
            bug = icarus.with_bug(folder, files, name, pattern, replacement)
            if simulate(folder, bug, WIDTHS[0])[1] == 0:
                raise icarus.Failed(f"not found: '{replacement}' for '{pattern}' in {name}")
            found += 1
    print(f"{total} results, 0 mismatches; {found} planted bugs found")


if __name__ == "__main__":
    icarus.main(main)
