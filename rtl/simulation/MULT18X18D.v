// MULT18X18D: what a simulation needs of the multiplier block of Lattice ECP5. Synthesis has its own; do not give it this.
//
// It models the product of 18 x 18 bits, signed or not by SIGNEDA and SIGNEDB, and the registers of operands, middle and
// product: each is there when its ..._CLK is "CLK0", moves at the rising edge of CLK0 when CE0 is 1, and starts unknown.
// It has no reset (RST0 has to be 0), no other clocks, no cascade, no third operand, and no time.
// The macro NETLIST adds the pins of the third operand, which Yosys ties to 0.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module MULT18X18D #(
    parameter REG_INPUTA_CLK   = "NONE",
    parameter REG_INPUTB_CLK   = "NONE",
    parameter REG_PIPELINE_CLK = "NONE",
    parameter REG_OUTPUT_CLK   = "NONE"
) (
    input  wire A0, A1, A2, A3, A4, A5, A6, A7, A8,
    input  wire A9, A10, A11, A12, A13, A14, A15, A16, A17,
    input  wire B0, B1, B2, B3, B4, B5, B6, B7, B8,
    input  wire B9, B10, B11, B12, B13, B14, B15, B16, B17,
    input  wire SIGNEDA, SIGNEDB,
    /* verilator lint_off UNUSED */
    input  wire SOURCEA, SOURCEB, RST0,
`ifdef NETLIST
    input  wire C0, C1, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, C12, C13, C14, C15, C16, C17,
`endif
    /* verilator lint_on UNUSED */
    input  wire CLK0, CE0,
    output wire P0, P1, P2, P3, P4, P5, P6, P7, P8,
    output wire P9, P10, P11, P12, P13, P14, P15, P16, P17,
    output wire P18, P19, P20, P21, P22, P23, P24, P25, P26,
    output wire P27, P28, P29, P30, P31, P32, P33, P34, P35
);

    wire [17:0] a_now = {
        A17, A16, A15, A14, A13, A12, A11, A10, A9,
        A8, A7, A6, A5, A4, A3, A2, A1, A0
    };
    wire [17:0] b_now = {
        B17, B16, B15, B14, B13, B12, B11, B10, B9,
        B8, B7, B6, B5, B4, B3, B2, B1, B0
    };
    reg  [17:0] a_q, b_q;
    reg  [35:0] middle_q, product_q;

    wire        [17:0] a = REG_INPUTA_CLK == "CLK0" ? a_q : a_now;
    wire        [17:0] b = REG_INPUTB_CLK == "CLK0" ? b_q : b_now;
    wire signed [35:0] wide_a = {{18{SIGNEDA & a[17]}}, a};
    wire signed [35:0] wide_b = {{18{SIGNEDB & b[17]}}, b};
    wire        [35:0] now = wide_a * wide_b;
    wire        [35:0] middle = REG_PIPELINE_CLK == "CLK0" ? middle_q : now;
    always @(posedge CLK0) begin
        if (CE0) begin
            a_q       <= a_now;
            b_q       <= b_now;
            middle_q  <= now;
            product_q <= middle;
        end
    end
    assign {
        P35, P34, P33, P32, P31, P30, P29, P28, P27,
        P26, P25, P24, P23, P22, P21, P20, P19, P18,
        P17, P16, P15, P14, P13, P12, P11, P10, P9,
        P8, P7, P6, P5, P4, P3, P2, P1, P0
    } = REG_OUTPUT_CLK == "CLK0" ? product_q : middle;

endmodule

`default_nettype wire
