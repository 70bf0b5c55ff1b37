#!/usr/bin/env python3
"""run.py fails where it has to: a planted bug that survives, a false property, an edit that does not apply, no task."""

import contextlib
import dataclasses
import io
import pathlib
import subprocess
import sys
import unittest

import run

SCRIPT = pathlib.Path(run.__file__)


def named(name):
    return next(task for task in run.tasks() if task.name == name)


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

    def test_wrappers_differ_in_numbers_only(self):
        """Proven is that of p12."""
        self.assertIn("bps", run.LOBES)
        for lobe in run.LOBES:
            numbers = run.word_lengths(lobe, "p12")
            texts = set()
            for profile in ("p8", "p12", "p16"):
                text = run.wrapper_at_any_size(lobe, profile, numbers)
                texts.add(text[text.index("#("):])
            self.assertEqual(len(texts), 1, lobe)

    def test_arguments(self):
        for arguments, text in ((["--only", "nonsense"], "--only nonsense is no task"), (["--jobs", "0"], "--jobs 0")):
            done = subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn(text, done.stderr)


if __name__ == "__main__":
    unittest.main()
