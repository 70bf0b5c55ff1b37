#!/usr/bin/env python3
"""The Python module, built by `pip install .` as docs/python.md says, in a fresh environment.

    python_test.py --glint build/glint --folder SCRATCH

Runs the lines of docs/python.md, the example, the module against `glint`, its types by mypy, its speed beside the C++ batch.
Exit status: 0 if all held, 77 where pip or the package registry is missing, 1 otherwise.
"""

import argparse
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", (ROOT / "docs/python.md").read_text(), re.DOTALL)


def run(*command, folder, **settings):
    done = subprocess.run([*map(str, command)], cwd=folder, capture_output=True, text=True, check=False, **settings)
    if done.returncode != 0:
        raise SystemExit(f"FAILED: {' '.join(map(str, command))}\n{done.stdout}{done.stderr[-3000:]}")
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--glint", type=os.path.abspath, required=True)
    parser.add_argument("--folder", type=Path, required=True)
    options = parser.parse_args()
    folder = options.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    if importlib.util.find_spec("pip") is None:
        print("skipped: Python has no pip (install the package `python3-pip`)")
        return 77
    probe = [sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", folder / "probe", "nanobind==2.4.0"]
    if subprocess.run(probe, capture_output=True, timeout=300, check=False).returncode != 0:
        print("skipped: the package registry is not reached")
        return 77
    # A copy of the tree, as a clone has it.
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, capture_output=True,
                           text=True, check=True).stdout
    tree = folder / "tree"
    for name in filter(None, names.split("\0")):
        if (ROOT / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, tree / name)
    python = tree / "env/bin/python"
    start = time.monotonic()
    printed = run("bash", "-euc", blocks("text")[0], folder=tree).splitlines()[-1]
    print(f"pip install . to a first number: {time.monotonic() - start:.0f} s")
    assert printed == "1448", printed

    run(python, "-m", "pip", "install", "-q", "matplotlib==3.9.4", "mypy==1.13.0", folder=tree)
    run(python, "-c", blocks("python")[0], folder=folder)
    print(run(python, ROOT / "examples/python/error_over_n.py", folder / "error.png", folder=folder), end="")
    assert (folder / "error.png").stat().st_size > 10000
    (folder / "typed.py").write_text(blocks("python")[0])
    run(python, "-m", "mypy", "--strict", "-p", "glint", folder=folder)
    run(python, "-m", "mypy", "--strict", "typed.py", folder=folder)
    (folder / "wrong.py").write_text('import glint\nglint.lobe("bps").sweep(n=1.5)\n')
    assert subprocess.run([python, "-m", "mypy", "wrong.py"], cwd=folder, capture_output=True, check=False).returncode == 1
    print(run(python, Path(__file__).parent / "module_test.py", options.glint, folder=folder), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
