// sphere_turn: a point that goes round a circle, one step at a time: 2 pi 2^SHIFT steps a turn, no table, no product.
//
// Two shears are a step. They keep the radius, but y is then half a step behind x: what comes out is the mean of y before
// and after its shear, which is off by the cosine of half a step, below 2^-(2 SHIFT + 3). Both are bijections of the integers.

`default_nettype none

module sphere_turn #(
    parameter                SHIFT = 6,   // a step is 2^-SHIFT radian, 4 .. 8
    parameter signed  [15:0] X0    = 0,   // where it starts, code / 2^15
    parameter signed  [15:0] Y0    = 0
) (
    input  wire               clk_i,
    input  wire               rst_ni,  // synchronous, active low
    input  wire               step_i,
    output wire signed [15:0] x_o,     // code / 2^15
    output wire signed [15:0] y_o
);

    // 8 bits below those of the ports. Y0 is where the mean starts: half a step back.
    localparam signed [23:0] X_START = 24'sd256 * X0;
    localparam signed [23:0] Y_START = 24'sd256 * Y0 - (X_START >>> (SHIFT + 1));
    reg signed [23:0] x_q, y_q;
    wire signed [23:0] y_next = y_q + (x_q >>> SHIFT);
    wire signed [24:0] y_two  = {y_q[23], y_q} + {y_next[23], y_next};
    always @(posedge clk_i) begin
        if (!rst_ni) begin
            x_q <= X_START;
            y_q <= Y_START;
        end else if (step_i) begin
            x_q <= x_q - (y_next >>> SHIFT);
            y_q <= y_next;
        end
    end
    assign x_o = x_q[23:8];
    assign y_o = y_two[24:9];
    wire unused = &{1'b0, y_two[8:0]};

endmodule

`default_nettype wire
