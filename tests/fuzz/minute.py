#!/usr/bin/env python3
"""Fuzzes every target for a time, from its committed inputs. Exit status: 0; 1 for a finding; 77 without libFuzzer.

    minute.py [--seconds 60] [--build build/fuzz] [--jobs 1] [TARGET...]

Builds the preset `fuzz` first. What is found is in BUILD/findings/; once it is mended it becomes an input of tests/fuzz/corpus.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CORPUS = Path(__file__).resolve().parent / "corpus"


def has_libfuzzer():
    if not shutil.which("clang++"):
        return False
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "a.cpp"
        source.write_text('extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }\n')
        command = ["clang++", "-fsanitize=fuzzer", str(source), "-o", str(Path(folder) / "a")]
        return subprocess.run(command, capture_output=True).returncode == 0


def build(folder, jobs):
    options = ["-B", str(folder), "-S", str(ROOT), "--preset", "fuzz"]
    for command in (["cmake", *options], ["cmake", "--build", str(folder), "--target", "glint-fuzz", "-j", str(jobs)]):
        done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)} failed:\n{done.stdout[-2000:]}")


def fuzz(program, target, seconds):
    """The line of a target, and whether something was found."""
    findings = program.parent / "findings"
    findings.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:  # what it learns, which also is where it runs
        command = [program, target, f"-max_total_time={seconds}", "-max_len=20000", "-timeout=20", "-rss_limit_mb=4096",
                   "-print_final_stats=1", f"-artifact_prefix={findings}/{target}-", folder, CORPUS / target]
        done = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace",
                              env={**os.environ, "UBSAN_OPTIONS": "print_stacktrace=1"})
    executions = re.search(r"stat::number_of_executed_units: (\d+)", done.stderr)
    count = int(executions[1]) if executions else 0
    failed = done.returncode != 0 or count == 0
    if failed:
        (findings / f"{target}.log").write_text(done.stderr)
    wrong = re.findall(r"^(?:does not hold:|ERROR:|==\d+==\s*ERROR:|\S+: runtime error:).*$|.*runtime error:.*$|SUMMARY:.*$", done.stderr, re.MULTILINE)
    line = f"{target}: {count} inputs in {seconds} s, " + (f"FOUND: {wrong[0] if wrong else 'see'} ({findings}/{target}.log)" if failed else "nothing found")
    return line, failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=int, default=60, help="for each target")
    parser.add_argument("--build", type=Path, default=ROOT / "build/fuzz")
    parser.add_argument("--jobs", type=int, default=1, help="of the build")
    parser.add_argument("targets", nargs="*", help="none: all that have inputs")
    options = parser.parse_args()
    if not has_libfuzzer():
        print("fuzzing: OFF (clang++ with libFuzzer not found; install the packages `clang` and `libclang-rt-dev`)")
        sys.exit(77)
    build(options.build.resolve(), options.jobs)
    program = options.build.resolve() / "tests/fuzz/glint-fuzz"
    found = False
    for target in options.targets or sorted(folder.name for folder in CORPUS.iterdir()):
        line, failed = fuzz(program, target, options.seconds)
        print(line, flush=True)
        found |= failed
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
