#!/usr/bin/env python3
"""docs/lobes/*.md against the oracle and the tool: each worked example, and every intermediate that `glint eval` names.

Exit status: 0 all hold, 1 some do not, 2 no tool or no document.
"""

import argparse
import re
import sys

import oracle
from checks import Checks
from document import DOCS, Document, Unreadable, contract_of
from oracle import Profile, Refused, run_tool


def check_lobe(glint, lobe, checks):
    document = Document(contract_of(lobe))
    examples = document.examples()
    checks.true(f"{lobe} has worked examples at p12", examples.get("p12"))
    for name, rows in examples.items():
        profile = Profile(lobe, name)
        for row in rows:
            n, code = row["n"], row["cos_code"]
            values = oracle.intermediates(profile, n, code)
            checks.equal(f"{lobe} {name} n={n} cos_code={code}", row, {"n": n, "cos_code": code, **values})
            output, message, status = run_tool(
                [glint, "eval", "--lobe", lobe, "--profile", name, "--n", n, f"--cos-code={code}", "--port"])
            checks.equal(f"{lobe} {name} n={n} cos_code={code}: exit status", (status, message), (0, ""))
            answered = {name: int(x) for name, x in re.findall(r"^(\w+) +(-?[0-9]+) +[0-9]+ +-?[0-9.]+$", output, re.M)}
            printed = ["C", *(x for x in profile.lobe.names if x not in getattr(profile.lobe, "unnamed", ()))]
            checks.equal(f"{lobe} {name} n={n} cos_code={code}: values of the tool", answered,
                         {x: values[x] for x in printed})
            checks.equal(f"{lobe} {name} n={n} cos_code={code}: clamped of the tool",
                         ", clamped" in output.split("\n")[0], values["clamped"] == 1)


def main():
    parser = argparse.ArgumentParser(description="The worked examples of docs/lobes, recomputed and asked of the tool.")
    parser.add_argument("--glint", required=True, help="the tool")
    parser.add_argument("lobes", nargs="*", help="lobes (default: all of docs/lobes)")
    arguments = parser.parse_args()
    lobes = arguments.lobes or sorted(path.stem for path in (DOCS / "lobes").glob("*.md"))
    held = bool(lobes)
    try:
        for lobe in lobes:
            if lobe not in oracle.LOBES:
                raise Refused(f"lobe '{lobe}' has no oracle: tests/oracle/lobes/{lobe}.py")
            checks = Checks(lobe)
            check_lobe(arguments.glint, lobe, checks)
            held &= checks.finish()
    except (Refused, Unreadable) as error:
        print(f"check_lobes: {error}", file=sys.stderr)
        return 2
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
