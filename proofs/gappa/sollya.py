#!/usr/bin/env python3
"""Holds the proofs of `bps` against Sollya, which shares nothing with Gappa but the constants of the scripts.

Sollya rounds the published constants itself, and bounds the rounding error in another way, by interval arithmetic on
the sum of what each rounding can contribute, piece by piece:

  error / 2^O  in  [-1/2, 1/2] 2^-O                                 the last rounding
                 + [-2^-S, 0] P'(s)                                 the quotient, by the mean value theorem
                 + (a_K - a) q^3 + (b_K - b) q^2 + (c1_K - c1) q + (d0_K - d0)
                 + [-1/2, 1/2] 2^-K (q^2 + q)                       the roundings of h1 and h2

The two bounds have to agree to a hundredth of an ulp. Exit status: 0, 1 (a check failed), 2 (bad arguments, or no
Sollya).
"""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
AGREEMENT = 0.01
LOBE = "bps"  # whose formula PROGRAM has

PROGRAM = """
prec = 200!;
a = {a}; b = {b}; c1 = {c1}; d0 = {d0};
a_K = ({a_K}) * 2^(-{K}); b_K = ({b_K}) * 2^(-{K}); c1_K = ({c1_K}) * 2^(-{K}); d0_K = ({d0_K}) * 2^(-{K});
rounded = a_K == nearestint(a * 2^{K}) * 2^(-{K}) && b_K == nearestint(b * 2^{K}) * 2^(-{K})
  && c1_K == nearestint(c1 * 2^{K}) * 2^(-{K}) && d0_K == nearestint(d0 * 2^{K}) * 2^(-{K});
slope = 3 * a * x^2 + 2 * b * x + c1;
constants = (a_K - a) * x^3 + (b_K - b) * x^2 + (c1_K - c1) * x + (d0_K - d0);
steps = x^2 + x;
half = [-1/2; 1/2];
least = 0;
largest = 0;
for i from 0 to 255 do {{
  piece = [i / 256 - 2^(-{S}); (i + 1) / 256];
  total = half * 2^(-{O}) + [-2^(-{S}); 0] * evaluate(slope, piece) + evaluate(constants, piece)
    + half * 2^(-{K}) * evaluate(steps, piece);
  least = min(least, inf(total));
  largest = max(largest, sup(total));
}};
display = dyadic!;
print("rounded", rounded);
print("least", least * 2^{O});
print("largest", largest * 2^{O});
quit;
"""


class UsageError(Exception):
    """What was asked cannot be done: one line, exit status 2."""


def constants(path):
    """What the Gappa script says: word lengths, published constants as fractions, rounded ones as integers."""
    text = path.read_text()
    found = re.search(r"(?m)^# F, S, K, O: (\d+), (\d+), (\d+), (\d+)$", text)
    published = dict(re.findall(r"(?m)^(a|b|c1|d0) = (-?[\d.]+);$", text))
    rounded = dict(re.findall(r"(?m)^(a_K|b_K|c1_K|d0_K) = (-?\d+)b-\d+;$", text))
    if not found or len(published) != 4 or len(rounded) != 4:
        raise UsageError(f"{path} is not a script of the lobe {LOBE}")
    exact = {name: f"({Fraction(value)})" for name, value in published.items()}
    return dict(zip("FSKO", found.groups()), **exact, **rounded)


def bounds(sollya, path):
    """(are the constants the published ones, rounded; least and largest error in ulps), by Sollya."""
    done = subprocess.run([sollya, "--warnonstderr"], input=PROGRAM.format(**constants(path)), capture_output=True,
                          text=True, timeout=600, check=False)
    answers = dict(re.findall(r"(?m)^(rounded|least|largest) (\S+)$", done.stdout))
    ends = []
    for name in ("least", "largest"):
        number = re.fullmatch(r"(-?\d+)(?:b(-?\d+))?", answers.get(name, ""))
        if done.returncode != 0 or done.stderr or not number:
            raise RuntimeError(f"Sollya gave no bound for {path.name}: {(done.stderr or done.stdout).strip()[:200]}")
        ends.append(int(number.group(1)) * Fraction(2) ** int(number.group(2) or 0))
    return answers.get("rounded") == "true", *ends


def main():
    parser = argparse.ArgumentParser(description=f"The proven bounds of {LOBE} against those of Sollya.",
                                     epilog="Example: sollya.py proofs.json")
    parser.add_argument("proofs", type=pathlib.Path, help="a file that run.py --json wrote")
    parser.add_argument("--scripts", type=pathlib.Path, default=HERE / "generated", metavar="FOLDER",
                        help="the scripts that it is of (default: the committed ones)")
    parser.add_argument("--sollya", default="sollya", metavar="PROGRAM", help="the Sollya program (default: sollya)")
    options = parser.parse_args()
    sollya = shutil.which(options.sollya)
    if not sollya:
        raise UsageError(f"program '{options.sollya}' not found; install the package `sollya`")
    try:
        proofs = [(proof["profile"], options.scripts / proof["script"], proof["proven_ulp"])
                  for proof in json.loads(options.proofs.read_text())["proofs"] if proof["lobe"] == LOBE]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise UsageError(f"{options.proofs} is not a file of run.py --json with proven bounds: "
                         f"{type(error).__name__} {error}") from error

    failures = []
    print("profile        Gappa/ulp  Sollya/ulp")
    for profile, path, proven in proofs:
        try:
            rounded, least, largest = bounds(sollya, path)
        except OSError as error:
            raise UsageError(f"{path} cannot be read: {error.strerror}") from error
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            failures.append(f"{profile}: {error}")
            continue
        bound = float(max(-least, largest))
        print(f"{profile:<14} {proven:9.6f}   {bound:9.6f}")
        if not rounded:
            failures.append(f"{profile}: the script's constants are not the published ones, rounded")
        if abs(bound - proven) > AGREEMENT:
            failures.append(f"{profile}: the bounds differ by more than {AGREEMENT} ulp")
    if not proofs:
        failures.append(f"no proof of {LOBE} in the file")
    for failure in failures:
        print(f"FAILED: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except UsageError as error:
        print(f"sollya.py: {error}", file=sys.stderr)
        sys.exit(2)
