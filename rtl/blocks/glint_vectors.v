// glint_vectors: what two vectors make of each other: p = a.b and s = |a|^2 |b|^2, moved up together, one result a clock.
// 2 MULTIPLIER_STAGES + 8 clocks.
//
// The arithmetic is docs/effects/cosine.md; a value here carries the name that it has there. No valid bits and no reset: its
// owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_vectors #(
    parameter W                 = 16,  // bits of a component, 8 .. 18
    parameter MULTIPLIER_STAGES = 1    // clocks of a product, 1 .. 4
) (
    input  wire           clk_i,
    input  wire           enable_i,
    input  wire [3*W-1:0] a_i,      // three signed components, side by side
    input  wire [3*W-1:0] b_i,
    output wire   [2*W:0] p_o,      // p 4^j, signed
    output wire [4*W-1:0] s_o,      // s 16^j, 2^(4W-4) and above; 0 where a or b is 0
    output wire           none_o    // a or b is 0
);

    localparam LEVELS = W > 16 ? 5 : W > 8 ? 4 : 3;  // of the shifts: ceil(log2 W)

    // p, and the squares of the lengths, at most 3 2^(2W-2): 2 W bits.
    wire [2*W:0] p;
    /* verilator lint_off UNUSED */  // the bit above, 0
    wire [2*W:0] aa, bb;
    /* verilator lint_on UNUSED */
    glint_dot_product #(
        .WIDTH            (W),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) dot_ab (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .a_i     (a_i),
        .b_i     (b_i),
        .dot_o   (p)
    );
    glint_dot_product #(
        .WIDTH            (W),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) dot_aa (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .a_i     (a_i),
        .b_i     (a_i),
        .dot_o   (aa)
    );
    glint_dot_product #(
        .WIDTH            (W),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) dot_bb (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .a_i     (b_i),
        .b_i     (b_i),
        .dot_o   (bb)
    );

    // s = aa bb of four products of halves of W bits: 4 W bits.
    wire [2*W-1:0] low, cross_1, cross_2, high;
    glint_multiplier #(
        .A_W   (W),
        .B_W   (W),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_low (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (aa[W-1:0]),
        .b_i      (bb[W-1:0]),
        .product_o(low)
    );
    glint_multiplier #(
        .A_W   (W),
        .B_W   (W),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_cross_1 (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (aa[2*W-1:W]),
        .b_i      (bb[W-1:0]),
        .product_o(cross_1)
    );
    glint_multiplier #(
        .A_W   (W),
        .B_W   (W),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_cross_2 (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (aa[W-1:0]),
        .b_i      (bb[2*W-1:W]),
        .product_o(cross_2)
    );
    glint_multiplier #(
        .A_W   (W),
        .B_W   (W),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_high (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (aa[2*W-1:W]),
        .b_i      (bb[2*W-1:W]),
        .product_o(high)
    );
    reg [4*W-1:0] outer_q, s_q;
    reg   [2*W:0] cross_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            outer_q <= {high, low};
            cross_q <= {1'b0, cross_1} + {1'b0, cross_2};
            s_q     <= {outer_q[4*W-1:W] + {{(W - 1) {1'b0}}, cross_q}, outer_q[W-1:0]};
        end
    end

    // j: how many of the W nibbles of s are 0 from the top; of s = 0 any. Nibbles are looked at, then counted.
    function [4:0] zeros(input [W-1:0] x);
        integer k;
        begin
            zeros = 5'd0;
            for (k = 0; k < W; k = k + 1) if (x[k]) zeros = W[4:0] - 5'd1 - k[4:0];
        end
    endfunction
    reg   [W-1:0] some_q;
    reg [4*W-1:0] s_q2, s_q3;
    /* verilator lint_off UNUSED */  // above LEVELS
    reg     [4:0] j_q;
    /* verilator lint_on UNUSED */
    integer       k;
    always @(posedge clk_i) begin
        if (enable_i) begin
            for (k = 0; k < W; k = k + 1) some_q[k] <= |s_q[4*k+:4];
            s_q2 <= s_q;
            j_q  <= zeros(some_q);
            s_q3 <= s_q2;
        end
    end
    wire none = ~|some_q;
    glint_delay #(
        .WIDTH (1),
        .STAGES(3)
    ) delay_none (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (none),
        .data_o  (none_o)
    );
    wire [2*W:0] p_late;
    glint_delay #(
        .WIDTH (2 * W + 1),
        .STAGES(MULTIPLIER_STAGES + 4)
    ) delay_p (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (p),
        .data_o  (p_late)
    );

    // s 16^j and p 4^j, by 4 nibbles and more in one clock, by 2 and 1 in the next. |p| 4^j is below 2^(2W), since p^2 <= s.
    wire [4*W-1:0] s_far  = s_q3 << {j_q[LEVELS-1:2], 4'd0};
    wire   [2*W:0] p_far  = p_late << {j_q[LEVELS-1:2], 3'd0};
    reg  [4*W-1:0] s_far_q, s_up_q;
    reg    [2*W:0] p_far_q, p_up_q;
    reg      [1:0] near_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            s_far_q <= s_far;
            p_far_q <= p_far;
            near_q  <= j_q[1:0];
            s_up_q  <= s_far_q << {near_q, 2'd0};
            p_up_q  <= p_far_q << {near_q, 1'd0};
        end
    end
    assign p_o = p_up_q;
    assign s_o = s_up_q;

endmodule

`default_nettype wire
