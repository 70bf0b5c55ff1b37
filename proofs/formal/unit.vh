// Included at the end of a copy of a unit (glint_bps, ...). What it needs of the unit: the ports of docs/rtl.md, and an
// instance of glint_ports named ports. run.py puts the localparam CLOCKS before it. ITERATIVE: one item at a time.

(* hierconn *) wire                         \ports.advance ;
(* hierconn *) wire           [CLOCKS-1:0] \ports.valid_q ;
(* hierconn *) wire         [6*CLOCKS-1:0] \ports.after_q ;
(* hierconn *) wire                   [5:0] \ports.inside ;
`ifdef ITERATIVE
(* hierconn *) wire               [TAG_W:0] \ports.one.tag_q ;
localparam CAPACITY = 1;
`else
(* hierconn *) wire [(TAG_W+1)*CLOCKS-1:0] \ports.all.delay_tag.contents ;
localparam CAPACITY = CLOCKS;
`endif

wire              watch_now, watching;
wire  [TAG_W-1:0] item;
wire        [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (TAG_W),
    .RESULT_W  (O + 2),
    .CAPACITY  (CAPACITY),
    .FULL_RATE (CAPACITY > 1),
    .PATIENCE  (CLOCKS),
    .DROUGHT   (CLOCKS),
    .RATE      (0),
    .REGISTERED(0)
) scoreboard (
    .clk       (clk_i),
    .rst_n     (rst_ni),
    .in_valid  (valid_i),
    .in_ready  (ready_o),
    .in_data   (tag_i),
    .out_valid (valid_o),
    .out_ready (ready_i),
    .out_data  (tag_o),
    .out_result({y_o, clamped_o}),
    .watch_now (watch_now),
    .watching  (watching),
    .item      (item),
    .in_flight (in_flight),
    .ahead     (ahead),
    .patience  (patience),
    .drought   (drought),
    .ready_run (ready_run)
);

reg  [CLOCKS-1:0] mark_q;  // the slot that holds the watched item
wire [CLOCKS-1:0] mark_ok, drought_ok;
always @(posedge clk_i) begin
    if (!rst_ni) mark_q <= 0;
    else if (\ports.advance ) mark_q <= {mark_q, watch_now};
end
genvar slot;
generate
    for (slot = 0; slot < CLOCKS; slot = slot + 1) begin : marks
        assign mark_ok[slot] = !mark_q[slot] || (\ports.valid_q [slot] && ahead == \ports.after_q [6*slot+:6]
`ifdef ITERATIVE
            && patience <= slot && item == \ports.one.tag_q [TAG_W-1:0]);
`else
            && patience <= slot && item == \ports.all.delay_tag.contents [slot*(TAG_W+1)+:TAG_W]);
`endif
        assign drought_ok[slot] = \ports.valid_q [slot] && drought <= slot;
    end
endgenerate

always @* begin
    if (!$initstate) begin
        inv_count: assert (in_flight == \ports.inside );
        if (in_flight != 0 && !\ports.valid_q [CLOCKS-1]) inv_drought: assert (|drought_ok);
        inv_mark: assert (watching == |mark_q && (mark_q & (mark_q - 1)) == 0 && &mark_ok);
    end
end
