// Included at the end of a copy of rtl/blocks/ecp5/glint_fifo.v.

localparam DEPTH = 1 << LOG_DEPTH;
wire [LOG_DEPTH:0] stored = write_q - next_q;  // in the memory; one more may stand in data_q

reg pushed_q;  // at the last clock: that one cannot be taken yet
always @(posedge clk_i) pushed_q <= rst_ni & push_i;

// The rule: nothing is pushed into a full memory, nothing popped from an empty one.
always @* begin
    assume (!(push_i && in_flight == DEPTH));
    assume (!(pop_i && !valid_o));
end

wire             watching;
wire [WIDTH-1:0] item;
wire       [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (WIDTH),
    .CAPACITY  (DEPTH),
    .PATIENCE  (DEPTH),
    .DROUGHT   (2),
    .FULL_RATE (0),
    .REGISTERED(2)
) scoreboard (
    .clk       (clk_i),
    .rst_n     (rst_ni),
    .in_valid  (push_i),
    .in_ready  (1'b1),
    .in_data   (data_i),
    .out_valid (valid_o),
    .out_ready (pop_i),
    .out_data  (data_o),
    .out_result(1'b0),
    .watch_now (),
    .watching  (watching),
    .item      (item),
    .in_flight (in_flight),
    .ahead     (ahead),
    .patience  (patience),
    .drought   (drought),
    .ready_run (ready_run)
);

// What lies `ahead` after the oldest: in data_q, or in the memory.
wire [LOG_DEPTH:0] behind = ahead - 1'b1;
wire [WIDTH-1:0] at_place = ahead == 0 && valid_q ? data_q
                          : memory[(next_q + (valid_q ? behind : ahead)) & {LOG_DEPTH{1'b1}}];

always @* begin
    if (!$initstate) begin
        held_counted:  assert (in_flight == stored + valid_q);
        // The clocks are those of the generic one, whose valid_o is this by its own pointers.
        same_clocks:   assert (valid_o == (in_flight != pushed_q));
        inv_pushed:    assert (!pushed_q || stored != 0);
        if (in_flight != 0 && !valid_o) inv_drought: assert (drought == 0);
        if (watching) begin
            inv_place:    assert (ahead < in_flight && at_place == item);
            inv_patience: assert (patience + ahead < DEPTH);
        end
    end

    cover_full:    cover (in_flight == DEPTH && valid_o);
    cover_wrapped: cover (pop_i && watching && ahead == 0 && write_q[LOG_DEPTH] != next_q[LOG_DEPTH]);
    cover_through: cover (push_i && pop_i && in_flight == 2);
end
