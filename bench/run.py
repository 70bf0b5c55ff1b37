#!/usr/bin/env python3
"""What a lobe costs on this processor, by glint-bench, or a lighting model, by glint-bench-models: times by Google
Benchmark, instructions by Valgrind's callgrind.

Times are medians over repetitions in random order, of processor time; a latency is less that of the chain itself.
Instructions are counted twice, and the counts have to be the same. docs/cpu-cost.md says what each figure means.
Exit status: 0, 1 (a check failed), 2 (bad arguments, or a program that is missing or fails).
"""

import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

TOOL = "bench/run.py"
SUBJECTS = ("lobe", "model")  # a point has one of them
PASSES = 4


class UsageError(Exception):
    """What was asked cannot be done: one line, exit status 2."""


class CheckFailed(Exception):
    """One line, exit status 1."""


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["no message"])[-1]
        raise UsageError(f"{command[0]} fails with exit status {done.returncode}: {last}")
    return done.stdout


def count_instructions(bench, names, valgrind):
    """Instructions per result of each case: the difference between 2 PASSES and PASSES over the inputs."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        # A dump at every mark, so that one run counts all cases; a dump holds what came since the one before.
        marks = run(valgrind, "--tool=callgrind", f"--callgrind-out-file={out}", "--combine-dumps=no",
                    "--dump-before=*glint_bench_mark*", bench, "--passes", PASSES, *names).split()
        if marks != names:
            raise UsageError(f"{bench} ran {len(marks)} cases instead of {len(names)}")
        counts = {}
        for i, name in enumerate(names):
            once, twice = (total(out.with_name(f"out.{3 * i + part}")) for part in (2, 3))
            counts[name] = (twice - once) / PASSES
        return counts


def total(dump):
    found = re.search(r"^totals: (\d+)$", dump.read_text(), re.M) if dump.exists() else None
    if not found:
        raise UsageError("callgrind did not count where the program marks: no totals in its output")
    return int(found[1])


def measure_times(bench, names, repetitions, min_time):
    """Nanoseconds of processor time per pass over the inputs, one value a repetition, by the benchmark's name."""
    wanted = "|".join(re.escape(name) for name in names)
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "times.json"
        run(bench, f"--benchmark_filter=^(throughput|latency)/({wanted}|dependency/.*)$", f"--benchmark_min_time={min_time}",
            f"--benchmark_repetitions={repetitions}", "--benchmark_enable_random_interleaving=true",
            f"--benchmark_out={out}", "--benchmark_out_format=json")
        times = {}
        for entry in json.loads(out.read_text())["benchmarks"]:
            if entry["run_type"] == "iteration":
                assert entry["time_unit"] == "ns"
                times.setdefault(entry["run_name"].split("/repeats:")[0], []).append(entry["cpu_time"])
        return times


def median_and_quartiles(values, inputs, less=0.0):
    """Per result."""
    q1, median, q3 = statistics.quantiles(values, n=4, method="inclusive")
    return [(value / inputs) - less for value in (median, q1, q3)]


def rounded(value):
    return float(f"{value:.4g}")


def processor():
    """The name that the system tells, and what identifies a processor whose name is hidden."""
    fields = {}
    if os.path.exists("/proc/cpuinfo"):
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            key, _, value = line.partition(":")
            fields.setdefault(key.strip(), value.strip())
    name = fields.get("model name") or platform.processor() or platform.machine()
    if "cpu family" in fields:
        name += f" (family {fields['cpu family']}, model {fields['model']})"
    return name


def measure(options, bench, valgrind):
    described = json.loads(run(bench, "--describe"))
    cases = [case for case in described["cases"] if re.search(options.only, case["name"])]
    if not cases:
        raise UsageError(f"--only '{options.only}' is not legal: it has to match a case, such as "
                         f"{described['cases'][0]['name']}")
    names = [case["name"] for case in cases]
    inputs = described["inputs"]

    counts = {}
    if valgrind:
        counts = count_instructions(bench, names, valgrind)
        again = count_instructions(bench, names, valgrind)
        differing = [name for name in names if counts[name] != again[name]]
        if differing:
            name = differing[0]
            raise CheckFailed(f"instruction counts do not repeat: {name}: {counts[name]} and {again[name]}")
    times = {}
    if not options.counts_only:
        times = measure_times(bench, names, options.repetitions, options.min_time)
    dependency = {}
    for name in times:
        if name.startswith("latency/dependency/"):
            dependency[name.split("/")[2]] = median_and_quartiles(times[name], inputs)[0]

    points = []
    for case in cases:
        point = {key: case[key] for key in (*SUBJECTS, "type", "profile", "form", "formula") if key in case}
        throughput = times.get(f"throughput/{case['name']}")
        latency = times.get(f"latency/{case['name']}")
        point["throughput_ns"] = point["latency_ns"] = None
        if throughput:
            median, q1, q3 = map(rounded, median_and_quartiles(throughput, inputs))
            point.update(throughput_ns=median, throughput_q1_ns=q1, throughput_q3_ns=q3)
        if latency:
            median, q1, q3 = map(rounded, median_and_quartiles(latency, inputs, dependency[case["type"]]))
            if median <= 0:
                raise CheckFailed(f"{case['name']}: a chain of it takes no longer than the chain alone: {median} ns")
            point.update(latency_ns=median, latency_q1_ns=q1, latency_q3_ns=q3)
        point["instructions"] = round(counts[case["name"]] / inputs, 2) if counts else None
        points.append(point)
    machine = {"cpu": processor(), "compiler": described["compiler"], "flags": described["flags"],
               "library": " ".join(platform.libc_ver()),
               "valgrind": run(valgrind, "--version").strip() if valgrind else None,
               "date": datetime.date.today().isoformat()}
    return {"format": described["format"], "machine": machine, "command": " ".join([TOOL, *sys.argv[1:]]), "inputs": inputs,
            "repetitions": options.repetitions if times else 0,
            "dependency_ns": {key: rounded(value) for key, value in dependency.items()}, "points": points}


