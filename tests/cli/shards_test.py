"""Runs in parts: --shard, --resume, --plan, glint merge."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import time

from case import Case, OPTIONS, ROOT


class Shards(Case):
    SWEEP = ("sweep", "--lobe", "bps,schlick", "--profile", "p8", "--n", "1:1000:7")

    def results(self, name):
        """The runs of a file, but for what no two runs have in common."""
        runs = json.loads(self.read(name))["runs"]
        for run in runs:
            run.pop("seconds")
            run.pop("vectors_per_second")
        return runs

    def parts(self, count, *arguments, **settings):
        names = [f"{i}.json" for i in range(1, count + 1)]
        for i, name in enumerate(names):
            self.good(*arguments, "--shard", f"{i + 1}/{count}", "--json", name, "--threads", 1 + i % 2, **settings)
        return names

    def edited(self, name, change):
        """A copy of the file with a change to its JSON."""
        file = json.loads(self.read(name))
        change(file)
        (self.folder / "edited.json").write_text(json.dumps(file))
        return "edited.json"

    def test_sweep(self):
        self.good(*self.SWEEP, "--json", "whole.json", "--csv", "whole.csv")
        whole = self.results("whole.json")
        self.true(whole[0]["inputs"] == 143 * 65537, whole[0]["inputs"])
        for count in (2, 5, 17):
            self.good("merge", *self.parts(count, *self.SWEEP), "--json", "joined.json", "--csv", "joined.csv")
            self.equal(self.results("joined.json"), whole, f"{count} shards")
            self.equal(self.read("joined.csv"), self.read("whole.csv"))

    def test_cosim(self):
        if not OPTIONS.cosim:
            self.skipTest("glint-cosim is not built")
        profile = OPTIONS.cosim_profiles[0]
        for arguments in (("--n", "1:300:50", "--cos", "all", "--unit", "core,axis"),
                          ("--count", 50000, "--stall-probability", 0.3, "--seed", 5), ("--illegal",), ("--resets", 20)):
            arguments = ("--profile", profile, *arguments)
            self.good(*arguments, "--json", "whole.json", tool=OPTIONS.cosim)
            names = self.parts(3, *arguments, tool=OPTIONS.cosim)
            self.good("merge", *names, "--json", "joined.json")
            self.equal(self.results("joined.json"), self.results("whole.json"), arguments)
        if profile in ("p8", "p12", "p16"):
            units = json.loads((ROOT / "rtl/units.json").read_text())["units"]
            files = next(unit["files"] for unit in units if unit["name"] == f"glint_bps_{profile}")
            text = b"".join((ROOT / "rtl" / name).read_bytes() for name in sorted(files))
            key = json.loads(self.read("1.json"))["runs"][0]["part"]["key"]
            self.matches(key, f" verilog {hashlib.sha256(text).hexdigest()[:16]}$")

        def other_verilog(file):
            part = file["runs"][0]["part"]
            part["key"] = re.sub(r"verilog \w+$", "verilog 0123456789abcdef", part["key"])

        self.refused("'edited.json' is foreign: it is of '.*verilog 0123", "merge", "1.json", "2.json",
                     self.edited("3.json", other_verilog))

        def mismatch(file):
            file["runs"][0]["mismatches"] = 1
            file["runs"][0]["part"]["complaint"] = "1 mismatches; the first: this\n"

        done = self.run_tool("merge", "1.json", "2.json", self.edited("3.json", mismatch), "--json", "failed.json")
        self.equal(done.returncode, 1)
        self.matches(done.stderr, "FAILED: 1 mismatches; the first: this")
        self.equal(self.results("failed.json")[0]["mismatches"], 1)

    def test_merge_refuses(self):
        names = self.parts(4, *self.SWEEP)
        self.good("merge", *names)
        self.refused("1 of 4 shards are missing: 3", "merge", *names[:2], names[3])
        self.refused("shard 2/4 is there twice: '2.json' and '2.json'", "merge", *names, names[1])
        self.refused("foreign: it is of 'version 0.0.1'", "merge", *names[:3],
                     self.edited("4.json", lambda file: file.update(version="0.0.1")))
        self.good(*self.SWEEP[:-1], "1:1000:8", "--shard", "4/4", "--json", "other.json")
        self.refused("'other.json' is foreign: it is of 'bps p8 n 1:1000:8 ", "merge", *names[:3], "other.json")
        self.good(*self.SWEEP, "--shard", "4/5", "--json", "other.json")
        self.refused("'other.json' is foreign: it is of '5 shards'", "merge", *names[:3], "other.json")
        self.good(*self.SWEEP, "--json", "whole.json")
        self.refused("'whole.json' is no shard", "merge", "whole.json")
        self.refused("'none.json' cannot be read", "merge", "none.json")
        self.refused("squares", "merge", *names[:3],
                     self.edited("4.json", lambda file: file["runs"][0]["part"]["squares"].pop()))
        self.refused("rounding", "merge", *names[:3],
                     self.edited("4.json", lambda file: file["runs"][0]["part"]["squares"][0].update(rounding=[1, 2])))
        for text in ("0/4", "5/4", "1", "1/", "a/b", "1/4x", "1/1000001", "-1/4", ""):
            self.refused("--shard", *self.SWEEP, "--shard", text, "--json", "no.json")
        self.refused("17 parts at most", *self.SWEEP, "--shard", "1/18", "--json", "no.json")
        self.refused("--json", *self.SWEEP, "--shard", "1/2")
        self.refused("--shard", *self.SWEEP, "--resume", "--json", "no.json")
        self.true("no.json" not in self.files(), self.files())

    def test_killed_run_goes_on(self):
        """Every part of a killed run is there whole or not at all; the same command again runs only the others."""
        command = f"for i in $(seq 17); do {OPTIONS.glint} sweep --profile p8 --threads 1 --shard $i/17 --json s$i.json --resume; done"
        run = subprocess.Popen(["bash", "-c", command], cwd=self.folder, stdout=subprocess.DEVNULL, start_new_session=True)
        while "s2.json" not in self.files():
            time.sleep(0.01)
        os.killpg(run.pid, 9)
        run.wait()
        left = [name for name in self.files() if name.endswith(".json")]
        self.true(2 <= len(left) < 17, left)
        again = self.run_tool("-c", command, tool="bash")
        self.equal(again.stdout.count(" is there: "), len(left), again.stdout)
        self.good("merge", *(f"s{i}.json" for i in range(1, 18)), "--json", "joined.json")
        self.good("sweep", "--profile", "p8", "--json", "whole.json")
        self.equal(self.results("joined.json"), self.results("whole.json"))
        # Neither a broken file nor one of another run stands for a part.
        shutil.copy(self.folder / "s2.json", self.folder / "s1.json")
        (self.folder / "s3.json").write_text("{")
        again = self.run_tool("-c", command, tool="bash")
        self.equal(again.stdout.count(" is there: "), 15, again.stdout)
        self.good("merge", *(f"s{i}.json" for i in range(1, 18)))

    def test_plan(self):
        text = self.good("sweep", "--profile", "28,27,27,24", "--plan", 64)
        self.matches(text, r"bps +28_27_27_24 +274 609 472 511 +65 537 .* (s|min|h|days) .* (s|min|h|days)\n")
        self.refused("--plan '0' is not legal", "sweep", "--plan", 0)
        self.refused("--json", "sweep", "--plan", 4, "--json", "plan.json")
