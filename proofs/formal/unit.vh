// Included at the end of a copy of a unit (glint_bps, ...). What it needs of the unit: the ports of docs/rtl.md, and an
// instance of glint_ports named ports. run.py puts the localparam CLOCKS before it. ITERATIVE: one item at a time.

(* hierconn *) wire                        \ports.advance ;
(* hierconn *) wire           [CLOCKS-1:0] \ports.valid_q ;
(* hierconn *) wire         [6*CLOCKS-1:0] \ports.after_q ;
(* hierconn *) wire                  [5:0] \ports.inside ;
wire              moves        = \ports.advance ;
wire [CLOCKS-1:0] slots_full   = \ports.valid_q ;
wire [6*CLOCKS-1:0] slots_after = \ports.after_q ;
wire        [5:0] slots_inside = \ports.inside ;

localparam SLOT_W   = TAG_W + 1;
localparam ITEM_W   = TAG_W;
localparam RESULT_W = O + 2;
`ifdef ITERATIVE
localparam CAPACITY = 1;
(* hierconn *) wire [TAG_W:0] \ports.one.tag_q ;
wire [SLOT_W*CLOCKS-1:0] slots_item = {CLOCKS{\ports.one.tag_q }};
`else
localparam CAPACITY = CLOCKS;
(* hierconn *) wire [SLOT_W*CLOCKS-1:0] \ports.all.delay_tag.contents ;
wire [SLOT_W*CLOCKS-1:0] slots_item = \ports.all.delay_tag.contents ;
`endif
wire   [ITEM_W-1:0] item_in  = tag_i;
wire   [ITEM_W-1:0] item_out = tag_o;
wire [RESULT_W-1:0] result   = {y_o, clamped_o};

`include "pipeline.vh"