def to_text(result):
    """JSON with a point a line, so that a difference shows what changed."""
    head = json.dumps({key: value for key, value in result.items() if key != "points"}, indent=1, ensure_ascii=False)
    lines = ",\n".join("  " + json.dumps(point, ensure_ascii=False) for point in result["points"])
    return f'{head[:-2]},\n "points": [\n{lines}\n ]\n}}\n'


def write(path, text):
    """Whole or not at all."""
    temporary = path.with_name(path.name + ".part")
    try:
        temporary.write_text(text)
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise UsageError(f"--json '{path}' cannot be written: {error.strerror}") from None


def show(result):
    def shown(value, digits):
        return "-" if value is None else f"{value:.{digits}f}"

    print(f"{'':42}{'ns/result':>10}{'quartiles':>18}{'latency':>9}{'instructions':>14}")
    for point in result["points"]:
        name = "/".join(point[key] for key in (*SUBJECTS, "type", "profile", "form") if key in point)
        quartiles = "-".join(shown(point[key], 3) for key in ("throughput_q1_ns", "throughput_q3_ns") if key in point)
        print(f"{name:42}{shown(point['throughput_ns'], 3):>10}{quartiles:>18}{shown(point['latency_ns'], 2):>9}"
              f"{shown(point['instructions'], 2):>14}")


def parse(arguments):
    class Parser(argparse.ArgumentParser):
        def error(self, message):
            raise UsageError(message)

    def whole(low, high):
        def convert(text):
            if not re.fullmatch(r"\d+", text) or not low <= int(text) <= high:
                raise argparse.ArgumentTypeError(f"'{text}' is not legal: a whole number, {low} to {high}")
            return int(text)
        return convert

    def seconds(text):
        try:
            value = float(text)
        except ValueError:
            value = 0.0
        if not 0.001 <= value <= 10:
            raise argparse.ArgumentTypeError(f"'{text}' is not legal: seconds, 0.001 to 10")
        return value

    def expression(text):
        try:
            re.compile(text)
        except re.error as error:
            raise argparse.ArgumentTypeError(f"'{text}' is not legal: a regular expression ({error})") from None
        return text

    parser = Parser(prog=TOOL, description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                    epilog="Example: bench/run.py --bench build/release/glint-bench --json cost/data/cpu.json",
                    allow_abbrev=False)
    parser.add_argument("--bench", required=True, metavar="FILE", help="the program glint-bench or glint-bench-models")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write the results here")
    parser.add_argument("--only", type=expression, default="", metavar="REGEX", help="the cases whose names match it")
    parser.add_argument("--repetitions", type=whole(3, 1000), default=15, metavar="N", help="of each time (default: 15)")
    parser.add_argument("--min-time", type=seconds, default=0.01, metavar="S", help="of one repetition (default: 0.01)")
    parser.add_argument("--counts-only", action="store_true", help="no times, only instructions")
    parser.add_argument("--valgrind", default="valgrind", metavar="FILE", help="the program (default: valgrind)")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    bench = shutil.which(options.bench if os.sep in options.bench else f"./{options.bench}")
    if not bench:
        raise UsageError(f"--bench '{options.bench}' is not legal: a program glint-bench, such as build/release/glint-bench")
    if options.json and not options.json.parent.is_dir():
        raise UsageError(f"--json '{options.json}' is not legal: its folder does not exist")
    valgrind = shutil.which(options.valgrind)
    if not valgrind:
        reason = f"'{options.valgrind}' not found; install the package `valgrind`"
        if options.counts_only:
            raise UsageError(f"--counts-only: {reason}")
        print(f"instruction counts: OFF ({reason})", file=sys.stderr)
    result = measure(options, bench, valgrind)
    show(result)
    if options.json:
        write(options.json, to_text(result))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except UsageError as error:
        print(f"{TOOL}: {error}", file=sys.stderr)
        sys.exit(2)
    except CheckFailed as error:
        print(f"{TOOL}: {error}", file=sys.stderr)
        sys.exit(1)
