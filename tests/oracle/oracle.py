#!/usr/bin/env python3
"""An independent oracle: the contract a second time, in exact integers, against `glint eval`.

It was written from docs/contract.md and the lobes' documents alone, before its author had read the model, the HLS code
or the Verilog; keep it so. A later lobe adds one file to lobes/. Only Python's standard library is needed.

Exit status: 0 all answers agree, 1 some do not, 2 wrong usage or no tool.
"""

import argparse
import random
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

from arithmetic import Refused, cosine_code
from document import Document, Unreadable, contract_of


# A lobe is a file of its own, lobes/<name>.py, with a class `Lobe`. It holds the guard bits by name and those of the
# shipped profiles, `steps` (one integer per name in `names`, the last one y) for a corrected n and C, `refusal` for the
# rules on its guard bits, and `inputs` for the inputs at which its own formula is most likely to be got wrong. Names in
# `unnamed` stand in the document alone: the tool does not print them.
LOBES = {}
for path in sorted((Path(__file__).resolve().parent / "lobes").glob("[a-z]*.py")):
    LOBES[path.stem] = import_module(f"lobes.{path.stem}").Lobe


# Section "Profiles"

SHIPPED = {"p8": (16, 8), "p12": (18, 12), "p16": (20, 16)}  # F and O, for all lobes


class Profile:
    """A legal profile of one lobe. `text` is a shipped name, or F,<guard bits>,O."""

    def __init__(self, lobe, text):
        kind = LOBES[lobe]
        if text in SHIPPED:
            self.name = text
            self.F, self.O = SHIPPED[text]
            self.guards = kind.shipped[text]
        else:
            if not re.fullmatch("[0-9]+(,[0-9]+)*", text):
                raise Refused(f"profile '{text}' is not legal: neither a shipped one nor a list of decimal integers")
            numbers = [int(x) for x in text.split(",")]
            if len(numbers) != len(kind.guards) + 2:
                raise Refused(f"profile '{text}' is not legal for {lobe}: F,{','.join(kind.guards)},O")
            self.name = "_".join(str(x) for x in numbers)
            self.F, self.O = numbers[0], numbers[-1]
            self.guards = tuple(numbers[1:-1])
        if not (8 <= self.F <= 30 and 4 <= self.O <= 28):
            raise Refused(f"profile '{text}' is not legal: 8 <= F <= 30 and 4 <= O <= 28")
        self.argument = text
        self.lobe = kind(self.F, self.guards, self.O)
        reason = self.lobe.refusal()
        if reason:
            raise Refused(f"profile '{text}' is not legal for {lobe}: {reason}")


def split_profiles(lobe, text):
    """`p8,18,14,14,12,p12` as three profiles: a custom one takes a number per guard bit of the lobe, and two more."""
    size, profiles, numbers = len(LOBES[lobe].guards) + 2, [], []
    for token in text.split(","):
        if token.isdigit():
            numbers.append(token)
            if len(numbers) == size:
                profiles.append(",".join(numbers))
                numbers = []
        elif numbers:
            break
        else:
            profiles.append(token)
    if numbers:
        raise Refused(f"profile '{','.join(numbers)}' is not legal for {lobe}: {size} numbers")
    return profiles


# Section "Ports"


def is_legal(profile, n, cos_code):
    return 1 <= n <= 1023 and 0 <= cos_code <= 1 << profile.F


def correct(profile, n, cos_code):
    """n and C as the lobe sees them."""
    one = 1 << profile.F
    if n == 0:
        n = 1
    return n, 0 if cos_code < 0 else one if cos_code > one else cos_code


def answer(profile, n, cos_code):
    """y and clamped for what the ports carry."""
    clamped = 1 if n == 0 or cos_code < 0 or cos_code > 1 << profile.F else 0
    n, C = correct(profile, n, cos_code)
    y = profile.lobe.steps(n, C)[-1]
    return 0 if cos_code < 0 else y, clamped


def intermediates(profile, n, cos_code):
    """Every value by its name in the worked examples."""
    y, clamped = answer(profile, n, cos_code)
    n, C = correct(profile, n, cos_code)
    return {"C": C, **dict(zip(profile.lobe.names, profile.lobe.steps(n, C))), "y": y, "clamped": clamped}


# Section "File formats"

FORMATS = {
    "tv": lambda n, cos_code, y, clamped: f"{n} {cos_code} {y} {clamped}",
    "csv": lambda n, cos_code, y, clamped: f"{n},{cos_code},{y},{clamped}",
    "hex": lambda n, cos_code, y, clamped: f"{(cos_code % 2**32 << 16 | n) << 48 | clamped << 32 | y:024x}",
}

# Inputs

CORNER_EXPONENTS = (0, 1, 2, 3, 8, 50, 512, 1000, 1022, 1023)


