#!/usr/bin/env python3
"""The cocotb benches of docs/cocotb.md, in the environment that python_test.py made: cocotb_test.py FOLDER.

Runs the commands of that page; then Verilog with a planted bug, which must fail. Verilator too, where it is new enough.
Exit status: 0 if all held, 77 without that environment, without Icarus or without the package registry, 1 otherwise.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/rtl"))
import icarus  # noqa: E402

BUGS = (  # wrong numbers; a tag, a spare word that are right until there is back-pressure
    ("core", "glint_horner.v", r"\+:H_W\], 1'b1, ", "+:H_W], 1'b0, "),
    ("core", "glint_delay.v", r"if \(enable_i\) data_q <= stage", "data_q <= stage"),
    ("core", "glint_ports.v", r"advance = ready_i \| ~valid_q\[CLOCKS-1\]", "advance = 1'b1"),
    ("axis", "glint_axis.v", r"\{\(30 - O\) \{1'b0\}\}", "{(30 - O) {clamped}}"),
    ("axis", "glint_skid.v", r"spare_full_q \? spare_q : data_i", "data_i"),
)


def main():
    folder = Path(sys.argv[1]).resolve()
    python = folder / "env/bin/python"
    if not python.is_file():
        print("skipped: python.module has made no environment (it wants the package registry)")
        return 77
    if not shutil.which("iverilog"):
        print("skipped: no iverilog (install the package `iverilog`)")
        return 77
    if subprocess.run([python, "-m", "pip", "install", "-q", "-r", ROOT / "examples/cocotb/requirements.txt"], check=False).returncode:
        print("skipped: the package registry is not reached")
        return 77
    scratch = folder / "cocotb"
    shutil.rmtree(scratch, ignore_errors=True)

    def run(*arguments):
        done = subprocess.run([python, ROOT / "examples/cocotb/run.py", "-o", scratch, *arguments], cwd=folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return done.returncode, done.stdout

    def right(*arguments):
        status, text = run(*arguments)
        said = re.search(r"(\d+) results, 0 mismatches, seed \d+", text)
        assert status == 0 and said and int(said[1]) > 0, f"{arguments}: {status}\n{text[-3000:]}"
        print(*arguments, said[0])

    commands = re.findall(r"^env/bin/python examples/cocotb/run.py (.*)$", (ROOT / "docs/cocotb.md").read_text(), re.MULTILINE)
    assert len(commands) == 2
    for command in commands:
        right(*command.split())
    for number, (unit, file, pattern, replacement) in enumerate(BUGS):
        rtl = icarus.planted(folder / f"cocotb/rtl{number}", file, pattern, replacement)
        status, text = run("--unit", unit, "--count", "2000", "--seed", "1", "--rtl", rtl)
        assert status == 1 and "FAIL=1" in text, f"a bug in {file} passed: {status}\n{text[-3000:]}"
        print(f"{unit}, a bug in {file}: found")
    for arguments, wrong in ((("--lobe", "none"), "glint_none_p12"), (("--count", "0"), "--count 0")):
        status, text = run(*arguments)
        assert status == 2 and wrong in text, text
    status, text = run("--sim", "verilator", "--count", "1") if shutil.which("verilator") else (2, "no Verilator")
    if status == 2:
        print(text.splitlines()[-1])
    else:
        for unit in ("core", "axis"):
            right("--sim", "verilator", "--unit", unit)
    return 0


if __name__ == "__main__":
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.exit(main())
