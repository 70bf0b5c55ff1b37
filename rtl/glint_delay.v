// glint_delay: what goes in comes out STAGES enabled clocks later. No reset.
// Table of ports and parameters: docs/rtl.md.

`default_nettype none

module glint_delay #(
    parameter WIDTH  = 1,
    parameter STAGES = 1  // at least 1
) (
    input  wire             clk_i,
    input  wire             enable_i,
    input  wire [WIDTH-1:0] data_i,
    output wire [WIDTH-1:0] data_o
);

    genvar i;
    generate
        for (i = 0; i < STAGES; i = i + 1) begin : stage
            reg [WIDTH-1:0] data_q;
            if (i == 0) begin : first
                always @(posedge clk_i) if (enable_i) data_q <= data_i;
            end else begin : rest
                always @(posedge clk_i) if (enable_i) data_q <= stage[i-1].data_q;
            end
        end
    endgenerate

    assign data_o = stage[STAGES-1].data_q;

endmodule

`default_nettype wire
