// glint_divider_restoring: quotient = floor(dividend / divisor) by restoring division, one quotient bit a row.
//
// The contract is that of glint_divider. A register follows every REGISTER_EVERY rows and the last one, so that
// ceil(Q_W / REGISTER_EVERY) clocks with enable_i = 1 lead from operands to result. Ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_divider_restoring #(
    parameter X_W            = 34,  // dividend bits; Q_W < X_W <= Y_W + Q_W
    parameter Y_W            = 28,  // divisor bits
    parameter Q_W            = 16,  // quotient bits = rows, at least 2
    parameter REGISTER_EVERY = 1,   // rows in a clock
    parameter BESIDE_W       = 1    // bits of what goes with the operands
) (
    input  wire                clk_i,
    input  wire                enable_i,
    input  wire      [X_W-1:0] dividend_i,
    input  wire      [Y_W-1:0] divisor_i,
    input  wire [BESIDE_W-1:0] beside_i,
    output wire      [Q_W-1:0] quotient_o,
    output wire      [Y_W-1:0] remainder_o,
    output wire [BESIDE_W-1:0] beside_o
);

    // The head of the dividend starts as the remainder: dividend < divisor * 2^Q_W makes it less than the divisor.
    // The tail waits in `bits`; each row takes its top bit and puts a quotient bit in at the bottom, so that after
    // Q_W rows `bits` is the quotient.
    localparam HEAD_W = X_W - Q_W;

    wire [Y_W-1:0] head = {{(Y_W - HEAD_W) {1'b0}}, dividend_i[X_W-1:Q_W]};

    genvar i;
    generate
        for (i = 0; i < Q_W; i = i + 1) begin : row
            wire [Y_W-1:0] remainder, remainder_next;
            /* verilator lint_off UNUSED */  // after the last row
            wire [Y_W-1:0] complement, complement_next;
            /* verilator lint_on UNUSED */
            wire [Q_W-1:0] bits, bits_next;
            wire [BESIDE_W-1:0] beside, beside_next;

            if (i == 0) begin : first
                assign remainder  = head;
                assign complement = ~divisor_i;
                assign bits       = dividend_i[Q_W-1:0];
                assign beside     = beside_i;
            end else begin : rest
                assign remainder  = row[i-1].remainder_next;
                assign complement = row[i-1].complement_next;
                assign bits       = row[i-1].bits_next;
                assign beside     = row[i-1].beside_next;
            end

            // remainder <= divisor - 1, so shifted = 2 remainder + bit <= 2 divisor - 1, and shifted - divisor is
            // -divisor .. divisor - 1: one bit more than the divisor, the sign. What is kept is below the divisor
            // again, whether the divisor came off or did not fit: Y_W bits.
            // The complement of the divisor travels, since there are devices whose carry chains add only: x - y =
            // x + ~y + 1, and the 1 is the carry out of a bit below.
            wire   [Y_W:0] shifted = {remainder, bits[Q_W-1]};
            /* verilator lint_off UNUSED */  // the bit below
            wire [Y_W+1:0] difference = {shifted, 1'b1} + {1'b1, complement, 1'b1};
            /* verilator lint_on UNUSED */
            wire           fits = ~difference[Y_W+1];
            wire [Y_W-1:0] reduced = fits ? difference[Y_W:1] : shifted[Y_W-1:0];

            if ((i + 1) % REGISTER_EVERY == 0 || i == Q_W - 1) begin : registered
                reg [Y_W-1:0] remainder_q;
                reg [Y_W-1:0] complement_q;
                reg [Q_W-1:0] bits_q;
                reg [BESIDE_W-1:0] beside_q;
                always @(posedge clk_i) begin
                    if (enable_i) begin
                        remainder_q  <= reduced;
                        complement_q <= complement;
                        bits_q       <= {bits[Q_W-2:0], fits};
                        beside_q     <= beside;
                    end
                end
                assign remainder_next = remainder_q;
                assign complement_next = complement_q;
                assign bits_next      = bits_q;
                assign beside_next    = beside_q;
            end else begin : passed
                assign remainder_next = reduced;
                assign complement_next = complement;
                assign bits_next      = {bits[Q_W-2:0], fits};
                assign beside_next    = beside;
            end
        end
    endgenerate

    assign quotient_o  = row[Q_W-1].bits_next;
    assign remainder_o = row[Q_W-1].remainder_next;
    assign beside_o    = row[Q_W-1].beside_next;

endmodule

`default_nettype wire
