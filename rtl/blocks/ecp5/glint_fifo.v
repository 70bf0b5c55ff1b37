// glint_fifo for Lattice ECP5: first in, first out, in a memory of LUTs.
//
// It takes the place of rtl/blocks/glint_fifo.v in a list of files: same ports, parameters and clocks, and bits where valid_o
// is 1. The address is a register, and pop_i only enables: no way leads from it through the memory. Table of ports and
// parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_fifo #(
    parameter WIDTH     = 1,
    parameter LOG_DEPTH = 6  // at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni, // synchronous, active low
    input  wire             push_i,
    input  wire [WIDTH-1:0] data_i,
    output wire             valid_o,
    input  wire             pop_i,  // only while valid_o = 1
    output wire [WIDTH-1:0] data_o
);

    (* ram_style = "distributed" *) reg [WIDTH-1:0] memory[0:(1<<LOG_DEPTH)-1];
    reg [WIDTH-1:0] data_q;
    reg             valid_q;

    // One bit more than an address, so that full and empty differ. The oldest stands in data_q, the next at next_q.
    reg  [LOG_DEPTH:0] write_q, next_q;
    wire               more = write_q != next_q;
    wire               take = pop_i | ~valid_q;
    always @(posedge clk_i) begin
        if (!rst_ni) begin
            write_q <= {(LOG_DEPTH + 1) {1'b0}};
            next_q  <= {(LOG_DEPTH + 1) {1'b0}};
            valid_q <= 1'b0;
        end else begin
            write_q <= write_q + {{LOG_DEPTH{1'b0}}, push_i};
            if (take) begin
                next_q  <= next_q + {{LOG_DEPTH{1'b0}}, more};
                valid_q <= more;
            end
        end
    end

    always @(posedge clk_i) begin
        if (push_i) memory[write_q[LOG_DEPTH-1:0]] <= data_i;
        if (take) data_q <= memory[next_q[LOG_DEPTH-1:0]];
    end

    assign valid_o = valid_q;
    assign data_o  = data_q;

endmodule

`default_nettype wire
