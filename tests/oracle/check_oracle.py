#!/usr/bin/env python3
"""That the oracle's programs find what is wrong: altered answers of the tool, altered copies of the documents.

Exit status: 0 all was found, 1 something passed unseen, 2 no tool or no document.
"""

import argparse
import contextlib
import io
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import oracle
from checks import Checks, by_name, run_parts
from document import CONTRACT, Document, Unreadable, contract_of

HERE = Path(__file__).resolve().parent

# A tool that does as the real one does, but where its arguments match `pattern`. There `action` has the real one as
# `$glint`, the last argument as `$last`, and `filter` to alter what is answered and keep the exit status.
WRAPPER = """#!/bin/sh
glint='{glint}'
for last; do :; done
filter() {{
  answered=$("$glint" "$@" && echo .) || exit $?
  printf '%s' "${{answered%.}}" | sed "$program"
}}
case "$*" in
  {pattern}) {action} ;;
  *) exec "$glint" "$@" ;;
esac
"""


def run(*command):
    done = subprocess.run([sys.executable, "-B", *map(str, command)], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def altered_tool(glint, folder, pattern, action):
    path = Path(folder) / "altered"
    path.write_text(WRAPPER.format(glint=Path(glint).resolve(), pattern=pattern, action=action))
    path.chmod(0o755)
    return path


def altered_by(program):
    return f"program='{program}'; filter \"$@\""


def check_answers(glint, checks):
    """oracle.py against altered answers: (what, which arguments, action, what must be printed)."""
    plain, port = "*--stdin", "*--port"
    title = {plain: "bps p8: [0-9]+ inputs", port: "bps p8 --port: [0-9]+ inputs"}
    shown = (r"\n  line 124, n=[0-9]+ cos_code=-?[0-9]+: the tool answers '.*', the contract '.*': "
             r"C=.* D=.* quotient=.* h1=.* h2=.* r=.* y=.* clamped=")
    one = ", 1 mismatches" + shown
    cases = (
        ("nothing", plain, 'exec "$glint" "$@"', ", 0 mismatches\n$"),
        ("y of one line", plain, altered_by("124s/^/1/"), one),
        ("y of one port line", port, altered_by("124s/^/1/"), one),
        ("clamped of one line", port, altered_by("124{s/ 0$/ 2/;s/ 1$/ 0/;s/ 2$/ 1/}"), one),
        ("a blank too many", plain, altered_by("124s/^/ /"), one),
        ("the last line missing", plain, altered_by("$d"), ", 1 mismatches\n.*the tool answers nothing"),
        ("no line feed at the end", plain, '"$glint" "$@" | head -c -1', ", 1 mismatches\n.*no line feed"),
        ("a line too many", plain, '"$glint" "$@"; echo 0', ", 1 mismatches\n.*more lines than inputs"),
        ("no answers", plain, "cat > /dev/null", r"bps p8: ([0-9]+) inputs, \1 mismatches"),
        ("another exit status", plain, '"$glint" "$@"; exit 3', ", 0 mismatches\n  the tool exits with status 3"),
    )
    with tempfile.TemporaryDirectory() as folder:
        for what, pattern, action, printed in cases:
            tool = altered_tool(glint, folder, pattern, action)
            status, output, _ = run(HERE / "oracle.py", "--glint", tool, "--profile", "p8", "--count", "1000")
            checks.equal(f"{what}, exit status", status, 0 if what == "nothing" else 1)
            expected = printed if printed.startswith("bps") else title[pattern] + printed
            checks.true(f"{what}, output: {output}", re.search(expected, output))
            other = title[port if pattern == plain else plain]
            checks.true(f"{what}, the other run holds: {output}", re.search(other + ", 0 mismatches\n", output))
    profile = oracle.Profile("bps", "p8")
    with contextlib.redirect_stdout(io.StringIO()) as output:
        checks.true("no inputs fail", not oracle.compare(glint, "bps", profile, [], [], False))
    checks.true("no inputs are named", "nothing was compared" in output.getvalue())


def check_usage(glint, checks):
    """Exit status 2 and one clear line: no tool, no document, no such profile."""
    cases = (("oracle.py", "--glint", "/nonexistent/glint"), ("check_tool.py", "--glint", "/nonexistent/glint"),
             ("oracle.py", "--glint", HERE), ("oracle.py", "--glint", glint, "--contract", "/nonexistent/contract.md"),
             ("check_document.py", "--document", "/nonexistent/contract.md"),
             ("check_bps.py", "--document", "/nonexistent/bps.md"),
             ("oracle.py", "--glint", glint, "--profile", "8,30,4,4"),
             ("oracle.py", "--glint", glint, "--profile", "p9"),
             ("oracle.py", "--glint", glint, "--profile", "p8,18,14,14"))
    for command in cases:
        status, output, errors = run(HERE / command[0], *command[1:])
        checks.equal(f"{command}, exit status", status, 2)
        checks.equal(f"{command}, lines", (output, len(errors.splitlines())), ("", 1))


def check_tool_checks(glint, checks):
    """Parts of check_tool.py against a tool that breaks them: (part, which arguments, action, first failure)."""
    cases = (
        ("profiles", r"*,30,4,4\ *", "exit 0", "profile '[0-9]+,30,4,4' is not legal, exit status: 0 where 2 is right"),
        ("cosines", "*", altered_by("s/code 131071/code 131070/"), "p8 cosine .*: 131070 where 131071 is right"),
        ("refused_inputs", "*--stdin", '"$glint" "$@"; exit 0', "p8 0 -131072, exit status: 0 where 2 is right"),
        ("vectors", "*hex*", '"$glint" "$@" && sed -i s/a/A/ "$last"/*.hex', "hex p8, format of '.*A.*'"),
        ("vectors", "*hex*", '"$glint" "$@" && truncate -s -1 "$last"/*.hex', "hex p8 is ASCII with line feeds"),
        ("vectors", r"*\ tv\ *", """ "$glint" "$@" && sed -i '9s/ 1$/ 0/' "$last"/*.tv""",
         r"tv p8, '.* 0': \([0-9]+, 0\) where \([0-9]+, 1\) is right"),
        ("vectors", "*csv*", '"$glint" "$@" && sed -i 1d "$last"/*.csv', "csv p8, header"),
        ("measures", "sweep*", """ "$glint" "$@" > /dev/null && sed -i 's/"rms": 0.003/"rms": 0.004/' "$last" """,
         "sweep p8 .*RMS of approximation"),
    )
    with tempfile.TemporaryDirectory() as folder:
        for part, pattern, action, failure in cases:
            tool = altered_tool(glint, folder, pattern, action)
            status, output, _ = run(HERE / "check_tool.py", "--glint", tool, "--part", part)
            checks.equal(f"{part} with `{action}`, exit status", status, 1)
            checks.true(f"{part} with `{action}`: {output}",
                        re.search(rf"^{part}: [0-9]+ checks, [1-9][0-9]* failures\n  {failure}", output, re.M))


def check_lobe_checks(glint, checks):
    """check_lobes.py against a tool with another h1, with a value too many, and without `clamped`."""
    cases = ((altered_by("s/^h1  /h1 1/"), "values of the tool: {.*} where {.*} is right"),
             (altered_by("s/^\\(h1 *\\)\\(.*\\)/&\\nh3 \\2/"), "values of the tool: {.*} where {.*} is right"),
             (altered_by("s/, clamped//"), "clamped of the tool: False where True is right"))
    with tempfile.TemporaryDirectory() as folder:
        for action, failure in cases:
            tool = altered_tool(glint, folder, "*", action)
            status, output, _ = run(HERE / "check_lobes.py", "--glint", tool, "bps")
            checks.equal(f"`{action}`, exit status", status, 1)
            checks.true(f"`{action}`: {output}",
                        re.search(f"^bps: [0-9]+ checks, [1-9][0-9]* failures\n  bps p8 .*: {failure}", output, re.M))


DOCUMENT, BPS = ("check_document.py", CONTRACT), ("check_bps.py", contract_of("bps"))


def check_document_checks(glint, checks):
    """Each part of the programs that check a document, against a copy with figures altered: (program and document, part,
    failures, figures)."""
    cases = (
        (DOCUMENT, "arithmetic", 1, [("| -2 | -3 | -3 |", "| -2 | -2 | -3 |")]),
        (DOCUMENT, "profiles", 1, [("268 174 335 |", "268 174 336 |")]),
        (BPS, "rule_4", 2, [("66 of\nthe 6925", "65 of\nthe 6925"), ("`S >= 9`", "`S >= 8`")]),
        (BPS, "real_function", 2, [("0.12633238", "0.12633239"), ("-0.00936969", "-0.00936968")]),
        (BPS, "constants", 3, [("| 98140 |", "| 98141 |"), ("c1 = -0.374", "c1 = -0.375"),
                              ("| constants | 11 | 15 |", "| constants | 11 | 14 |")]),
        (BPS, "real_ranges", None, [("0 .. 1.375 + 1.5 u", "0 .. 1.375 + 0.5 u")]),
        (BPS, "quotients", 6, [("2794 .. 6134", "2793 .. 6134"), ("5 and 270", "5 and 271"), ("0.698959", "0.698958"),
                               ("0.755517", "0.755516"), ("3, 900484", "3, 900485"),
                               ("67 044 351 (all)", "67 044 352 (all)")]),
        (BPS, "quotients", None, [("| 0.682051 | 1, 65248 |", "| 0.680227 | 2, 65392 |")]),  # right, but not the worst
        (DOCUMENT, "epicentre", None, [("`2^-52`, and", "`2^-30`, and")]),
        (BPS, "examples", 1, [("| 256 | 5717 |", "| 257 | 5717 |")]),
        (BPS, "example_in_full", 1, [("rnd(1162635984, 15)", "rnd(1162635985, 15)")]),
        (DOCUMENT, "formats", 1, [("ffffffff0032000100000000", "ffffffff0032000000000000")]),
        (BPS, "program", None, [("(1 << (k - 1))) >> k\n\nfor", "(1 << k)) >> k\n\nfor")]),
    )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "altered.md"
        for (program, document), part, failures, figures in cases:
            altered = Document(document).text
            for old, new in figures:
                checks.true(f"the document holds '{old}'", old in altered)
                altered = altered.replace(old, new, 1)
            path.write_text(altered, encoding="utf-8")
            status, output, errors = run(HERE / program, "--document", path, "--part", part)
            checks.equal(f"{part}, exit status", status, 1)
            count = re.search(f"^{part}: [0-9]+ checks, ([0-9]+) failures", output, re.M)
            found = int(count[1]) if count else -1
            checks.true(f"{part}, failures: {output}{errors}", found > 0 if failures is None else found == failures)


def check_nothing(glint, checks):
    """A part that checks nothing fails."""
    with contextlib.redirect_stdout(io.StringIO()) as output:
        checks.true("no checks fail", not Checks("a part without checks").finish())
    checks.true("no checks are named", "nothing was checked" in output.getvalue())


PARTS = by_name(check_answers, check_usage, check_tool_checks, check_lobe_checks, check_document_checks, check_nothing)


def main():
    parser = argparse.ArgumentParser(description="That the oracle's programs find what is wrong.")
    parser.add_argument("--glint", required=True, help="the tool")
    parser.add_argument("--part", nargs="+", choices=PARTS, help="only these")
    arguments = parser.parse_args()
    try:
        oracle.run_tool([arguments.glint, "--version"])
        return 0 if run_parts(PARTS, arguments.part, arguments.glint) else 1
    except (oracle.Refused, Unreadable) as error:
        print(f"check_oracle: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
