#!/usr/bin/env python3
"""The commands of hls/README.md, run as they stand: readme_test.py GLINT GLINT_HLS_TB COMPILER.

Exit status: 0 all succeed and print what the page says, 1 one does not.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HLS = Path(__file__).resolve().parents[2] / "hls"


def blocks(section):
    """The fenced blocks of a section: (language, text)."""
    text = HLS.joinpath("README.md").read_text().split(f"\n## {section}\n", 1)[1].split("\n## ", 1)[0]
    return re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def run(line, folder, environment):
    done = subprocess.run(["sh", "-c", line], cwd=folder, env=environment, capture_output=True, text=True)
    print(f"$ {line}\n{done.stdout}{done.stderr}", end="")
    if done.returncode != 0:
        sys.exit(f"FAILED: exit status {done.returncode}: {line}")
    return done.stdout


def main():
    glint, bench, compiler = (Path(argument).resolve() for argument in sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for path, target in (("build/release/glint", glint), ("build/release/glint-hls-tb", bench), ("bin/glint", glint),
                             ("bin/g++", compiler), *((f"hls/{path.name}", path) for path in HLS.iterdir())):
            if path != "hls/vectors":
                folder.joinpath(path).parent.mkdir(parents=True, exist_ok=True)
                folder.joinpath(path).symlink_to(target)
        environment = {**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}"}

        (_, text), (_, printed) = blocks("C simulation without a tool")[:2]
        _, *commands = text.splitlines()  # the first builds Glint
        outputs = [run(line, folder, environment) for line in commands]
        if outputs[-1] != printed:
            sys.exit(f"FAILED: '{outputs[-1]}' is not what the page shows: '{printed}'")

        _, text = blocks("Custom word lengths")[0]
        outputs = [run(line, folder, environment) for line in text.splitlines()]
        if not re.search(r"[1-9]\d* vectors, 0 mismatches\n$", outputs[-1]):
            sys.exit(f"FAILED: '{outputs[-1]}' is no agreement")


if __name__ == "__main__":
    main()
