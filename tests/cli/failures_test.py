"""What goes wrong around a program: a full disk, a folder that can't be written or goes away, a reader that leaves, an
interruption, another run in the same folder, a clock that went back. Nothing is corrupt, nothing temporary is left, one
line says what happened, and the exit status is that of docs/command-line.md. Run by cli_test.py."""

import ctypes
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from case import Case, OPTIONS, ROOT
from choose_test import write_prices

FEW = ("--profile", "p8", "--n", "1:40", "--cos", "0:90")
SHARD = ("sweep", "--profile", "p8", "--n", "1:3", "--cos", "0:9000", "--shard")
# What is run, with OUT for its output: a file, or where `files` are named a folder that gets these.
PROGRAMS = {
    "eval": (("eval", "--n", "5", "--cos", "0.5", "--json", "OUT"), ()),
    "sweep": (("sweep", *FEW, "--json", "OUT"), ()),
    "sweep, CSV": (("sweep", *FEW, "--csv", "OUT"), ()),
    "merge": (("merge", "1.json", "2.json", "--json", "OUT"), ()),
    "merge, CSV": (("merge", "1.json", "2.json", "--csv", "OUT"), ()),
    "vectors": (("vectors", "--profile", "p8", "--count", "500", "-o", "OUT"), ("glint_bps_p8.json", "glint_bps_p8.tv")),
    "emit": (("emit", "--profile", "p8", "--target", "proof", "-o", "OUT"), ("glint_bps_p8.g",)),
    "fit": (("fit", "--n", "50", "--theta", "0:1:0.1", "--json", "OUT"), ()),
    "cases": (("cases", "-o", "OUT"), ()),
    "cases, JSON": (("cases", "--json", "OUT"), ()),
    "choose": (("choose", "--json", "OUT"), ()),
    "cost": (("cost", "--json", "OUT"), ()),
    "cost, CSV": (("cost", "--csv", "OUT"), ()),
    "cost --accuracy": (("cost", "--accuracy", "--lobe", "bps", "--profile", "8,4,7,4", "--json", "OUT"), ()),
    "render": (("render", "a.obj", "--size", "64x36", "-o", "OUT.png"), ()),
    "render, JSON": (("render", "a.obj", "--size", "9x9", "-o", "a.png", "--json", "OUT"), ()),
    "cosim": (("cosim", "--count", "300", "--json", "OUT"), ()),
    "cosim, JUnit": (("cosim", "--count", "300", "--junit", "OUT"), ()),
}
OBJECT = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


class Creations:
    """Tells of files that are made in a folder (inotify), without a moment between."""

    def __init__(self, folder):
        self.libc = ctypes.CDLL(None, use_errno=True)
        self.file = self.libc.inotify_init1(os.O_CLOEXEC)
        self.libc.inotify_add_watch(self.file, os.fsencode(folder), 0x100)

    def wait(self):
        os.read(self.file, 4096)

    def close(self):
        os.close(self.file)


