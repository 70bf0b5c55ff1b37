// glint_normalise: moves the leading one of a number to the top, and says how far up it was. 2 clocks.
//
// Shifts by 2^(SHIFT_W - 1), .., 2, 1 places, each where so many bits at the top are 0; a register in the middle and one
// at the end. No valid bits and no reset: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_normalise #(
    parameter WIDTH   = 16,  // bits of x, 5 .. 32
    parameter SHIFT_W = 4,   // bits of the count: ceil(log2(WIDTH))
    parameter OUT_W   = 8,   // bits of the result, below WIDTH
    parameter FILL    = 0    // what moves in from below
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire   [WIDTH-1:0] x_i,
    output wire [SHIFT_W-1:0] kept_o,  // 2^SHIFT_W - 1 less the places it was moved by
    output wire   [OUT_W-1:0] rest_o   // the bits after the leading one; 0 if no one has reached the top
);

    localparam SPLIT = (SHIFT_W + 1) / 2;

    reg   [WIDTH-1:0] middle_q;
    reg   [SPLIT-1:0] high_q;
    reg [SHIFT_W-1:0] kept_q;
    reg   [OUT_W-1:0] rest_q;

    /* verilator lint_off UNUSED */  // of the last step, what is below the result
    genvar j;
    generate
        for (j = SHIFT_W - 1; j >= 0; j = j - 1) begin : step
            localparam       PLACES = 1 << j;
            wire [WIDTH-1:0] x, y;
            wire             keep = |x[WIDTH-1:WIDTH-PLACES];
            if (j == SHIFT_W - 1) begin : first
                assign x = x_i;
            end else if (j == SHIFT_W - SPLIT - 1) begin : second
                assign x = middle_q;
            end else begin : others
                assign x = step[j+1].y;
            end
            assign y = keep ? x : {x[WIDTH-PLACES-1:0], {PLACES{FILL[0]}}};
        end
        for (j = 0; j < SHIFT_W; j = j + 1) begin : count
            if (j >= SHIFT_W - SPLIT) begin : high
                always @(posedge clk_i) begin
                    if (enable_i) begin
                        high_q[j-SHIFT_W+SPLIT] <= step[j].keep;
                        kept_q[j]               <= high_q[j-SHIFT_W+SPLIT];
                    end
                end
            end else begin : low
                always @(posedge clk_i) if (enable_i) kept_q[j] <= step[j].keep;
            end
        end
    endgenerate
    /* verilator lint_on UNUSED */

    always @(posedge clk_i) begin
        if (enable_i) begin
            middle_q <= step[SHIFT_W-SPLIT].y;
            rest_q   <= step[0].y[WIDTH-1] ? step[0].y[WIDTH-2:WIDTH-1-OUT_W] : {OUT_W{1'b0}};
        end
    end
    assign kept_o = kept_q;
    assign rest_o = rest_q;

endmodule

`default_nettype wire
