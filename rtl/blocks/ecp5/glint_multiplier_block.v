// glint_multiplier_block for Lattice ECP5: a product of 18 x 18 bits in one MULT18X18D. STAGES clocks: 1, a register of
// the product in the block; 2, also of the operands; each further one is a register of logic cells after it, since the way
// out of a block is long; 0, none.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_multiplier_block #(
    parameter SIGNED = 0,  // 1: a is signed; b is unsigned
    parameter STAGES = 1   // 0 .. 4
) (
    input  wire        clk_i,
    input  wire        enable_i,
    input  wire [17:0] a_i,
    input  wire [17:0] b_i,
    output wire [35:0] product_o
);

    wire [35:0] now;
    /* verilator lint_off PINMISSING */  // the third operand, cascades of operands, the other clocks
    MULT18X18D #(
        .REG_INPUTA_CLK(STAGES > 1 ? "CLK0" : "NONE"),
        .REG_INPUTB_CLK(STAGES > 1 ? "CLK0" : "NONE"),
        .REG_OUTPUT_CLK(STAGES > 0 ? "CLK0" : "NONE")
    ) multiplier (
        .CLK0(clk_i), .CE0(enable_i), .RST0(1'b0),
        .SIGNEDA(SIGNED != 0), .SIGNEDB(1'b0), .SOURCEA(1'b0), .SOURCEB(1'b0),
        .A0(a_i[0]), .A1(a_i[1]), .A2(a_i[2]), .A3(a_i[3]), .A4(a_i[4]), .A5(a_i[5]),
        .A6(a_i[6]), .A7(a_i[7]), .A8(a_i[8]), .A9(a_i[9]), .A10(a_i[10]), .A11(a_i[11]),
        .A12(a_i[12]), .A13(a_i[13]), .A14(a_i[14]), .A15(a_i[15]), .A16(a_i[16]), .A17(a_i[17]),
        .B0(b_i[0]), .B1(b_i[1]), .B2(b_i[2]), .B3(b_i[3]), .B4(b_i[4]), .B5(b_i[5]),
        .B6(b_i[6]), .B7(b_i[7]), .B8(b_i[8]), .B9(b_i[9]), .B10(b_i[10]), .B11(b_i[11]),
        .B12(b_i[12]), .B13(b_i[13]), .B14(b_i[14]), .B15(b_i[15]), .B16(b_i[16]), .B17(b_i[17]),
        .P0(now[0]), .P1(now[1]), .P2(now[2]), .P3(now[3]), .P4(now[4]), .P5(now[5]),
        .P6(now[6]), .P7(now[7]), .P8(now[8]), .P9(now[9]), .P10(now[10]), .P11(now[11]),
        .P12(now[12]), .P13(now[13]), .P14(now[14]), .P15(now[15]), .P16(now[16]), .P17(now[17]),
        .P18(now[18]), .P19(now[19]), .P20(now[20]), .P21(now[21]), .P22(now[22]), .P23(now[23]),
        .P24(now[24]), .P25(now[25]), .P26(now[26]), .P27(now[27]), .P28(now[28]), .P29(now[29]),
        .P30(now[30]), .P31(now[31]), .P32(now[32]), .P33(now[33]), .P34(now[34]), .P35(now[35])
    );
    /* verilator lint_on PINMISSING */
    glint_delay #(
        .WIDTH (36),
        .STAGES(STAGES > 2 ? STAGES - 2 : 0)
    ) delay (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (now),
        .data_o  (product_o)
    );

endmodule

`default_nettype wire
