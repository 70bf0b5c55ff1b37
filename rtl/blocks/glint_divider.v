// glint_divider: quotient = floor(dividend / divisor), by the divider that DIVIDER names; all give the same bits.
//
// Contract, with integers: for 0 <= dividend < divisor * 2^Q_W and divisor > 0,
//   dividend = divisor * quotient + remainder   and   0 <= remainder < divisor.
// Outside that domain the outputs are unspecified. No valid bits and no reset: its owner counts clocks; glint_ports says
// how many. All but the iterative one take new operands every clock. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_divider #(
    parameter X_W            = 34,  // dividend bits; Q_W < X_W <= Y_W + Q_W
    parameter Y_W            = 28,  // divisor bits
    parameter Q_W            = 16,  // quotient bits, at least 2
    parameter DIVIDER        = 0,   // 0 restoring, 1 radix4, 2 iterative, 3 reciprocal
    parameter REGISTER_EVERY = 1,   // restoring, radix4: rows in a clock
    parameter MULTIPLIER_STAGES = 1,  // reciprocal: clocks of a product
    parameter ZEROS          = Y_W - 1,  // reciprocal: most leading zeros of a divisor
    parameter BESIDE_W       = 1    // bits of what goes with the operands
) (
    input  wire                clk_i,
    input  wire                enable_i,
    /* verilator lint_off UNUSED */
    input  wire                start_i,     // iterative: begin with these operands, which stay until done_o
    /* verilator lint_on UNUSED */
    input  wire      [X_W-1:0] dividend_i,
    input  wire      [Y_W-1:0] divisor_i,
    input  wire [BESIDE_W-1:0] beside_i,
    output wire                done_o,      // iterative: for one clock, the result is there, until the next start
    output wire      [Q_W-1:0] quotient_o,
    output wire      [Y_W-1:0] remainder_o,
    output wire [BESIDE_W-1:0] beside_o     // beside_i of this result
);

    generate
        if (DIVIDER == 1) begin : radix4
            glint_divider_radix4 #(
                .X_W           (X_W),
                .Y_W           (Y_W),
                .Q_W           (Q_W),
                .REGISTER_EVERY(REGISTER_EVERY),
                .BESIDE_W      (BESIDE_W)
            ) divider (
                .clk_i      (clk_i),
                .enable_i   (enable_i),
                .dividend_i (dividend_i),
                .divisor_i  (divisor_i),
                .beside_i   (beside_i),
                .quotient_o (quotient_o),
                .remainder_o(remainder_o),
                .beside_o   (beside_o)
            );
            assign done_o = 1'b0;
        end else if (DIVIDER == 2) begin : iterative
            glint_divider_iterative #(
                .X_W(X_W),
                .Y_W(Y_W),
                .Q_W(Q_W)
            ) divider (
                .clk_i      (clk_i),
                .enable_i   (enable_i),
                .start_i    (start_i),
                .dividend_i (dividend_i),
                .divisor_i  (divisor_i),
                .done_o     (done_o),
                .quotient_o (quotient_o),
                .remainder_o(remainder_o)
            );
            assign beside_o = beside_i;
        end else if (DIVIDER == 3) begin : reciprocal
            glint_divider_reciprocal #(
                .X_W(X_W),
                .Y_W(Y_W),
                .Q_W(Q_W),
                .ZEROS(ZEROS),
                .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
                .BESIDE_W(BESIDE_W)
            ) divider (
                .clk_i      (clk_i),
                .enable_i   (enable_i),
                .dividend_i (dividend_i),
                .divisor_i  (divisor_i),
                .beside_i   (beside_i),
                .quotient_o (quotient_o),
                .remainder_o(remainder_o),
                .beside_o   (beside_o)
            );
            assign done_o = 1'b0;
        end else begin : restoring
            glint_divider_restoring #(
                .X_W           (X_W),
                .Y_W           (Y_W),
                .Q_W           (Q_W),
                .REGISTER_EVERY(REGISTER_EVERY),
                .BESIDE_W      (BESIDE_W)
            ) divider (
                .clk_i      (clk_i),
                .enable_i   (enable_i),
                .dividend_i (dividend_i),
                .divisor_i  (divisor_i),
                .beside_i   (beside_i),
                .quotient_o (quotient_o),
                .remainder_o(remainder_o),
                .beside_o   (beside_o)
            );
            assign done_o = 1'b0;
        end
    endgenerate

endmodule

`default_nettype wire
