#!/usr/bin/env python3
"""Runs bench.py: a lobe's unit against the Python golden model, in Icarus Verilog or Verilator, by cocotb.

Needs the module `glint` and what requirements.txt lists (docs/cocotb.md). Exit status: 0 all results were right, 1 not,
2 bad arguments.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

try:
    from cocotb_tools.runner import get_results, get_runner  # cocotb 2
except ImportError:
    from cocotb.runner import get_results, get_runner

HERE = Path(__file__).resolve().parent


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--unit", choices=("core", "axis"), default="core")
    parser.add_argument("--lobe", default="bps")
    parser.add_argument("--profile", default="p12")
    parser.add_argument("--count", type=int, default=10000, help="inputs (default 10000)")
    parser.add_argument("--seed", type=int, help="repeats a run (default: the time)")
    parser.add_argument("--sim", choices=("icarus", "verilator"), default="icarus", help="verilator: from 5.022")
    parser.add_argument("--rtl", type=Path, default=HERE.parents[1] / "rtl", metavar="FOLDER")
    parser.add_argument("-o", dest="folder", type=Path, default=Path("build/cocotb"), help="where it builds (default: build/cocotb)")
    options = parser.parse_args()
    module = f"glint_{options.lobe}_{'axis_' if options.unit == 'axis' else ''}{options.profile}"
    listing = options.rtl / f"generated/{module}.f"
    if not listing.is_file():
        parser.error(f"there is no {listing}")
    if options.count < 1:
        parser.error(f"--count {options.count} is not legal: at least 1")
    if options.sim == "verilator":
        version = re.search(r"[\d.]+", subprocess.run(["verilator", "--version"], capture_output=True, text=True, check=True).stdout)
        if tuple(map(int, version[0].split("."))) < (5, 22):
            parser.error(f"--sim verilator: cocotb wants Verilator 5.022; here is {version[0]}")
    files = [line.replace("$(GLINT_RTL)", str(options.rtl.resolve())) for line in listing.read_text().splitlines()
             if line.startswith("$")]
    runner = get_runner(options.sim)
    runner.build(verilog_sources=files, hdl_toplevel=module, build_dir=options.folder / module, timescale=("1ns", "1ps"), always=True)
    results = runner.test("bench", module, testcase="axi_stream" if options.unit == "axis" else "core_stream", seed=options.seed,
                          extra_env={"GLINT_LOBE": options.lobe, "GLINT_PROFILE": options.profile,
                                     "GLINT_COUNT": str(options.count), "PYTHONPATH": str(HERE)})
    tests, failed = get_results(results)
    return 0 if tests == 1 and failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
