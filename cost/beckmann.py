#!/usr/bin/env python3
"""Beckmann's exponential, exp(-(tan a / m)^2), by the tables of `decay`, beside the form that cook_torrance has: errors, and LUTs by Yosys.

    cost/beckmann.py --glint build/release/glint --json cost/data/beckmann.json

By tables it is exp(-2^x) with x = log2(1 / m^2) + log2(tan^2 a): `glint_decay` with another table of logarithms, and the first
of the two as a port. cook_torrance squares N.H, multiplies by falloff, divides, and takes exp2 of the quotient. Both are
synthesized with their handshake. Errors are over every code of N.H, for each m of ROUGHNESS.
"""

import argparse
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FORMATS = ["16,4,8,8,4,1,4,0,9", "16,5,10,10,5,1,4,0,11", "16,5,12,12,5,0,4,0,13"]  # of decay; n is not used
PROFILES = {"p8": (16, 8), "p12": (18, 12)}  # of cook_torrance: F, O
ROUGHNESS = [0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0]
ROUGH = 0.3  # from there on errors stand in a column of their own

DIVIDED = """
module divided #(PARAMETERS) (
    input wire clk_i, rst_ni, valid_i, ready_i, tag_i, input wire [F+1:0] nh_i, input wire [O+9:0] falloff_i,
    output wire ready_o, valid_o, tag_o, clamped_o, output wire [O:0] y_o);
    wire advance;
    glint_stream #(.LATENCY(S + 18), .TAG_W(1)) stream (.clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o),
        .clamped_i(nh_i[F+1]), .tag_i(tag_i), .valid_o(valid_o), .ready_i(ready_i), .tag_o(tag_o), .clamped_o(clamped_o), .advance_o(advance));
    reg [F:0] nh_q; reg [2*F:0] square_q; reg [W:0] s_q, e_q, e_late_q; reg [O+9:0] falloff_2_q, falloff_1_q, falloff_q; reg [O+W+9:0] product_q;
    wire [2*F:0] rest = {1'b1, {(2 * F) {1'b0}}} - square_q;
    always @(posedge clk_i) if (advance) begin
        nh_q <= nh_i[F+1] ? 0 : nh_i[F:0]; falloff_2_q <= falloff_i;
        square_q <= {{F{1'b0}}, nh_q} * {{F{1'b0}}, nh_q}; falloff_1_q <= falloff_2_q;
        s_q <= rest[2*F:2*F-W]; e_q <= {1'b1, {W{1'b0}}} - rest[2*F:2*F-W]; falloff_q <= falloff_1_q;
        product_q <= {{W{1'b0}}, falloff_q} * {{(O + 9) {1'b0}}, s_q}; e_late_q <= e_q;
    end
    wire [S+6:0] t; wire beyond;
    wire [W+S+9:0] dividend = {product_q, {(S - O) {1'b0}}};
    glint_divider #(.X_W(W + S + 8), .Y_W(W + 1), .Q_W(S + 7)) divider (.clk_i(clk_i), .enable_i(advance), .start_i(1'b0),
        .dividend_i(dividend[W+S+7:0]), .divisor_i(e_late_q), .beside_i(1'b0), .quotient_o(t));
    glint_delay #(.WIDTH(1), .STAGES(S + 13)) delay (.clk_i(clk_i), .enable_i(advance),
        .data_i(product_q[O+W+9:O+7] >= {2'b00, e_late_q}), .data_o(beyond));
    wire [E-1:0] address; wire [3*S-3*E+5:0] entry;
    glint_exp2 #(.I_W(7), .E(E), .S(S), .O(O)) exp2 (.clk_i(clk_i), .enable_i(advance), .t_i(t), .negative_i(beyond), .address_o(address),
        .entry_i(entry), .y_o(y_o));
    TABLE table_exp2 (.clk_i(clk_i), .enable_i(advance), .address_i(address), .entry_o(entry));
endmodule
"""

TABLES = """
module logarithm #(PARAMETERS) (input wire clk_i, enable_i, input wire [AW-1:0] address_i, output reg [EW-1:0] entry_o);
    always @(posedge clk_i) if (enable_i) case (address_i)
ROWS    endcase
endmodule
module tables #(PARAMETERS) (input wire clk_i, rst_ni, valid_i, ready_i, tag_i, input wire [F+1:0] nh_i, input wire [V+3:0] level_i,
    output wire ready_o, valid_o, tag_o, clamped_o, output wire [O:0] y_o);
    wire enable, clear; wire [AW-1:0] address; wire [EW-1:0] entry; wire [W+H-1:0] fall_address; wire [2*O+2*G-H-2:0] fall_entry;
    reg [V+3:0] level_2_q, level_1_q, level_q;
    always @(posedge clk_i) if (enable) {level_q, level_1_q, level_2_q} <= {level_1_q, level_2_q, level_i};
    glint_decay #(.F(F), .A(A), .M(M), .V(V), .H(H), .G(G), .W(W), .O(O), .LATENCY(9), .PRODUCTS(2), .N(1), .TAG_W(1)) core (.clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i),
        .ready_o(ready_o), .n_i(10'd2), .cos_i(nh_i), .tag_i(tag_i), .valid_o(valid_o), .ready_i(ready_i), .y_o(y_o), .tag_o(tag_o),
        .clamped_o(clamped_o), .table_enable_o(enable), .logarithm_address_o(address), .logarithm_entry_i(entry),
        .exponent_entry_i(level_q), .fall_address_o(fall_address), .fall_entry_i(fall_entry), .fall_clear_o(clear));
    logarithm table_logarithm (.clk_i(clk_i), .enable_i(enable), .address_i(address), .entry_o(entry));
    FALL fall (.clk_i(clk_i), .enable_i(enable), .address_i(fall_address), .clear_i(clear), .entry_o(fall_entry));
endmodule
"""


