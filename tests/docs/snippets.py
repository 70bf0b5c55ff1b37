#!/usr/bin/env python3
"""Every snippet in README and docs/ is run, compiled, or held against the command's own help.

    snippets.py --build FOLDER        where glint and glint-cosim are

A fenced block names its language: `sh` are commands, `cpp` is compiled, all others hold no command. Commands under the
mark `<!-- run -->` are run, from the root of a copy of the tree without its history; a block under `<!-- prints -->`
must be what the commands above it print. Of all other commands the program or script must be there, know the
subcommand, and name every option in its help. A block under `<!-- run by FILE -->` is left to that test, which names the
document.
"""

import argparse
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"(?:<!-- (run|prints|run by [\w./]+) -->\n)?^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
PROGRAMS = ("glint", "glint-cosim")
COMMAND = re.compile(r"^\s*(?:[A-Z_]+=\S+ )*((?:\./|\w+/)[\w./-]+|glint|glint-cosim|cmake|ctest|iverilog|verilator|python3|sed|time)(?= |$)")


class Failed(Exception):
    pass


def pages():
    names = subprocess.run(["git", "ls-files", "-z", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return [ROOT / name for name in names.split("\0") if name and name != "CHANGELOG.md"]


class Checker:
    def __init__(self, build):
        self.build = Path(build).resolve()
        self.helps = {}
        self.counts = {"run": 0, "compiled": 0, "read": 0}

    def help(self, *words):
        if words not in self.helps:
            if not Path(words[0]).is_file():
                raise Failed(f"there is no {words[0]}")
            result = subprocess.run([*words, "--help"], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
            self.helps[words] = result.stdout if result.returncode == 0 else None
        return self.helps[words]

    def command(self, line, made):
        """A command that takes too long to run here: does it exist, or is it `made` before, and does it know its options?"""
        try:
            words = shlex.split(line, comments=True)
        except ValueError as error:
            raise Failed(f"'{line}': {error}") from error
        while words and re.match(r"[A-Z_]+=|time$", words[0]):
            words.pop(0)
        if not words:
            return
        program, name = words[0], Path(words[0]).name
        if program in made:
            return
        if name in PROGRAMS:
            asked = [str(self.build / name)]
            if name == "glint" and len(words) > 1 and not words[1].startswith("-"):
                asked.append(words[1])
        elif program.startswith("build/"):  # a program without --help has tests of its own
            if not (self.build / "/".join(program.split("/")[2:])).is_file():
                raise Failed(f"'{line}': the build has no {program}")
            return
        elif "/" in program:
            if not (ROOT / program).is_file():
                raise Failed(f"'{line}': there is no {program}")
            asked = [str(ROOT / program)]
        else:
            if shutil.which(program) is None:
                raise Failed(f"'{line}': no program {program}")
            return
        text = self.help(*asked)
        if text is None:
            raise Failed(f"'{line}': {' '.join(asked)} --help fails")
        for word in words:
            option = word.split("=")[0]
            if re.match(r"--[a-z]", option) and not re.search(re.escape(option) + r"(?![\w-])", text):
                raise Failed(f"'{line}': {' '.join(words[:2])} has no {option}")
        self.counts["read"] += 1

    def run(self, text):
        with tempfile.TemporaryDirectory() as folder:
            tree = Path(folder) / "glint"
            names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
            for name in filter(None, names.split("\0")):
                (tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, tree / name)
            (tree / "build").mkdir()
            (tree / "build/clang").symlink_to(self.build)
            result = subprocess.run(["bash", "-euc", text], cwd=tree, capture_output=True, text=True, check=False, timeout=300,
                                    env={"PATH": f"{self.build}:/usr/local/bin:/usr/bin:/bin", "HOME": folder})
        if result.returncode != 0:
            raise Failed(f"exit status {result.returncode} of\n{text}{result.stdout}{result.stderr}")
        self.counts["run"] += 1
        return result.stdout

    def compile(self, text):
        includes = [line for line in text.splitlines() if line.startswith("#include")]
        rest = [line for line in text.splitlines() if not line.startswith("#include")]
        declares = "int main(" in text or 'extern "C"' in text
        body = "#include <cstdint>\n" + (text if declares else "\n".join([*includes, "int main() {", *rest, "}"]))
        result = subprocess.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-Wno-unused", "-Werror", "-fsyntax-only", "-I", str(ROOT / "model/include"),
                                 "-x", "c++", "-"], input=body, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise Failed(f"does not compile:\n{body}\n{result.stderr}")
        self.counts["compiled"] += 1

    def page(self, path):
        printed = None
        for mark, language, text in BLOCK.findall(path.read_text()):
            if mark.startswith("run by "):
                test = ROOT / mark[len("run by "):]
                if not test.is_file() or path.name not in test.read_text(encoding="utf-8"):
                    raise Failed(f"'{mark}': that file is not there or does not name {path.name}")
            elif mark == "prints":
                if printed != text:
                    raise Failed(f"prints\n{printed}\nand not\n{text}")
            elif language == "sh":
                if mark == "run":
                    printed = self.run(text)
                else:
                    made = re.findall(r" -o (\S+)", text)
                    for line in text.replace("\\\n", " ").splitlines():
                        self.command(line, made)
            elif language == "cpp":
                self.compile(text)
            else:
                for line in text.splitlines():
                    if COMMAND.match(line):
                        raise Failed(f"a block of '{language}' holds the command '{line}'")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True)
    checker = Checker(parser.parse_args().build)
    failures = 0
    for path in pages():
        try:
            checker.page(path)
        except Failed as failed:
            print(f"FAILED: {path.relative_to(ROOT)}: {failed}")
            failures += 1
    counts = checker.counts
    print(f"snippets: {counts['run']} blocks run, {counts['compiled']} compiled, {counts['read']} commands held against their help")
    return 1 if failures or 0 in counts.values() else 0


if __name__ == "__main__":
    sys.exit(main())
