#!/usr/bin/env python3
"""Replays a vector file through the Verilog in Icarus: at full speed, then with bubbles and stalls.

    glint vectors --lobe bps --profile p12 --format hex -o out
    replay.py --unit axis out/glint_bps_p12.hex

The manifest beside the file (out/glint_bps_p12.json) says lobe, profile, F, O and how many vectors there must be.
Exit status: 0 every result matched, 1 not, 2 bad arguments.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import icarus


def replay(vectors, unit, rtl, wrappers, expect):
    manifest = json.loads(vectors.with_suffix(".json").read_text())
    module = f"glint_{manifest['lobe']}_{manifest['profile']}"
    modules = [module]
    if unit == "axis":  # its wrapper contains that of the core
        module = f"glint_{manifest['lobe']}_axis_{manifest['profile']}"
        modules.append(module)
    bench = Path(__file__).with_name("replay_tb.v")
    with tempfile.TemporaryDirectory() as folder:
        executable = Path(folder) / "replay"
        icarus.build(
            executable,
            "replay_tb",
            [bench, *(wrappers / f"{name}.v" for name in modules), *icarus.sources(rtl)],
            {name: manifest[key] for name, key in (("F", "F"), ("O", "O"), ("COUNT", "count"))},
            {"UNIT": module, **({"AXIS": 1} if unit == "axis" else {})},
        )
        for pace, arguments in (("full speed", []), ("bubbles and stalls", ["+stalls"])):
            output = icarus.run(executable, f"+vectors={vectors}", *arguments)
            shown = f"{module}, {pace}:\n{output}"
            icarus.require(shown, "vectors", manifest["count"])
            print(shown, end="", flush=True)
            if expect and pace == "full speed" and expect not in output:
                raise icarus.Failed(f"'{expect}' was expected")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vectors", type=Path, help="hex file of `glint vectors`, its manifest beside it")
    parser.add_argument("--unit", choices=("core", "axis"), default="core")
    parser.add_argument("--rtl", type=Path, default=icarus.RTL, help="folder of the Verilog")
    parser.add_argument("--wrappers", type=Path, default=icarus.RTL / "generated", help="folder of the wrapper")
    parser.add_argument("--expect", help="what must be measured at full speed, such as 'latency 25, holds 25'")
    options = parser.parse_args()
    try:
        replay(options.vectors, options.unit, options.rtl, options.wrappers, options.expect)
    except icarus.Failed as failed:
        print(f"replay.py: FAILED: {failed}", file=sys.stderr)
        return 1
    except (OSError, ValueError, KeyError) as error:
        print(f"replay.py: manifest '{options.vectors.with_suffix('.json')}' cannot be used: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
