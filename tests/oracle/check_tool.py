#!/usr/bin/env python3
"""What docs/contract.md says beyond y for legal inputs, against the tool: which profiles, cosines and inputs are
refused, the file formats, the error measures.

Exit status: 0 all hold, 1 some do not, 2 no tool.
"""

import argparse
import itertools
import json
import math
import random
import re
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import oracle
from checks import by_name, run_parts
from oracle import Profile, Refused, run_tool


class Tool:
    def __init__(self, path):
        self.path = path

    def run(self, *arguments, text=None):
        return run_tool([self.path, *arguments], text)

    def eval(self, profile, *arguments, text=None):
        return self.run("eval", "--lobe", "bps", f"--profile={profile}", *arguments, text=text)


def refused(checks, what, answer):
    output, message, status = answer
    checks.equal(f"{what}, exit status", status, 2)
    checks.true(f"{what}: a line says why", message)
    checks.equal(f"{what}, output", output, "")


# Section "Profiles"


def check_profiles(tool, checks):
    generator = random.Random("profiles")
    texts = ["p8", "p12", "p16", "P8", "p10", "bps", "", "18,14,14", "18,14,14,12,9", "18,14,14,12,", ",18,14,14,12",
             "18,,14,12", "18;14;14;12", "0x12,14,14,12", "18.0,14,14,12", "+18,14,14,12", "-18,14,14,12",
             "99999999999999999999,14,14,12", "18,14,14,4294967308"]
    for F, S, K, O in ((18, 14, 14, 12), (8, 4, 8, 4), (30, 30, 30, 28), (20, 28, 28, 28), (9, 30, 30, 4)):
        texts += [f"{x},{S},{K},{O}" for x in (0, 7, 8, 30, 31)]
        texts += [f"{F},{x},{K},{O}" for x in (0, O - 1, O, 30, 31)]
        texts += [f"{F},{S},{x},{O}" for x in (0, O - 1, O, 30, 31)]
        texts += [f"{F},{S},{K},{x}" for x in (0, 3, 4, min(S, K), min(S, K) + 1, 28, 29)]
    for O in range(4, 10):  # rule 4, all of O = K
        texts += [f"{generator.randint(8, 30)},{S},{O},{O}" for S in range(O, 31)]
    texts += [f"{F},{S},{K},4" for F, S, K in itertools.product((8, 30), (4, 7, 8, 30), (5, 6, 30))]
    texts += [f"{F},{S},{K},{O}" for F, S, K, O in
              ([generator.randint(*ends) for ends in ((7, 31), (4, 31), (4, 31), (3, 29))] for _ in range(50))]
    verdicts = {True: 0, False: 0}
    for text in dict.fromkeys(texts):
        try:
            Profile("bps", text)
            legal = True
        except Refused:
            legal = False
        verdicts[legal] += 1
        answer = tool.eval(text, "--n", "50", "--cos-code", "0")
        if legal:
            checks.equal(f"profile '{text}' is legal, exit status", answer[2], 0)
        else:
            refused(checks, f"profile '{text}' is not legal", answer)
    checks.true("legal and refused profiles", all(verdicts.values()))
    print(f"  {verdicts[True]} legal profiles, {verdicts[False]} refused")


# Sections "Arithmetic" (cosines given as real numbers) and "Ports"


def check_cosines(tool, checks):
    for name in ("p8", "p16", "8,30,30,4", "30,30,30,28"):
        profile = Profile("bps", name)
        ulp = 2.0**-profile.F
        halves = [x * ulp for x in (0.5, 1.5, 2.5, 1000.5, 2.0**profile.F - 0.5, 2.0**profile.F + 0.5)]
        top = 2.0 - ulp / 2  # rounds to 2^(F+1), which the port cannot carry
        values = [0.0, 0.98, 1.0, 0.5, 1e-300, 5e-324, top, 2.0 - ulp, math.nextafter(2.0, 0.0), 1.0 + 1e-15]
        values += [math.nextafter(x, 0.0) for x in halves + [top]] + [math.nextafter(x, 2.0) for x in halves] + halves
        values = [2.0, 2.5, *values, *(-x for x in values), -2.0]
        for x in values:
            what = f"{profile.name} cosine {x!r}"
            port = tool.eval(name, "--n", "5", f"--cos={x!r}", "--port")
            plain = tool.eval(name, "--n", "5", f"--cos={x!r}")
            try:
                code = oracle.cosine_code(Fraction(x), profile.F)
            except Refused:
                refused(checks, what, port)
                refused(checks, what, plain)
                continue
            answered = re.search(r"cos code (-?[0-9]+)", port[0])
            checks.equal(what, answered and int(answered[1]), code)
            if oracle.is_legal(profile, 5, code):
                checks.equal(f"{what}, exit status", plain[2], 0)
            else:
                refused(checks, what, plain)
    for x in ("nan", "inf", "-inf", "1e999", "abc", ""):
        refused(checks, f"cosine '{x}'", tool.eval("p8", "--n", "5", f"--cos={x}", "--port"))


