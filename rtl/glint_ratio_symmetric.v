// glint_ratio_symmetric: t = (1 + c) / ((1 + c) + 2 n (1 - c)), as floor((2^F + C) 2^S / D) with
// D = 2^F + C + 2 n (2^F - C). Latency S + 3 clocks.
//
// The sibling of glint_ratio, for the lobes that are functions of t. No valid bits and no reset: its owner counts
// clocks. A value here carries the name that it has in docs/lobes/polynomial.md.

`default_nettype none

module glint_ratio_symmetric #(
    parameter F = 18,  // fraction bits of the cosine
    parameter S = 15   // fraction bits of the quotient, at least 1
) (
    input  wire       clk_i,
    input  wire       enable_i,
    input  wire [9:0] n_i,        // 1 .. 1023
    input  wire [F:0] cosine_i,   // C: 0 .. 2^F
    input  wire [F:0] distance_i, // 2^F - C
    output wire [S:0] quotient_o  // 1 .. 2^S
);

    // 2^F + C <= 2^(F+1): F + 2 bits. D falls when C grows, from (2 n + 1) 2^F <= 2047 2^F: F + 11 bits, and so has
    // 2 n (2^F - C) <= 2046 2^F.
    localparam A_W = F + 2;
    localparam D_W = F + 11;

    reg [D_W-2:0] scaled_q;  // n (2^F - C)
    reg [A_W-1:0] numerator_scaled_q;
    reg [D_W-1:0] divisor_q;
    reg [A_W-1:0] numerator_divisor_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            scaled_q            <= {{F{1'b0}}, n_i} * {{(D_W - F - 2) {1'b0}}, distance_i};
            numerator_scaled_q  <= {2'b01, {F{1'b0}}} + {1'b0, cosine_i};
            divisor_q           <= {scaled_q, 1'b0} + {{(D_W - A_W) {1'b0}}, numerator_scaled_q};
            numerator_divisor_q <= numerator_scaled_q;
        end
    end

    // The numerator is at most D, so the quotient is at most 2^S: S + 1 bits, as the divider asks.
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(A_W + S),
        .Y_W(D_W),
        .Q_W(S + 1)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (enable_i),
        .dividend_i ({numerator_divisor_q, {S{1'b0}}}),
        .divisor_i  (divisor_q),
        .quotient_o (quotient_o),
        .remainder_o(),
        .divisor_o  ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

endmodule

`default_nettype wire
