#!/usr/bin/env python3
"""docs/hard-cases.md is what `glint cases` writes, and every id in its column "covered by" names tests that exist.

covered.json has the tests of an id as patterns of CTest names, {lobe} in the place of a lobe, and the CTest label of the
part of the house that they belong to. A part that this build leaves out is said in a line.

Exit status: 0 all hold, 1 some do not, 2 wrong usage.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
DOCUMENT = HERE.parents[1] / "docs/hard-cases.md"


def ctest_tests(build):
    """Test names by label, and the test programs that are not built: CTest does not know what is in those."""
    listing = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True,
                             check=True)
    tests, missing = {}, []
    for test in json.loads(listing.stdout)["tests"]:
        unbuilt = re.fullmatch(r"(.*)_NOT_BUILT.*", test["name"])
        missing += [unbuilt[1]] if unbuilt else []
        for item in test.get("properties", []):
            for label in item["value"] if item["name"] == "LABELS" else []:
                tests.setdefault(label, []).append(test["name"])
    return tests, missing


def ids_by_table(tables):
    """(title, id) of every id, once."""
    found = {}
    for table in tables:
        if "covered by" in table["columns"]:
            column = table["columns"].index("covered by")
            found.update({(table["title"], name): None for row in table["rows"] for name in row[column].split(", ")})
    return list(found)


def failures(uses, covered, tests, missing, lobes, built):
    """What is wrong, and what was looked up; `built` are the lobes of this build."""
    wrong, looked_up, left_out = [], 0, set()
    for title, name in uses:
        entry = covered.get(name)
        if not entry or not entry["tests"]:
            wrong.append(f"{title}: id '{name}' has no tests in covered.json")
            continue
        if title in lobes and title not in built:
            left_out.add(f"lobe {title}")
            continue
        if entry["label"] not in tests:
            left_out.add(f"label {entry['label']}")
            continue
        for pattern in entry["tests"]:
            pattern = pattern.replace("{lobe}", title)
            if any(re.fullmatch(pattern, test) for test in tests[entry["label"]]):
                looked_up += 1
            elif missing:
                left_out.add(f"not built: {', '.join(missing)}")
            else:
                wrong.append(f"{title}: id '{name}': no test of label {entry['label']} is named '{pattern}'")
    unused = set(covered) - {name for _, name in uses}
    wrong += [f"covered.json: id '{name}' covers no case" for name in sorted(unused)]
    return wrong, looked_up, sorted(left_out)


def main():
    parser = argparse.ArgumentParser(description="The ids of docs/hard-cases.md, looked up in the list of tests.")
    parser.add_argument("--glint", required=True, help="the tool")
    parser.add_argument("--build", required=True, help="the folder of the build, for CTest")
    parser.add_argument("--lobes", required=True, help="the lobes of this build, comma separated")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        page, tables = Path(folder, "page.md"), Path(folder, "tables.json")
        subprocess.run([arguments.glint, "cases", "-o", page, "--json", tables], check=True)
        current = page.read_text() == DOCUMENT.read_text()
        tables = json.loads(tables.read_text())["tables"]
    covered = json.loads((HERE / "covered.json").read_text())
    tests, missing = ctest_tests(arguments.build)
    uses = ids_by_table(tables)
    lobes = {table["title"] for table in tables if table["lobe"]}
    wrong, looked_up, left_out = failures(uses, covered, tests, missing, lobes, arguments.lobes.split(","))
    wrong += [] if current else [f"{DOCUMENT} is not what `glint cases` writes"]
    wrong += [] if looked_up else ["no id was looked up"]
    # The look-up can fail: without the tests of one label, and with an id that nothing knows.
    for label in tests:
        fewer = {key: [] if key == label else names for key, names in tests.items()}
        used = any(entry["label"] == label for entry in covered.values())
        if used and not failures(uses, covered, fewer, [], lobes, arguments.lobes.split(","))[0]:
            wrong.append(f"that no test of label {label} exists passed unseen")
    if not failures([("bps", "unheard-of")], covered, tests, missing, lobes, ["bps"])[0]:
        wrong.append("an unknown id passed unseen")
    print(f"hard cases: {len(uses)} uses of {len(covered)} ids, {looked_up} found in the list of tests")
    for line in left_out:
        print(f"  left out, as this build has it not: {line}")
    for line in wrong:
        print(f"FAILED: {line}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
