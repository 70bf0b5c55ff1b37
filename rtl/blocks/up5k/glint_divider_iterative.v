// glint_divider_iterative for iCE40 UltraPlus: quotient = floor(dividend / divisor) by one row, used Q_W times.
//
// It takes the place of rtl/blocks/glint_divider_iterative.v in a list of files: same ports, parameters, bits and clocks. The
// row leaves the choice of its remainder to its next use: both candidates and the sign are registers, so that the way from the
// end of the carry chain to all bits is in another clock than the chain. Ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_divider_iterative #(
    parameter X_W = 34,  // dividend bits; Q_W < X_W <= Y_W + Q_W
    parameter Y_W = 28,  // divisor bits
    parameter Q_W = 16   // quotient bits, 2 .. 63
) (
    input  wire           clk_i,
    input  wire           enable_i,
    input  wire           start_i,
    input  wire [X_W-1:0] dividend_i,
    input  wire [Y_W-1:0] divisor_i,
    output wire           done_o,      // for one clock: the result is there
    output wire [Q_W-1:0] quotient_o,
    output wire [Y_W-1:0] remainder_o
);

    localparam        HEAD_W = X_W - Q_W;
    localparam [31:0] ROWS   = Q_W;

    reg     [5:0] left_q;  // rows that are still to be done
    reg           done_q;
    reg           fits_q;
    reg [Y_W-1:0] less_q;  // the remainder if the divisor came off
    reg [Y_W-1:0] kept_q;  // and if it did not fit
    reg [Q_W-1:0] bits_q;

    // The widths of a row are derived in glint_divider_restoring.
    wire [Y_W-1:0] remainder = fits_q ? less_q : kept_q;
    wire   [Y_W:0] shifted = {remainder, bits_q[Q_W-1]};
    /* verilator lint_off UNUSED */  // the bit below
    wire [Y_W+1:0] difference = {shifted, 1'b1} + {1'b1, ~divisor_i, 1'b1};
    /* verilator lint_on UNUSED */
    wire           fits = ~difference[Y_W+1];

    always @(posedge clk_i) begin
        if (enable_i) begin
            done_q <= ~start_i & (left_q == 6'd1);
            if (start_i) begin
                left_q <= ROWS[5:0];
                fits_q <= 1'b0;
                kept_q <= {{(Y_W - HEAD_W) {1'b0}}, dividend_i[X_W-1:Q_W]};
                bits_q <= dividend_i[Q_W-1:0];
            end else if (left_q != 6'd0) begin
                left_q <= left_q - 6'd1;
                fits_q <= fits;
                kept_q <= shifted[Y_W-1:0];
                bits_q <= {bits_q[Q_W-2:0], fits};
            end
            if (left_q != 6'd0) less_q <= difference[Y_W:1];
        end
    end

    assign done_o      = done_q;
    assign quotient_o  = bits_q;
    assign remainder_o = remainder;

endmodule

`default_nettype wire