BENCH = """
module bench;
    reg clk = 0, reset_n = 0; reg [F+1:0] nh; reg [V+3:0] level; wire [O:0] y; integer i;
    tables unit (.clk_i(clk), .rst_ni(reset_n), .valid_i(1'b1), .ready_i(1'b1), .tag_i(1'b0), .nh_i(nh), .level_i(level), .y_o(y));
    reg [31:0] all [0:2*COUNT-1];
    initial begin
        $readmemh("inputs", all);
        #1 clk = 1; #1 clk = 0; reset_n = 1;
        for (i = 0; i < COUNT + 9; i = i + 1) begin
            nh = all[2*(i%COUNT)]; level = all[2*(i%COUNT)+1];
            #1 clk = 1; #1 clk = 0; if (i > 7 && i < COUNT + 8) $display("%d", y);
        end
    end
endmodule
"""


class Tables:
    """The integers of docs/lobes/decay.md, with log2(tan^2 a) - 1 for log2(-ln c)."""

    def __init__(self, text):
        self.F, self.A, self.M, self.V, self.H, self.G, self.W, _, self.O = map(int, text.split(","))
        self.E = max(self.F - 1, 1).bit_length()
        self.slope_bits = self.V + 2 - min(self.A, 4)
        one, rows, last = 1 << self.V, 1 << self.A, (1 << self.E) - 1

        def base(octave, i):
            d = (rows + i) / 2 ** (self.A + 1 + last - octave)
            c = 1 - d
            return (1 << self.V + 2) - 1 if c <= 0 else min(
                round((math.log2((1 - c * c) / c / c) - 1 + last - octave + 1) * one) + 1, (1 << self.V + 2) - 1)

        self.rows = []
        for octave in range(last + 1):
            for i in range(rows):
                here = base(octave, i)
                after = base(octave, i + 1) if i + 1 < rows else base(octave + 1, 0) + one if octave < last else here
                self.rows.append((here, max(0, min(after - here, (1 << self.slope_bits) - 1))))
        top = (1 << self.O + self.G) - 1
        begin = 4 - (1 << self.W)
        self.fall = [min(top, round((1 - math.exp(-2.0 ** (begin + j / 2 ** self.H))) * (top + 1))) for j in range(1 << self.W + self.H)]
        self.fall.append(top)

    def x(self, code):
        """x without the material's logarithm."""
        D = (1 << self.F) - 1 - code
        e = min(self.F - D.bit_length(), (1 << self.E) - 1)
        octave = (1 << self.E) - 1 - e
        m = max(0, ((D + 1 << e) - 1 - (1 << self.F - 1)) >> self.F - 1 - self.M)
        base, slope = self.rows[(octave << self.A) + (m >> self.M - self.A)]
        return base + (slope * (m & (1 << self.M - self.A) - 1) >> self.M - self.A) + (octave + 6 << self.V)

    def y(self, code, x):
        if code in (0, 1 << self.F):
            return code >> self.F - self.O
        Q = self.V - self.H
        j = (x >> Q) - ((1 << self.E) + 10 - (1 << self.W) << self.H)
        if j < 0:
            fall = 0
        elif j >= 1 << self.W + self.H:
            fall = self.fall[-1]
        else:
            fall = self.fall[j] + ((self.fall[j + 1] - self.fall[j]) * (x & (1 << Q) - 1) >> Q)
        return (1 << self.O) - 1 - (fall >> self.G)

    def exponential(self, code, m):
        x = self.x(code) if code < 1 << self.F else 0
        return self.y(code, x + round((1 - 2 * math.log2(m)) * 2 ** self.V)) / 2 ** self.O

    def verilog(self, fall):
        numbers = {**{name: getattr(self, name) for name in "FAMVHGWO"}, "AW": self.E + self.A, "EW": self.V + 2 + self.slope_bits}
        rows = "".join(f"        {k}: entry_o <= {(base << self.slope_bits) + slope};\n" for k, (base, slope) in enumerate(self.rows))
        return with_parameters(TABLES, numbers).replace("ROWS", rows).replace("FALL", fall)


    def simulate(self, folder, text, files):
        """Fails unless the Verilog has the integers of this class, for 2000 random inputs."""
        generator = random.Random(1)
        inputs = [(generator.randint(1, 1 << self.F), generator.randrange(1 << self.V, 10 << self.V)) for _ in range(2000)]
        (folder / "inputs").write_text("\n".join(f"{code:x} {level + (6 << self.V):x}" for code, level in inputs))
        bench = BENCH.replace("COUNT", str(len(inputs)))
        for name in "FVO":
            bench = bench.replace(f"[{name}", f"[{getattr(self, name)}")
        (folder / "bench.v").write_text(text + bench)
        subprocess.run(["iverilog", "-g2005", "-s", "bench", "-o", "bench", "bench.v", *files], check=True, cwd=folder)
        done = subprocess.run(["vvp", "-n", "bench"], check=True, cwd=folder, stdout=subprocess.PIPE, text=True)
        wanted = [self.y(code, (self.x(code) if code < 1 << self.F else 0) + level) for code, level in inputs]
        assert list(map(int, done.stdout.split())) == wanted, "the Verilog differs from the integers"


