#!/usr/bin/env python3
"""FuseSoC, Yosys with nextpnr and SiliconCompiler on an installation, by the commands of docs/tools.md.

    tools_test.py PREFIX FOLDER        PREFIX: what `cmake --install` wrote

Exit status: 0 if all held, 77 where the package registry is not reached, 1 otherwise.
"""

import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def main():
    prefix, folder = (Path(argument).resolve() for argument in sys.argv[1:])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "share").symlink_to(prefix / "share")
    blocks = re.findall(r"<!-- run by tests/python/tools_test.py -->\n```\w+\n(.*?)```", (ROOT / "docs/tools.md").read_text(), re.DOTALL)
    fusesoc, nextpnr, silicon = blocks
    environment = {**os.environ, "PATH": f"{prefix}/bin:{os.environ['PATH']}"}

    def run(name, text, *wanted):
        start = time.monotonic()
        done = subprocess.run(["bash", "-euc", text], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              check=False, env=environment)
        for line in wanted:
            if not re.search(line, done.stdout):
                done.returncode = done.returncode or 1
        if done.returncode != 0:
            sys.exit(f"FAILED: {name}: exit status {done.returncode}; wanted {wanted}\n{done.stdout[-3000:]}")
        print(f"{name}: {time.monotonic() - start:.0f} s")

    probe = [sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", folder / "probe", "fusesoc==2.4.7"]
    if subprocess.run(probe, capture_output=True, timeout=300, check=False).returncode != 0:
        print("skipped: the package registry is not reached")
        return 77
    *first, lint = fusesoc.splitlines()
    run("FuseSoC to 10,000 right results", "\n".join(first), r"10000 vectors, 0 mismatches")
    run("FuseSoC, lint", "\n".join([first[1], lint]))
    run("Yosys, nextpnr", nextpnr)
    assert (folder / "unit.asc").stat().st_size > 100000
    (folder / "lint.py").write_text(silicon)
    run("SiliconCompiler", "env/bin/pip install -q siliconcompiler==0.38.11; env/bin/python lint.py", r"Number of errors: 0", r"Number of warnings: 0")
    return 0


if __name__ == "__main__":
    sys.exit(main())
