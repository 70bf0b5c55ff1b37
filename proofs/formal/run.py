#!/usr/bin/env python3
"""Proves the stream handshake, the divider and the square root of the Verilog in rtl/, with Yosys and z3.

A task copies the modules that it needs, adds the property file of each before its `endmodule`, and hands the result to
yosys-smtbmc. `induction` holds for any length of run, `cover` shows that what the properties speak of does happen, and
a planted bug is an edit of the copy that the property named for it has to find. What is proven at which parameters:
README.md. Exit status: 0, 1 (a check failed), 2 (bad arguments, or a program is missing).
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import axis
import lanes
import own
from tasks import EFFECT_NUMBERS, KINDS, MODULES, NUMBERS, UNITS, WRAPPER_PARAMETERS, in_stream, tasks, word_lengths

HERE = pathlib.Path(__file__).resolve().parent
MOST_SECONDS = 120  # of processor time, for one way of asking the solver
GLINT = None  # the command, for wrappers that are not committed
PROGRAMS = {"yosys": "yosys", "yosys-smtbmc": "yosys", "z3": "z3"}  # and the package of each


class UsageError(Exception):
    """What was asked cannot be done: one line, exit status 2."""


def needed(*tops):
    """The modules and all that they instantiate, directly or not."""
    return {path.stem: path.read_text() for top in tops for path in MODULES[top]}


def around_lobe(module):
    """The generated wrapper of phong or blinn_phong, around the unit in the place of its wrapper; that unit, and its numbers."""
    unit = UNITS[module]
    lobe, profile = unit["lobe"], unit["profile"]
    numbers = word_lengths(lobe, profile)
    passed = "".join(f".{name}({value}), " for name, value in numbers.items())
    text = axis.edited(module, unit["files"][-1].read_text(), f"glint_{lobe}_{profile} #(", f"glint_{lobe} #({passed}")
    return text, f"glint_{lobe}", numbers


def declared_result(top, numbers):
    """RESULT_W and result: the outputs of an effect's unit but those of the handshake, side by side."""
    unit = next(unit for unit in UNITS.values() if unit["name"] == top or unit["core"]["module"] == top
                and all(unit["core"]["parameters"].get(name, str(value)) == str(value) for name, value in numbers.items()))
    ports = [port for port in unit["ports"] if port["direction"] == "output"
             and port["name"] not in ("valid_o", "ready_o", "tag_o", "clamped_o")]
    return (f"localparam RESULT_W = {sum(port['width'] for port in ports)};\n"
            f"wire [RESULT_W-1:0] result = {{{', '.join(port['name'] for port in ports)}}};\n")


def latency(unit, parameters, folder, frame="ports"):
    """The clocks from an input of the unit to its result: as many as its glint_ports or glint_stream has valid bits."""
    chosen = " ".join(f"-chparam {name} {value}" for name, value in parameters.items())
    (folder / "latency.ys").write_text(
        f"read_verilog -formal -defer -D SYNTHESIS {' '.join(map(str, MODULES[unit]))}\n"
        f"hierarchy -check -top {unit} {chosen}\nproc\nflatten\nwrite_rtlil latency.il\n")
    run(["yosys", "-q", "-l", "latency.log", "latency.ys"], folder, "Yosys")
    return int(re.search(rf"^  wire width (\d+) \\{frame}\.valid_q$", (folder / "latency.il").read_text(), re.M).group(1))


def write_lanes(task, folder):
    """The model of the proof of lanes."""
    unit = UNITS[task.top.replace("_lanes_", "_axis_")]
    modules = {path.stem: path.read_text() for path in unit["files"]}
    modules[task.top] = axis.emitted(GLINT, unit, folder, task.top, "--lanes", str(lanes.LANES))
    if task.edit:
        module, text, instead = task.edit
        modules[module] = axis.edited(module, modules[module], text, instead)
    lanes.write_model(task, folder, modules, unit, run)


