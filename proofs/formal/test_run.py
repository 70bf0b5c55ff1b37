#!/usr/bin/env python3
"""run.py fails where it has to: a planted bug that survives, a false property, an edit that does not apply, no task."""

import contextlib
import dataclasses
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import run
import tasks

SCRIPT = pathlib.Path(run.__file__)


def named(name):
    return next(task for task in tasks.tasks() if task.name == name)


def failures(task, **changes):
    changed = dataclasses.replace(task, failures=[], **changes)
    with contextlib.redirect_stdout(io.StringIO()):
        return run.carry_out(changed, None).failures


class Runner(unittest.TestCase):
    bug = named("bugs.skid.order_lost")
    proof = named("skid.handshake")

    def test_passes_what_is_right(self):
        self.assertEqual(failures(self.bug), [])
        self.assertEqual(failures(self.proof), [])

    def test_bug_that_survives(self):
        module, text, _ = self.bug.edit
        self.assertIn("is not found", failures(self.bug, edit=(module, text, text))[0])

    def test_broken_module(self):
        self.assertIn("fails after reset", failures(self.proof, edit=self.bug.edit, depth=6)[0])

    def test_edit_that_does_not_apply(self):
        self.assertIn("applies 0 times", failures(self.bug, edit=("glint_skid", "no such text", ""))[0])

    def test_unreached_cover(self):
        self.assertIn("reached 0 of 5", failures(named("skid.cover"), depth=1)[0])

    def test_no_property(self):
        self.assertIn("no property", failures(self.bug, only="no_such_property")[0])

        self.assertIn("no property", failures(self.bug, given="no_such_property")[0])

    def test_every_effect_is_proven(self):
        names = {task.name for task in tasks.tasks() if task.method == "induction"}
        self.assertIn("lambert", tasks.EFFECTS)
        for effect in set(tasks.EFFECTS) - {"pixel"}:  # glint_stream, then shade
            self.assertTrue({f"effect.{effect}.{task}" for task in ("p12", "p8", "order")} & set(names), effect)

    def test_given_is_proven_before(self):
        """What a step of shade may assume, an earlier step proves."""
        with tempfile.TemporaryDirectory() as temporary:
            steps = [task for task in tasks.tasks() if task.top == "glint_effect_shade" and task.method == "induction"]
            self.assertEqual([bool(task.given) for task in steps], [False] + [True] * (len(steps) - 1))
            run.prepare(dataclasses.replace(steps[0], only="", given=""), pathlib.Path(temporary))
            proven = set()
            for task in steps:
                properties = run.cells(pathlib.Path(temporary), "assert")
                given = {name for name in properties if task.given and re.fullmatch(task.given, name)}
                self.assertLessEqual(given, proven, task.name)
                proven |= {name for name in properties if re.fullmatch(task.only, name)}
            rest = {name for name in properties if name not in proven}
            self.assertTrue(all(re.search(r"inv_after(_bound)?$", name) for name in rest), rest)  # bookkeeping nothing rests on

    def test_arguments(self):
        for arguments, text in ((["--only", "nonsense"], "--only nonsense is no task"), (["--jobs", "0"], "--jobs 0")):
            done = subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn(text, done.stderr)


if __name__ == "__main__":
    unittest.main()
