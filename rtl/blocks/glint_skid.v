// glint_skid: a stream register slice. What it offers and what it accepts both come straight from registers, and it
// still moves one item a clock: the item that arrives while the receiver stalls goes into a second register.
// Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_skid #(
    parameter WIDTH = 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,  // synchronous, active low; only the valid bits and ready_o are reset
    input  wire             valid_i,
    output wire             ready_o,
    input  wire [WIDTH-1:0] data_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire [WIDTH-1:0] data_o
);

    reg             ready_q;     // there is room: the spare register is empty
    reg             valid_q;     // data_q holds an item
    reg [WIDTH-1:0] data_q;
    reg [WIDTH-1:0] spare_q;     // holds an item while ready_q is 0 outside reset
    reg             spare_full_q;

    assign ready_o = ready_q;
    assign valid_o = valid_q;
    assign data_o  = data_q;

    wire accept = valid_i & ready_q;
    wire leave  = ready_i | ~valid_q;  // data_q may be filled anew at the next edge

    // The spare register is full after the edge if it was and could not move on, or if an item had nowhere else to go.
    wire spare_full = ~leave & (spare_full_q | accept);

    always @(posedge clk_i) begin
        if (!rst_ni) begin
            ready_q      <= 1'b0;
            valid_q      <= 1'b0;
            spare_full_q <= 1'b0;
        end else begin
            ready_q      <= ~spare_full;
            spare_full_q <= spare_full;
            if (leave) valid_q <= spare_full_q | accept;
        end
        if (leave) data_q <= spare_full_q ? spare_q : data_i;
        if (accept) spare_q <= data_i;
    end

endmodule

`default_nettype wire
