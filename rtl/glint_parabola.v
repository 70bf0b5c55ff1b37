// glint_parabola: c0 + (c1 + c2 rho) rho with rho = r / 2^R, each product rounded. Latency 4 clocks.
//
// The arithmetic is the section "Quadratic pieces" of docs/exp-log.md; a value here carries the name that it has there.
// No valid bits and no reset: its owner counts clocks.

`default_nettype none

module glint_parabola #(
    parameter R    = 12,  // fraction bits of the argument, at least 1
    parameter G    = 0,   // fraction bits of c1 and c2 above those of c0 and the value
    parameter V_W  = 25,  // width of c0 and of the value
    parameter C1_W = 22,  // width of c1, signed; at most V_W + G
    parameter C2_W = 16   // width of c2, signed; at most C1_W
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

    reg  signed [P2_W-1:0] product2_q;
    reg  signed [P1_W-1:0] product1_q;
    reg  signed [C1_W-1:0] c1_q, h_q;
    reg          [V_W-1:0] c0_2_q, c0_1_q, c0_0_q, value_q;
    reg              [R:0] r_2_q, r_1_q;

    localparam signed [P2_W-1:0] HALF2 = {{(P2_W - R) {1'b0}}, 1'b1, {(R - 1) {1'b0}}};
    localparam signed [P1_W-1:0] HALF1 = {{(P1_W - R - G) {1'b0}}, 1'b1, {(R + G - 1) {1'b0}}};

    /* verilator lint_off UNUSED */  // the low bits of the sums are those that rounding cuts
    wire signed [P2_W-1:0] sum2 = product2_q + HALF2;
    wire signed [P1_W-1:0] sum1 = product1_q + HALF1;
    /* verilator lint_on UNUSED */

    // Operands at the width of their product, signed.
    wire signed [P2_W-1:0] c2_wide = {{R{c2_i[C2_W-1]}}, c2_i};
    wire signed [P2_W-1:0] r2_wide = {{(P2_W - R - 1) {1'b0}}, r_i};
    wire signed [P1_W-1:0] h_wide  = {{R{h_q[C1_W-1]}}, h_q};
    wire signed [P1_W-1:0] r1_wide = {{(P1_W - R - 1) {1'b0}}, r_1_q};

    wire [C1_W-1:0] rounded2 = {{(C1_W - C2_W) {sum2[P2_W-1]}}, sum2[P2_W-1:R]};
    wire  [V_W-1:0] rounded1 = {{(V_W + G - C1_W) {sum1[P1_W-1]}}, sum1[P1_W-1:R+G]};

    always @(posedge clk_i) begin
        if (enable_i) begin
            product2_q <= c2_wide * r2_wide;
            c1_q       <= c1_i;
            c0_2_q     <= c0_i;
            r_2_q      <= r_i;

            h_q        <= c1_q + rounded2;
            c0_1_q     <= c0_2_q;
            r_1_q      <= r_2_q;

            product1_q <= h_wide * r1_wide;
            c0_0_q     <= c0_1_q;

            value_q    <= c0_0_q + rounded1;
        end
    end
    assign value_o = value_q;

endmodule

`default_nettype wire
