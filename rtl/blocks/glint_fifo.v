// glint_fifo: first in, first out, in a memory that is read by the clock (block RAM). It holds 2^LOG_DEPTH; whoever pushes
// has to know that there is room. What is pushed can be taken two clocks later. Table of ports and parameters: docs/rtl.md.

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

    reg [WIDTH-1:0] memory[0:(1<<LOG_DEPTH)-1];
    reg [WIDTH-1:0] data_q;

    // One bit more than an address, so that full and empty differ.
    reg  [LOG_DEPTH:0] write_q, read_q;
    reg  [LOG_DEPTH:0] written_q;  // write_q of one clock ago: up to there the memory can be read
    wire [LOG_DEPTH:0] read = read_q + {{LOG_DEPTH{1'b0}}, pop_i};
    always @(posedge clk_i) begin
        if (!rst_ni) begin
            write_q   <= {(LOG_DEPTH + 1) {1'b0}};
            written_q <= {(LOG_DEPTH + 1) {1'b0}};
            read_q    <= {(LOG_DEPTH + 1) {1'b0}};
        end else begin
            write_q   <= write_q + {{LOG_DEPTH{1'b0}}, push_i};
            written_q <= write_q;
            read_q    <= read;
        end
    end

    always @(posedge clk_i) begin
        if (push_i) memory[write_q[LOG_DEPTH-1:0]] <= data_i;
        data_q <= memory[read[LOG_DEPTH-1:0]];
    end

    assign valid_o = written_q != read_q;
    assign data_o  = data_q;

endmodule

`default_nettype wire