def write_own(task, folder):
    """The model of the proof that a result belongs to its own input."""
    unit = UNITS[task.top]
    modules = {path.stem: path.read_text() for path in unit["files"]}
    if task.edit:
        module, text, instead = task.edit
        modules[module] = axis.edited(module, modules[module], text, instead)
    own.write_model(task, folder, unit, modules, run)


def write_model(task, folder):
    """The model of every other proof."""
    parameters = dict(task.parameters)
    added = ""
    if task.kind == "axis":
        wrapper, core = UNITS[task.top], UNITS[UNITS[task.top]["core"]["module"]]
        of_effect, unit = wrapper["kind"] == "effect_axis", core["core"]["module"]
        text = axis.emitted(GLINT, wrapper, folder, task.top, "--sidebands", axis.SIDEBANDS) if task.sidebands else wrapper["files"][-1].read_text()
        if of_effect:
            modules = {**needed("glint_skid", "glint_stream"), core["name"]: axis.stand_in(core), task.top: text}
        else:
            numbers = {name: value for name, value in parameters.items() if name not in WRAPPER_PARAMETERS}
            modules = {**needed("glint_axis", unit), task.top: axis.at_any_size(UNITS, wrapper, text, numbers)}
        added = axis.beside(task.sidebands) + (axis.words_of_effect(core) if of_effect else axis.words_of_lobe())
    elif task.kind == "highlight":
        text, unit, numbers = around_lobe(task.top)
        modules = {**needed("glint_effect_highlight", unit), task.top: text}
    else:
        modules = needed(task.top)
    if task.kind == "pixel":  # the dot products: any number
        text = modules["glint_frame"]
        head = text[:text.index(");\n", text.index("module glint_frame")) + 3]
        modules["glint_frame"] = head + "(* anyseq *) wire [8*F+15:0] any;\nassign {" + ", ".join(
            re.findall(r"output wire +\[F\+1:0\] (\w+)", head)) + "} = any;\nendmodule\n"
    if task.edit:
        module, text, instead = task.edit
        modules[module] = axis.edited(module, modules[module], text, instead)
    if task.kind in ("unit", "effect", "highlight"):
        if task.kind != "highlight":
            unit, numbers = task.top, {name: value for name, value in parameters.items() if name != "TAG_W"}
        frame = "stream" if task.kind == "effect" else "ports"
        added += f"localparam CLOCKS = {latency(unit, numbers, folder, frame)};\n"
        if task.kind != "unit":
            added += declared_result(task.top, {} if task.kind == "highlight" else numbers)
    modules[task.top] = modules[task.top].replace("endmodule", f"{added}endmodule")
    for name, text in modules.items():
        properties = HERE / f"{task.kind if name == task.top and task.kind in KINDS else name}.vh"
        end = text.rindex("endmodule")
        text = text[:end] + (properties.read_text() if properties.exists() else "") + text[end:]
        (folder / f"{name}.v").write_text(text)
    if task.kind == "axis":
        if not of_effect:
            parameters["CORE_CLOCKS"] = latency(unit, numbers, folder, "stream" if in_stream(unit) else "ports")
        copy = folder / f"{task.top}.v"
        copy.write_text(axis.frame(copy.read_text(), of_effect or in_stream(unit), of_effect))
    for name in ("glint_scoreboard.v", "pipeline.vh", "glint_ports.vh"):
        shutil.copy(HERE / name, folder)
    defines = " ".join(f"-D {name}" for name in ("SYNTHESIS", f"PROVE_{task.kind.upper()}") + task.defines)
    chosen = " ".join(f"-chparam {name} {value}" for name, value in parameters.items())
    script = f"read_verilog -formal -defer {defines} *.v\nhierarchy -check -top {task.top} {chosen}\n"
    if task.kind == "shade":
        script += "cutpoint t:$mul\n"
    if task.kind in KINDS and not (task.kind == "axis" and of_effect):
        # Any product, quotient, logarithm, ... will do, and whatever waits for it beside: the handshake must not depend on
        # them.
        names = EFFECT_NUMBERS if task.kind == "effect" else NUMBERS
        script += (f"select -set numbers {' '.join(f't:*glint_{name}*' for name in names)} t:$mul t:$shr\n"
                   "select -set frame *glint_ports*/* *glint_stream*/*\ncutpoint @numbers @frame %d\n")
    # What nothing drives, such as the entries of tables beside a unit, may be anything: before `opt` chooses a value.
    script += "proc\nflatten\nsetundef -undriven -anyseq\nopt -full\ndffunmap\nopt_clean\n"
    script += "delete t:$assert\n" if task.method == "cover" else "delete t:$cover\n"
    script += "check -assert\nwrite_rtlil model.il\nwrite_smt2 -wires model.smt2\n"
    (folder / "model.ys").write_text(script)
    run(["yosys", "-q", "-l", "yosys.log", "model.ys"], folder, "Yosys")


