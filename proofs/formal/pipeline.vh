// Included by effect.vh and highlight.vh: the scoreboard beside a pipeline that moves as a whole, and where the
// watched item is in it. What includes it declares, of the pipeline of CLOCKS slots, slot 0 the first:
//   moves, slots_full, slots_after, slots_inside  its enable and valid bits; the bookkeeping of glint_ports.vh
//   slots_item                                    SLOT_W bits a slot, the item below
//   ITEM_W, item_in, item_out                     what travels with an item unchanged
//   RESULT_W, result                              all other outputs that valid vouches for
//   CAPACITY                                      most items in flight; 1: a full rate is not claimed

wire              watch_now, watching;
wire [ITEM_W-1:0] item;
wire        [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (ITEM_W),
    .RESULT_W  (RESULT_W),
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
    .in_data   (item_in),
    .out_valid (valid_o),
    .out_ready (ready_i),
    .out_data  (item_out),
    .out_result(result),
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
    else if (moves) mark_q <= {mark_q, watch_now};
end
genvar slot;
generate
    for (slot = 0; slot < CLOCKS; slot = slot + 1) begin : marks
        assign mark_ok[slot] = !mark_q[slot] || (slots_full[slot] && ahead == slots_after[6*slot+:6]
            && patience <= slot && item == slots_item[slot*SLOT_W+:ITEM_W]);
        assign drought_ok[slot] = slots_full[slot] && drought <= slot;
    end
endgenerate

always @* begin
    if (!$initstate) begin
        inv_count: assert (in_flight == slots_inside);
        if (in_flight != 0 && !slots_full[CLOCKS-1]) inv_drought: assert (|drought_ok);
        inv_mark: assert (watching == |mark_q && (mark_q & (mark_q - 1)) == 0 && &mark_ok);
    end
end
