#!/usr/bin/env python3
"""The replay must fail on everything that it should fail on, and say why.

    replay_test.py GLINT        the `glint` that makes the vectors
"""

import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import icarus

COUNT = 1000
NAME = "glint_bps_p8"


class Checks:
    def __init__(self, folder, text, manifest):
        self.folder = folder
        self.text = text
        self.manifest = manifest
        self.made = 0

    def expect(self, status, pattern, *arguments, text=None, manifest=None):
        """Replays a file of this text (None: there is no file), beside this manifest."""
        file = self.folder / "edited.hex"
        file.unlink(missing_ok=True)
        if text is not None:
            file.write_text(text)
        file.with_suffix(".json").write_text(self.manifest if manifest is None else manifest)
        command = [sys.executable, str(Path(__file__).with_name("replay.py")), "--units", str(self.folder / "units"), *arguments,
                   str(file)]
        done = subprocess.run(command, capture_output=True, text=True)
        output = done.stdout + done.stderr
        if done.returncode != status or not re.search(pattern, output, re.DOTALL):
            raise icarus.Failed(f"exit status {done.returncode}, expected {status} and '{pattern}':\n{output}")
        self.made += 1

    def files(self):
        text = self.text
        lines = text.splitlines(keepends=True)
        self.expect(0, r"full speed:.*1000 vectors, 0 mismatches.*stalls:.*1000 vectors, 0 mismatches\n\Z", text=text)
        slower = self.folder / "slower"  # the manifest states another latency than the Verilog has
        shutil.copytree(self.folder / "units", slower)
        stated = (slower / "units.json").read_text()
        (slower / "units.json").write_text(stated.replace('"latency": 21,', '"latency": 22,'))
        self.expect(1, "'latency 22, holds 22' was expected", "--units", str(slower), text=text)

        # One result of 1000: y by one, and clamped.
        for place, digit in ((23, "[01]"), (15, "[01]")):
            line = lines[499]
            bit = str(int(line[place], 16) ^ 1)
            wrong = "".join([*lines[:499], line[:place] + bit + line[place + 1 :], *lines[500:]])
            self.expect(1, r"FAILED: vector 500, n = .*\n1000 vectors, 1 mismatches\n", text=wrong)
        # Two inputs exchanged: two results. All wrong: the run ends at the tenth.
        (a, b) = (lines[400], lines[401])
        assert a[16:] != b[16:], "these two have the same result"
        swapped = "".join([*lines[:400], a[:16] + b[16:], b[:16] + a[16:], *lines[402:]])
        self.expect(1, r"vector 401, .*vector 402, .*\n1000 vectors, 2 mismatches\n", text=swapped)
        wrong = "".join(line[:15] + str(int(line[15]) ^ 1) + line[16:] for line in lines)
        self.expect(1, r"vector 10, .*\n10 vectors, 10 mismatches\n", text=wrong)

        # Not as many vectors as the manifest says; none; no file.
        self.expect(1, r"holds 999 lines, not 1000\n0 vectors, 1 mismatches\n", text="".join(lines[:-1]))
        self.expect(1, r"holds 1001 lines, not 1000\n0 vectors, 1 mismatches\n", text=text + lines[0])
        self.expect(1, r"holds 0 lines, not 1000\n0 vectors, 1 mismatches\n", text="")
        none = json.dumps({**json.loads(self.manifest), "count": 0})
        self.expect(1, r"holds 0 lines, not 0\n0 vectors, 1 mismatches\n", text="", manifest=none)
        self.expect(1, r"vector file '.*edited.hex' cannot be read\n0 vectors, 1 mismatches\n")
        self.expect(2, r"^replay.py: manifest '.*edited.json' cannot be used: .*\n\Z", text=text, manifest="")
        self.expect(2, r"^replay.py: --define '2=x' is not legal: NAME or NAME=VALUE\n\Z", "--define", "2=x", "--", text=text)
        unnamed = self.manifest.replace('"count"', '"n"')
        self.expect(2, r"manifest '.*' cannot be used: 'count'", text=text, manifest=unnamed)

        # Words that are none: no number, one digit too many (Icarus drops the first), a cosine that is not
        # sign-extended, y that the port cannot carry, bits between the fields, a blank line.
        place = r"word 7 of the file, \w{24}, is no vector.*\n0 vectors, 1 mismatches\n"
        for old, new, pattern in (
            (lines[6], lines[6].replace(lines[6][0], "x", 1), place),
            (lines[6], "00010000" + lines[6][8:], r"1000 vectors, 1 mismatches"),
            (lines[6], "00020000" + lines[6][8:], place),
            (lines[6], "fffd0000" + lines[6][8:], place),
            (lines[6], lines[6][:16] + "00000200\n", place),
            (lines[6], lines[6][:8] + "8" + lines[6][9:], place),
            (lines[6], lines[6][:12] + "8" + lines[6][13:], place),
            (lines[6], "g" + lines[6][1:], r"exit status 0\n.*ERROR"),
            (lines[6], "\n", r"Not enough words"),
        ):
            self.expect(1, pattern, text="".join([*lines[:6], new, *lines[7:]]))

    def planted(self, unit, file, pattern, replacement, message):
        """A bug in the Verilog."""
        rtl = icarus.planted(self.folder / f"rtl{self.made}", file, pattern, replacement)
        self.expect(1, message, "--unit", unit, "--rtl", str(rtl), text=self.text)

    def bugs(self):
        good_at_full_speed = r"full speed:.*1000 vectors, 0 mismatches.*stalls:\nFAILED: vector .* mismatches"
        ports = "glint_ports.v"
        advance = r"advance = ready_i \| ~valid_q\[CLOCKS-1\]"
        self.planted("core", ports, advance, "advance = 1'b1", "FAILED: after 64 inputs")
        self.planted("core", ports, r"n_q        <= none \? 10'd1 : n_i", "n_q <= n_i", r"FAILED: vector \d+, n = 0,")
        self.planted("core", "glint_horner.v", r"\+:H_W\], 1'b1, ", "+:H_W], 1'b0, ",
                     r"FAILED: vector \d+, n = ")
        self.planted("core", ports, r"STAGES\(CLOCKS\)", "STAGES(CLOCKS - 1)", r"FAILED: vector \d+, n = ")
        self.planted("core", ports, "assign valid_o   = rst_ni & ", "assign valid_o   = ",
                     "FAILED: in reset: valid is x")
        self.planted("core", ports, "assign ready_o   = rst_ni & ", "assign ready_o   = ",
                     "FAILED: in reset: valid is 0, ready is x")
        # A reset that leaves the results in flight: the first has the tag of the filling.
        self.planted("core", ports, r"if \(!rst_ni\) valid_q <= \{CLOCKS\{1'b0\}\};",
                     "if (!rst_ni) valid_q <= (valid_q[0] === 1'b1) ? {CLOCKS{1'b1}} : {CLOCKS{1'b0}};",
                     "FAILED: vector 1, n = 0, .*tag 000000 1; expected .* ffffff 0")
        self.planted("core", ports, r"\{valid_q\[CLOCKS-2:0\], valid_i & room\}", "{valid_q[CLOCKS-2:0], 1'b1}",
                     "FAILED: clock .*: a result that no input had asked for")
        # The tag does not stop with the rest of the pipeline.
        self.planted("core", "glint_delay.v", r"if \(enable_i\) data_q <= stage", "data_q <= stage", good_at_full_speed)
        axis = "glint_axis.v"
        self.planted("axis", axis, r"\{\(30 - O\) \{1'b0\}\}", "{(30 - O) {clamped}}", r"FAILED: vector \d+, n = ")
        self.planted("axis", axis, r"s_axis_tdata\[9:0\]\}", "s_axis_tdata[10:1]}",
                     r"FAILED: vector \d+, .*: y X, clamped x")
        self.planted("axis", "glint_skid.v", r"spare_full_q \? spare_q : data_i", "data_i", good_at_full_speed)
        self.planted("axis", "glint_skid.v", "assign valid_o = valid_q;", "assign valid_o = valid_q & ready_i;",
                     "FAILED: after 25 inputs, of which none could leave: valid is 0")
        self.planted("axis", "glint_skid.v", "assign valid_o = valid_q;",
                     "assign valid_o = valid_q & (ready_i | ~spare_full_q | ~data_q[WIDTH-1]);",
                     r"result \d+ was withdrawn")


def main(glint):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        arguments = ["--profile", "p8", "--count", str(COUNT), "--seed", "1", "--format", "hex", "-o", name]
        subprocess.run([glint, "vectors", "--lobe", "bps", *arguments], check=True)
        subprocess.run([glint, "emit", "--lobe", "bps", "--profile", "p8", "--target", "verilog", "-o", folder / "units"], check=True)
        checks = Checks(folder, (folder / f"{NAME}.hex").read_text(), (folder / f"{NAME}.json").read_text())
        checks.files()
        checks.bugs()
    print(f"{checks.made} replays behaved")
    return 0 if checks.made > 0 else 1


if __name__ == "__main__":
    icarus.main(main)
