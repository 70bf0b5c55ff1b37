// CCU2C: what a simulation needs of the carry cell of Lattice ECP5, two LUTs and a carry through both. Synthesis has its own;
// do not give it this.
//
// A LUT is addressed by {D, C, B, A}. Where it is 0 its bit makes a carry, which is the LUT at {0, 0, B, A}; where it is 1 it
// passes one on. INJECT1_0 and INJECT1_1 have to be "NO". It has no time.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module CCU2C #(
    parameter [15:0] INIT0     = 16'h0000,
    parameter [15:0] INIT1     = 16'h0000,
    /* verilator lint_off UNUSED */
    parameter        INJECT1_0 = "NO",
    parameter        INJECT1_1 = "NO"
    /* verilator lint_on UNUSED */
) (
    input  wire CIN, A0, B0, C0, D0, A1, B1, C1, D1,
    output wire S0, S1, COUT
);

    wire lut0 = INIT0[{D0, C0, B0, A0}];
    wire lut1 = INIT1[{D1, C1, B1, A1}];
    wire between = lut0 ? CIN : INIT0[{2'b00, B0, A0}];
    assign S0   = lut0 ^ CIN;
    assign S1   = lut1 ^ between;
    assign COUT = lut1 ? between : INIT1[{2'b00, B1, A1}];

endmodule

`default_nettype wire
