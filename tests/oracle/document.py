"""What docs/contract.md and docs/lobes say, as data: its tables and its worked examples."""

import argparse
import re
import sys
from pathlib import Path

from checks import run_parts


DOCS = Path(__file__).resolve().parents[2] / "docs"
CONTRACT = DOCS / "contract.md"  # what is common to all lobes


def contract_of(lobe):
    """The document that prescribes a lobe."""
    return DOCS / "lobes" / f"{lobe}.md"


class Unreadable(Exception):
    """The document is missing, or lacks what it should hold."""


def plain(cell):
    return cell.strip().strip("`")


def integer(cell):
    """An integer of a table; thousands may be set apart by blanks."""
    text = plain(cell).replace(" ", "")
    if not re.fullmatch("-?[0-9]+", text):
        raise Unreadable(f"contract: '{cell.strip()}' is not an integer")
    return int(text)


class Document:
    def __init__(self, path):
        try:
            self.text = path.read_text(encoding="utf-8")
        except OSError as error:
            raise Unreadable(f"the contract {path} cannot be read: {error.strerror}") from error
        self.prose = " ".join(self.text.split())

    def section(self, title):
        """The lines from a heading to the next one of the same or a higher level."""
        lines = self.text.split("\n")
        for start, line in enumerate(lines):
            heading = re.fullmatch("(#+) (.*)", line)
            if heading and plain(heading[2].replace("`", "")) == title:
                level = len(heading[1])
                for end in range(start + 1, len(lines)):
                    other = re.match("(#+) ", lines[end])
                    if other and len(other[1]) <= level:
                        return lines[start + 1 : end]
                return lines[start + 1 :]
        raise Unreadable(f"contract: no section '{title}'")

    def tables(self, title):
        """All tables of a section: lists of rows, each a list of cells, the header first."""
        found, rows = [], []
        for line in self.section(title) + [""]:
            if line.startswith("|"):
                rows.append([plain(cell) for cell in line.strip().strip("|").split("|")])
            elif rows:
                found.append([rows[0]] + rows[2:])
                rows = []
        return found

    def table(self, title, *header):
        """The table of a section whose header starts with these cells."""
        for rows in self.tables(title):
            if tuple(rows[0][: len(header)]) == header:
                if len(rows) < 2 or any(len(row) != len(rows[0]) for row in rows):
                    break
                return rows
        raise Unreadable(f"contract: section '{title}' has no table '{' | '.join(header)}'")

    def find(self, pattern):
        """The groups of a pattern that the prose must hold; line ends count as blanks."""
        match = re.search(pattern, self.prose)
        if not match:
            raise Unreadable(f"contract: nothing reads '{pattern}'")
        return match.groups()

    def blocks(self, title, language=""):
        """The fenced blocks of a section, each a list of lines."""
        found, block = [], None
        for line in self.section(title):
            if block is None and line == "```" + language:
                block = []
            elif block is not None and line == "```":
                found.append(block)
                block = None
            elif block is not None:
                block.append(line)
        return found

    def examples(self):
        """The tables of worked examples by profile; each row a dict by the names of its header."""
        examples, profile = {}, None
        for line in self.section("Worked examples"):
            title = re.fullmatch("`([a-z0-9]+)`:", line)
            if title:
                profile = title[1]
                examples[profile], header = [], None
            elif profile and line.startswith("|"):
                cells = line.strip().strip("|").split("|")
                if header is None:
                    header = [plain(cell) for cell in cells]
                elif not re.fullmatch(r"[|:\- ]+", line):
                    examples[profile].append(dict(zip(header, map(integer, cells), strict=True)))
        return examples


def check(parts, path):
    """The command line of a program that checks a document in parts. Exit status: 0, 1 or, when unreadable, 2."""
    parser = argparse.ArgumentParser(description=f"The tables and figures of {path.relative_to(DOCS.parent)}, recomputed.")
    parser.add_argument("--document", type=Path, default=path, help="another copy of it")
    parser.add_argument("--part", nargs="+", choices=parts, help="only these")
    arguments = parser.parse_args()
    try:
        return 0 if run_parts(parts, arguments.part, Document(arguments.document)) else 1
    except Unreadable as error:
        print(f"{Path(sys.argv[0]).stem}: {error}", file=sys.stderr)
        return 2
