// glint_divider: quotient = floor(dividend / divisor), one result a clock.
//
// Contract, with integers: for 0 <= dividend < divisor * 2^Q_W and divisor > 0,
//   dividend = divisor * quotient + remainder   and   0 <= remainder < divisor.
// Outside that domain the outputs are unspecified. Restoring division, one quotient bit a stage: Q_W clocks with
// enable_i = 1 from operands to result. The pipeline has no valid bits and no reset: its owner counts clocks.
// Table of ports and parameters: docs/rtl.md.

`default_nettype none

module glint_divider #(
    parameter X_W = 34,  // dividend bits; Q_W < X_W <= Y_W + Q_W
    parameter Y_W = 28,  // divisor bits
    parameter Q_W = 16   // quotient bits = stages, at least 2
) (
    input  wire           clk_i,
    input  wire           enable_i,
    input  wire [X_W-1:0] dividend_i,
    input  wire [Y_W-1:0] divisor_i,
    output wire [Q_W-1:0] quotient_o,
    output wire [Y_W-1:0] remainder_o,
    output wire [Y_W-1:0] divisor_o
);

    // The head of the dividend starts as the remainder: dividend < divisor * 2^Q_W makes it less than the divisor.
    // The tail waits in `bits`; each stage takes its top bit and puts a quotient bit in at the bottom, so that after
    // Q_W stages `bits` is the quotient.
    localparam HEAD_W = X_W - Q_W;

    wire [Y_W-1:0] head = {{(Y_W - HEAD_W) {1'b0}}, dividend_i[X_W-1:Q_W]};

    genvar i;
    generate
        for (i = 0; i < Q_W; i = i + 1) begin : stage
            wire [Y_W-1:0] remainder;
            wire [Y_W-1:0] divisor;
            wire [Q_W-1:0] bits;

            if (i == 0) begin : first
                assign remainder = head;
                assign divisor   = divisor_i;
                assign bits      = dividend_i[Q_W-1:0];
            end else begin : rest
                assign remainder = stage[i-1].remainder_q;
                assign divisor   = stage[i-1].divisor_q;
                assign bits      = stage[i-1].bits_q;
            end

            // remainder <= divisor - 1, so shifted = 2 remainder + bit <= 2 divisor - 1: one bit more than the divisor.
            // What is kept is below the divisor again, whether the divisor came off or did not fit: Y_W bits.
            wire [Y_W:0] shifted = {remainder, bits[Q_W-1]};
            wire         fits = shifted >= {1'b0, divisor};
            wire [Y_W-1:0] reduced = fits ? shifted[Y_W-1:0] - divisor : shifted[Y_W-1:0];

            reg [Y_W-1:0] remainder_q;
            reg [Y_W-1:0] divisor_q;
            reg [Q_W-1:0] bits_q;
            always @(posedge clk_i) begin
                if (enable_i) begin
                    remainder_q <= reduced;
                    divisor_q   <= divisor;
                    bits_q      <= {bits[Q_W-2:0], fits};
                end
            end
        end
    endgenerate

    assign quotient_o  = stage[Q_W-1].bits_q;
    assign remainder_o = stage[Q_W-1].remainder_q;
    assign divisor_o   = stage[Q_W-1].divisor_q;

endmodule

`default_nettype wire
