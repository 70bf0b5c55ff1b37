// glint_signed_multiplier for Lattice ECP5: product = a * b of two signed numbers, in one MULT18X18D.
//
// It takes the place of rtl/blocks/glint_signed_multiplier.v in a list of files: same ports, parameters, bits and clocks.
// The registers are in the block; from the third clock on they are logic cells after it.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_signed_multiplier #(
    parameter WIDTH  = 16,  // bits of a and of b, 2 .. 18
    parameter STAGES = 1    // 1 .. 4
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire   [WIDTH-1:0] a_i,
    input  wire   [WIDTH-1:0] b_i,
    output wire [2*WIDTH-1:0] product_o
);

    wire [18:0] a = {{(19 - WIDTH) {a_i[WIDTH-1]}}, a_i};
    wire [18:0] b = {{(19 - WIDTH) {b_i[WIDTH-1]}}, b_i};
    /* verilator lint_off UNUSED */  // copies of the sign
    wire [35:0] now;
    wire        unused = a[18] & b[18];
    /* verilator lint_on UNUSED */
    /* verilator lint_off PINMISSING */  // the third operand, cascades of operands, the other clocks
    MULT18X18D #(
        .REG_INPUTA_CLK(STAGES > 1 ? "CLK0" : "NONE"),
        .REG_INPUTB_CLK(STAGES > 1 ? "CLK0" : "NONE"),
        .REG_OUTPUT_CLK("CLK0")
    ) multiplier (
        .CLK0(clk_i), .CE0(enable_i), .RST0(1'b0),
        .SIGNEDA(1'b1), .SIGNEDB(1'b1), .SOURCEA(1'b0), .SOURCEB(1'b0),
        .A0(a[0]), .A1(a[1]), .A2(a[2]), .A3(a[3]), .A4(a[4]), .A5(a[5]),
        .A6(a[6]), .A7(a[7]), .A8(a[8]), .A9(a[9]), .A10(a[10]), .A11(a[11]),
        .A12(a[12]), .A13(a[13]), .A14(a[14]), .A15(a[15]), .A16(a[16]), .A17(a[17]),
        .B0(b[0]), .B1(b[1]), .B2(b[2]), .B3(b[3]), .B4(b[4]), .B5(b[5]),
        .B6(b[6]), .B7(b[7]), .B8(b[8]), .B9(b[9]), .B10(b[10]), .B11(b[11]),
        .B12(b[12]), .B13(b[13]), .B14(b[14]), .B15(b[15]), .B16(b[16]), .B17(b[17]),
        .P0(now[0]), .P1(now[1]), .P2(now[2]), .P3(now[3]), .P4(now[4]), .P5(now[5]),
        .P6(now[6]), .P7(now[7]), .P8(now[8]), .P9(now[9]), .P10(now[10]), .P11(now[11]),
        .P12(now[12]), .P13(now[13]), .P14(now[14]), .P15(now[15]), .P16(now[16]), .P17(now[17]),
        .P18(now[18]), .P19(now[19]), .P20(now[20]), .P21(now[21]), .P22(now[22]), .P23(now[23]),
        .P24(now[24]), .P25(now[25]), .P26(now[26]), .P27(now[27]), .P28(now[28]), .P29(now[29]),
        .P30(now[30]), .P31(now[31]), .P32(now[32]), .P33(now[33]), .P34(now[34]), .P35(now[35])
    );
    /* verilator lint_on PINMISSING */
    glint_delay #(
        .WIDTH (2 * WIDTH),
        .STAGES(STAGES > 2 ? STAGES - 2 : 0)
    ) delay_product (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (now[2*WIDTH-1:0]),
        .data_o  (product_o)
    );

endmodule

`default_nettype wire
