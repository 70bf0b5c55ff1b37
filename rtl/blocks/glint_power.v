// glint_power: a power of a fraction r = 0 .. 1 by repeated squaring. (SQUARES + 1) times
// MULTIPLIER_STAGES + 1 clocks.
//
//   r2 = rnd(r * r, S), r4 = rnd(r2 * r2, S), ... SQUARES of them, and y = rnd(left * right, 2 S - O) with
//   power_i   0          1        2      3       4        5       6        7
//   product   the last,  r * 1.0  r * r  r2 * r  r2 * r2  r4 * r  r4 * r2  r4 * r4
//             squared
//
// so that y is r^(2^(SQUARES + 1)), or the power 1 .. 6 or 8. Used by the lobes that take powers; no valid bits and no
// reset: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_power #(
    parameter S       = 17,  // fraction bits of r and its powers
    parameter O       = 12,  // fraction bits of y; O < 2 S
    parameter SQUARES = 2,   // 0 .. 5; at least 2 with CHOICE
    parameter CHOICE  = 1,   // 0: power_i is not read and counts as 0
    parameter MULTIPLIER_STAGES = 1
) (
    input  wire       clk_i,
    input  wire       enable_i,
    input  wire [S:0] r_i,        // 0 .. 2^S
    input  wire [2:0] power_i,    // beside r_i
    input  wire       negative_i, // y is 0: beside the last step
    output wire [O:0] y_o         // 0 .. 2^O
);

    // stage i: r^(2^i), with the lower powers that a product can need beside it.
    genvar i;
    generate
        for (i = 0; i <= SQUARES; i = i + 1) begin : stage
            wire [S:0] last;
            /* verilator lint_off UNUSED */  // without CHOICE
            wire [S:0] r1, r2, r4;
            wire [2:0] power;
            /* verilator lint_on UNUSED */
            if (i == 0) begin : first
                assign last  = r_i;
                assign r1    = r_i;
                assign r2    = {(S + 1) {1'b0}};
                assign r4    = {(S + 1) {1'b0}};
                assign power = power_i;
            end else begin : rest
                wire [S:0] r2_late, r4_late;
                glint_square #(
                    .S                (S),
                    .R                (S),
                    .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
                ) square (
                    .clk_i   (clk_i),
                    .enable_i(enable_i),
                    .x_i     (stage[i-1].last),
                    .y_o     (last)
                );
                if (CHOICE != 0) begin : late
                    glint_delay #(
                        .WIDTH (3 * S + 6),
                        .STAGES(MULTIPLIER_STAGES + 1)
                    ) delay (
                        .clk_i   (clk_i),
                        .enable_i(enable_i),
                        .data_i  ({stage[i-1].power, stage[i-1].r1, stage[i-1].r2, stage[i-1].r4}),
                        .data_o  ({power, r1, r2_late, r4_late})
                    );
                end else begin : none
                    assign {power, r1, r2_late, r4_late} = {(3 * S + 6) {1'b0}};
                end
                assign r2 = i == 1 ? last : r2_late;
                assign r4 = i == 2 ? last : r4_late;
            end
        end
    endgenerate

    wire [S:0] last = stage[SQUARES].last;
    wire [S:0] left, right;
    generate
        if (CHOICE != 0) begin : chosen
            wire [2:0] power = stage[SQUARES].power;
            wire [S:0] r1 = stage[SQUARES].r1;
            wire [S:0] r2 = stage[SQUARES].r2;
            wire [S:0] r4 = stage[SQUARES].r4;

            wire takes_r  = power == 3'd2 || power == 3'd3 || power == 3'd5;
            wire takes_r2 = power == 3'd4 || power == 3'd6;
            assign left  = power == 3'd0 ? last : power <= 3'd2 ? r1 : power <= 3'd4 ? r2 : r4;
            assign right = power == 3'd0 ? last :
                           power == 3'd1 ? {1'b1, {S{1'b0}}} : takes_r ? r1 : takes_r2 ? r2 : r4;
        end else begin : square
            assign left  = last;
            assign right = last;
        end
    endgenerate

    // The product is at most 2^(2S); with the half that rounds it still fits 2 S + 1 bits.
    localparam CUT = 2 * S - O;

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
        .a_i      (left),
        .b_i      (right),
        .product_o(product)
    );

    reg [O:0] y_q;
    always @(posedge clk_i) if (enable_i) y_q <= negative_i ? {(O + 1) {1'b0}} : sum[2*S:CUT];
    assign y_o = y_q;

endmodule

`default_nettype wire
