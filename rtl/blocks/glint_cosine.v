// glint_cosine: the cosine of the angle between two vectors, one result a clock. 2 MULTIPLIER_STAGES + 2 F + 12 clocks.
//
// The arithmetic is docs/effects/cosine.md; a value here carries the name that it has there. No valid bits and no reset: its
// owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_cosine #(
    parameter W                 = 16,  // bits of a component, 8 .. 18
    parameter F                 = 20,  // fraction bits of the cosine, W - 1 .. 29
    parameter MULTIPLIER_STAGES = 1    // clocks of a product, 1 .. 4
) (
    input  wire           clk_i,
    input  wire           enable_i,
    input  wire [3*W-1:0] a_i,      // three signed components, side by side
    input  wire [3*W-1:0] b_i,
    output wire   [F+1:0] cosine_o, // signed, -2^F .. 2^F; 0 where a or b is 0
    output wire           none_o    // a or b is 0
);

    localparam K  = F + 2;              // bits of the root
    localparam UP = 2 * F + 3 - 2 * W;  // zeros of x below p 4^j

    // p 4^j and s 16^j.
    wire   [2*W:0] p_up_first;
    /* verilator lint_off UNUSED */  // of s, what has no place in the root
    wire [4*W-1:0] s_up;
    /* verilator lint_on UNUSED */
    wire           none;
    glint_vectors #(
        .W                (W),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) vectors (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .a_i     (a_i),
        .b_i     (b_i),
        .p_o     (p_up_first),
        .s_o     (s_up),
        .none_o  (none)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(2 * F + 4)
    ) delay_none (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (none),
        .data_o  (none_o)
    );

    // r = floor(sqrt(s 16^j 2^(2K-4W)))
    wire [2*K-1:0] radicand;
    generate
        if (4 * W >= 2 * K) begin : cut
            assign radicand = s_up[4*W-1:4*W-2*K];
        end else begin : pad
            assign radicand = {s_up, {(2 * K - 4 * W) {1'b0}}};
        end
    endgenerate
    wire [K-1:0] r;
    wire [2*W:0] p_up;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_sqrt #(
        .Y_W(K)
    ) root (
        .clk_i      (clk_i),
        .enable_i   (enable_i),
        .radicand_i (radicand),
        .root_o     (r),
        .remainder_o()
    );
    /* verilator lint_on PINCONNECTEMPTY */
    glint_delay #(
        .WIDTH (2 * W + 1),
        .STAGES(K)
    ) delay_p_up (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (p_up_first),
        .data_o  (p_up)
    );

    // c, nearest to p 4^j 2^UP / (2 r + 1)
    glint_nearest #(
        .ROOT_W(K),
        .Q_W   (F + 1)
    ) nearest (
        .clk_i     (clk_i),
        .enable_i  (enable_i),
        .x_i       ({p_up, {UP{1'b0}}}),
        .root_i    (r),
        .quotient_o(cosine_o)
    );

endmodule

`default_nettype wire
