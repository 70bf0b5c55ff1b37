#!/usr/bin/env python3
"""glint_multiplier of a family of devices by the contract of that for any device, with the model of its block, in Icarus.

    family_multiplier_test.py FAMILY PRODUCTS [YOSYS]

Widths: those of lobes at p8, p12 and p16, small ones, and more slices than lobes need; PRODUCTS of each, corners among them.
With YOSYS, also: the netlist that it makes, and its own model of the block where it has one. Then planted bugs, which must be
found.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path

import icarus
from icarus import RTL
from units import read

BENCH = Path(__file__).parent / "multiplier_tb.v"
# n (2^F - C); steps of Horner; slope, estimate and remainder of the reciprocal divider; several slices of both.
WIDTHS = ((1, 1), (1, 37), (2, 3), (10, 17), (10, 19), (10, 21), (14, 12), (18, 16), (22, 20), (13, 12), (18, 18), (28, 16), (40, 31))
NETLISTS = ((10, 19, 0, 3), (18, 16, 1, 2), (22, 20, 1, 4), (28, 16, 0, 1))
BLOCK = {"ecp5": 18, "up5k": 16}
FLOWS = {"ecp5": "synth_ecp5", "up5k": "synth_ice40"}
CELLS = {"ecp5": "ecp5/cells_sim.v", "up5k": "ice40/cells_sim.v"}
BUGS = (("glint_multiplier_sliced.v", r"\(A_SLICES \* W \+ 1 - A_W\) \{sign\}", "(A_SLICES * W + 1 - A_W) {1'b0}"),
        ("glint_multiplier_sliced.v", r"<< \(W \* \(i \+ j\)\)", "<< (W * i)"),
        ("glint_multiplier_sliced.v", r"(\.enable_i)\(enable_i\)(,\s+\.data_i  \(sum\))", r"\g<1>(1'b1)\g<2>"),
        ("glint_multiplier_sliced.v", r"\{\{W\{LAST & slice\[W-1\]\}\}, slice\}", "{{W{1'b0}}, slice}"))


def simulate(folder, files, width, bench=BENCH, macros=None, products=1000):
    executable = Path(folder) / "bench"
    icarus.build(executable, "multiplier_tb", [*files, bench],
                 dict(zip(("A_W", "B_W", "SIGNED", "STAGES", "PRODUCTS"), (*width, products))), macros)
    return icarus.run(executable)


def netlist(yosys, family, folder, files, width):
    """The module as the family's synthesis leaves it."""
    values = " ".join(f"-set {name} {value}" for name, value in zip(("A_W", "B_W", "SIGNED", "STAGES"), width))
    script = (f"read_verilog {' '.join(map(str, files))}; chparam {values} glint_multiplier; {FLOWS[family]} -top "
              f"glint_multiplier; rename -top netlist; write_verilog -noattr {folder}/netlist.v")
    subprocess.run([yosys, "-q", "-p", script], check=True)
    (a, b, signed, stages) = width
    wrapper = Path(folder) / "wrapper.v"  # the bench sets parameters, of which a netlist has none
    wrapper.write_text(f"""module glint_multiplier #(parameter A_W = 1, B_W = 1, SIGNED = 0, STAGES = 1) (
    input wire clk_i, enable_i, input wire [{a - 1}:0] a_i, input wire [{b - 1}:0] b_i, output wire [{a + b - 1}:0] product_o);
    netlist netlist (.clk_i(clk_i), .enable_i(enable_i), .a_i(a_i), .b_i(b_i), .product_o(product_o));
endmodule
""")
    return [Path(folder) / "netlist.v", wrapper]


def library(yosys, family, model):
    """Yosys's models of a family's cells, and ours of the multiplier block where Yosys has none."""
    cells = Path(shutil.which(yosys)).resolve().parents[1] / "share/yosys" / CELLS[family]
    return [cells] if f"module {model.stem} (" in cells.read_text() else [cells, model]


def run(executable_folder, files, width):
    """As `simulate`, with the warnings of files that are not ours left out."""
    executable = Path(executable_folder) / "bench"
    a, b, signed, stages = width
    command = ["iverilog", "-g2012", "-DNO_ICE40_DEFAULT_ASSIGNMENTS", f"-I{files[-1].parent}",
               f"-I{files[-2].parent}", f"-I{BENCH.parent}", "-s", "multiplier_tb", "-o", str(executable)]
    command += [f"-Pmultiplier_tb.{n}={v}" for n, v in (("A_W", a), ("B_W", b), ("SIGNED", signed), ("STAGES", stages),
                                                        ("PRODUCTS", 10000))]
    subprocess.run([*command, *map(str, [*files, BENCH])], check=True, capture_output=True)
    return icarus.run(executable)


def main(family, products, yosys=None):
    products = int(products)
    listed = read()["families"][family]
    files = [RTL / name for name in listed["glint_multiplier"]]
    model = RTL / listed["simulation"][0]
    total = 0
    with tempfile.TemporaryDirectory() as folder:
        for index, (a, b) in enumerate(WIDTHS):
            for stages in (1, 2, 3, 4):
                for signed in (0, 1) if yosys else ((index + stages) % 2,):
                    width = (a, b, signed, stages)
                    icarus.require(simulate(folder, [*files, model], width, products=products), "products", products)
                    total += products
        if yosys:
            for width in NETLISTS:
                made = netlist(yosys, family, folder, files, width)
                of_yosys = library(yosys, family, model)
                icarus.require(run(folder, [*made, *of_yosys], width), "products", 10000)
                if len(of_yosys) == 1:
                    icarus.require(run(folder, [*files, *of_yosys], width), "products", 10000)
                total += 10000
        found = 0
        for number, (name, pattern, replacement) in enumerate(BUGS):
            rtl = icarus.planted(Path(folder) / str(number), name, pattern, replacement)
            planted = [rtl / file.relative_to(RTL) for file in files]
            width = (BLOCK[family], BLOCK[family] + 1, 1, 2) if "slice" in replacement else (40, 31, 1, 2)
            if icarus.counts(simulate(folder, [*planted, model], width), "products")[1] == 0:
                raise icarus.Failed(f"not found: '{replacement}' for '{pattern}' in {name}")
            found += 1
    print(f"{family}: {total} products, 0 mismatches{', netlists among them' if yosys else ''}; {found} planted bugs found")


if __name__ == "__main__":
    icarus.main(main)
