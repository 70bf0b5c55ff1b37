"""What the commands take from shells and pipes: values that are empty, no number or too large; lines of --stdin."""

import os
import random
import re

from case import Case, OPTIONS, PROFILES, ROOT


class Arguments(Case):
    def test_empty(self):
        """An empty text, as a shell variable that is not set gives, is no value of any option."""
        for arguments in (("eval", "--n", "50", "--cos", ""), ("eval", "--n", "50", "--cos="),
                          ("eval", "--n", "50", "--cos-code", ""), ("eval", "--n", "", "--cos", "1"),
                          ("eval", "--n", "50", "--cos", "1", "--json", ""), ("sweep", "--lobe", ""),
                          ("sweep", "--csv", ""), ("choose", "--max-error", ""), ("choose", "--clock", ""),
                          ("choose", "--latency-ns", "", "--max-error", "0.1"), ("vectors", "-o", ""), ("emit", "--lobe="),
                          ("cost", "--device", ""), ("cost", "--csv="), ("render", "", "-o", "a.png"),
                          ("render", "a.obj", "-o", ""), ("fit", "--theta", ""), ("",)):
            self.refused(" ", *arguments)
        self.refused("--cos '' is not legal: an empty text is no value", "eval", "--n", "50", "--cos", "")
        self.equal(self.files(), [])

    def test_no_number(self):
        for name, value in (("--cos", "nan"), ("--cos", "1e400"), ("--cos", "inf")):
            self.refused("is not legal", "eval", "--n", "50", name, value)
        self.equal(self.good("eval", "--n", "5", "--cos", "1e-400"), self.good("eval", "--n", "5", "--cos", "0"))
        self.equal(self.good("eval", "--n", "5", "--cos", "+.5"), self.good("eval", "--n", "5", "--cos", "0.5"))
        for option in ("--max-error", "--clock", "--latency-ns", "--throughput"):
            for value in ("nan", "inf", "-1", "1e400"):
                self.refused(f"{option} '{value}' is not legal", "choose", option, value)

        self.refused("--cos 'x' is not legal: a finite number", "eval", "--n", "50", "--cos", "x")
        self.refused("--lanes 'x' is not legal: 2 to 64", "emit", "--lanes", "x")
        for value in ("x", "nan", "0", "0.6"):
            self.refused(f"--max-error '{value}' is not legal: a number from 0.0001 to 0.5", "cost", "--grid", "--max-error",
                         value)

    def test_echo(self):
        """A value is shown without what moves a cursor, and up to its 200th character."""
        for arguments in (("eval", "--lobe"), ("eval", "--profile"), ("fit", "--theta"), ("choose", "--clock"),
                          ("eval", "--nothing"), ()):
            self.refused("a b \\[31m", *arguments, "a\nb\x1b[31m")
            done = self.run_tool(*arguments, "x" * 5000)
            self.equal(done.returncode, 2)
            self.true(len(done.stderr) < 700 and done.stderr.count("\n") == 1, done.stderr)

    def test_one_file_for_two(self):
        for arguments in (("sweep", "--profile", "p8", "--n", "1"), ("cost", "--data", ROOT / "cost/data")):
            self.refused("file './a' is not legal: two options name it", *arguments, "--csv", "a", "--json", "./a")
        self.refused("two options name it", "cases", "-o", "a", "--json", "a")
        self.equal(self.files(), [])

    def test_range_that_is_empty(self):
        """Where the other numbers of a profile leave no legal value, they are named."""
        self.refused("S = 3 is not legal for cubic: no value is with this F and O, of 28 or more and 10 or less", "eval",
                     "--lobe", "cubic", "--profile", "10,3,3,28", "--n", 1, "--cos", 1)

    def test_help_that_cannot_be_written(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        for arguments in (("--help",), ("eval", "--help"), ("--version",)):
            with open("/dev/full", "w") as full:
                self.refused("standard output cannot be written", *arguments, stdout=full)

    def test_cosim(self):
        if not OPTIONS.cosim:
            self.true(True, "glint-cosim is not built")
            return
        few = ("--n", "50", "--cos", "0:5", "--profile", OPTIONS.cosim_profiles[0])
        for value in ("nan", "", "1e400", "-nan"):
            self.refused("--stall-probability", *few, "--stall-probability", value, tool=OPTIONS.cosim)
        self.refused("'missing/out.fst' cannot be written", *few, "--trace", "missing/out.fst", tool=OPTIONS.cosim)
        self.equal(self.files(), [])


class Stdin(Case):
    def test_equals_eval(self):
        """The stream answers what eval shows for each input alone."""
        generator = random.Random(1)
        for profile, bits in PROFILES.items():
            one = 1 << bits["F"]
            inputs = [(n, code) for n in (1, 50, 1023) for code in (0, 1, one - 1, one)]
            inputs += [(generator.randint(1, 1023), generator.randint(one - one // 50, one)) for _ in range(20)]
            text = "".join(f"{n} {code}\n" for n, code in inputs)
            answers = self.good("eval", "--profile", profile, "--stdin", text=text).splitlines()
            shown = []
            for n, code in inputs:
                alone = self.good("eval", "--profile", profile, "--n", n, "--cos-code", code)
                shown.append(re.search(r"^y +(\d+) ", alone, re.MULTILINE)[1])
            self.equal(answers, shown)
            self.true(len(set(answers)) > 10, f"{answers}")

    def test_port(self):
        inputs = [(n, code) for n in (0, 1, 1023) for code in (-524288, -1, 0, 262144, 262145, 524287)]
        text = "".join(f"{n} {code}\n" for n, code in inputs)
        answers = self.good("eval", "--port", "--stdin", text=text).splitlines()
        self.equal(len(answers), len(inputs))
        for (n, code), answer in zip(inputs, answers):
            clamped = n == 0 or code < 0 or code > 262144
            self.matches(answer, rf"\A\d+ {int(clamped)}\Z")
            self.true(code >= 0 or answer == "0 1", f"{n} {code}: {answer}")

    def test_many_lines(self):
        """Lines over many blocks of input, against a vector file; the last line without its line feed too."""
        self.good("vectors", "--count", 300000, "--seed", 7)
        vectors = [line.split() for line in self.read("glint_bps_p12.tv").splitlines()]
        text = "".join(f"{n} {code}\n" for n, code, _, _ in vectors)
        self.true(len(text) > 2 << 20, f"{len(text)} bytes")
        wanted = "".join(f"{y} {clamped}\n" for _, _, y, clamped in vectors)
        self.true(self.good("eval", "--port", "--stdin", text=text) == wanted, "the answers are those of the vectors")
        self.true(self.good("eval", "--port", "--stdin", text=text[:-1]) == wanted, "without the last line feed")
        done = self.run_tool("eval", "--port", "--stdin", text=text + "1 x\n")
        self.equal(done.returncode, 2)
        self.matches(done.stderr, r"\Aglint: line 300001[ :].*\n\Z")

    def test_refused(self):
        self.refused("standard input.*0 lines", "eval", "--stdin", text="")
        for line in ("", "1", "1 ", "1 x", "x 1", "1,2", "1 2 3", "1 2 ", " 1 2", "1.0 2", "1 0x2", "1\t2", "1 2\r\r"):
            self.cut_off("line 3 is not legal: two integers", f"{line}\n1 2\n")
        for line, why in (("0 5", "n 0"), ("1024 5", "n 1024"), ("5 -1", "cos code -1"),
                          ("5 262145", "cos code 262145")):
            self.cut_off(f"line 3: {why} is not legal: ", f"{line}\n")
        for line, why in (("1024 5", "n 1024"), ("5 -524289", "cos code -524289"), ("5 524288", "cos code 524288")):
            self.cut_off(f"line 3: {why} is not legal: ", f"{line}\n", "--port")
        for line in ("99999999999 1", "1 99999999999999999999"):
            self.cut_off("line 3", f"{line}\n", "--port")

    def cut_off(self, pattern, lines, *port):
        """A line that is refused: the results of the two before it are there."""
        good = "1 2\n50 256901\n"
        done = self.run_tool("eval", "--stdin", *port, text=good + lines)
        self.equal((done.returncode, done.stdout), (2, self.good("eval", "--stdin", *port, text=good)))
        self.matches(done.stderr, rf"\Aglint: {pattern}[^\n]*\n\Z")

    def test_line_ends_of_windows(self):
        self.equal(self.good("eval", "--stdin", text="1 2\r\n50 256901\r\n"),
                   self.good("eval", "--stdin", text="1 2\n50 256901\n"))
        codes = ("50 200000 200000", "1 2 3")
        self.equal(self.good("eval", "--effect", "phong", "--stdin", "--port", text="\r\n".join(codes)),
                   self.good("eval", "--effect", "phong", "--stdin", "--port", text="\n".join(codes)))

    def test_effect_refused(self):
        good = "50 200000 200000\n"
        for line in ("1 2\n", "0 1 2\n", "x\n"):
            done = self.run_tool("eval", "--effect", "phong", "--stdin", text=good + line + good)
            self.equal((done.returncode, done.stdout),
                       (2, self.good("eval", "--effect", "phong", "--stdin", text=good)))
            self.matches(done.stderr, r"\Aglint: line 2[^\n]*\n\Z")
