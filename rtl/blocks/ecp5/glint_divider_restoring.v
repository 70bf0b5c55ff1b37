// glint_divider_restoring for Lattice ECP5: quotient = floor(dividend / divisor), one quotient bit a row.
//
// It takes the place of rtl/blocks/glint_divider_restoring.v in a list of files: same ports, parameters, bits and clocks. Inside
// it does not restore: a row takes the divisor off a remainder that is not negative and adds it to one that is, in one row of
// carry cells, so that nothing follows the adder. Table of ports and parameters: docs/rtl.md.

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

    // Head and tail of the dividend: as in the divider of any device. A remainder is -divisor .. divisor - 1: Y_W bits and a
    // sign, kept as `fits`, not negative. 2 remainder + bit, less or more the divisor, is in that range again. With s the sign
    // before, the bit Y_W + 1 of the sum is s + ~s + carry: the result is not negative where the adder below has a carry.
    localparam HEAD_W = X_W - Q_W;

    genvar i;
    generate
        for (i = 0; i < Q_W; i = i + 1) begin : row
            wire    [Y_W-1:0] remainder, remainder_next;
            wire    [Y_W-1:0] divisor, divisor_next;
            wire    [Q_W-1:0] bits, bits_next;
            wire [BESIDE_W-1:0] beside, beside_next;
            wire              fits, fits_after;
            /* verilator lint_off UNUSED */  // the top bit is the sign again
            wire      [Y_W:0] next;
            /* verilator lint_on UNUSED */
            if (i == 0) begin : first
                assign remainder = {{(Y_W - HEAD_W) {1'b0}}, dividend_i[X_W-1:Q_W]};
                assign divisor   = divisor_i;
                assign bits      = dividend_i[Q_W-1:0];
                assign beside    = beside_i;
            end else begin : rest
                assign remainder = row[i-1].remainder_next;
                assign divisor   = row[i-1].divisor_next;
                assign bits      = row[i-1].bits_next;
                assign beside    = row[i-1].beside_next;
            end
            if (i == 0) begin : subtract  // in any case; the owner's complement of the divisor may be a register
                /* verilator lint_off UNUSED */  // the bit below
                wire [Y_W+2:0] sum = {1'b0, remainder, bits[Q_W-1], 1'b1} + {2'b01, ~divisor, 1'b1};
                /* verilator lint_on UNUSED */
                assign {fits, next} = sum[Y_W+2:1];
            end else begin : choose
                glint_add_sub #(
                    .WIDTH(Y_W + 1)
                ) add_sub (
                    .subtract_i(row[i-1].fits_after),
                    .a_i       ({remainder, bits[Q_W-1]}),
                    .b_i       ({1'b0, divisor}),
                    .result_o  (next),
                    .carry_o   (fits)
                );
            end
            if ((i + 1) % REGISTER_EVERY == 0 || i == Q_W - 1) begin : registered
                reg  [Y_W-1:0] remainder_q;
                reg  [Y_W-1:0] divisor_q;
                reg  [Q_W-1:0] bits_q;
                reg            fits_q;
                reg [BESIDE_W-1:0] beside_q;
                always @(posedge clk_i) begin
                    if (enable_i) begin
                        remainder_q <= next[Y_W-1:0];
                        divisor_q   <= divisor;
                        bits_q      <= {bits[Q_W-2:0], fits};
                        fits_q      <= fits;
                        beside_q    <= beside;
                    end
                end
                assign remainder_next = remainder_q;
                assign divisor_next   = divisor_q;
                assign bits_next      = bits_q;
                assign fits_after     = fits_q;
                assign beside_next    = beside_q;
            end else begin : passed
                assign remainder_next = next[Y_W-1:0];
                assign divisor_next   = divisor;
                assign bits_next      = {bits[Q_W-2:0], fits};
                assign fits_after     = fits;
                assign beside_next    = beside;
            end
        end
    endgenerate

    // What is negative at the end is one divisor too small.
    wire [Y_W-1:0] back = row[Q_W-1].fits_after ? {Y_W{1'b0}} : row[Q_W-1].divisor_next;
    assign quotient_o  = row[Q_W-1].bits_next;
    assign remainder_o = row[Q_W-1].remainder_next + back;
    assign beside_o    = row[Q_W-1].beside_next;

endmodule

`default_nettype wire
