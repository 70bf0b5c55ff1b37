#!/usr/bin/env python3
"""Every unit from power-up in Icarus, whose registers and memories start unknown (X): no unknown bit leaves it after a reset.

    unknown_test.py            every unit of rtl/units.json, default architecture
    unknown_test.py NAME ...   these units, in each of their architectures

The reset is unknown at first, then one clock long. All inputs are unknown but the handshake; those of an item are random while it is offered.
Checked: valid and ready are low at the end of the reset, and known after it; with valid, every bit of the result is known;
as many items leave as came. Exit status: 0 all hold, 1 not, 2 bad arguments.
"""

import sys
import tempfile
from pathlib import Path

import icarus
from units import units

ITEMS = 200
HANDSHAKE = {"clk_i": "clk", "rst_ni": "rst", "valid_i": "offer", "ready_o": "room", "valid_o": "there", "ready_i": "take",
             "aclk": "clk", "aresetn": "rst", "s_axis_tvalid": "offer", "s_axis_tready": "room", "m_axis_tvalid": "there", "m_axis_tready": "take"}
BENCH = """
module unknown_tb;
    reg clk = 1'b0, rst, offer = 1'b0, take = 1'b0;
    wire room, there;
    integer seed = 1, came = 0, left = 0, wrong = 0, clocks = 0, i;
    reg [%(in)d:0] given;
    wire [%(out)d:0] result;
    %(module)s #(%(parameters)s) unit (%(ports)s);
    always #2 clk = ~clk;
    always @(posedge clk) begin
        if (rst && ^{room, there} === 1'bx) wrong = wrong + 1;
        if (rst && there && ^result === 1'bx) wrong = wrong + 1;
        if (rst && offer && room) came = came + 1;
        if (rst && there && take) left = left + 1;
    end
    initial begin
        given = {%(in)d + 1{1'bx}};
        #1 rst = 1'b0;
        @(posedge clk);
        @(negedge clk) if (room !== 1'b0 || there !== 1'b0) wrong = 1;
        rst = 1'b1;
        while (left < %(items)d && clocks < 20000) begin
            @(negedge clk) clocks = clocks + 1;
            if (!(offer && !room_q)) begin
                offer = came < %(items)d - 1 + !offer && $random(seed) %% 4 != 0;
                for (i = 0; i <= %(in)d; i = i + 1) given[i] = offer ? $random(seed) : 1'bx;
            end
            take = $random(seed) %% 3 != 0;
        end
        repeat (100) @(posedge clk);
        $display("%%0d items, %%0d mismatches", left, wrong);
        $finish(0);
    end
    reg room_q = 1'b1;
    always @(posedge clk) room_q <= room;
endmodule
"""


def bench(unit, parameters):
    """The bench around a unit: its inputs are parts of one word, its outputs of another."""
    sizes = {**{p["name"]: p["default"] for p in unit["parameters"]}, **parameters}
    width = {"input": 0, "output": 0}
    ports = []
    for port in unit["ports"]:
        name, way = port["name"], port["direction"]
        if name in HANDSHAKE:
            ports.append(f".{name}({HANDSHAKE[name]})")
            continue
        bits = int(sizes.get(port["width"], port["width"]))
        ports.append(f".{name}({'given' if way == 'input' else 'result'}[{width[way]}+:{bits}])")
        width[way] += bits
    return BENCH % {"module": unit["name"], "parameters": ", ".join(f".{k}({v})" for k, v in parameters.items()), "ports": ", ".join(ports),
                    "in": width["input"] - 1, "out": width["output"] - 1, "items": ITEMS}


def simulate(unit, architecture):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "unknown_tb.v"
        file.write_text(bench(unit, architecture["parameters"]))
        icarus.build(Path(folder) / "tb", "unknown_tb", [*unit["files"], file], strict=False)
        icarus.require(icarus.run(Path(folder) / "tb"), "items", ITEMS)
    print(f"{unit['name']} {architecture['name']}: {ITEMS} items, no unknown bit", flush=True)


def main():
    known = units()
    for name in sys.argv[1:]:
        if name not in known:
            print(f"unknown_test.py: '{name}' is no unit of rtl/units.json", file=sys.stderr)
            return 2
    failed = 0
    for unit in [known[name] for name in sys.argv[1:] or known]:
        for architecture in unit["architectures"] if sys.argv[1:] else unit["architectures"][:1]:
            try:
                simulate(unit, architecture)
            except icarus.Failed as failure:
                failed += 1
                print(f"FAILED: {unit['name']} {architecture['name']}: {failure}")
    return 1 if failed or not known else 0


if __name__ == "__main__":
    sys.exit(main())
