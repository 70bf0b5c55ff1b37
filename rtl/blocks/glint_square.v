// glint_square: y = rnd(x^2, 2 S - R): the square of a fraction 0 .. 1 at S bits, rounded to R bits. MULTIPLIER_STAGES + 1
// clocks.
//
// No valid bits and no reset: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_square #(
    parameter S = 17,  // fraction bits of x
    parameter R = 17,  // fraction bits of y; R < 2 S
    parameter MULTIPLIER_STAGES = 1
) (
    input  wire       clk_i,
    input  wire       enable_i,
    input  wire [S:0] x_i,      // 0 .. 2^S
    output wire [R:0] y_o       // 0 .. 2^R
);

    localparam CUT = 2 * S - R;

    // x^2 <= 2^(2S); with the half that rounds it still fits 2 S + 1 bits.
    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts; the product's top bit is 0
    wire [2*S+1:0] product;
    wire   [2*S:0] sum = product[2*S:0] + {{(2 * S + 1 - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */

    glint_multiplier #(
        .A_W   (S + 1),
        .B_W   (S + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (x_i),
        .b_i      (x_i),
        .product_o(product)
    );

    reg [R:0] y_q;
    always @(posedge clk_i) if (enable_i) y_q <= sum[2*S:CUT];
    assign y_o = y_q;

endmodule

`default_nettype wire
