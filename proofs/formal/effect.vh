// Included at the end of a copy of an effect's unit (glint_effect_lambert, ...). What it needs of the unit: the ports of
// docs/adding-an-effect.md, and an instance of glint_stream named stream. run.py puts before it the localparam CLOCKS, and
// RESULT_W and result: the outputs beside the handshake.

(* hierconn *) wire                        \stream.advance ;
(* hierconn *) wire           [CLOCKS-1:0] \stream.valid_q ;
(* hierconn *) wire         [6*CLOCKS-1:0] \stream.after_q ;
(* hierconn *) wire                  [5:0] \stream.inside ;
(* hierconn *) wire [(TAG_W+1)*CLOCKS-1:0] \stream.delay_tag.contents ;
(* hierconn *) wire                        \stream.clamped_i ;
(* hierconn *) wire                        \stream.clamped_o ;
wire                        moves        = \stream.advance ;
wire           [CLOCKS-1:0] slots_full   = \stream.valid_q ;
wire         [6*CLOCKS-1:0] slots_after  = \stream.after_q ;
wire                  [5:0] slots_inside = \stream.inside ;
wire [(TAG_W+1)*CLOCKS-1:0] slots_item   = \stream.delay_tag.contents ;

// What was corrected is known when the item comes, and is said of it when it leaves.
localparam CAPACITY = CLOCKS;
localparam SLOT_W   = TAG_W + 1;
localparam ITEM_W   = TAG_W + 1;
wire [ITEM_W-1:0] item_in  = {\stream.clamped_i , tag_i};
wire [ITEM_W-1:0] item_out = {\stream.clamped_o , tag_o};  // clamped_o, but where an effect has its own

`include "pipeline.vh"
