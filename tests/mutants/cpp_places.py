"""The places of C++ sources where cpp_faults.py can plant a fault, by libclang (python3-clang-14), and the text with faults."""

import hashlib
import os
import re
import shlex
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
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


class Places:
    """The faults that a file can have: offset, length, what the text becomes."""

    def __init__(self, path, arguments, source):
        import clang.cindex as clang
        self.kinds, self.types, self.path, self.text = clang.CursorKind, clang.TypeKind, path, path.read_bytes()
        unit = clang.Index.create().parse(str(source), args=arguments)
        wrong = [str(d) for d in unit.diagnostics if d.severity >= 3]
        if wrong:
            raise Failed(f"{path}: libclang: {wrong[0]}")
        self.found, self.names = [], {}
        self.visit(unit.cursor, None)

    def own(self, cursor):
        name = cursor.location.file and cursor.location.file.name
        if name not in self.names:
            self.names[name] = name is not None and os.path.realpath(name) == str(self.path)
        return self.names[name]

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
        line = self.text.rfind(b"\n", 0, start) + 1
        words = self.text[line:(self.text + b"\n").find(b"\n", start)]
        before = [other.strip() for other in self.text[:line].split(b"\n")]
        self.found.append({"line": cursor.extent.start.line, "text": words.strip().decode(), "nth": before.count(words.strip()),
                           "column": start - line - len(words) + len(words.lstrip()), "mutation": what,
                           "start": start, "end": end, "new": alternative})

    def visit(self, cursor, parent):
        k = self.kinds
        if cursor.kind in (k.STATIC_ASSERT, k.ENUM_DECL, k.TEMPLATE_TYPE_PARAMETER, k.TEMPLATE_NON_TYPE_PARAMETER):
            return
        if parent is None or self.own(cursor):
            start, end = cursor.extent.start.offset, cursor.extent.end.offset
            children = list(cursor.get_children())
            if cursor.kind == k.VAR_DECL and "constexpr" in self.part(start, end).split("=")[0]:
                return
            if parent is not None:
                self.look(cursor, parent, children, start, end)
            for i, child in enumerate(children):
                if not (cursor.kind == k.CASE_STMT and i == 0):
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
            for sign in "+" if re.fullmatch(r"0[uUlL]*", text) else "+-":
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


def key(fault):
    """What names a fault, wherever its line moves to."""
    return fault["file"], fault["text"], fault["nth"], fault["column"], fault["mutation"]


def candidates(commands, name):
    """The faults of a file, those of different lines first. A constant has two; the later one comes last."""
    path = ROOT / name
    if name.startswith("hls/"):
        unit = ROOT / f"hls/generated/{path.stem}_p8.cpp"
        source = unit if unit.exists() else next(u for u in sorted((ROOT / "hls/generated").glob("*_p8.cpp")) if includes(u, path.name))
        arguments = ["-std=c++14", f"-I{ROOT}/hls/generated"]
    else:
        source, words = path, shlex.split(command(commands, name))
        arguments = [word for i, word in enumerate(words) if re.match("-(I|D|std|isystem)", word) or words[i - 1] == "-isystem"]
    places = {}
    for place in Places(path, arguments, source).found:
        place["file"] = name
        places.setdefault(key(place), place)
    places = sorted(places.values(), key=lambda p: order("|".join(map(str, key(p)))))
    lines, constants = {}, set()
    for place in places:
        place["turn"] = lines[place["line"]] = lines.get(place["line"], 0) + 1
        if place["mutation"].endswith((" + 1", " - 1")):
            place["turn"] += 1000 if place["start"] in constants else 0
            constants.add(place["start"])
    return sorted(places, key=lambda p: p["turn"])


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