def check_refused_inputs(tool, checks):
    for name in ("p8", "p16", "30,30,30,28"):
        profile = Profile("bps", name)
        one = 1 << profile.F
        for n, code in itertools.product((0, 1, 50, 1023), (-2 * one, -one, -1, 0, one, one + 1, 2 * one - 1)):
            answer = tool.eval(name, "--stdin", text=f"{n} {code}\n")
            if oracle.is_legal(profile, n, code):
                checks.equal(f"{name} {n} {code}", answer, (f"{oracle.answer(profile, n, code)[0]}\n", "", 0))
            else:
                refused(checks, f"{name} {n} {code}", answer)
        for n, code in ((-1, 0), (1024, 0), (1 << 32, 0), (1, -2 * one - 1), (1, 2 * one), (1, 1 << 32), (1 << 64, 0)):
            refused(checks, f"{name} {n} {code}", tool.eval(name, "--stdin", text=f"{n} {code}\n"))
            refused(checks, f"{name} {n} {code} --port", tool.eval(name, "--stdin", "--port", text=f"{n} {code}\n"))
        for line in ("", "50", "50 x", "x 50", "1.5 3", "50 3x", "50,3", "50 3 4", "0x10 3"):
            refused(checks, f"{name} line '{line}'", tool.eval(name, "--stdin", "--port", text=line + "\n"))


# Section "File formats"

NUMBER = "(0|-?[1-9][0-9]*)"
LINES = {
    "tv": re.compile(f"{NUMBER} {NUMBER} {NUMBER} ([01])"),
    "csv": re.compile(f"{NUMBER},{NUMBER},{NUMBER},([01])"),
    "hex": re.compile("([0-9a-f]{8})([0-9a-f]{4})([0-9a-f]{4})([0-9a-f]{8})"),
}


def parse_vector(kind, line):
    """n, cos_code, y, clamped of a line; None if the line is not of the format."""
    fields = LINES[kind].fullmatch(line)
    if not fields:
        return None
    if kind != "hex":
        return tuple(map(int, fields.groups()))
    cos, n, clamped, y = (int(x, 16) for x in fields.groups())
    if n > 1023 or clamped > 1:
        return None
    return n, cos - (cos >> 31 << 32), y, clamped


def check_vectors(tool, checks):
    count = 5000
    for kind, name in itertools.product(LINES, ("p8", "p12", "p16", "30,30,30,28", "8,4,4,4")):
        profile = Profile("bps", name)
        with tempfile.TemporaryDirectory() as folder:
            _, message, status = tool.run("vectors", "--lobe", "bps", "--profile", name, "--count", str(count),
                                          "--format", kind, "-o", folder)
            checks.equal(f"vectors {kind} {name}, exit status", (status, message), (0, ""))
            files = [x for x in Path(folder).iterdir() if x.suffix != ".json"]
            checks.equal(f"{kind} {name}, files", [x.name for x in files], [f"glint_bps_{profile.name}.{kind}"])
            manifests = [json.loads(x.read_text()) for x in Path(folder).glob("*.json")]
            checks.equal(f"{kind} {name}, manifest", [(x["profile"], x["F"], x["O"], x["count"]) for x in manifests],
                         [(profile.name, profile.F, profile.O, count)])
            data = files[0].read_bytes() if files else b""
        checks.true(f"{kind} {name} is ASCII with line feeds, the last line too",
                    data.isascii() and b"\r" not in data and data.endswith(b"\n"))
        lines = data.decode("ascii", "replace").split("\n")[:-1]
        if kind == "csv":
            checks.equal(f"{kind} {name}, header", lines[:1], ["n,cos_code,y,clamped"])
            lines = lines[1:]
        checks.equal(f"{kind} {name}, number of vectors", len(lines), count)
        legal = 0
        for line in lines:
            vector = parse_vector(kind, line)
            if vector is None:
                checks.true(f"{kind} {name}, format of '{line}'", False)
                continue
            n, code, *answered = vector
            checks.equal(f"{kind} {name}, '{line}'", tuple(answered), oracle.answer(profile, n, code))
            checks.equal(f"{kind} {name}, writing", oracle.FORMATS[kind](n, code, *answered), line)
            legal += oracle.is_legal(profile, n, code)
        checks.true(f"{kind} {name}, legal inputs and others", 0 < legal < count)


# Section "Errors"


