#!/usr/bin/env python3
"""The SystemC bench of docs/c-api.md, by the commands of that page; then Verilog with a planted bug, which must fail.

    systemc_test.py BUILD        where model/libglint-c.so is
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/rtl"))
import icarus  # noqa: E402


def main():
    page = (ROOT / "docs/c-api.md").read_text()
    commands = re.search(r"<!-- run by tests/c_api/systemc_test.py -->\n```sh\n(.*?)```", page, re.DOTALL)[1]
    with tempfile.TemporaryDirectory() as name:
        # A tag that does not wait for its result.
        bug = icarus.planted(Path(name) / "planted", "glint_delay.v", r"if \(enable_i\) data_q <= stage", "data_q <= stage")
        for rtl, status, said in ((ROOT / "rtl", 0, r"100000 inputs, 0 mismatches, seed 1\n\Z"), (bug, 1, r" 10 mismatches, seed 1\n\Z")):
            folder = Path(name) / f"status{status}"
            (folder / "build").mkdir(parents=True)
            for link, target in (("build/clang", sys.argv[1]), ("examples", ROOT / "examples"), ("model", ROOT / "model"), ("rtl", rtl)):
                (folder / link).symlink_to(target)
            done = subprocess.run(["bash", "-euc", commands], cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode != status or not re.search(said, done.stdout):
                sys.exit(f"FAILED: exit status {done.returncode}, expected {status}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
            print(done.stdout.splitlines()[-1])


if __name__ == "__main__":
    main()
