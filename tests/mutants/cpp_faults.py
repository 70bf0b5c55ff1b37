#!/usr/bin/env python3
"""Planted faults in the C++: which test finds which.

    cpp_faults.py --tree /tmp/faulty              what the record does not hold yet, or holds of other files; may be stopped
    cpp_faults.py --tree /tmp/faulty --longest 1  the same with tests of up to a second; a later run tries the rest longer
    cpp_faults.py --check                         counts the record; fails for a survivor or a file that has changed

libclang (python3-clang-14) finds the operators, constants, conditions and statements of FILES. Some of each file are chosen and all
planted in one copy of the sources, each behind a comparison with the variable GLINT_PLANTED (planted.hpp). A run without
a fault tells which tests pass which place; then each fault meets those tests, the shortest first, until one fails.
cpp_faults.jsonl, the record, has a line for each. Exit status: 0 all found or equivalent, 1 not, 2 bad arguments.
"""

import argparse
import hashlib
import json
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
RECORD = HERE / "cpp_faults.jsonl"
# What is planted, by kind of code. A fault for so many lines.
FILES = {
    "golden": ("model/src/lobes/[b-ds-tgpq]*.cpp model/src/lobes/exp_log.cpp model/src/effects/*.cpp model/src/golden.cpp "
               "model/src/cook_torrance.cpp model/src/fixed_point.cpp model/src/profile.cpp model/src/effect.cpp", 13),
    "meter": ("model/src/accuracy.cpp model/src/reference.cpp model/src/sweep.cpp model/src/hard_cases.cpp model/src/fit.cpp "
              "model/src/word_lengths.cpp cost/accuracy.cpp", 7),
    "price": ("cost/choice.cpp cost/table.cpp cost/prices.cpp cost/effect_prices.cpp cost/cpu_prices.cpp cost/decay_formats.cpp "
              "cost/missing.cpp cost/fpga/cost.cpp cost/fpga/points.cpp cost/fpga/table.cpp cli/choose.cpp", 11),
    "parser": ("model/src/range.cpp model/src/architecture.cpp io/command.cpp io/json_node.cpp io/results.cpp io/merge.cpp io/quantity.cpp "
               "io/shards.cpp render/text.cpp render/mtl.cpp render/wavefront.cpp render/scene.cpp", 9),
    "kernel": ("hls/lobes/*.hpp hls/effects/*.hpp hls/blocks/glint_exp_log.hpp hls/blocks/glint_divide.hpp "
               "hls/blocks/glint_sqrt.hpp hls/blocks/glint_microfacets.hpp", 12),
}
# No warnings, and the kernels' test ends with the first wrong result.
CHANGES = (("tests/hls/CMakeLists.txt", b"-Wall -Wextra -Wconversion -Werror", b"-w"),
           ("tests/hls/kernel.cpp", b"if (++mismatches_ > 10) return;", b"if (++mismatches_ != 0) std::_Exit(1);"))
TARGETS = ("glint-cli glint-unit-tests glint-render-tests glint-cost-tests hls-kernel-g++ hls-divide-adding hls-divide-radix4 "
           "hls-divide-reciprocal hls-divide-restoring").split()
LABELS = {"unit", "oracle", "cli", "cost", "render", "hls"}
OPERATORS = {"+": "-", "-": "+", "*": "+", "/": "*", "%": "/", "<<": ">>", ">>": "<<", "<": "<=", "<=": "<", ">": ">=", ">=": ">",
             "==": "!=", "!=": "==", "&": "|", "|": "&", "^": "&", "&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "|=": "&="}


class Failed(Exception):
    """A tool that failed; the text says which and why."""


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def run(*command, **more):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)


def order(text):
    return hashlib.sha256(text.encode()).hexdigest()