def prepare(task, folder):
    """Writes the copies of the modules and runs Yosys; the result is model.smt2."""
    {"lanes": write_lanes, "own": write_own}.get(task.kind, write_model)(task, folder)
    if task.only:
        sets = {}
        for name, pattern in (("kept", task.only), ("given", task.given)):
            sets[name] = [n for n in cells(folder, "assert") if pattern and re.fullmatch(pattern, n)]
            if pattern and not sets[name]:
                raise RuntimeError(f"no property `{pattern}` in the model")
        script = "read_rtlil model.il\n"
        script += "".join(f"chtype -set $assume c:{n}\n" for n in sets["given"] if n not in sets["kept"])
        script += f"select -set kept {' '.join(f'c:{n}' for n in sets['kept'])}\ndelete t:$assert @kept %d\n"
        (folder / "only.ys").write_text(script + "opt_clean\nwrite_rtlil model.il\nwrite_smt2 -wires model.smt2\n")
        run(["yosys", "-q", "-l", "only.log", "only.ys"], folder, "Yosys")


def run(command, folder, what):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{what} ended with status {done.returncode}: {' '.join(done.stdout.split())[-300:]}")


def cells(folder, kind):
    """The names of the properties of a kind (assert, cover) in the model."""
    return re.findall(rf"^  cell \${kind} \\(\S+)$", (folder / "model.il").read_text(), re.M)


solvers = set()  # the process groups of yosys-smtbmc and its z3, which would outlive this program


def stop(number, _):
    for group in solvers:
        os.killpg(group, signal.SIGKILL)
    os._exit(128 + number)


