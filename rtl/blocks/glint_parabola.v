// glint_parabola: c0 + (c1 + c2 rho) rho with rho = r / 2^R, each product rounded. 2 MULTIPLIER_STAGES + 2
// clocks.
//
// The arithmetic is the section "Quadratic pieces" of docs/exp-log.md; a value here carries the name that it has there.
// No valid bits and no reset: its owner counts clocks.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_parabola #(
    parameter R    = 12,  // fraction bits of the argument, at least 1
    parameter G    = 0,   // fraction bits of c1 and c2 above those of c0 and the value
    parameter V_W  = 25,  // width of c0 and of the value
    parameter C1_W = 22,  // width of c1, signed; at most V_W + G
    parameter C2_W = 16,  // width of c2, signed; at most C1_W
    parameter MULTIPLIER_STAGES = 1
) (
    input  wire            clk_i,
    input  wire            enable_i,
    input  wire      [R:0] r_i,      // 0 .. 2^R
    input  wire  [V_W-1:0] c0_i,
    input  wire [C1_W-1:0] c1_i,
    input  wire [C2_W-1:0] c2_i,
    output wire  [V_W-1:0] value_o
);

    // rho <= 1, so a product has the magnitude of its coefficient: R bits more, and the half that rounds it does not
    // change its sign bit. h is within the range of c1 by the owner's choice of C1_W, the value within that of c0.
    localparam P2_W = C2_W + R;
    localparam P1_W = C1_W + R;

    localparam [P2_W-1:0] HALF2 = {{(P2_W - R) {1'b0}}, 1'b1, {(R - 1) {1'b0}}};
    localparam [P1_W-1:0] HALF1 = {{(P1_W - R - G) {1'b0}}, 1'b1, {(R + G - 1) {1'b0}}};

    wire [C1_W-1:0] c1;     // beside product2
    wire      [R:0] r;      // beside h
    wire  [V_W-1:0] c0;     // beside product1
    reg  [C1_W-1:0] h_q;
    reg   [V_W-1:0] value_q;

    /* verilator lint_off UNUSED */  // the low bits of the sums are those that rounding cuts; a product's top bit repeats
    wire     [C2_W+R:0] product2;
    wire     [C1_W+R:0] product1;
    wire     [P2_W-1:0] sum2 = product2[P2_W-1:0] + HALF2;
    wire     [P1_W-1:0] sum1 = product1[P1_W-1:0] + HALF1;
    /* verilator lint_on UNUSED */

    wire [C1_W-1:0] rounded2 = {{(C1_W - C2_W) {sum2[P2_W-1]}}, sum2[P2_W-1:R]};
    wire  [V_W-1:0] rounded1 = {{(V_W + G - C1_W) {sum1[P1_W-1]}}, sum1[P1_W-1:R+G]};

    glint_multiplier #(
        .A_W   (C2_W),
        .B_W   (R + 1),
        .SIGNED(1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_2 (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (c2_i),
        .b_i      (r_i),
        .product_o(product2)
    );
    glint_multiplier #(
        .A_W   (C1_W),
        .B_W   (R + 1),
        .SIGNED(1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_1 (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (h_q),
        .b_i      (r),
        .product_o(product1)
    );
    glint_delay #(
        .WIDTH (C1_W),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_c1 (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (c1_i),
        .data_o  (c1)
    );
    glint_delay #(
        .WIDTH (R + 1),
        .STAGES(MULTIPLIER_STAGES + 1)
    ) delay_r (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (r_i),
        .data_o  (r)
    );
    glint_delay #(
        .WIDTH (V_W),
        .STAGES(2 * MULTIPLIER_STAGES + 1)
    ) delay_c0 (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (c0_i),
        .data_o  (c0)
    );

    always @(posedge clk_i) begin
        if (enable_i) begin
            h_q     <= c1 + rounded2;
            value_q <= c0 + rounded1;
        end
    end
    assign value_o = value_q;

endmodule

`default_nettype wire
