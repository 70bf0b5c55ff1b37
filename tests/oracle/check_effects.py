#!/usr/bin/env python3
"""docs/effects a second time, in exact integers, against `glint eval --effect`.

For each effect: its worked examples, value by value; then its corners, the inputs of effects/<name>.py and random ones,
as many as asked for, at every shipped profile. Ports and legal ranges are read from the table of its document.

Exit status: 0 all answers agree, 1 some do not, 2 wrong usage or no tool.
"""

import argparse
import random
import re
import sys
from importlib import import_module
from itertools import islice, product
from pathlib import Path

from arithmetic import Refused
from checks import Checks
from document import DOCS, Document, Unreadable
from oracle import SHIPPED, run_tool


def width(text, F, O):
    """`2^(O+8) - 1` and its like."""
    python = text.replace("^", "**")
    if not re.fullmatch(r"[0-9FOW+*() -]+", python):
        raise Unreadable(f"'{text}' is not a width or a code")
    return eval(python, {"__builtins__": {}}, {"F": F, "O": O, "W": 16})


class Port:
    def __init__(self, row, F, O):
        bits, *sign = row[1].split(", ")
        self.bits, signed = width(bits, F, O), sign == ["signed"]
        self.least, self.greatest = (-(1 << self.bits - 1), (1 << self.bits - 1) - 1) if signed else (0, (1 << self.bits) - 1)
        low, high = (self.least, self.greatest) if row[2] == "all" else (width(x, F, O) for x in row[2].split(" .. "))
        self.low, self.high = low, high

    def cut(self, code):
        return min(max(code, self.low), self.high)

    def corners(self, O):
        codes = {self.least, self.low - 1, self.low, -1, 0, 1, (1 << O) // 2, self.high // 2, self.high - 1, self.high,
                 self.high + 1, self.greatest}
        return sorted(code for code in codes if self.least <= code <= self.greatest)

    def random(self, generator):
        kind = generator.randrange(8)
        if kind == 0:
            return generator.randint(self.least, self.greatest)
        if kind < 4:
            return generator.randint(self.low, self.high)
        distance = generator.getrandbits(self.bits) >> generator.randrange(self.bits)
        return self.cut(self.high - distance if kind < 6 else distance if kind < 7 else self.low + distance)


class Subject:
    """An effect at a profile."""

    def __init__(self, name, profile):
        self.name, self.profile = name, profile
        F, O = SHIPPED[profile]
        self.O = O
        self.effect = import_module(f"effects.{name}").Effect(F, O)
        document = Document(DOCS / "effects" / f"{name}.md")
        rows = document.table("Contract", "port", "bits", "legal")
        self.ports = {}
        for row in rows[1:]:
            for port in row[0].split(", "):
                self.ports[port.strip("`")] = Port(row, F, O)
        self.outputs = {port: self.ports.pop(port) for port in self.effect.outputs}
        self.examples = document.examples().get(profile, [])

    def answer(self, codes):
        """All values by name, for codes as the ports carry them. An effect made of others corrects by them."""
        if hasattr(self.effect, "answer"):
            return self.effect.answer(dict(zip(self.ports, codes)))
        legal = [port.cut(code) for port, code in zip(self.ports.values(), codes)]
        values = self.effect.steps(*legal)
        for name, port in self.outputs.items():
            if not port.low <= values[name] <= port.high:
                raise Unreadable(f"{self.name}: {name} = {values[name]} for {codes} is outside its port")
        return {**values, "clamped": int(legal != list(codes))}

    def line(self, codes):
        values = self.answer(codes)
        return " ".join(str(values[name]) for name in (*self.outputs, "clamped"))

    def inputs(self, generator, count, most_corners):
        corners = [port.corners(self.O) for port in self.ports.values()]
        total = 1
        for codes in corners:
            total *= len(codes)
        if total <= most_corners:
            yield from product(*corners)
        else:
            for _ in range(min(getattr(self.effect, "corners", most_corners), most_corners)):
                yield tuple(generator.choice(codes) for codes in corners)
        yield from self.effect.inputs()
        for _ in range(count):
            yield tuple(port.random(generator) for port in self.ports.values())


def check_examples(tool, subject, checks):
    name = f"{subject.name} {subject.profile}"
    checks.true(f"{name}: worked examples", len(subject.examples) > 0)
    for example in subject.examples:
        codes = [example[port] for port in subject.ports]
        title = f"{name} {codes}"
        values = {**subject.answer(codes), **dict(zip(subject.ports, codes))}
        for value, code in example.items():
            checks.equal(f"{title}: {value} of the document", code, values.get(value))
        arguments = [f"--{port}={code}" if port == "n" else f"--{port}-code={code}" for port, code in zip(subject.ports, codes)]
        output, message, status = run_tool(
            [tool, "eval", "--effect", subject.name, "--profile", subject.profile, "--port", *arguments])
        checks.equal(f"{title}: exit status", (status, message), (0, ""))
        answered = dict(re.findall(r"^ *([A-Za-z]\w*) +(-?[0-9]+) +[0-9]+ ", output, re.MULTILINE))
        for value in example:
            if value not in subject.ports and value != "clamped":
                checks.equal(f"{title}: {value} of the tool", answered.get(value), str(values[value]))
        checks.equal(f"{title}: clamped of the tool", int(", clamped\n" in output), values["clamped"])


def check_stream(tool, subject, count, most_corners, seed, checks):
    generator = random.Random(f"{seed} {subject.name} {subject.profile}")
    inputs = subject.inputs(generator, count, most_corners)
    compared = 0
    while block := list(islice(inputs, 200000)):
        output, message, status = run_tool(
            [tool, "eval", "--effect", subject.name, "--profile", subject.profile, "--port", "--stdin"],
            "".join(" ".join(map(str, codes)) + "\n" for codes in block))
        checks.equal(f"{subject.name} {subject.profile}: exit status", (status, message), (0, ""))
        answers = output.split("\n")
        checks.equal(f"{subject.name} {subject.profile}: lines", len(answers), len(block) + 1)
        for codes, got in zip(block, answers):
            checks.equal(f"{subject.name} {subject.profile} {codes}", got, subject.line(codes))
        compared += len(block)
    checks.true(f"{subject.name} {subject.profile}: inputs", compared > count)


def main():
    parser = argparse.ArgumentParser(description="docs/effects in exact integers, compared with what glint eval answers.")
    parser.add_argument("--glint", required=True, help="the tool")
    parser.add_argument("--count", type=int, default=100000, help="random inputs per effect and profile")
    parser.add_argument("--corners", type=int, default=200000, help="where there are more corners, as many at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("effects", nargs="*", help="effects (default: all of docs/effects)")
    arguments = parser.parse_args()
    names = arguments.effects or sorted(path.stem for path in (DOCS / "effects").glob("*.md"))
    held = bool(names)
    try:
        for name in names:
            if not (Path(__file__).parent / "effects" / f"{name}.py").exists():
                raise Refused(f"effect '{name}' has no oracle: tests/oracle/effects/{name}.py")
            checks = Checks(name)
            for profile in SHIPPED:
                subject = Subject(name, profile)
                check_examples(arguments.glint, subject, checks)
                check_stream(arguments.glint, subject, arguments.count, arguments.corners, arguments.seed, checks)
            held &= checks.finish()
    except (Refused, Unreadable) as error:
        print(f"check_effects: {error}", file=sys.stderr)
        return 2
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
