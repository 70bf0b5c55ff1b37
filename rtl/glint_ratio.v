// glint_ratio: Schlick's fraction s = C / D, D = n 2^F - (n-1) C, as floor(C 2^S / D). Latency S + 3 clocks.
//
// Used by the lobes that are functions of s; a value here carries the name that it has in docs/contract.md. No valid
// bits and no reset: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none

module glint_ratio #(
    parameter F = 18,  // fraction bits of the cosine
    parameter S = 15   // fraction bits of the quotient, at least 1
) (
    input  wire       clk_i,
    input  wire       enable_i,
    input  wire [9:0] n_i,        // 1 .. 1023
    input  wire [F:0] cosine_i,   // C: 0 .. 2^F
    input  wire [F:0] distance_i, // 2^F - C
    output wire [S:0] quotient_o  // 0 .. 2^S
);

    // D = C + n (2^F - C). n (2^F - C) <= 1023 2^F, and D <= n 2^F as well, since D falls when C grows: F + 10 bits.
    localparam D_W = F + 10;

    reg [D_W-1:0] scaled_q;
    reg     [F:0] cosine_scaled_q;
    reg [D_W-1:0] divisor_q;
    reg     [F:0] cosine_divisor_q;
    always @(posedge clk_i) begin
        if (enable_i) begin
            scaled_q         <= {{(D_W - 10) {1'b0}}, n_i} * {{(D_W - F - 1) {1'b0}}, distance_i};
            cosine_scaled_q  <= cosine_i;
            divisor_q        <= scaled_q + {{(D_W - F - 1) {1'b0}}, cosine_scaled_q};
            cosine_divisor_q <= cosine_scaled_q;
        end
    end

    // C <= D, so the quotient is at most 2^S: S + 1 bits, and C 2^S < D 2^(S+1) as the divider asks.
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(F + 1 + S),
        .Y_W(D_W),
        .Q_W(S + 1)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (enable_i),
        .dividend_i ({cosine_divisor_q, {S{1'b0}}}),
        .divisor_i  (divisor_q),
        .quotient_o (quotient_o),
        .remainder_o(),
        .divisor_o  ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

endmodule

`default_nettype wire
