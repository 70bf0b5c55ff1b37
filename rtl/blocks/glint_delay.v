// glint_delay: what goes in comes out STAGES enabled clocks later. No reset.
// Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_delay #(
    parameter WIDTH  = 1,
    parameter STAGES = 1  // 0: a wire
) (
    /* verilator lint_off UNUSED */  // with no stage
    input  wire             clk_i,
    input  wire             enable_i,
    /* verilator lint_on UNUSED */
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
        if (STAGES == 0) begin : none
            assign data_o = data_i;
        end else begin : last
            assign data_o = stage[STAGES-1].data_q;
        end
    endgenerate

endmodule

`default_nettype wire
