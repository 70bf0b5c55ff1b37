#!/usr/bin/env python3
"""An installed share/glint/rtl through tools that are not ours: the replay bench, ghdl with Icarus.

    packages_test.py PREFIX        what is missing is said in a line
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

UNIT = "glint_bps_p8"
USER = """library ieee;
use ieee.std_logic_1164.all;
use work.{unit}_pkg.all;
entity highlight is
  port (clk, rst_n, valid : in std_logic; n : in std_logic_vector(9 downto 0);
        cosine : in std_logic_vector(17 downto 0); y : out std_logic_vector(8 downto 0); done : out std_logic);
end entity;
architecture rtl of highlight is
  signal ready, clamped : std_logic;
  signal tag : std_logic_vector(7 downto 0);
begin
  unit : {unit} generic map (TAG_W => 8)
    port map (clk_i => clk, rst_ni => rst_n, valid_i => valid, ready_o => ready, n_i => n, cos_i => cosine,
              tag_i => x"00", valid_o => done, ready_i => '1', y_o => y, tag_o => tag, clamped_o => clamped);
end architecture;
"""
BENCH = """module bench;
    reg clk = 0, rst_n = 0;
    wire done;
    wire [8:0] y;
    highlight h (.clk(clk), .rst_n(rst_n), .valid(1'b1), .n(10'd50), .cosine(18'd64225), .y(y), .done(done));
    always #1 clk = ~clk;
    initial begin #9 rst_n = 1; #200 $display("y %0d done %b", y, done); $finish(0); end
endmodule
"""


def run(*command, folder):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, cwd=folder)
    if done.returncode:
        sys.exit(f"packages_test.py: FAILED: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def vhdl(prefix, folder):
    rtl = prefix / "share/glint/rtl"
    (folder / "user.vhd").write_text(USER.format(unit=UNIT))
    (folder / "bench.v").write_text(BENCH)
    run("ghdl", "-a", rtl / f"generated/{UNIT}_pkg.vhd", "user.vhd", folder=folder)
    text = run("ghdl", "--synth", "--out=verilog", "highlight", folder=folder)
    (folder / "user.v").write_text(re.sub(rf"module {UNIT}\b.*?endmodule\n", "", text, count=1, flags=re.S))
    listing = (rtl / f"generated/{UNIT}.f").read_text().replace("$(GLINT_RTL)", str(rtl))
    (folder / "unit.f").write_text(listing)
    run("iverilog", "-g2005", "-s", "bench", "-o", "bench", "-f", "unit.f", "user.v", "bench.v", folder=folder)
    said = run("vvp", "-n", "bench", folder=folder)
    expected = subprocess.run([prefix / "bin/glint", "eval", "--profile", "p8", "--stdin"], input="50 64225\n",
                              capture_output=True, text=True, check=True).stdout.strip()
    if said != f"y {expected} done 1\n":
        sys.exit(f"packages_test.py: FAILED: VHDL user: '{said}', glint says {expected}")
    print(f"ghdl, iverilog: y {expected}")


def replay(prefix, folder):
    run(prefix / "bin/glint", "vectors", "--profile", "p8", "--count", 1000, "--format", "hex", "-o", "vectors", folder=folder)
    said = run(sys.executable, prefix / "share/glint/bench/replay/replay.py", f"vectors/{UNIT}.hex", folder=folder)
    if said.count("1000 vectors, 0 mismatches") != 2:
        sys.exit(f"packages_test.py: FAILED: installed replay\n{said}")
    print("replay: 1000 vectors, 0 mismatches, twice")


def main():
    prefix = Path(sys.argv[1]).resolve()
    for tools, check in ((("iverilog",), replay), (("ghdl", "iverilog"), vhdl)):
        missing = [tool for tool in tools if not shutil.which(tool)]
        if missing:
            print(f"{check.__name__}: skipped, no {missing[0]}")
            continue
        with tempfile.TemporaryDirectory() as folder:
            check(prefix, Path(folder))


if __name__ == "__main__":
    main()
