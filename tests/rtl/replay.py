#!/usr/bin/env python3
"""Replays a vector file through the Verilog in Icarus or Verilator: at full speed, then with bubbles and stalls.

    glint vectors --lobe bps --profile p12 --format hex -o out
    replay.py --unit axis out/glint_bps_p12.hex
    replay.py --sim verilator --netlist mine.v cells.v -- out/glint_bps_p12.hex

The manifest beside the file (out/glint_bps_p12.json) says lobe, profile, F, O and how many vectors there must be; the
units.json of the folder FOLDER (default: rtl/), what the unit is made of and its latency.
Exit status: 0 every result matched, 1 not, 2 bad arguments.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import icarus
from units import RTL, units


def verilate(folder, files, parameters, macros, strict):
    """The bench by Verilator, for the processor's own speed; of Verilog that is not ours, it says errors only."""
    command = ["verilator", "--binary", "-j", "1", "--top-module", "replay_tb", "--Mdir", str(folder), "-Wno-WIDTH", "-MAKEFLAGS", "OPT_FAST=-O0 OPT_SLOW=-O0"]
    if not strict:
        command += ["-Wno-fatal", "-Wno-lint", "-Wno-style", *sorted({f"-I{Path(file).parent}" for file in files})]
    command += [f"-G{name}={value}" for name, value in parameters.items()]
    command += [f"-D{name}={value}" for name, value in macros.items()]
    done = subprocess.run(command + [str(file) for file in files], capture_output=True, text=True)
    if done.returncode != 0:
        raise icarus.Failed(f"{' '.join(command)}: exit status {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")

    def run(*arguments):
        done = subprocess.run([f"{folder}/Vreplay_tb", *arguments], capture_output=True, text=True)
        if done.returncode != 0 or done.stderr:
            raise icarus.Failed(f"Vreplay_tb: exit status {done.returncode}\n{done.stdout}{done.stderr}")
        return re.sub(r"^- .*: Verilog \$finish\n", "", done.stdout, flags=re.MULTILINE)

    return run


def replay(vectors, kind, folder, rtl=RTL, netlist=(), sim="icarus", defines=()):
    manifest = json.loads(vectors.with_suffix(".json").read_text())
    module = f"glint_{manifest['lobe']}_{'axis_' if kind == 'axis' else ''}{manifest['profile']}"
    every = units(folder, rtl)
    if module not in every:
        raise icarus.Failed(f"{folder}/units.json has no {module}")
    unit = every[module]
    # A stalled pipeline is full; a register slice at each end holds two.
    latency = unit["architectures"][0]["latency"]
    expected = f"latency {latency}, holds {latency + 2 if kind == 'axis' else latency}"
    bench = Path(__file__).with_name("replay_tb.v")
    with tempfile.TemporaryDirectory() as folder:
        files = [*(netlist or unit["files"]), bench]
        parameters = {name: manifest[key] for name, key in (("F", "F"), ("O", "O"), ("COUNT", "count"))}
        macros = {"UNIT": module, **({"AXIS": 1} if kind == "axis" else {}), **({"NETLIST": 1} if netlist else {})}
        macros.update(define.partition("=")[::2] for define in defines)
        if sim == "verilator":
            run = verilate(Path(folder) / "sim", files, parameters, macros, not netlist)
        else:
            executable = Path(folder) / "replay"
            icarus.build(executable, "replay_tb", files, parameters, macros, not netlist)

            def run(*arguments):
                return icarus.run(executable, *arguments)

        for pace, arguments in (("full speed", []), ("bubbles and stalls", ["+stalls"])):
            output = run(f"+vectors={vectors}", *arguments)
            shown = f"{module}, {pace}:\n{output}"
            icarus.require(shown, "vectors", manifest["count"])
            print(shown, end="", flush=True)
            if pace == "full speed" and not netlist and expected not in output:
                raise icarus.Failed(f"'{expected}' was expected")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vectors", type=Path, help="hex file of `glint vectors`, its manifest beside it")
    parser.add_argument("--unit", choices=("core", "axis"), default="core")
    parser.add_argument("--units", type=Path, default=RTL, metavar="FOLDER", help="rtl/, or where `glint emit` wrote")
    parser.add_argument("--rtl", type=Path, default=RTL, metavar="FOLDER", help="rtl/, for units of `glint emit`")
    parser.add_argument("--netlist", type=Path, nargs="+", default=[], metavar="FILE",
                        help="Verilog of your own in the place of the unit's files: your netlist, and its library")
    parser.add_argument("--sim", choices=("icarus", "verilator"), default="icarus",
                        help="verilator: for netlists; it compiles for a minute, then runs at once")
    parser.add_argument("--define", nargs="+", default=[], metavar="NAME", help="macros, for a library; or NAME=VALUE")
    options = parser.parse_args()
    missing = [file for file in options.netlist if not file.is_file()]
    if missing:
        print(f"replay.py: --netlist '{missing[0]}' is not a file", file=sys.stderr)
        return 2
    wrong = [define for define in options.define if not re.fullmatch(r"[A-Za-z_]\w*(=.*)?", define)]
    if wrong:
        print(f"replay.py: --define '{wrong[0]}' is not legal: NAME or NAME=VALUE", file=sys.stderr)
        return 2
    program = {"icarus": "iverilog", "verilator": "verilator"}[options.sim]
    if not shutil.which(program):
        print(f"replay.py: --sim {options.sim} wants the program {program}, which is not in PATH", file=sys.stderr)
        return 2
    try:
        replay(options.vectors, options.unit, options.units, options.rtl, options.netlist, options.sim, options.define)
    except icarus.Failed as failed:
        print(f"replay.py: FAILED: {failed}", file=sys.stderr)
        return 1
    except (OSError, ValueError, KeyError) as error:
        print(f"replay.py: manifest '{options.vectors.with_suffix('.json')}' cannot be used: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