def corners(profile):
    one, end = 1 << profile.F, 2 << profile.F
    near = ((-end, 0, 2), (-one, -1, 2), (0, -3, 5), (one // 2, -2, 3), (one, -3, 4), (end, -2, 0))
    codes = [code + offset for code, first, last in near for offset in range(first, last)]
    codes += [one * percent // 100 for percent in (1, 10, 25, 75, 90, 98, 99)]
    return sorted({(n, code) for n in CORNER_EXPONENTS for code in codes})


def random_inputs(profile, generator, count):
    """About four in five legal: n uniform or small, the cosine uniform, near 1 (where highlights are) or near 0. The
    others anywhere the port can carry, or just outside what is legal."""
    F, one = profile.F, 1 << profile.F
    bits, uniform = generator.getrandbits, generator.random
    inputs = []
    for _ in range(count):
        kind = int(uniform() * 8)
        n = bits(10) >> (int(uniform() * 10) if kind & 1 else 0) or 1
        if kind < 2:
            code = int(uniform() * (one + 1))
        elif kind < 5:
            code = one - (bits(F) >> int(uniform() * F))
        elif kind < 6:
            code = bits(F) >> int(uniform() * F)
        else:
            if bits(2) == 0:
                n = 0
            if kind == 6:
                code = bits(F + 2) - 2 * one
            elif bits(1):
                code = one + 1 + (bits(F) >> int(uniform() * F))
                code = min(code, 2 * one - 1)
            else:
                code = -1 - (bits(F + 1) >> int(uniform() * (F + 1)))
        inputs.append((n, code))
    return inputs


# Comparison


def run_tool(command, text=None):
    """Standard output, first line of standard error, exit status."""
    try:
        done = subprocess.run([str(x) for x in command], input=text, capture_output=True, text=True, errors="replace")
    except OSError as error:
        raise Refused(f"{command[0]} cannot be run: {error.strerror}") from error
    return done.stdout, (done.stderr.splitlines() or [""])[0], done.returncode


def compare(tool, lobe, profile, inputs, expected, port, show=5):
    """Feeds the inputs to the tool in one go; True if each line it answers is the expected one."""
    title = f"{lobe} {profile.name}{' --port' if port else ''}"
    command = [tool, "eval", "--lobe", lobe, "--profile", profile.argument, "--stdin"] + ["--port"] * port
    output, message, status = run_tool(command, "".join([f"{n} {code}\n" for n, code in inputs]))
    mismatches = []
    if output != "".join([line + "\n" for line in expected]):
        lines = output.split("\n")
        ending = lines.pop()
        if ending:
            lines.append(ending + " (no line feed)")
        total = max(len(lines), len(expected))
        for i in range(total):
            got = lines[i] if i < len(lines) else None
            want = expected[i] if i < len(expected) else None
            if got != want:
                mismatches.append((i, got, want))
    print(f"{title}: {len(inputs)} inputs, {len(mismatches)} mismatches")
    for i, got, want in mismatches[:show]:
        answered = "nothing" if got is None else f"'{got}'"
        if want is None:
            print(f"  line {i + 1}: the tool answers {answered}, more lines than inputs")
            continue
        values = " ".join(f"{name}={x}" for name, x in intermediates(profile, *inputs[i]).items())
        print(f"  line {i + 1}, n={inputs[i][0]} cos_code={inputs[i][1]}: the tool answers {answered}, "
              f"the contract '{want}': {values}")
    if status != 0:
        print(f"  the tool exits with status {status}: {message}")
    if not inputs:
        print("  no inputs: nothing was compared")
    return bool(inputs) and not mismatches and status == 0


def compare_profile(tool, lobe, profile, examples, count, seed):
    generator = random.Random(f"{seed} {lobe} {profile.name}")
    inputs = examples + corners(profile) + list(profile.lobe.inputs()) + random_inputs(profile, generator, count)
    answers = [answer(profile, n, code) for n, code in inputs]
    held = compare(tool, lobe, profile, inputs, [f"{y} {clamped}" for y, clamped in answers], True)
    legal = [i for i, (n, code) in enumerate(inputs) if is_legal(profile, n, code)]
    plain = [inputs[i] for i in legal], [str(answers[i][0]) for i in legal]
    return compare(tool, lobe, profile, *plain, False) and held


def main():
    parser = argparse.ArgumentParser(
        description="The contract in exact integers, compared with every line that glint eval answers.",
        epilog="Example: oracle.py --glint build/clang/glint --profile p8,p12,p16,18,14,14,12 --count 1000000")
    parser.add_argument("--glint", required=True, help="the tool")
    parser.add_argument("--lobe", default="bps", choices=sorted(LOBES))
    parser.add_argument("--profile", default="p8,p12,p16", help="profiles: p8, p12, p16, or F,<guard bits>,O")
    parser.add_argument("--count", type=int, default=100000, help="random inputs per profile, beside the corners")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--contract", type=Path,
                        help="the document, for the inputs of its examples (default: the one of the lobe)")
    arguments = parser.parse_args()
    if arguments.count < 0:
        parser.error(f"--count {arguments.count} is not legal: at least 0")

    try:
        document = Document(arguments.contract or contract_of(arguments.lobe))
        profiles = [Profile(arguments.lobe, text) for text in split_profiles(arguments.lobe, arguments.profile)]
        held = True
        for profile in profiles:
            examples = [(row["n"], row["cos_code"]) for row in document.examples().get(profile.name, [])]
            held &= compare_profile(arguments.glint, arguments.lobe, profile, examples, arguments.count, arguments.seed)
    except (Refused, Unreadable) as error:
        print(f"oracle: {error}", file=sys.stderr)
        return 2
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
