// sphere_beam: where the picture's beam is: 640 + 16 + 96 + 48 clocks a line, 480 + 10 + 2 + 33 lines.

`default_nettype none

module sphere_beam #(
    parameter LATE = 0  // clocks behind one with 0; below 800
) (
    input  wire               clk_i,
    input  wire               rst_ni,     // synchronous, active low
    output wire signed [10:0] x_o,        // half pixels from the middle: odd, -639 .. 959; 639 is the last that is seen
    output wire signed [10:0] y_o,        // upwards: odd, 479 .. -569; -479 is the last
    output wire               hsync_o,    // active high
    output wire               vsync_o,    // active high
    output wire               visible_o,
    output wire               line_end_o, // the last clock of a line
    output wire               tick_o      // the last clock of the last line that is seen
);

    localparam signed [10:0] X_START = LATE == 0 ? -11'sd639 : 11'sd961 - 2 * LATE;
    localparam signed [10:0] Y_START = LATE == 0 ? 11'sd479 : -11'sd569;
    reg signed [10:0] x_q, y_q;
    always @(posedge clk_i) begin
        if (!rst_ni) begin
            x_q <= X_START;
            y_q <= Y_START;
        end else if (line_end_o) begin
            x_q <= -11'sd639;
            y_q <= y_q == -11'sd569 ? 11'sd479 : y_q - 11'sd2;
        end else begin
            x_q <= x_q + 11'sd2;
        end
    end
    assign x_o        = x_q;
    assign y_o        = y_q;
    assign hsync_o    = x_q >= 11'sd673 & x_q < 11'sd865;
    assign vsync_o    = y_q <= -11'sd501 & y_q > -11'sd505;
    assign visible_o  = x_q <= 11'sd639 & y_q >= -11'sd479;
    assign line_end_o = x_q == 11'sd959;
    assign tick_o     = line_end_o & y_q == -11'sd479;

endmodule

`default_nettype wire
