#!/usr/bin/env python3
"""glint_signed_multiplier, glint_sqrt and glint_nearest by their contracts in Icarus, for any device and as the ECP5 has them;
then planted bugs, which must be found."""

import tempfile
from pathlib import Path

import icarus
from icarus import RTL
from units import read

BENCH = Path(__file__).parent / "cosine_blocks_tb.v"
MODULES = ("glint_signed_multiplier", "glint_sqrt", "glint_nearest")
TRIALS = 200
# WIDTH, ROOT_W, Q_W, STAGES: those of cosine at p16 and p8, the ends of what is legal, small ones.
WIDTHS = ((16, 22, 21, 3), (16, 18, 17, 1), (18, 31, 30, 2), (8, 9, 8, 4), (3, 2, 2, 1), (4, 3, 5, 2))
BUGS = (  # family, module, text, another
    ("", "glint_signed_multiplier", r"\{\{WIDTH\{b\[WIDTH-1\]\}\}, b\}", "{{WIDTH{1'b0}}, b}"),
    ("", "glint_nearest", r"lower & ~quotient\[Q_W-1\]", "lower"),
    ("", "glint_nearest", r"rounded \+ lifted", "rounded + (lifted << 1)"),
    ("ecp5", "glint_signed_multiplier", r"\.SIGNEDB\(1'b1\)", ".SIGNEDB(1'b0)"),
    ("ecp5", "glint_sqrt", r"root_o\[0\] \? \{\(Y_W \+ 1\) \{1'b0\}\} : ", ""),
    ("ecp5", "glint_sqrt", r"remainder_q <= next;", "remainder_q <= shifted[i+1:0];"),
    ("ecp5", "glint_nearest", r"positive_q <= ~rounded\[X_W\]", "positive_q <= 1'b1"),
    ("ecp5", "glint_add_sub_odd", r"i == 0 \? 16'h55AA", "i == 0 ? 16'hAAAA"),
    ("ecp5", "glint_add_sub_odd", r"2 \* i \+ 1 == WIDTH - 1 \? 16'h69AA", "2 * i + 1 == WIDTH - 1 ? 16'h96AA"),
)


def files_of(family):
    manifest = read()
    listed = manifest["families"][family] if family else manifest["modules"]
    simulation = listed["simulation"] if family else ()
    return list(dict.fromkeys([RTL / file for name in MODULES for file in listed[name]] + [RTL / file for file in simulation]))


def simulate(folder, files, widths):
    parameters = dict(zip(("WIDTH", "ROOT_W", "Q_W", "STAGES"), widths), TRIALS=TRIALS)
    icarus.build(Path(folder) / "bench", "cosine_blocks_tb", [*files, BENCH], parameters)
    return icarus.run(Path(folder) / "bench")


def main():
    total = found = 0
    with tempfile.TemporaryDirectory() as folder:
        for family in ("", "ecp5"):
            for widths in WIDTHS:
                icarus.require(simulate(folder, files_of(family), widths), "results", 3 * TRIALS)
                total += 3 * TRIALS
        for family, name, pattern, replacement in BUGS:
            files = icarus.with_bug(folder, files_of(family), name, pattern, lambda match: replacement)
            if icarus.counts(simulate(folder, files, WIDTHS[1]), "results")[1] == 0:
                raise icarus.Failed(f"not found: '{replacement}' for '{pattern}' in {name} {family}")
            found += 1
    print(f"{total} results, 0 mismatches; {found} planted bugs found")


if __name__ == "__main__":
    icarus.main(main)
