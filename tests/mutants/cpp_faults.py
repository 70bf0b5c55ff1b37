#!/usr/bin/env python3
"""Planted faults in the C++: which test finds which.

    cpp_faults.py --tree /tmp/faulty              what the record does not hold yet, or holds of other files; may be stopped
    cpp_faults.py --tree /tmp/faulty --longest 1  the same with tests of up to a second; a later run tries the rest longer
    cpp_faults.py --tree /tmp/faulty --changed    files that changed: are as many faults found as before?
    cpp_faults.py --check                         counts the record; fails for a survivor or a file that has changed

libclang (python3-clang-14) finds the operators, constants, conditions and statements of FILES. Some of each file are chosen and all
planted in one copy of the sources, each behind a comparison with the variable GLINT_PLANTED (planted.hpp). A run without
a fault tells which tests pass which place; then each fault meets those tests, the shortest first, until one fails.
cpp_faults.jsonl, the record, has a line for each. A fault is known by its line's text; when its file changes, it meets the
test again that found it. Exit status: 0 all found or equivalent, 1 not, 2 bad arguments.
"""

import argparse
import hashlib
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

from cpp_places import HERE, ROOT, Failed, candidates, digest, key, planted, run

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
# What has no faults is compiled as everywhere, so that ccache may know it; the rest quickly, without warnings.
LAUNCHER = """for source; do :; done
if grep -qs planted.hpp "$source" $(sed -n 's/^#include "\\(.*\\)"$/\\1/p' "$source"); then set -- "$@" -w -O1; fi
exec {} "$@"
"""
TARGETS = ("glint-cli glint-unit-tests glint-word-tests glint-render-tests glint-cost-tests hls-kernel-g++ hls-divide-adding hls-divide-radix4 "
           "hls-divide-reciprocal hls-divide-restoring").split()
LABELS = {"unit", "oracle", "cli", "cost", "render", "hls"}


