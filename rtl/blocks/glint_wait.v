// glint_wait: data_o is data_i of CLOCKS enabled edges ago, kept in a memory; from few clocks on in registers.
//
// What glint_delay does, for long waits. A reset places the addresses; the memory keeps what it holds. Table of ports and
// parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_wait #(
    parameter WIDTH  = 1,
    parameter CLOCKS = 16  // at least 0
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             enable_i,
    input  wire [WIDTH-1:0] data_i,
    output wire [WIDTH-1:0] data_o
);

    function integer bits(input integer x);
        begin
            bits = 1;
            while ((1 << bits) < x) bits = bits + 1;
        end
    endfunction

    generate
        if (CLOCKS < 8) begin : registers
            glint_delay #(
                .WIDTH (WIDTH),
                .STAGES(CLOCKS)
            ) delay (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  (data_i),
                .data_o  (data_o)
            );
            wire unused = &{1'b0, rst_ni};
        end else begin : memory
            // Read CLOCKS - 1 edges after it was written: the register behind the memory is the last clock. No word is
            // written in the clock that reads it, since CLOCKS - 1 < 2^A.
            localparam         A     = bits(CLOCKS);
            localparam [A-1:0] AHEAD = CLOCKS[A-1:0] - 1'b1;
            reg [WIDTH-1:0] words[0:(1<<A)-1];
            reg [WIDTH-1:0] data_q;
            reg     [A-1:0] write_q, read_q;
            always @(posedge clk_i) begin
                if (!rst_ni) begin
                    write_q <= AHEAD;
                    read_q  <= {A{1'b0}};
                end else if (enable_i) begin
                    write_q <= write_q + 1'b1;
                    read_q  <= read_q + 1'b1;
                end
                if (enable_i) begin
                    words[write_q] <= data_i;
                    data_q         <= words[read_q];
                end
            end
            assign data_o = data_q;
        end
    endgenerate

endmodule

`default_nettype wire