class Failures(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "a.obj").write_text(OBJECT)
        write_prices(self.folder)
        for i in (1, 2):
            self.good(*SHARD, f"{i}/2", "--json", f"{i}.json")
        self.before = self.files()

    def command(self, name, output):
        """The words of a program, and the tool."""
        words = [word.replace("OUT", output) for word in PROGRAMS[name][0]]
        if words[0] != "cosim":
            return {"tool": OPTIONS.glint}, words
        return {"tool": OPTIONS.cosim}, ["--profile", OPTIONS.cosim_profiles[0], *words[1:]]

    def programs(self):
        """Those that this build has. They write what they should where nothing goes wrong."""
        left_out = []
        for name, (words, files) in PROGRAMS.items():
            if words[0] == "cosim" and not OPTIONS.cosim:
                left_out.append(name)
                continue
            settings, words = self.command(name, "good-folder" if files else "good")
            done = self.run_tool(*words, **settings)
            if words[0] == "render" and "not in this build" in done.stderr:
                left_out.append(name)
                continue
            self.equal((done.returncode, done.stderr.replace("glint: warning: nothing is in the picture (0 fragments)\n", "")),
                       (0, ""), name)
            made = set(self.files()) - set(self.before)
            self.true(made, name)
            self.clear()
            yield name
        if left_out:
            print(f"left out, since this build has not got them: {', '.join(left_out)}")

    def clear(self):
        for name in set(self.files()) - set(self.before):
            (self.folder / name).unlink()

    def fails(self, name, output, pattern, **settings):
        """Exit status 2, one line, and no file more."""
        tool, words = self.command(name, output)
        done = self.run_tool(*words, **tool, **settings)
        lines = [line for line in done.stderr.splitlines() if "warning: nothing is in the picture" not in line]
        self.equal((done.returncode, len(lines)), (2, 1), f"{name}, {output}: {done.stderr}")
        self.matches(lines[0], rf"\Aglint(-cosim)?: {pattern}")
        if PROGRAMS[name][0][-1] == "OUT" and "a.png" in PROGRAMS[name][0]:
            (self.folder / "a.png").unlink(missing_ok=True)  # the picture is whole, and its JSON is not there
        self.equal(self.files(), self.before, name)

    def test_every_program(self):
        def no_space():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))

        nobody = {"user": 65534, "group": 65534, "extra_groups": []} if os.getuid() == 0 else {}
        readable = self.run_tool("--version", **nobody).returncode == 0 if self.can_run(nobody) else False
        (self.folder / "closed").mkdir(mode=0o555)
        if nobody:
            self.folder.chmod(0o755)
        for name in self.programs():
            files = PROGRAMS[name][1]
            there = r"(file|folder) '\S*' cannot be (written|made)"
            self.fails(name, "full-folder" if files else "full", there + ": File too large", preexec_fn=no_space)
            if files:
                (self.folder / "file").touch()
                self.before = self.files()
                self.fails(name, "file/below", there)
                (self.folder / "file").unlink()
                self.before = self.files()
            else:
                self.fails(name, "none/out", there)
                if name != "render" and os.path.exists("/dev/full"):
                    self.fails(name, "/dev/full", there + ": No space left on device")
            if readable:
                self.fails(name, "closed/out", there, **nobody)
        if not readable:
            print("a folder that can't be written: left out, since no other user can run this build")

    def can_run(self, settings):
        try:
            self.run_tool("--version", **settings)
            return True
        except (OSError, subprocess.SubprocessError):
            return False

    def test_folder_goes_away(self):
        """Between the start and the writing: the program waits for what it merges."""
        os.mkfifo(self.folder / "2.fifo")
        self.before = self.files()
        for output in ("gone/out.json", "gone/below/out.csv"):
            (self.folder / output).parent.mkdir(parents=True)
            run = subprocess.Popen([OPTIONS.glint, "merge", "1.json", "2.fifo", "--json" if "json" in output else "--csv", output],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            with open(self.folder / "2.fifo", "w") as fifo:  # opens when the program does
                shutil.rmtree(self.folder / "gone")
                fifo.write((self.folder / "2.json").read_text())
            out, err = run.communicate()
            self.equal((run.returncode, out), (2, ""))
            self.matches(err, rf"\Aglint: file '{output}' cannot be written[^\n]*\n\Z")
            self.equal(self.files(), self.before)

    def test_reader_leaves(self):
        """A closed pipe ends a program without a line, as it ends others; where that signal is ignored, there is one."""
        for words in (("cases",), ("eval", "--stdin"), ("sweep", *FEW, "--json", "out.json"), ("emit", "-o", "out"), ("--help",)):
            for ignored in (False, True):
                reader, writer = os.pipe()
                os.close(reader)
                settings = {"restore_signals": False} if ignored else {}
                done = self.run_tool(*words, stdout=writer, text="1 2\n" * 9 if "--stdin" in words else None, **settings)
                os.close(writer)
                self.equal(done.returncode, 2 if ignored else -signal.SIGPIPE, f"{words}: {done.stderr}")
                self.equal(done.stderr, "glint: standard output cannot be written\n" if ignored else "")
                for name in set(self.files()) - set(self.before):
                    self.true(not name.endswith(".tmp") and (self.folder / name).stat().st_size > 100, f"{name} is whole")
                self.clear()

    def test_interrupted_while_it_writes(self):
        """The file is there whole or not at all, and its temporary one is gone."""
        caught = 0
        for attempt in range(20):
            creations = Creations(self.folder)
            run = subprocess.Popen([OPTIONS.glint, "vectors", "--profile", "p8", "--count", "120000", "--format", "hex"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            creations.wait()
            run.send_signal((signal.SIGTERM, signal.SIGINT, signal.SIGHUP)[attempt % 3])
            err = run.communicate()[1]
            creations.close()
            left = sorted(set(self.files()) - set(self.before))
            if run.returncode < 0:
                self.equal(err, "")
            if not left:
                caught += 1
            for name in left:
                self.equal((self.folder / name).suffix in (".hex", ".json"), True, name)
                if name.endswith(".hex"):
                    self.equal((self.folder / name).stat().st_size, 120000 * 25)
            self.clear()
            if caught == 2:
                break
        self.true(caught >= 1, "no run was interrupted in mid-write")

    def test_interrupted_with_a_program(self):
        """What runs another program ends it, and removes their temporary folder."""
        (self.folder / "bin").mkdir()
        (self.folder / "tmp").mkdir()
        (self.folder / "bin/python3").write_text("#!/bin/sh\necho half > $(dirname $3)/half\nmkdir -p $(dirname $3)/a/b\n"
                                                 "touch $(dirname $3)/a/b/c\necho $$ > pid\nexec sleep 100\n")
        (self.folder / "bin/python3").chmod(0o755)
        environment = {**os.environ, "TMPDIR": str(self.folder / "tmp"), "PATH": f"{self.folder}/bin:{os.environ['PATH']}"}
        run = subprocess.Popen([OPTIONS.glint, "cost", "--plots", "page"], cwd=self.folder, env=environment,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + 120
        while not (self.folder / "pid").exists() or not self.read("pid").endswith("\n"):
            self.assertLess(time.monotonic(), end, "the script has not begun")
            time.sleep(0.01)
        self.equal(len(list((self.folder / "tmp").iterdir())), 1)
        run.send_signal(signal.SIGTERM)
        self.equal((*run.communicate(), run.returncode), ("", "", -signal.SIGTERM))
        self.equal(list((self.folder / "tmp").iterdir()), [])
        self.true(not (self.folder / "page").exists(), "no picture")
        with self.assertRaises(ProcessLookupError):
            os.kill(int(self.read("pid")), 0)

    def test_page(self):
        """The page's own files are written whole or not at all, too."""
        def no_space():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        program = "import stills\ntry: stills.write('page', {'a.csv': 'x', 'b/c': 'y' * 9999})\nexcept stills.Failure as f: print(f)"
        (self.folder / "page").mkdir()
        (self.folder / "page/a.csv").write_text("old")
        done = self.run_tool("-B", "-c", program, tool=sys.executable, preexec_fn=no_space, env={**os.environ, "PYTHONPATH": str(ROOT / "page")})
        self.equal(done.stdout, "page/a.csv\nfile 'page/b/c' cannot be written: File too large\n", done.stderr)
        self.equal(self.files(), sorted([*self.before, "page/a.csv"]))
        self.equal(self.read("page/a.csv"), "x")

    def test_runs_at_once(self):
        """In one folder: the last of those that write one file is there whole; those that add to one file all have."""
        profiles = [f"8,4,{k},4" for k in range(4, 10)]
        commands = [("sweep", *FEW, "--json", "out.json", "--csv", "out.csv")] * 4
        commands += [("cost", "--accuracy", "--lobe", "bps", "--profile", profile, "--threads", "1", "--json", "accuracy.json") for profile in profiles]
        runs = [subprocess.Popen([OPTIONS.glint, *words], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) for words in commands]
        for run in runs:
            self.equal((run.communicate()[1], run.returncode), (b"", 0))
        self.equal(sorted(set(self.files()) - set(self.before)), ["accuracy.json", "out.csv", "out.json"])
        self.equal([point["profile"] for point in json.loads(self.read("accuracy.json"))["points"]], profiles)
        self.equal(json.loads(self.read("out.json"))["runs"][0]["inputs"], 40 * 91)
        self.equal(len(self.read("out.csv").splitlines()), 42)

    def test_clock_went_back(self):
        """Files from the future are as good as others: nothing depends on times."""
        future = time.time() + 1e9
        again = (*SHARD, "1/2", "--json", "1.json", "--resume")
        for name in ("1.json", "2.json", "."):
            os.utime(self.folder / name, (future, future))
        self.matches(self.good(*again), r"\Ashard 1/2 is there: 1.json\n\Z")
        self.good("merge", "1.json", "2.json", "--json", "out.json")
        whole = self.read("out.json")
        for words in (("merge", "1.json", "2.json", "--json", "out.json"),
                      ("cost", "--accuracy", "--lobe", "bps", "--profile", "8,4,7,4", "--json", "accuracy.json"),
                      ("cost", "--accuracy", "--lobe", "bps", "--profile", "8,4,6,4", "--json", "accuracy.json")):
            self.good(*words)
            os.utime(self.folder / words[-1], (future, future))
        self.equal(self.read("out.json"), whole)
        self.equal(len(json.loads(self.read("accuracy.json"))["points"]), 2)

    def test_bytes_that_are_no_text(self):
        """A command line may hold any bytes; the JSON that quotes it is JSON."""
        name = os.fsencode(self.folder) + b"/\xff.json"
        done = subprocess.run([OPTIONS.glint, "eval", "--n", "5", "--cos", "0.5", "--json", name], capture_output=True)
        self.equal((done.returncode, done.stderr), (0, b""))
        with open(name, encoding="utf-8") as file:
            self.true("\N{REPLACEMENT CHARACTER}.json" in json.load(file)["command"], "the name")

    def test_folder_that_is_gone(self):
        """The working folder itself."""
        (self.folder / "gone").mkdir()
        done = self.run_tool("-c", f"cd gone && rmdir ../gone && {OPTIONS.glint} sweep --profile p8 --n 1 --cos 0:9 --json out.json", tool="sh")
        self.equal((done.returncode, done.stdout), (2, ""))
        self.matches(done.stderr, r"\Aglint: file 'out.json' cannot be written[^\n]*\n\Z")