def files():
    """Each file with its kind and how many faults it gets."""
    out = {}
    for kind, (patterns, lines) in FILES.items():
        for pattern in patterns.split():
            for path in sorted(ROOT.glob(pattern)):
                out[str(path.relative_to(ROOT))] = (kind, max(4, path.read_text().count("\n") // lines))
    return out


# ---- the copy of the sources -------------------------------------------------------------------------------------------

def put(path, text):
    """Writes what has changed alone, for a build looks at the time."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != text:
        path.write_bytes(text)


def sources(tree, shares):
    """The copy without faults, configured; how each file is compiled."""
    (tree / "build").mkdir(parents=True, exist_ok=True)
    for name in run("git", "ls-files", cwd=ROOT).stdout.splitlines():
        if name not in shares or not (tree / name).exists():
            text = (ROOT / name).read_bytes()
            for file, old, new in CHANGES:
                text = text.replace(old, new) if name == file else text
            put(tree / name, text)
            shutil.copymode(ROOT / name, tree / name)
    put(tree / "compile.sh", LAUNCHER.format(os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", "")).encode())
    configured = run("cmake", "-G", "Ninja", "-S", tree, "-B", tree / "build", "-DGLINT_COSIM=OFF", "-DCMAKE_CXX_COMPILER=g++",
                     "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_COMPILER_LAUNCHER=sh;{tree / 'compile.sh'}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    if configured.returncode != 0:
        raise Failed(configured.stdout[-1000:] + configured.stderr[-1000:])
    return {str(Path(c["file"]).relative_to(tree)): c["command"]
            for c in json.loads((tree / "build/compile_commands.json").read_text()) if c["file"].startswith(str(tree))}


def choose(shares, commands, record):
    """Of each file the faults that the record holds, and others until it has its share; the rest."""
    held, chosen, rest = {key(line) for line in record}, {}, {}
    for name, (_, share) in shares.items():
        known = candidates(commands, name)
        chosen[name] = [fault for fault in known if key(fault) in held]
        others = [fault for fault in known if key(fault) not in held]
        more = max(0, share - len(chosen[name]))
        chosen[name] += others[:more]
        rest[name] = others[more:]
    return chosen, rest


def compiles(tree, jobs):
    """What the compiler says, and whether it is content."""
    done = run("cmake", "--build", tree / "build", "--target", *TARGETS, "--", "-k", "0", f"-j{jobs}")
    return done.returncode == 0, done.stdout


def build(tree, shares, record, jobs):
    """The faults by number, in a copy of the sources that is built. What does not compile is left out."""
    chosen, rest = choose(shares, sources(tree, shares), record)
    for _ in range(12):
        number = 0
        for name, faults in chosen.items():
            for fault in faults:
                number += 1
                fault["number"] = number
            put(tree / name, planted((ROOT / name).read_bytes(), faults))
        good, words = compiles(tree, jobs)
        if good:
            return {str(f["number"]): {"kind": shares[name][0], **f} for name, faults in chosen.items() for f in faults}
        wrong = set(re.findall(r"^(?:In file included from )?(?:\.\./)*" + rf"(?:{re.escape(str(tree))}/)?([\w/.]+):(\d+):", words, re.MULTILINE))
        dropped = 0
        for name, faults in chosen.items():
            bad = [f for f in faults if (name, str(f["line"])) in wrong]
            dropped += len(bad)
            chosen[name] = [f for f in faults if f not in bad] + rest[name][:len(bad)]
            rest[name] = rest[name][len(bad):]
        print(f"{dropped} faults do not compile, others instead", flush=True)
        if not dropped:
            raise Failed(words[-3000:])
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


def prepare(tree, shares, record, options):
    """The faults in the tree by number, its tests, and for each test its seconds and the faults that it meets."""
    state = tree / "planted.json"
    held = json.loads(state.read_text()) if state.exists() else {"digests": None, "faults": {}, "met": {}}
    now = {name: digest(ROOT / name) for name in shares}
    if held["digests"] == now and not options.plant:
        sources(tree, shares)
        good, words = compiles(tree, options.jobs)
        if not good:
            raise Failed(words[-3000:])
    else:
        faults = build(tree, shares, record, options.jobs)
        held = {"digests": now, "faults": faults, "met": held["met"] if faults == held["faults"] else {}}
    print(f"{len(held['faults'])} faults planted", flush=True)
    known = shortened(tests(tree))
    again = re.compile(options.again)
    held["met"] = {name: met for name, met in held["met"].items() if name in known and not (options.again and again.search(name))}
    held["met"] |= survey({name: test for name, test in known.items() if name not in held["met"]}, options.longest)
    state.write_text(json.dumps(held))
    return held["faults"], known, {name: (seconds, set(some)) for name, (seconds, some) in held["met"].items()}


def plant(tree, shares, file, options):
    """Tries what the record does not hold, and writes it there."""
    faults, known, met = prepare(tree, shares, read(file), options)
    before = {key(line): line for line in read(file)}
    passed = tree / "passed.jsonl"  # which fault has passed which test, for the next run
    done = set(map(tuple, map(json.loads, passed.read_text().splitlines()))) if passed.exists() else set()
    if options.again:
        done = {(*fault, name) for *fault, name in done if not re.search(options.again, name)}
        passed.write_text("".join(json.dumps(one) + "\n" for one in sorted(done)))
    tries = {}  # by file and test: what found a fault of a file may find the next
    with file.open("a") as out, passed.open("a") as kept:
        for number, fault in faults.items():
            line = {name: fault[name] for name in ("kind", "file", "line", "text", "nth", "column", "mutation")}
            line["sha256"] = digest(ROOT / fault["file"])
            last = before.get(key(line), {"killed_by": "", "sha256": ""})
            subject = Path(fault["file"]).stem.removeprefix("glint_").removeprefix("effect_")

            def dear(name):
                """Seconds until it has found a fault."""
                found, tried = tries.get((fault["file"], name), (0, 0))
                return name != last["killed_by"], met[name][0] * (tried + 1) / (found + (0.5 if subject in name else 0.1))

            if last["sha256"] == line["sha256"] and not is_open(last):
                continue
            meets = sorted((name for name, (_, some) in met.items() if int(number) in some), key=dear)[:options.most]
            line |= {"killed_by": "", "tried": len(meets), "longest": options.longest}
            line |= {"equivalent": last["equivalent"]} if "equivalent" in last else {}
            for name in meets:
                one = (*map(str, key(line)), line["sha256"], name)
                if one in done:
                    continue
                found = not passes(known[name], number, 2 + 5 * met[name][0])
                hits, tried = tries.get((fault["file"], name), (0, 0))
                tries[fault["file"], name] = (hits + found, tried + 1)
                if found:
                    line["killed_by"] = name
                    line.pop("equivalent", None)
                    break
                kept.write(json.dumps(one) + "\n")
                kept.flush()
            out.write(json.dumps(line) + "\n")
            out.flush()
    now = {key(fault) for fault in faults.values()}
    lines = [line for line in read(file) if key(line) in now or line["file"] not in shares and line["file"] in files()]
    names = list(files())
    write(file, sorted(lines, key=lambda line: (names.index(line["file"]), line["line"], line["column"], line["mutation"])))


# ---- the record --------------------------------------------------------------------------------------------------------

def read(file):
    """The lines of a record; of two about one fault the later."""
    lines = map(json.loads, file.read_text().splitlines()) if file.exists() else []
    return list({key(line): line for line in lines}.values())


def write(file, lines):
    file.write_text("".join(json.dumps(line) + "\n" for line in lines))


def is_open(line):
    return not line["killed_by"] and not line.get("equivalent")


def stale(record):
    """The files that are not as they were when their faults were tried."""
    names = {line["file"] for line in record if not (ROOT / line["file"]).exists() or digest(ROOT / line["file"]) != line["sha256"]}
    return sorted(names | set(files()) - {line["file"] for line in record})


def try_changed(file, options):
    """Are as many faults of the files that changed found as before?"""
    record = read(RECORD)
    write(file, record)
    shares = {name: share for name, share in files().items() if name in stale(record)}
    worse = []
    if shares:
        plant(options.tree, shares, file, options)
        before, after = (Counter(line["file"] for line in lines if is_open(line)) for lines in (record, read(file)))
        worse = [name for name in shares if after[name] > before[name]]
    print(f"{len(shares)} files have changed; more faults than before are open in: {', '.join(worse) or 'none'}")
    return 1 if worse else 0


def check(record):
    counts = Counter("open" if is_open(l) else "found" if l["killed_by"] else "equivalent" for l in record)
    for line in filter(is_open, record):
        print(f"open: {line['file']}:{line['line']} {line['mutation']}")
    changed = stale(record)
    for name in changed:
        print(f"not tried as it stands: {name}")
    print(f"{len(record)} faults: {counts['found']} found, {counts['equivalent']} equivalent, {counts['open']} open")
    return 1 if counts["open"] or changed or not record else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tree", type=Path, metavar="DIR", help="where the copy of the sources is kept")
    parser.add_argument("--record", type=Path, default=RECORD, metavar="FILE")
    parser.add_argument("--longest", type=float, default=20, metavar="SECONDS", help="tests that take more processor time are left out")
    parser.add_argument("--most", type=int, default=1000, metavar="TESTS", help="ends after so many tests of a fault; a later run tries more")
    parser.add_argument("--changed", action="store_true",
                        help="files that have changed; fails where more of a file's faults are open than in the record")
    parser.add_argument("--plant", action="store_true", help="plants again in files that have not changed")
    parser.add_argument("--again", default="", metavar="REGEX", help="tests that have changed since they were tried in this tree")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="for the build")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        return check(read(options.record))
    if not options.tree:
        print("cpp_faults.py: --tree is missing: a folder for the copy of the sources", file=sys.stderr)
        return 2
    options.tree = options.tree.resolve()
    try:
        if options.changed:
            return try_changed(options.record, options)
        plant(options.tree, files(), options.record, options)
    except Failed as failed:
        print(f"cpp_faults.py: FAILED: {failed}", file=sys.stderr)
        return 1
    return check(read(options.record))


if __name__ == "__main__":
    sys.exit(main())
