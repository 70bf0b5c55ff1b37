#!/usr/bin/env python3
"""Latency and interval of the manifest are those of the Verilog: every unit of rtl/units.json, measured in Icarus.

    clocks_test.py [UNIT...]      default: all units

The default architecture at every profile, the others at p8. Inputs are 0, which count as others do.
"""

import sys
import tempfile
from pathlib import Path

import icarus
from units import units

RESULTS = 4

BENCH = """`default_nettype none
module clocks_tb;
    reg clk = 0;
    always #1 clk = ~clk;
    reg reset_n = 0;
    wire ready, valid;
    {top} #({parameters}) unit ({connections});
    integer clock = 0, accepted = -1, first = -1, last = -1, interval = 0, results = 0;
    always @(posedge clk) begin
        clock <= clock + 1;
        if (clock == 3) reset_n <= 1;
        if (reset_n && ready && accepted < 0) accepted <= clock;
        if (reset_n && valid) begin
            if (first < 0) first <= clock;
            else if (clock - last > interval) interval <= clock - last;
            last    <= clock;
            results <= results + 1;
            if (results == {results}) begin
                $display("latency %0d, interval %0d", first - accepted, interval);
                $finish(0);
            end
        end
        if (clock == 1000) begin
            $display("no results");
            $finish(0);
        end
    end
endmodule
"""
ROLES = {"clk_i": "clk", "aclk": "clk", "rst_ni": "reset_n", "aresetn": "reset_n", "ready_o": "ready", "valid_o": "valid",
         "s_axis_tready": "ready", "m_axis_tvalid": "valid"}
ONES = ("valid_i", "ready_i", "s_axis_tvalid", "m_axis_tready")


def measured(unit, parameters, folder):
    connections = []
    for port in unit["ports"]:
        name = port["name"]
        value = ROLES.get(name) or ("1'b1" if name in ONES else "" if port["direction"] == "output" else "0")
        if value == "0":
            value = f"{{({port['width']}) {{1'b0}}}}".replace("TAG_W", "16").replace("USER_W", "16").replace("WORD_W", "64")
        connections.append(f".{name}({value})")
    bench = Path(folder) / "clocks_tb.v"
    bench.write_text(BENCH.format(top=unit["name"], connections=", ".join(connections), results=RESULTS,
                                  parameters=", ".join(f".{name}({value})" for name, value in parameters.items())))
    icarus.build(Path(folder) / "clocks", "clocks_tb", [bench, *unit["files"]])
    return icarus.run(Path(folder) / "clocks").strip()


def main():
    every = units()
    chosen = sys.argv[1:] or every
    done, wrong = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for name in chosen:
            unit = every[name]
            for place, architecture in enumerate(unit["architectures"]):
                if place > 0 and unit["profile"] != "p8":
                    continue
                found = measured(unit, architecture["parameters"], folder)
                stated = f"latency {architecture['latency']}, interval {architecture['interval']}"
                if found != stated:
                    print(f"FAILED: {name} {architecture['name']}: {found} measured; {stated} in the manifest", file=sys.stderr)
                    wrong += 1
                done += 1
    print(f"{done} units and architectures, {wrong} with other clocks than the manifest's")
    return 1 if wrong or not done else 0


if __name__ == "__main__":
    sys.exit(main())
