#!/usr/bin/env python3
"""The tests that ./test leaves to ./test --all, by tests/nightly.json, as one regular expression for ctest.

CTest takes nine pairs of parentheses in all and ignores an expression that has more: so each `(a|b)` and `(a)?` is
written out.
"""

import json
import re
import sys
from pathlib import Path


def written_out(pattern):
    found = re.search(r"\(([^()]*)\)(\??)", pattern)
    if not found:
        return [pattern]
    choices = found[1].split("|") + ([""] if found[2] else [])
    return [whole for choice in choices for whole in written_out(pattern[:found.start()] + choice + pattern[found.end():])]


def main():
    file = Path(__file__).resolve().parents[1] / "tests/nightly.json"
    patterns = [pattern for part in json.loads(file.read_text())["tests"]
                for pattern in re.split(r"\|(?![^()]*\))", part["tests"])]  # at each | that stands in no parentheses
    expression = "|".join(f"^{name}" for pattern in patterns for name in written_out(pattern))
    if "(" in expression:
        sys.exit(f"{file}: a pattern has parentheses that can't be written out")
    print(expression)


if __name__ == "__main__":
    main()
