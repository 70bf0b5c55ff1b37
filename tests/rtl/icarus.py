"""Verilog benches in Icarus Verilog, an event-driven simulator of four states that shares nothing with Verilator."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from units import RTL, sources


class Failed(Exception):
    """A run that is no success; the text says why."""


def main(check):
    """Ends the program: 0, or what `check` returns when it is called with the arguments; 1 and a line when it fails."""
    try:
        sys.exit(check(*sys.argv[1:]))
    except (Failed, subprocess.CalledProcessError) as failed:
        sys.exit(f"{Path(sys.argv[0]).name}: FAILED: {failed}")


def command(*words):
    """Runs a program and returns what it printed."""
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        raise Failed(f"{' '.join(map(str, words))}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def build(executable, top, files, parameters=None, macros=None, strict=True):
    """Compiles; a warning is a failure, unless `strict` is off: for Verilog that is not ours, of any year."""
    command = ["iverilog", *(["-g2005", "-Wall"] if strict else ["-g2012"]), "-s", top, "-o", str(executable)]
    if strict:
        command += [f"-I{Path(__file__).parent}"]
    else:
        command += sorted({f"-I{Path(file).parent}" for file in files})
    command += [f"-P{top}.{name}={value}" for name, value in (parameters or {}).items()]
    command += [f"-D{name}={value}" for name, value in (macros or {}).items()]
    done = subprocess.run(command + [str(file) for file in files], capture_output=True, text=True)
    if done.returncode != 0 or strict and (done.stdout or done.stderr):
        raise Failed(f"{' '.join(command)}: exit status {done.returncode}\n{done.stdout}{done.stderr}")


def run(executable, *arguments):
    """Simulates and returns what the bench printed. A bench in Verilog-2005 cannot set the exit status."""
    try:
        done = subprocess.run(["vvp", "-n", str(executable), *arguments], capture_output=True, text=True, timeout=300)
    except subprocess.TimeoutExpired:
        raise Failed("the simulation did not end in 300 seconds") from None
    if done.returncode != 0 or done.stderr or "WARNING" in done.stdout or "ERROR" in done.stdout:
        raise Failed(f"vvp: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def counts(output, things):
    """How many were compared, and the mismatches: the last line of a bench."""
    match = re.search(rf"(?:^|\n)(\d+) {things}, (\d+) mismatches\n\Z", output)
    if not match:
        raise Failed(f"no last line 'N {things}, M mismatches' in\n{output}")
    return int(match[1]), int(match[2])


def require(output, things, expected):
    """Fails unless as many as expected were compared, more than none, and all were right."""
    compared, mismatches = counts(output, things)
    if expected < 1 or compared != expected or mismatches != 0:
        raise Failed(f"{output}{expected} {things} and no mismatch were expected")


def planted(folder, file, pattern, replacement):
    """Copies rtl/ into a folder, with one line of one file by hand changed."""
    shutil.copytree(RTL, folder)
    copies = [copy for copy in sources(folder) if copy.name == file]
    if len(copies) != 1:
        raise Failed(f"there are {len(copies)} files {file}, not one")
    copies[0].write_text(altered(copies[0], pattern, replacement))
    return folder


def with_bug(folder, files, module, pattern, replacement):
    """The same files, but a changed copy of that of a module."""
    [at] = [index for index, file in enumerate(files) if file.stem == module]
    copy = Path(folder) / files[at].name
    copy.write_text(altered(files[at], pattern, replacement))
    return [*files[:at], copy, *files[at + 1:]]


def altered(file, pattern, replacement):
    """The text of a file with the one match of a pattern replaced."""
    text, found = re.subn(pattern, replacement, file.read_text())
    if found != 1:
        raise Failed(f"'{pattern}' matches {found} times in {file}, not once")
    return text