def measures(profile, n, C):
    """Rounding error (ulp), approximation error at the rounded and the exact cosine, epicentre error (None outside
    its zone), all exact."""
    F, one = profile.F, 1 << profile.F
    y = profile.lobe.steps(n, C)[-1]
    numerator, denominator = profile.lobe.real(n, C)
    rounding = Fraction(abs(y * denominator - (numerator << profile.O)), denominator)

    def distance(code, bits):
        """|y / 2^O - (code / 2^bits)^n| as an integer over 2^(O + n bits)."""
        return abs((y << n * bits) - (code**n << profile.O))

    rounded = distance(C, F)
    low, high = max(0, 2 * C - 1), min(2 * one, 2 * C + 1)
    exact = max(distance(low, F + 1), distance(high, F + 1))
    inside = n >= 2 and n * C * C >= (n - 1) << 2 * F
    return (rounding, Fraction(rounded, 1 << profile.O + n * F), Fraction(exact, 1 << profile.O + n * (F + 1)),
            Fraction(rounded, C**n << profile.O) if inside else None)


KEYS = (("rounding", "max_ulp", "rms_ulp"), ("approximation", "max", "rms"),
        ("approximation_exact_cosine", "max", None), ("epicentre", "max", None))


def check_measures(tool, checks):
    runs = (("p8", range(1, 4), range(1, 65537, 5)), ("p8", range(50, 51), range(0, 65537)),
            ("p8", range(1023, 1024), range(65000, 65537, 3)), ("p12", range(2, 19, 16), range(0, 262145, 17)),
            ("p16", range(3, 4), range(900000, 901001)), ("18,14,14,12", range(8, 9), range(0, 262145, 31)))
    for name, exponents, codes in runs:
        profile = Profile("bps", name)
        n_range, code_range = (f"{x.start}:{x.stop - 1}:{x.step}" for x in (exponents, codes))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "out.json"
            _, message, status = tool.run("sweep", "--lobe", "bps", "--profile", name, "--n", n_range,
                                          "--cos", code_range, "--threads", "1", "--json", str(path))
            checks.equal(f"sweep {name} {n_range}, exit status", (status, message), (0, ""))
            accuracy = {"rows": [], "total": {}}
            if path.exists():
                accuracy = json.loads(path.read_text())["runs"][0]["accuracy"]
        values = {(n, C): measures(profile, n, C) for n in exponents for C in codes}
        checks.equal(f"sweep {name} {n_range}, rows", [row["n"] for row in accuracy["rows"]], list(exponents))
        rows = [(row, [row["n"]]) for row in accuracy["rows"] if row["n"] in exponents]
        rows.append((accuracy["total"], list(exponents)))
        for row, of in rows:
            what = f"sweep {name} n={of}"
            checks.equal(f"{what}, inputs", row.get("inputs"), len(of) * len(codes))
            for index, (key, greatest, rms) in enumerate(KEYS):
                got = row.get(key)
                tried = [(x[index], -n, -C) for (n, C), x in values.items() if n in of and x[index] is not None]
                if not tried:
                    checks.true(f"{what}, no {key}", not got)
                    continue
                if not got:
                    checks.true(f"{what}, {key} is missing", False)
                    continue
                worst, n, code = max(tried)
                scale = 2**profile.O if key == "rounding" else 1
                # In doubles the rounding error is right within 2^-49, section "Errors"; the others raise to n.
                slack = Fraction(scale, 2**49 if key == "rounding" else 2**44)
                checks.true(f"{what}, {key} is {float(worst)}, not {got[greatest]}",
                            abs(Fraction(got[greatest]) - worst) <= slack)
                place = got["n"], got["cos_code"]
                if place != (-n, -code):  # two that doubles cannot tell apart
                    other = values.get(place, [None] * len(KEYS))[index]
                    checks.true(f"{what}, {key} is worst at {(-n, -code)}, not {place}",
                                other is not None and 0 < worst - other <= 2 * slack)
                if rms:
                    mean = math.sqrt(math.fsum(float(x) ** 2 for x, _, _ in tried) / len(tried))
                    checks.true(f"{what}, RMS of {key} is {mean}, not {got[rms]}", abs(got[rms] - mean) <= 1e-9 * mean)


PARTS = by_name(check_profiles, check_cosines, check_refused_inputs, check_vectors, check_measures)


def main():
    parser = argparse.ArgumentParser(description="Refusals, file formats and measures of the tool.")
    parser.add_argument("--glint", required=True, help="the tool")
    parser.add_argument("--part", nargs="+", choices=PARTS, help="only these")
    arguments = parser.parse_args()
    try:
        return 0 if run_parts(PARTS, arguments.part, Tool(arguments.glint)) else 1
    except Refused as error:
        print(f"check_tool: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
