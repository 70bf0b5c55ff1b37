#!/usr/bin/env python3
"""Every kernel through Bambu, and what came out into a file: run_all.py GLINT FILE [KERNEL_PROFILE[:FORM] ...]

    BAMBU=/opt/panda/bin/bambu hls/bambu/run_all.py build/release/glint cost/data/hls.json

Runs run_hls.sh with 2000 vectors for all kernels at p8, p12 and p16, or for those named (bps_p12), and writes a point
each, in JSON, with a hash of all that the kernel includes. bps_p12:radix4 is bps p12 with that form of the divider
(hls/README.md): adding, radix4, reciprocal. --check instead says which points are of other sources. The clock after
route wants nextpnr-ecp5 (or NEXTPNR to name it).
Exit status: 0, 1 a kernel failed or a point is stale, 2 bad arguments.
"""

import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HLS = Path(__file__).resolve().parents[1]
TOOL = "Bambu v2024.03, clang-13, xc7z020-1clg484-VVD, 10 ns; area by Yosys synth_ecp5; clock after route by nextpnr-ecp5"
FORMS = ("adding", "radix4", "reciprocal")
COUNT = 2000


def sources(path, seen):
    """The file and all that it includes of this folder."""
    if path in seen:
        return seen
    seen.append(path)
    for name in re.findall(r'^#include "(.+)"', path.read_text(), re.MULTILINE):
        sources((path.parent / name).resolve(), seen)
    return seen


def digest(name):
    """Of the code alone: comments and layout make no figure stale."""
    text = ""
    for path in sources(HLS / f"generated/glint_{name}.cpp", []):
        text += re.sub(r"//.*", "", path.read_text())
    return hashlib.sha256("".join(text.split()).encode()).hexdigest()[:16]


def name_of(point):
    return f"{point['kernel']}_{point['profile']}" + (f":{point['form']}" if "form" in point else "")


def write(file, points):
    order = {"p8": 0, "p12": 1, "p16": 2}
    points = sorted(points, key=lambda point: (point["kernel"], order[point["profile"]], point.get("form", "")))
    lines = ",\n".join("  " + json.dumps(point) for point in points)
    partial = file.with_suffix(".part")
    partial.write_text(f'{{\n "format": "glint-cost-hls-1",\n "tool": "{TOOL}",\n "points": [\n{lines}\n ]\n}}\n')
    os.replace(partial, file)


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--check"]
    check = len(arguments) < len(sys.argv) - 1
    if len(arguments) < 2:
        print("run_all.py: usage: run_all.py GLINT FILE [KERNEL_PROFILE ...] [--check]", file=sys.stderr)
        return 2
    glint, file, names = Path(arguments[0]).resolve(), Path(arguments[1]), arguments[2:]
    known = [path.stem[len("glint_"):] for path in sorted(HLS.glob("generated/glint_*_p*.cpp"))]
    for name in names:
        kernel, _, form = name.partition(":")
        if kernel not in known or form not in ("", *FORMS):
            print(f"run_all.py: '{name}' is not known: {', '.join(known)}, and behind a colon {', '.join(FORMS)}",
                  file=sys.stderr)
            return 2
    points = json.loads(file.read_text())["points"] if file.is_file() else []
    if check:
        wanted = names or sorted({*known, *map(name_of, points)})
        current = {name_of(p) for p in points if p["hash"] == digest(f"{p['kernel']}_{p['profile']}")}
        stale = [name for name in wanted if name not in current]
        print(f"{len(wanted) - len(stale)} of {len(wanted)} points are of the kernels as they are")
        for name in stale:
            print(f"stale or missing: {name}")
        return 1 if stale else 0
    failed = 0
    for name in names or known:
        whole, _, form = name.partition(":")
        kernel, profile = whole.rsplit("_", 1)
        unit, what = ("effect", kernel[len("effect_"):]) if kernel.startswith("effect_") else ("lobe", kernel)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([glint, "vectors", f"--{unit}", what, "--profile", profile, "--count", str(COUNT), "-o",
                            folder], check=True, stdout=subprocess.DEVNULL)
            done = subprocess.run([HLS / "bambu/run_hls.sh", profile, kernel], cwd=folder, capture_output=True,
                                  text=True,
                                  env={**os.environ, "GLINT_VECTORS": folder, "GLINT_DIVIDE": form.upper()})
            log = Path(folder) / f"glint_{whole}/bambu.log"
            clock = re.search(r"Estimated max frequency \(MHz\): ([\d.]+)", log.read_text()) if log.is_file() else None
        line = (done.stdout.splitlines() or [""])[-1]
        print(line if done.returncode == 0 else f"FAILED: {name}: {line} {done.stderr.strip()}", flush=True)
        if done.returncode != 0:
            failed += 1
            continue
        values = dict(field.split("=") for field in line.split())
        early, routed = values.pop("early"), values.pop("clock_mhz")
        del values["top"]
        point = {"kernel": kernel, "profile": profile, **({"form": form} if form else {}),
                 **{key: int(value) for key, value in values.items()},
                 "early": {} if early == "-" else {k: int(v) for k, v in (e.split(":") for e in early.split(","))},
                 "mhz": round(float(clock[1]), 1), "clock_mhz": None if routed == "-" else float(routed),
                 "hash": digest(whole)}
        points = [p for p in points if name_of(p) != name] + [point]
        write(file, points)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
