#!/usr/bin/env python3
"""Replays a vector file through the Verilog in Icarus: at full speed, then with bubbles and stalls.

    glint vectors --lobe bps --profile p12 --format hex -o out
    replay.py --unit axis out/glint_bps_p12.hex
    replay.py --netlist mine.v cells.v -- out/glint_bps_p12.hex

The manifest beside the file (out/glint_bps_p12.json) says lobe, profile, F, O and how many vectors there must be; the
units.json of the folder FOLDER (default: rtl/), what the unit is made of and its latency.
Exit status: 0 every result matched, 1 not, 2 bad arguments.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import icarus
from units import RTL, units


def replay(vectors, kind, folder, rtl=RTL, netlist=()):
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
        executable = Path(folder) / "replay"
        icarus.build(
            executable,
            "replay_tb",
            [*(netlist or unit["files"]), bench],
            {name: manifest[key] for name, key in (("F", "F"), ("O", "O"), ("COUNT", "count"))},
            {"UNIT": module, **({"AXIS": 1} if kind == "axis" else {}), **({"NETLIST": 1} if netlist else {})},
            warnings=not netlist,
        )
        for pace, arguments in (("full speed", []), ("bubbles and stalls", ["+stalls"])):
            output = icarus.run(executable, f"+vectors={vectors}", *arguments)
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
    options = parser.parse_args()
    missing = [file for file in options.netlist if not file.is_file()]
    if missing:
        print(f"replay.py: --netlist '{missing[0]}' is not a file", file=sys.stderr)
        return 2
    try:
        replay(options.vectors, options.unit, options.units, options.rtl, options.netlist)
    except icarus.Failed as failed:
        print(f"replay.py: FAILED: {failed}", file=sys.stderr)
        return 1
    except (OSError, ValueError, KeyError) as error:
        print(f"replay.py: manifest '{options.vectors.with_suffix('.json')}' cannot be used: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