def ask(command, folder, limit):
    """What the solver printed, or None when it had no answer after so many seconds of processor time."""
    process = subprocess.Popen(["sh", "-c", 'ulimit -t "$0" && exec "$@"', str(limit), *command], cwd=folder,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
    solvers.add(process.pid)
    try:
        output = process.communicate()[0]
    finally:
        solvers.discard(process.pid)
    return None if "Unexpected EOF response from solver" in output or process.returncode == -signal.SIGKILL else output


def solve(task, folder, *arguments):
    """One run of yosys-smtbmc: whether it ended with PASSED, and what it printed."""
    # Which way of asking z3 answers fast differs by factors of a hundred, either way, and with any edit of the Verilog:
    # the one that did so far gets some time, each other a little, then each more.
    ways = [["--unroll", "--noincr"], ["--noincr"], ["--unroll"], []]
    fast = {"unit": ["--noincr"], "axis": ["--unroll"], "effect": ["--unroll"], "highlight": ["--unroll"]}
    if task.method == "induction" and task.kind in fast:
        ways.sort(key=lambda way: way != fast[task.kind])
    tries = [(ways[0], 60), *((way, 15) for way in ways[1:]), *((way, MOST_SECONDS) for way in ways)]
    for way, limit in tries:
        output = ask(["yosys-smtbmc", "--noprogress", *way, "-s", "z3", *arguments, "model.smt2"], folder, limit)
        if output is None:
            continue
        found = re.search(r"Status: (\w+)", output)
        if not found:
            raise RuntimeError(f"no status from yosys-smtbmc: {' '.join(output.split())[-300:]}")
        return found.group(1) == "PASSED", output
    raise RuntimeError(f"no answer from the solver, asked in {len(ways)} ways for {MOST_SECONDS} s each")


def failed_property(output):
    found = re.findall(r"(?:Assert failed in \S+: |Unreached cover statement at )(\S+?)\.?$", output, re.M)
    return ", ".join(dict.fromkeys(found)) or "no property named"


def lemmas(task, folder):
    """Asks z3 what a file says of integers: no query has an answer, but those that show that the assumptions can be met."""
    text = (HERE / f"{task.top}.smt2").read_text()
    if task.edit:
        old, new = task.edit
        if text.count(old) != 1:
            raise RuntimeError(f"{task.top}.smt2 has no single '{old}'")
        text = text.replace(old, new)
    (folder / "lemmas.smt2").write_text(text)
    output = ask(["z3", "lemmas.smt2"], folder, MOST_SECONDS) or ""
    answers = re.findall(r"^(.+)\n(sat|unsat|unknown)$", output, re.M)
    if not answers or len(answers) != text.count("(check-sat)"):
        raise RuntimeError(f"z3 answers {len(answers)} of {text.count('(check-sat)')} queries: {' '.join(output.split())[-300:]}")
    wrong = [name for name, answer in answers if answer != ("sat" if name.startswith("given") else "unsat")]
    if task.method == "bug":
        if not wrong or not all(re.match(task.only, name) for name in wrong):
            raise RuntimeError(f"the planted bug fails {', '.join(wrong) or 'nothing'}, not {task.only}")
        task.result = f"found, {len(wrong)} fail"
    elif wrong:
        raise RuntimeError(f"does not hold: {', '.join(wrong)}")
    else:
        task.result = f"proven, {sum(not name.startswith('given') for name, _ in answers)} lemmas"


def prove(task, folder):
    if task.kind == "lemmas":
        return lemmas(task, folder)
    prepare(task, folder)
    count = len(cells(folder, "cover" if task.method == "cover" else "assert"))
    if count == 0:
        raise RuntimeError("no property in the model")
    if task.method == "cover":
        passed, output = solve(task, folder, "-c", "-t", str(task.depth))
        reached = len(re.findall(r"Reached cover statement", output))
        if not passed or reached != count:
            raise RuntimeError(f"reached {reached} of {count} covers in {task.depth} clocks: {failed_property(output)}")
        steps = [int(n) for n in re.findall(r"Reached cover statement at \S+ in step (\d+)", output)]
        task.result = f"{count} reached, the last at clock {max(steps)}"
    elif task.method == "bug":
        passed, output = solve(task, folder, "-t", str(task.depth))
        if passed:
            raise RuntimeError(f"the planted bug is not found in {task.depth} clocks: {task.shows.split()[0]} holds")
        if not re.fullmatch(task.only, failed_property(output)):
            raise RuntimeError(f"the planted bug fails {failed_property(output)}, not {task.shows.split()[0]}")
        clock = re.findall(r"in step (\d+)", output)[-1]
        task.result = f"found at clock {clock}"
    else:
        passed, output = solve(task, folder, "-t", str(task.depth))  # the base case
        if not passed:
            raise RuntimeError(f"fails after reset: {failed_property(output)}")
        passed, output = solve(task, folder, "-i", "-t", str(task.depth))
        if not passed:
            raise RuntimeError(f"the induction does not close: {failed_property(output)}")
        k = task.depth - min(int(n) for n in re.findall(r"Trying induction in step (\d+)", output))
        task.result = f"proven, {count} properties, k = {max(k, 1)}"


def carry_out(task, build):
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="glint-formal-") as temporary:
        folder = pathlib.Path(temporary)
        if build:
            folder = build / task.name
            folder.mkdir(parents=True, exist_ok=True)
        try:
            prove(task, folder)
        except RuntimeError as error:
            task.failures.append(str(error))
    task.seconds = time.monotonic() - start
    parameters = " ".join(f"{name}={value}" for name, value in task.parameters.items())
    print(f"{'FAILED' if task.failures else 'ok':6}  {task.name:34}  {task.shows}  [{parameters}]  {task.method}: "
          f"{task.result or '; '.join(task.failures)}  {task.seconds:.1f} s", flush=True)
    return task


