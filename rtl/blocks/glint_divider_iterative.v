// glint_divider_iterative: quotient = floor(dividend / divisor) by one row of restoring division, used Q_W times.
//
// The contract is that of glint_divider, for one division at a time: a clock with start_i begins one, whatever went on
// before; the operands have to stay as they are until done_o, Q_W + 1 clocks with enable_i = 1 later. The result stays
// until the next start. Ports and parameters: docs/rtl.md.

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
    reg [Y_W-1:0] remainder_q;
    reg [Q_W-1:0] bits_q;

    // The row is that of glint_divider_restoring; the widths are derived there.
    wire   [Y_W:0] shifted = {remainder_q, bits_q[Q_W-1]};
    /* verilator lint_off UNUSED */  // the bit below
    wire [Y_W+1:0] difference = {shifted, 1'b1} + {1'b1, ~divisor_i, 1'b1};
    /* verilator lint_on UNUSED */
    wire           fits = ~difference[Y_W+1];
    wire [Y_W-1:0] reduced = fits ? difference[Y_W:1] : shifted[Y_W-1:0];

    always @(posedge clk_i) begin
        if (enable_i) begin
            done_q <= ~start_i & (left_q == 6'd1);
            if (start_i) begin
                left_q      <= ROWS[5:0];
                remainder_q <= {{(Y_W - HEAD_W) {1'b0}}, dividend_i[X_W-1:Q_W]};
                bits_q      <= dividend_i[Q_W-1:0];
            end else if (left_q != 6'd0) begin
                left_q      <= left_q - 6'd1;
                remainder_q <= reduced;
                bits_q      <= {bits_q[Q_W-2:0], fits};
            end
        end
    end

    assign done_o      = done_q;
    assign quotient_o  = bits_q;
    assign remainder_o = remainder_q;

endmodule

`default_nettype wire
