// glint_parabola for Lattice ECP5: c0 + (c1 + c2 rho) rho with rho = r / 2^R, each product rounded. 2 MULTIPLIER_STAGES + 2
// clocks, less SAVED.
//
// It takes the place of rtl/blocks/glint_parabola.v in a list of files: same ports, parameters, bits and clocks. One adder
// rounds a product and adds it: c + floor((x + 2^(k-1)) / 2^k) = floor((c 2^k + 2^(k-1) + x) / 2^k). It also adds up the slices of
// a wide one, which takes a clock of its own where there are three.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_parabola #(
    parameter R    = 12,  // fraction bits of the argument, at least 1
    parameter G    = 0,   // fraction bits of c1 and c2 above those of c0 and the value
    parameter V_W  = 25,  // width of c0 and of the value
    parameter C1_W = 22,  // width of c1, signed; at most V_W + G
    parameter C2_W = 16,  // width of c2, signed; at most C1_W
    parameter SAVED = 0,  // clocks that the first product takes less, below MULTIPLIER_STAGES
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

    // rho <= 1, so a product has the magnitude of its coefficient, R bits more, and its top bit repeats the sign. h is within
    // the range of c1 by the owner's choice of C1_W, the value within that of c0.
    wire [C1_W-1:0] c1;     // beside product2
    wire      [R:0] r;      // beside h
    wire  [V_W-1:0] c0;     // beside product1
    reg  [C1_W-1:0] h_q;
    reg   [V_W-1:0] value_q;

    /* verilator lint_off UNUSED */  // the low bits of the sums are those that rounding cuts
    wire   [C2_W+R:0] product2;
    wire  [C1_W+R-1:0] sum2 = {c1, 1'b1, {(R - 1) {1'b0}}} + {{(C1_W - C2_W) {product2[C2_W+R]}}, product2[C2_W+R-1:0]};
    wire [V_W+R+G-1:0] low1, high1;  // product1, or of a wide h those of its two slices
    wire [V_W+R+G-1:0] sum1 = {c0, 1'b1, {(R + G - 1) {1'b0}}} + low1 + high1;
    /* verilator lint_on UNUSED */
    glint_multiplier #(
        .A_W   (C2_W),
        .B_W   (R + 1),
        .SIGNED(1),
        .STAGES(MULTIPLIER_STAGES - SAVED)
    ) multiplier_2 (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (c2_i),
        .b_i      (r_i),
        .product_o(product2)
    );
    generate
        if (C1_W > 18 && MULTIPLIER_STAGES < 3) begin : slices
            wire      [18+R:0] low;
            wire [C1_W-18+R:0] high;
            glint_multiplier #(
                .A_W   (18),
                .B_W   (R + 1),
                .STAGES(MULTIPLIER_STAGES)
            ) multiplier_low (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .a_i      (h_q[17:0]),
                .b_i      (r),
                .product_o(low)
            );
            glint_multiplier #(
                .A_W   (C1_W - 18),
                .B_W   (R + 1),
                .SIGNED(1),
                .STAGES(MULTIPLIER_STAGES)
            ) multiplier_high (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .a_i      (h_q[C1_W-1:18]),
                .b_i      (r),
                .product_o(high)
            );
            assign low1  = {{(V_W + G - 19) {1'b0}}, low};
            assign high1 = {{(V_W + G - C1_W) {high[C1_W-18+R]}}, high[C1_W-19+R:0], 18'd0};
        end else begin : whole
            // The sign is not used where the sum has no more bits than the product.
            // verilator lint_off UNUSED
            wire [C1_W+R:0] product;
            // verilator lint_on UNUSED
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
                .product_o(product)
            );
            assign low1  = {{(V_W + G - C1_W) {product[C1_W+R]}}, product[C1_W+R-1:0]};
            assign high1 = {(V_W + R + G) {1'b0}};
        end
    endgenerate
    glint_delay #(
        .WIDTH (C1_W),
        .STAGES(MULTIPLIER_STAGES - SAVED)
    ) delay_c1 (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (c1_i),
        .data_o  (c1)
    );
    glint_delay #(
        .WIDTH (R + 1),
        .STAGES(MULTIPLIER_STAGES + 1 - SAVED)
    ) delay_r (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (r_i),
        .data_o  (r)
    );
    glint_delay #(
        .WIDTH (V_W),
        .STAGES(2 * MULTIPLIER_STAGES + 1 - SAVED)
    ) delay_c0 (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (c0_i),
        .data_o  (c0)
    );

    always @(posedge clk_i) begin
        if (enable_i) begin
            h_q     <= sum2[C1_W+R-1:R];
            value_q <= sum1[V_W+R+G-1:R+G];
        end
    end
    assign value_o = value_q;

endmodule

`default_nettype wire
