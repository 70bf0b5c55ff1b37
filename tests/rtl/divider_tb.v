// glint_divider by its contract: for divisor > 0 and dividend < divisor * 2^Q_W,
//   dividend = divisor * quotient + remainder, remainder < divisor, and beside_o is what was beside these operands.
// All dividers but the iterative one: divider_iterative_tb.v.
//
//   parameters  X_W, Y_W, Q_W (Y_W and Q_W up to 64), DIVIDER, REGISTER_EVERY, MULTIPLIER_STAGES as in glint_divider
//               LATENCY: what docs/rtl.md says for them
//               DIVISIONS: so many, of random operands and corners; 0: all that there are

`default_nettype none

module divider_tb;

    parameter X_W       = 34;
    parameter Y_W       = 28;
    parameter Q_W       = 16;
    parameter DIVISIONS = 0;
    parameter DIVIDER   = 0;
    parameter LATENCY   = 16;
    parameter REGISTER_EVERY    = 1;
    parameter MULTIPLIER_STAGES = 1;

    localparam THINGS = "divisions";
    localparam COUNT  = DIVISIONS;
    localparam IN_W   = Y_W + X_W;  // divisor, dividend
    localparam FIRST  = {{{Y_W - 1{1'b0}}, 1'b1}, {X_W{1'b0}}};
`include "pipeline.vh"
`include "division.vh"

    wire [Q_W-1:0] quotient;
    wire [Y_W-1:0] remainder;
    wire [Y_W-1:0] beside;
    wire [Y_W-1:0] divisor  = past[IN_W-1:X_W];
    wire [X_W-1:0] dividend = past[X_W-1:0];

    glint_divider #(
        .X_W              (X_W),
        .Y_W              (Y_W),
        .Q_W              (Q_W),
        .DIVIDER          (DIVIDER),
        .REGISTER_EVERY   (REGISTER_EVERY),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .BESIDE_W         (Y_W)
    ) divider (
        .clk_i      (clk),
        .enable_i   (enable),
        .start_i    (1'b0),
        .dividend_i (given[X_W-1:0]),
        .divisor_i  (given[IN_W-1:X_W]),
        .beside_i   (~given[IN_W-1:X_W]),
        .done_o     (),
        .quotient_o (quotient),
        .remainder_o(remainder),
        .beside_o   (beside)
    );

    assign right = divisor * {{Y_W{1'b0}}, quotient} + remainder === dividend && remainder < divisor
                   && beside === ~divisor;

    task draw_next;
        begin
            draw_division;
            next = {drawn_divisor, drawn[X_W-1:0]};
        end
    endtask

    reg [Y_W-1:0] last_divisor;
    reg   [X_W:0] next_dividend;  // a bit more than needed, to see a count run over

    task following;
        begin
            last_divisor  = next[IN_W-1:X_W];
            next_dividend = next[X_W-1:0] + 1;
            next          = {last_divisor, next_dividend[X_W-1:0]};
            if (next_dividend >> X_W != 0 || next_dividend >> Q_W == last_divisor) begin
                more = ~&last_divisor;
                next = {last_divisor + 1'b1, {X_W{1'b0}}};
            end
        end
    endtask

    task complain;
        $display("FAILED: %0d / %0d: quotient %0d, remainder %0d, beside %0d", dividend, divisor, quotient, remainder,
                 ~beside);
    endtask

endmodule

`default_nettype wire
