// Included at the end of a copy of glint_fifo.

localparam DEPTH = 1 << LOG_DEPTH;
wire [LOG_DEPTH:0] held    = write_q - read_q;      // pushed and not yet popped
wire [LOG_DEPTH:0] fresh   = write_q - written_q;   // of these, those pushed at the last clock, which cannot be read yet

// What lies so many after the oldest; place is for the owner to drive.
wire [LOG_DEPTH:0] place;
wire [WIDTH-1:0] at_place = memory[(read_q + place) & {LOG_DEPTH{1'b1}}];

always @* begin
    if (!$initstate) begin
        inv_pointers: assert (held <= DEPTH && fresh <= 1 && fresh <= held);
        if (valid_o) inv_output: assert (data_o == memory[read_q[LOG_DEPTH-1:0]]);
    end
end

`ifdef PROVE_FIFO

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
assign place = ahead;

always @* begin
    // What the pointers say is what went in and out: there is no overflow and no underflow.
    if (!$initstate) begin
        held_counted: assert (in_flight == held);
        if (in_flight != 0 && !valid_o) inv_drought: assert (drought == 0 && fresh == 1);
        if (watching) begin
            inv_place: assert (ahead < held && at_place == item);
            inv_patience: assert (patience + ahead < DEPTH);
        end
    end

    cover_full:    cover (in_flight == DEPTH && valid_o);
    cover_wrapped: cover (pop_i && watching && ahead == 0 && write_q[LOG_DEPTH-1:0] == read_q[LOG_DEPTH-1:0]);
    cover_through: cover (push_i && pop_i && in_flight == 2);
end

`else

// Its owner keeps the rule.
always @* begin
    if (rst_ni && push_i) room_to_push: assert (held < DEPTH);
    if (rst_ni && pop_i) there_to_pop: assert (valid_o);
end

`endif
