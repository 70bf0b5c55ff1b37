// glint_delay: data_o is data_i of STAGES enabled edges ago.

`default_nettype none

module delay_tb;

    parameter WIDTH  = 1;
    parameter STAGES = 1;
    parameter ITEMS  = 10000;

    localparam LATENCY = STAGES;
    localparam THINGS  = "items";
    localparam COUNT   = ITEMS;
    localparam IN_W    = WIDTH;
    localparam FIRST   = {WIDTH{1'b0}};
`include "pipeline.vh"

    wire [WIDTH-1:0] delayed;

    glint_delay #(
        .WIDTH (WIDTH),
        .STAGES(STAGES)
    ) delay (
        .clk_i   (clk),
        .enable_i(enable),
        .data_i  (given),
        .data_o  (delayed)
    );

    assign right = delayed === past;

    task draw_next;
        next = {$random(seed), $random(seed)};
    endtask

    task following;
        more = 1'b0;
    endtask

    task complain;
        $display("FAILED: clock %0d: %h instead of %h", clock, delayed, past);
    endtask

endmodule

`default_nettype wire
