// Included at the end of a copy of the generated unit of phong or blinn_phong, which connects glint_effect_highlight, named
// highlight, to a lobe's unit, named lobe. run.py puts the localparam CLOCKS before it, and F, O and the widths are numbers.

(* hierconn *) wire                        \lobe.ports.advance ;
(* hierconn *) wire           [CLOCKS-1:0] \lobe.ports.valid_q ;
(* hierconn *) wire         [6*CLOCKS-1:0] \lobe.ports.after_q ;
(* hierconn *) wire                  [5:0] \lobe.ports.inside ;
(* hierconn *) wire [(TAG_W+3)*CLOCKS-1:0] \lobe.ports.all.delay_tag.contents ;
(* hierconn *) wire                        \highlight.facing ;
wire                        moves        = \lobe.ports.advance ;
wire           [CLOCKS-1:0] slots_full   = \lobe.ports.valid_q ;
wire         [6*CLOCKS-1:0] slots_after  = \lobe.ports.after_q ;
wire                  [5:0] slots_inside = \lobe.ports.inside ;
wire [(TAG_W+3)*CLOCKS-1:0] slots_item   = \lobe.ports.all.delay_tag.contents ;

// Whether the surface faces the light and what was corrected travel with the tag.
localparam CAPACITY = CLOCKS;
localparam SLOT_W   = TAG_W + 3;
localparam ITEM_W   = TAG_W + 2;
wire [ITEM_W-1:0] item_in  = {$signed(nl_i) > 0, tag_in[TAG_W], tag_i};
wire [ITEM_W-1:0] item_out = {\highlight.facing , clamped_o, tag_o};

`include "pipeline.vh"

always @* begin
    // No light from behind the surface, for the item itself and not for a neighbour.
    if (rst_ni && valid_o && watching && ahead == 0 && !item[TAG_W+1]) dark_behind: assert (y_o == 0);
    cover_dark: cover (valid_o && watching && ahead == 0 && !item[TAG_W+1] && y != 0);
end
