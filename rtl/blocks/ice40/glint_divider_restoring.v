// glint_divider_restoring for Lattice iCE40: quotient = floor(dividend / divisor), one quotient bit a row.
//
// It takes the place of rtl/blocks/glint_divider_restoring.v in a list of files: same ports, parameters, bits and clocks. A row
// leaves the choice of its remainder to the next one: both candidates and the sign go to registers, so that the way from the end
// of a carry chain to all bits is in another clock than the chain. Table of ports and parameters: docs/rtl.md.

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

    // Head and tail of the dividend, and the widths of a row: as in the divider of any device. After row i HEAD_W + i + 1 bits
    // of the dividend have come in; where the divisor came off less than half of that is left, R_W bits: so in the first rows no
    // cell is spent on the upper ones. The top bit, which is 0 there, too, stays: with it the sign of the next row is a sum, and a
    // cell of the carry chain.
    localparam HEAD_W = X_W - Q_W;

    genvar i;
    generate
        for (i = 0; i < Q_W; i = i + 1) begin : row
            localparam           R_W  = HEAD_W + i < Y_W ? HEAD_W + i : Y_W;
            localparam [Y_W-1:0] MASK = {1'b1, {(Y_W - 1) {1'b0}}} | {Y_W{1'b1}} >> (Y_W - R_W);
            wire [Y_W-1:0] remainder;
            wire [Y_W-1:0] less, less_next;  // the remainder if the divisor came off
            wire [Y_W-1:0] kept, kept_next;  // and if it did not fit
            /* verilator lint_off UNUSED */  // after the last row
            wire [Y_W-1:0] complement, complement_next;
            /* verilator lint_on UNUSED */
            wire [Q_W-1:0] bits, bits_next;
            wire [BESIDE_W-1:0] beside, beside_next;

            if (i == 0) begin : first
                assign remainder  = {{(Y_W - HEAD_W) {1'b0}}, dividend_i[X_W-1:Q_W]};
                assign complement = ~divisor_i;
                assign bits       = dividend_i[Q_W-1:0];
                assign beside     = beside_i;
            end else begin : rest
                assign remainder  = row[i-1].bits_next[0] ? row[i-1].less_next : row[i-1].kept_next;
                assign complement = row[i-1].complement_next;
                assign bits       = row[i-1].bits_next;
                assign beside     = row[i-1].beside_next;
            end

            wire   [Y_W:0] shifted = {remainder, bits[Q_W-1]};
            /* verilator lint_off UNUSED */  // the bit below
            wire [Y_W+1:0] difference = {shifted, 1'b1} + {1'b1, complement, 1'b1};
            /* verilator lint_on UNUSED */
            wire           fits = ~difference[Y_W+1];
            assign less = difference[Y_W:1] & MASK;
            assign kept = shifted[Y_W-1:0];

            if ((i + 1) % REGISTER_EVERY == 0 || i == Q_W - 1) begin : registered
                reg [Y_W-1:0] less_q;
                reg [Y_W-1:0] kept_q;
                reg [Y_W-1:0] complement_q;
                reg [Q_W-1:0] bits_q;
                reg [BESIDE_W-1:0] beside_q;
                always @(posedge clk_i) begin
                    if (enable_i) begin
                        less_q       <= less;
                        kept_q       <= kept;
                        complement_q <= complement;
                        bits_q       <= {bits[Q_W-2:0], fits};
                        beside_q     <= beside;
                    end
                end
                assign less_next       = less_q;
                assign kept_next       = kept_q;
                assign complement_next = complement_q;
                assign bits_next       = bits_q;
                assign beside_next     = beside_q;
            end else begin : passed
                assign less_next       = less;
                assign kept_next       = kept;
                assign complement_next = complement;
                assign bits_next       = {bits[Q_W-2:0], fits};
                assign beside_next     = beside;
            end
        end
    endgenerate

    assign quotient_o  = row[Q_W-1].bits_next;
    assign remainder_o = quotient_o[0] ? row[Q_W-1].less_next : row[Q_W-1].kept_next;
    assign beside_o    = row[Q_W-1].beside_next;

endmodule

`default_nettype wire