def to_json(task):
    return {"name": task.name, "shows": task.shows, "module": task.top, "parameters": task.parameters,
            "method": task.method, "ok": not task.failures, "result": task.result, "failures": task.failures,
            "seconds": round(task.seconds, 2)}


def write(path, text):
    temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    try:
        temporary.write_text(text)
        temporary.replace(path)
    except OSError as error:
        raise UsageError(f"--json {path} cannot be written: {error.strerror}") from error


def chosen(all_tasks, only):
    """A name stands for the task of that name, or for all that begin with it and a dot."""
    out = []
    for name in only:
        found = [task for task in all_tasks if task.name == name or task.name.startswith(f"{name}.")]
        if not found:
            legal = ", ".join(dict.fromkeys(task.name.split(".")[0] for task in all_tasks))
            raise UsageError(f"--only {name} is no task; legal is a name of --list, or a group: {legal}")
        out += [task for task in found if task not in out]
    return out if only else all_tasks


def main():
    parser = argparse.ArgumentParser(description="Handshake of the stream units, divider and square root, by Yosys and z3.",
                                     epilog="Example: run.py --only bps --only bugs.bps --json formal.json")
    parser.add_argument("--only", action="append", default=[], metavar="NAME",
                        help="a task, or a group of tasks (skid, divider.stage, bugs.bps); may be given several times")
    parser.add_argument("--list", action="store_true", help="print the names of the tasks and stop")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="tasks at a time (default: 1)")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write the same facts as JSON")
    parser.add_argument("--build", type=pathlib.Path, metavar="DIR",
                        help="keep the copies, scripts and models there (default: a temporary folder)")
    parser.add_argument("--glint", type=pathlib.Path, metavar="FILE", help="the command, for the tasks of sidebands and lanes")
    options = parser.parse_args()
    global GLINT
    GLINT = options.glint
    if options.jobs < 1:
        raise UsageError(f"--jobs {options.jobs} is not legal: at least 1")
    for program, package in PROGRAMS.items():
        if not shutil.which(program):
            raise UsageError(f"program '{program}' not found; install the package `{package}`")
    wanted = chosen(tasks(), options.only)
    if not GLINT and not options.list and any(task.emitted for task in wanted):
        if options.only:
            raise UsageError("the proof of sidebands and of lanes needs --glint FILE, the command that writes the wrapper")
        wanted = [task for task in wanted if not task.emitted]
        print("left out: the proofs of sidebands and of lanes, which need --glint")
    if options.list:
        print("\n".join(task.name for task in wanted))
        return 0
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, stop)
    start = time.monotonic()
    build = options.build.resolve() if options.build else None
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        done = list(pool.map(lambda task: carry_out(task, build), wanted))
    failed = [task.name for task in done if task.failures]
    if options.json:
        write(options.json, json.dumps({"tool": "proofs/formal/run.py", "tasks": [to_json(task) for task in done]},
                                       indent=1) + "\n")
    print(f"{len(done) - len(failed)} of {len(done)} tasks passed in {time.monotonic() - start:.0f} s")
    if not done:
        print("FAILED: no task")
    for name in failed:
        print(f"FAILED: {name}")
    return 1 if failed or not done else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except UsageError as error:
        print(f"run.py: {error}", file=sys.stderr)
        sys.exit(2)
