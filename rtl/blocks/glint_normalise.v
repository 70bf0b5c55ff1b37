// glint_normalise: moves the leading one of a number to the top, and says how far up it was. 2 clocks, SHIFT_W with DEEP = 1.
//
// Shifts by 2^(SHIFT_W - 1), .., 2, 1 places, each where so many bits at the top are 0; a register in the middle and one
// at the end, or after each step. No valid bits and no reset: its owner counts clocks. Table of ports and parameters:
// docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_normalise #(
    parameter WIDTH   = 16,  // bits of x, 5 .. 32
    parameter SHIFT_W = 4,   // bits of the count: ceil(log2(WIDTH))
    parameter OUT_W   = 8,   // bits of the result, below WIDTH
    parameter FILL    = 0,   // what moves in from below
    parameter DEEP    = 0    // 1: a register after each step, SHIFT_W clocks
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire   [WIDTH-1:0] x_i,
    output wire [SHIFT_W-1:0] kept_o,  // 2^SHIFT_W - 1 less the places it was moved by
    output wire   [OUT_W-1:0] rest_o   // the bits after the leading one; 0 if no one has reached the top
);

    localparam MIDDLE = SHIFT_W / 2;  // the step before the register in the middle

    /* verilator lint_off UNUSED */  // of the last step, what is below the result
    genvar j;
    generate
        for (j = SHIFT_W - 1; j >= 0; j = j - 1) begin : step
            localparam       PLACES = 1 << j;
            wire [WIDTH-1:0] x, y;
            wire             keep = |x[WIDTH-1:WIDTH-PLACES];
            wire [WIDTH-1:0] shifted = keep ? x : {x[WIDTH-PLACES-1:0], {PLACES{FILL[0]}}};
            if (j == SHIFT_W - 1) begin : first
                assign x = x_i;
            end else begin : others
                assign x = step[j+1].y;
            end
            if (j == 0) begin : last
                assign y = shifted[WIDTH-1] ? shifted : {WIDTH{1'b0}};
            end else begin : inner
                glint_delay #(
                    .WIDTH (WIDTH),
                    .STAGES(DEEP != 0 || j == MIDDLE ? 1 : 0)
                ) delay (
                    .clk_i   (clk_i),
                    .enable_i(enable_i),
                    .data_i  (shifted),
                    .data_o  (y)
                );
            end
            glint_delay #(
                .WIDTH (1),
                .STAGES(DEEP != 0 ? j + 1 : j >= MIDDLE ? 2 : 1)
            ) delay_kept (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  (keep),
                .data_o  (kept_o[j])
            );
        end
    endgenerate
    glint_delay #(
        .WIDTH (OUT_W),
        .STAGES(1)
    ) delay_rest (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (step[0].y[WIDTH-2:WIDTH-1-OUT_W]),
        .data_o  (rest_o)
    );
    /* verilator lint_on UNUSED */

endmodule

`default_nettype wire
