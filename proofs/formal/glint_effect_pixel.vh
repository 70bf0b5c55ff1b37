// Included at the end of a copy of glint_effect_pixel: from its inputs to what shade gets. shade, which is proven by itself,
// and what glint_frame computes may answer anything.

(* hierconn *) wire                         \stream.advance ;
(* hierconn *) wire            [CLOCKS-1:0] \stream.valid_q ;
(* hierconn *) wire          [6*CLOCKS-1:0] \stream.after_q ;
(* hierconn *) wire                   [5:0] \stream.inside ;
(* hierconn *) wire                   [7:0] \wait_others.age ;
(* hierconn *) wire    [WIDE+TAG_W-1:0] \wait_others.at_age ;

// The tag and the other inputs of shade travel with an item.
localparam CAPACITY = CLOCKS;
localparam ITEM_W   = WIDE + TAG_W;
localparam SLOT_W   = ITEM_W;
localparam RESULT_W = 1;
wire                      moves        = \stream.advance ;
wire         [CLOCKS-1:0] slots_full   = \stream.valid_q ;
wire       [6*CLOCKS-1:0] slots_after  = \stream.after_q ;
wire                [5:0] slots_inside = \stream.inside ;
wire [CLOCKS*ITEM_W-1:0] slots_item   = {CLOCKS{\wait_others.at_age }};  // where the watched item is, that is all
wire         [ITEM_W-1:0] item_in  = {tag_i, waiting_i};
wire         [ITEM_W-1:0] item_out = {tag_o, waited_o};
wire                      result   = 1'b0;
wire                      valid_o  = start_o;
wire                      ready_i  = taken_i;

`include "pipeline.vh"

// The slot that holds the watched item.
function [7:0] number(input [CLOCKS-1:0] bits);
    integer k;
    begin
        number = 0;
        for (k = 0; k < CLOCKS; k = k + 1) if (bits[k]) number = k;
    end
endfunction
assign \wait_others.age = number(mark_q);

// A channel is cut to 0 .. 1 by itself.
wire [2:0] cut_ok;
generate
    for (c = 0; c < 3; c = c + 1) begin : cut
        wire [O+7:0] whole = sum_i[(O+8)*c+:O+8];
        assign cut_ok[c] = pixel_o[(O+1)*c+:O+1] == (whole > (1 << O) ? 1 << O : whole);
    end
endgenerate
always @* cut_right: assert (&cut_ok);