def files():
    """Each file with its kind and how many faults it gets."""
    out = {}
    for kind, (patterns, lines) in FILES.items():
        for pattern in patterns.split():
            for path in sorted(ROOT.glob(pattern)):
                out[str(path.relative_to(ROOT))] = (kind, max(4, path.read_text().count("\n") // lines))
    return out


# ---- the faults of a file ----------------------------------------------------------------------------------------------

class Places:
    """The faults that a file can have: offset, length, what the text becomes."""

    def __init__(self, path, arguments, source):
        import clang.cindex as clang
        self.kinds, self.types, self.path, self.text = clang.CursorKind, clang.TypeKind, path, path.read_bytes()
        unit = clang.Index.create().parse(str(source), args=arguments)
        wrong = [str(d) for d in unit.diagnostics if d.severity >= 3]
        if wrong:
            raise Failed(f"{path}: libclang: {wrong[0]}")
        self.found = []
        self.visit(unit.cursor, None)

    def own(self, cursor):
        return cursor.location.file is not None and os.path.realpath(cursor.location.file.name) == str(self.path)

    def part(self, start, end):
        return self.text[start:end].decode()

    def number(self, cursor):
        return self.types.BOOL.value <= cursor.type.get_canonical().kind.value <= self.types.LONGDOUBLE.value

    def in_type(self, start):
        """In an argument of a template: `name<` is open, which the compiler computes. A comparison has spaces around it."""
        closed, within = 0, 0  # `>` and `)` that are still to be opened
        for at in range(start - 1, 2, -1):
            sign, before = self.text[at:at + 1], self.text[at - 2:at]
            if sign in b";{}":
                return False
            if sign == b">" and before[1:] not in (b" ", b"-") and before != b" >":
                closed += 1
            if sign == b"<" and re.match(rb"\w", before[1:]):
                if closed == 0 and within == 0:
                    return True
                closed = max(0, closed - 1)
            within = max(0, within + {b")": 1, b"(": -1}.get(sign, 0))
        return False

    def add(self, cursor, what, start, end, alternative):
        if self.in_type(start):
            return
        self.found.append({"line": cursor.extent.start.line, "start": start, "end": end, "mutation": what, "new": alternative})

    def visit(self, cursor, parent):
        k = self.kinds
        if cursor.kind in (k.STATIC_ASSERT, k.ENUM_DECL, k.TEMPLATE_TYPE_PARAMETER, k.TEMPLATE_NON_TYPE_PARAMETER):
            return
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        children = list(cursor.get_children())
        if parent is None or self.own(cursor):
            if cursor.kind == k.VAR_DECL and "constexpr" in self.part(start, end).split("=")[0]:
                return
            if parent is not None:
                self.look(cursor, parent, children, start, end)
            for i, child in enumerate(children):
                if not (cursor.kind == k.CASE_STMT and i == 0):
                    self.visit(child, cursor)
        elif cursor.kind in (k.NAMESPACE, k.LINKAGE_SPEC):
            for child in children:
                self.visit(child, cursor)

    def look(self, cursor, parent, children, start, end):
        k, text = self.kinds, self.part(start, end)
        if cursor.kind in (k.BINARY_OPERATOR, k.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2 and all(map(self.number, children)):
            left, right = children[0].extent.end.offset, children[1].extent.start.offset
            old = self.part(left, right).strip()
            if old in OPERATORS:
                new = self.part(start, left) + f" {OPERATORS[old]} " + self.part(right, end)
                self.add(cursor, f"{old} becomes {OPERATORS[old]}", start, end, new)
        elif cursor.kind == k.INTEGER_LITERAL and re.fullmatch(r"(0x[0-9a-fA-F']+|[\d']+)[uUlL]*", text):
            sign = "+-"[int(order(f"{start}"), 16) % 2] if not re.fullmatch(r"0[uUlL]*", text) else "+"
            self.add(cursor, f"{text} {sign} 1", start, end, f"{text} {sign} 1")
        elif cursor.kind == k.FLOATING_LITERAL and re.fullmatch(r"[\d.'e+-]+", text):
            self.add(cursor, f"{text} * 1.25 + 0.01", start, end, f"{text} * 1.25 + 0.01")
        elif cursor.kind == k.UNARY_OPERATOR and text and text[0] in "-!~" and self.number(cursor):
            self.add(cursor, f"without {text[0]}", start, end, True if text[0] == "!" else text[1:])
        elif cursor.kind == k.IF_STMT and children and not text.startswith("if constexpr"):
            condition = children[0]
            if condition.kind != k.BINARY_OPERATOR and self.number(condition):
                a, b = condition.extent.start.offset, condition.extent.end.offset
                self.add(cursor, "condition negated", a, b, True)
        if parent.kind in (k.COMPOUND_STMT, k.IF_STMT, k.FOR_STMT) and self.part(end, end + 1) == ";" and \
                cursor.kind in (k.CALL_EXPR, k.BINARY_OPERATOR, k.COMPOUND_ASSIGNMENT_OPERATOR, k.CXX_THROW_EXPR, k.CONTINUE_STMT,
                                k.BREAK_STMT, k.UNEXPOSED_EXPR) and not re.match(r"(fmt::)?print\(", text) and \
                (parent.kind == k.COMPOUND_STMT or self.part(parent.extent.start.offset, start).rstrip().endswith((")", "else"))):
            self.add(cursor, "statement deleted", start, end, None)


def candidates(tree, commands, name):
    """Some faults of a file, those of different lines first."""
    path = ROOT / name
    if name.startswith("hls/"):
        unit = ROOT / f"hls/generated/{path.stem}_p8.cpp"
        source = unit if unit.exists() else next(u for u in sorted((ROOT / "hls/generated").glob("*_p8.cpp")) if includes(u, path.name))
        arguments = ["-std=c++14", f"-I{ROOT}/hls/generated"]
    else:
        source, words = path, shlex.split(command(commands, name))
        arguments = [word for i, word in enumerate(words) if re.match("-(I|D|std|isystem)", word) or words[i - 1] == "-isystem"]
    places = Places(path, arguments, source).found
    lines = {}
    for place in sorted(places, key=lambda p: order(f"{name} {p['mutation']} {p['start']}")):
        place["turn"] = lines[place["line"]] = lines.get(place["line"], 0) + 1
    return sorted(places, key=lambda p: (p["turn"], order(f"{name} {p['start']} {p['mutation']}")))


def command(commands, name):
    """How a file is compiled; one that is compiled together with others (UNITY_BUILD), as they are."""
    folders = [str(folder) for folder in Path(name).parents][:-1]
    together = [c for folder in folders for file, c in commands.items() if file.startswith(f"build/{folder}/") and "Unity" in file]
    return commands[name] if name in commands else together[0]


def includes(unit, header):
    return header in run("g++", "-std=c++14", f"-I{ROOT}/hls/generated", "-MM", unit).stdout


def planted(text, faults):
    """The text with the faults in it; of nested ones the alternative keeps the inner text as it was."""
    def rewrite(start, end, rest):
        out, at = b"", start
        while rest:
            fault = rest.pop(0)
            inner = []
            while rest and rest[0]["end"] <= fault["end"]:
                inner.append(rest.pop(0))
            old = rewrite(fault["start"], fault["end"], inner)
            test = f"glint_planted::on({fault['number']})".encode()
            if fault["new"] is None:
                new = b"if (" + test + b") {} else " + old
            elif fault["new"] is True:
                new = b"(" + test + b" != static_cast<bool>(" + old + b"))"
            else:
                new = b"(" + test + b" ? (" + fault["new"].encode() + b") : (" + old + b"))"
            out += text[at:fault["start"]] + new
            at = fault["end"]
        return out + text[at:end]
    ranked = sorted(faults, key=lambda f: (f["start"], -f["end"], f["new"] is not None))
    return f'#include "{HERE}/planted.hpp"\n#line 1\n'.encode() + rewrite(0, len(text), ranked)


# ---- the copy of the sources -------------------------------------------------------------------------------------------

def put(path, text):
    """Writes what has changed alone, for a build looks at the time."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != text:
        path.write_bytes(text)


def build(tree):
    """The faults by number, in a copy of the sources that is built. What does not compile is left out."""
    (tree / "build").mkdir(parents=True, exist_ok=True)
    shares = files()
    for name in run("git", "ls-files", cwd=ROOT).stdout.splitlines():
        if name not in shares or not (tree / name).exists():
            text = (ROOT / name).read_bytes()
            for file, old, new in CHANGES:
                text = text.replace(old, new) if name == file else text
            put(tree / name, text)
            shutil.copymode(ROOT / name, tree / name)
    configured = run("cmake", "-G", "Ninja", "-S", tree, "-B", tree / "build", "-DGLINT_COSIM=OFF", "-DGLINT_WERROR=OFF", "-DCMAKE_CXX_COMPILER=g++",
                     "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -w", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    if configured.returncode != 0:
        raise Failed(configured.stdout[-1000:] + configured.stderr[-1000:])
    commands = {str(Path(c["file"]).relative_to(tree)): c["command"]
                for c in json.loads((tree / "build/compile_commands.json").read_text()) if c["file"].startswith(str(tree))}
    known, chosen, number = {}, {}, 0
    for name, (_, share) in shares.items():
        known[name] = candidates(tree, commands, name)
        chosen[name], known[name] = known[name][:share], known[name][share:]
    for turn in range(12):
        number = 0
        for name, faults in chosen.items():
            for fault in faults:
                number += 1
                fault["number"] = number
            put(tree / name, planted((ROOT / name).read_bytes(), faults))
        done = run("cmake", "--build", tree / "build", "--target", *TARGETS, "--", "-k", "0", "-j1")
        if done.returncode == 0:
            return {f["number"]: {"kind": shares[name][0], "file": name, **f} for name, faults in chosen.items() for f in faults}
        wrong = set(re.findall(r"^(?:In file included from )?(?:\.\./)*" + rf"(?:{re.escape(str(tree))}/)?([\w/.]+):(\d+):", done.stdout, re.MULTILINE))
        dropped = 0
        for name, faults in chosen.items():
            bad = [f for f in faults if (name, str(f["line"])) in wrong]
            dropped += len(bad)
            chosen[name] = [f for f in faults if f not in bad] + known[name][:len(bad)]
            known[name] = known[name][len(bad):]
        print(f"{dropped} faults do not compile, others instead", flush=True)
        if not dropped:
            raise Failed(done.stdout[-3000:])
    raise Failed("no end of faults that do not compile")


def tests(tree):
    """The tests of ./test by name: command, folder, environment."""
    slow = re.compile("|".join(f"(?:{t['tests']})" for t in json.loads((ROOT / "tests/nightly.json").read_text())["tests"]))
    out = {}
    for test in json.loads(run("ctest", "--show-only=json-v1", cwd=tree / "build").stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test["properties"]}
        if "command" in test and LABELS & set(properties.get("LABELS", [])) and not slow.fullmatch(test["name"]):
            environment = dict(line.split("=", 1) for line in properties.get("ENVIRONMENT", []))
            out[test["name"]] = (test["command"], properties["WORKING_DIRECTORY"], environment)
    return out


def shortened(known):
    """Tests of random inputs with fewer of them: what these find, the whole test finds."""
    few = {"--count": "500", "--corners": "500"}
    return {name: ([few.get(before, word) if name.startswith("oracle_") else word for before, word in zip(["", *test[0]], test[0])], *test[1:])
            for name, test in known.items()}


def passes(test, number, seconds, log=None):
    """Does a test pass with a fault, in so many seconds of processor time? An endless loop does not."""
    command, folder, environment = test
    environment = {**os.environ, **environment, "GLINT_PLANTED": str(number), "OMP_NUM_THREADS": "1"}
    if log:
        environment["GLINT_PLANTED_LOG"] = log
    limit = int(seconds) + 1
    try:
        return subprocess.run(command, cwd=folder, env=environment, capture_output=True, timeout=100 * limit,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))).returncode in (0, 77)
    except subprocess.TimeoutExpired:
        return False


def survey(known, longest):
    """Each test that passes without a fault: its seconds, and the faults that it meets."""
    def spent():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    out = {}
    for name, test in known.items():
        with tempfile.TemporaryDirectory() as log:
            before = spent()
            if not passes(test, 0, longest, log):
                print(f"{name} takes longer than {longest} s, or fails without a fault: left out", flush=True)
                continue
            met = {int(n) for file in Path(log).iterdir() for n in file.read_text().split()}
            out[name] = (spent() - before, sorted(met))
    return out


def plant(tree, record, longest, most):
    """Tries what the record does not hold, and writes it there."""
    state = tree / "planted.json"
    now = [digest(ROOT / name) for name in files()] + [digest(Path(__file__)), digest(HERE / "planted.hpp"), longest]
    if not state.exists() or json.loads(state.read_text())["digests"] != now:
        faults = build(tree)
        print(f"{len(faults)} faults planted", flush=True)
        met = survey(shortened(tests(tree)), longest)
        state.write_text(json.dumps({"digests": now, "faults": faults, "met": met}))
    held = json.loads(state.read_text())
    known = shortened(tests(tree))
    met = {name: (seconds, set(met)) for name, (seconds, met) in held["met"].items()}
    before = {key(line): line for line in read(record)}
    tries = {}  # by file and test: what found a fault of a file may find the next
    with record.open("a") as out:
        for number, fault in held["faults"].items():
            line = {name: fault[name] for name in ("kind", "file", "line", "mutation", "start")}
            line["sha256"] = digest(ROOT / fault["file"])
            subject = Path(fault["file"]).stem.removeprefix("glint_").removeprefix("effect_")

            def dear(name):
                """Seconds until it has found a fault."""
                found, tried = tries.get((fault["file"], name), (0, 0))
                return met[name][0] * (tried + 1) / (found + (0.5 if subject in name else 0.1))

            meets = sorted((name for name, (seconds, some) in met.items() if int(number) in some and seconds <= longest), key=dear)[:most]
            last = before.get(key(line))
            if last and (not is_open(last) or last["longest"] >= longest and last["tried"] >= len(meets)):
                continue
            line |= {"killed_by": "", "tried": len(meets), "longest": longest}
            for name in meets:
                found = not passes(known[name], number, 2 + 5 * met[name][0])
                hits, tried = tries.get((fault["file"], name), (0, 0))
                tries[fault["file"], name] = (hits + found, tried + 1)
                if found:
                    line["killed_by"] = name
                    break
            out.write(json.dumps(line) + "\n")
            out.flush()


# ---- the record --------------------------------------------------------------------------------------------------------

def key(line):
    return line["file"], line["sha256"], line["start"], line["mutation"]


def read(file):
    """The lines of a record; of two about one fault the later."""
    lines = map(json.loads, file.read_text().splitlines()) if file.exists() else []
    return list({key(line): line for line in lines}.values())


def is_open(line):
    return not line["killed_by"] and not line.get("equivalent")


def check(record):
    counts = Counter("open" if is_open(l) else "found" if l["killed_by"] else "equivalent" for l in record)
    for line in filter(is_open, record):
        print(f"open: {line['file']}:{line['line']} {line['mutation']}")
    stale = {l["file"] for l in record if not (ROOT / l["file"]).exists() or digest(ROOT / l["file"]) != l["sha256"]}
    stale |= set(files()) - {line["file"] for line in record}
    for name in sorted(stale):
        print(f"not tried as it stands: {name}")
    print(f"{len(record)} faults: {counts['found']} found, {counts['equivalent']} equivalent, {counts['open']} open")
    return 1 if counts["open"] or stale or not record else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tree", type=Path, metavar="DIR", help="where the copy of the sources is kept")
    parser.add_argument("--record", type=Path, default=RECORD, metavar="FILE")
    parser.add_argument("--longest", type=float, default=20, metavar="SECONDS", help="tests that take more processor time are left out")
    parser.add_argument("--most", type=int, default=1000, metavar="TESTS", help="ends after so many tests of a fault; a later run tries more")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        return check(read(options.record))
    if not options.tree:
        print("cpp_faults.py: --tree is missing: a folder for the copy of the sources", file=sys.stderr)
        return 2
    try:
        plant(options.tree.resolve(), options.record, options.longest, options.most)
    except Failed as failed:
        print(f"cpp_faults.py: FAILED: {failed}", file=sys.stderr)
        return 1
    return check(read(options.record))


if __name__ == "__main__":
    sys.exit(main())