class Divided:
    """The integers of docs/effects/cook_torrance.md, up to t. Its exponent is a sum, so no rounding of the exponential is in the term."""

    def __init__(self, F, O):
        self.F, self.O, self.S, self.W, self.E = F, O, O + 4, O + 14, O // 4

    def exponential(self, code, m):
        s = (1 << 2 * self.F) - code * code >> 2 * self.F - self.W
        e = (1 << self.W) - s
        dividend = round(2 ** self.O / (m * m * math.log(2))) * s << self.S - self.O
        return 2.0 ** -(dividend // e / 2 ** self.S) if dividend < e << self.S + 7 else 0.0

    def verilog(self, exp2):
        return with_parameters(DIVIDED, {name: getattr(self, name) for name in "FOSWE"}).replace("TABLE", exp2)


def with_parameters(text, numbers):
    return text.replace("PARAMETERS", "parameter " + ", ".join(f"{name} = {value}" for name, value in numbers.items()))


def errors(form):
    """Over every code from 0.02 on, for each m: of the exponential; of exp / (pi m^2 (N.H)^4), relative where that is above 1."""
    found = {}
    for m in ROUGHNESS:
        own = term = 0.0
        for code in range((1 << form.F) // 50, (1 << form.F) + 1):
            c = code / 2 ** form.F
            real = math.exp((c * c - 1) / (c * m) ** 2)
            error = abs(form.exponential(code, m) - real)
            scale = 1 / (math.pi * m * m * c ** 4)
            own = max(own, error)
            term = max(term, error * scale / max(1.0, real * scale))
        found[m] = own, term
    return found


def synthesized(folder, top, text, files, device):
    (folder / "top.v").write_text(text)
    command = {"hx8k": "synth_ice40 -device hx", "ecp5-25k": "synth_ecp5"}[device]
    script = f"read_verilog {' '.join(map(str, files))} {folder}/top.v; {command} -top {top}; tee -q -o {folder}/stat stat"
    subprocess.run(["yosys", "-q", "-p", script], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    cells = {line.split()[0]: int(line.split()[1]) for line in (folder / "stat").read_text().splitlines() if re.fullmatch(r" {5,}\S+ +\d+", line)}
    return {"luts": cells.get("SB_LUT4", 0) + cells.get("LUT4", 0) + 2 * cells.get("CCU2C", 0), "dsps": cells.get("MULT18X18D", 0),
            "brams": cells.get("SB_RAM40_4K", 0) + cells.get("DP16KD", 0)}


def emitted(glint, folder, *arguments):
    subprocess.run([glint, "emit", *arguments, "--target", "verilog", "-o", folder], check=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--glint", required=True)
    parser.add_argument("--json", required=True)
    options = parser.parse_args()
    points = []
    for name in [*FORMATS, *PROFILES]:
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place)
            point = {"form": "divided" if name in PROFILES else "tables", "profile": name}
            if name in PROFILES:
                emitted(options.glint, folder, "--effect", "cook_torrance", "--profile", name)
                table, = folder.glob("glint_table_exp2_*.v")
                form = Divided(*PROFILES[name])
                point["clocks"] = form.S + 18
            else:
                emitted(options.glint, folder, "--lobe", "decay", "--profile", name)
                table, = folder.glob("glint_table_fall_*.v")
                form = Tables(name)
                point["clocks"] = 9
            files = [*sorted((ROOT / "rtl/blocks").glob("*.v")), ROOT / "rtl/lobes/glint_decay.v", table]
            text = form.verilog(table.stem)
            if name in FORMATS:
                form.simulate(folder, text, files)
            found = errors(form)
            point.update({"error": max(own for own, _ in found.values()), "term": max(term for _, term in found.values()),
                          "term_rough": max(term for m, (_, term) in found.items() if m >= ROUGH)})
            for device in ("hx8k", "ecp5-25k"):
                point[device] = synthesized(folder, point["form"], text, files, device)
        print(point, flush=True)
        points.append(point)
    lines = ",\n".join(json.dumps(point) for point in points)
    Path(options.json).write_text(f'{{"format": "glint-cost-beckmann-1",\n "points": [\n{lines}\n]}}\n')
    return 0


if __name__ == "__main__":
    sys.exit(main())
