// Included at the end of a copy of a stream unit (glint_bps, ...). What it needs of the unit: the ports of docs/rtl.md,
// `valid_q`, `advance`, LATENCY, and a glint_delay named delay_tag that carries {clamped, tag} through all LATENCY slots.

// Bookkeeping that the invariants rest on: for every slot of the pipeline, the number of items in the slots after it.
// The numbers of neighbours differ by one item or none, which is a relation that the solver can carry from clock to
// clock, where a count over all slots is not.
reg  [6*LATENCY-1:0] after_q;
wire           [5:0] inside = after_q[5:0] + valid_q[0];  // items in all slots
wire   [LATENCY-1:0] after_ok, after_bound;
genvar slot;
generate
    for (slot = 0; slot < LATENCY; slot = slot + 1) begin : slots
        wire [5:0] after = after_q[6*slot+:6];
        wire [5:0] before;  // what this slot's number is made of at the next step: that of the item that comes in
        if (slot == 0) assign before = inside;
        else assign before = after_q[6*(slot-1)+:6];
        always @(posedge clk_i) begin
            if (!rst_ni) after_q[6*slot+:6] <= 0;
            else if (advance) after_q[6*slot+:6] <= before - valid_q[LATENCY-1];
        end
        assign after_ok[slot]    = before == after + valid_q[slot] && (slot != LATENCY - 1 || after == 0);
        assign after_bound[slot] = after < LATENCY - slot && (slot == LATENCY - 1 || after >= valid_q[LATENCY-1]);
    end
endgenerate

always @* begin
    if (!$initstate) begin
        inv_after: assert (&after_ok);
        inv_after_bound: assert (&after_bound);
    end
end

`ifdef PROVE_STREAM

(* hierconn *) wire [(TAG_W+1)*LATENCY-1:0] \delay_tag.contents ;

wire              watch_now, watching;
wire  [TAG_W-1:0] item;
wire        [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (TAG_W),
    .RESULT_W  (O + 2),
    .CAPACITY  (LATENCY),
    .PATIENCE  (LATENCY),
    .DROUGHT   (LATENCY),
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

reg  [LATENCY-1:0] mark_q;  // the slot that holds the watched item
wire [LATENCY-1:0] mark_ok, drought_ok;
always @(posedge clk_i) begin
    if (!rst_ni) mark_q <= 0;
    else if (advance) mark_q <= {mark_q, watch_now};
end
generate
    for (slot = 0; slot < LATENCY; slot = slot + 1) begin : marks
        assign mark_ok[slot] = !mark_q[slot] || (valid_q[slot] && ahead == slots[slot].after && patience <= slot
            && item == \delay_tag.contents [slot*(TAG_W+1)+:TAG_W]);
        assign drought_ok[slot] = valid_q[slot] && drought <= slot;
    end
endgenerate

always @* begin
    if (!$initstate) begin
        inv_count: assert (in_flight == inside);
        if (in_flight != 0 && !valid_q[LATENCY-1]) inv_drought: assert (|drought_ok);
        inv_mark: assert (watching == |mark_q && (mark_q & (mark_q - 1)) == 0 && &mark_ok);
    end
end

`endif
