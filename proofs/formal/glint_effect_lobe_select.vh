// Included at the end of a copy of glint_effect_lobe_select. The lobes' units are outside: each answers what was started its
// CLOCKS ago, and nothing else, with any number.

localparam DEPTH = 1 << LOG_DEPTH;
localparam SLOTS = LATENCY + 1;  // of the stream: what entered a clock ago is in slot 0, and in place p of the line with slot p + 1

(* hierconn *) wire            [LOG_DEPTH:0] \fifo.held ;
(* hierconn *) wire            [LOG_DEPTH:0] \fifo.place ;
(* hierconn *) wire  [TAG_W+PLACE_W-1:0] \fifo.at_place ;
(* hierconn *) wire              [SLOTS-1:0] \stream.valid_q ;
(* hierconn *) wire  [SLOTS*(TAG_W+1)-1:0] \stream.delay_tag.contents ;

wire             watch_now, watching;
wire [TAG_W-1:0] item;
wire       [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (TAG_W),
    .RESULT_W  (PLACE_W),
    .CAPACITY  (DEPTH),
    .FULL_RATE (0),
    .PATIENCE  (0),
    .DROUGHT   (0),
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
    .out_result({clamped_o, y_o}),
    .watch_now (watch_now),
    .watching  (watching),
    .item      (item),
    .in_flight (in_flight),
    .ahead     (ahead),
    .patience  (patience),
    .drought   (drought),
    .ready_run (ready_run)
);

// The watched item: which lobe it asked for, whether that number was too great, and what the unit answered.
reg           [3:0] item_lobe;
reg                 item_above;
reg   [PLACE_W-1:0] item_result;
reg     [SLOTS-1:0] mark_q;  // the slot that holds it
initial mark_q = 0;
wire                item_built = item_lobe < N && MASK[item_lobe];
wire          [7:0] item_clocks = item_built ? CLOCKS[8*item_lobe+:8] : 0;
wire                answered = item_built && mark_q[item_clocks-1] && watching;
always @(posedge clk_i) begin
    mark_q <= !rst_ni ? 0 : {mark_q, watch_now};
    if (watch_now) {item_above, item_lobe, item_result} <= {above, lobe, {PLACE_W{1'b0}}};
    else if (answered) item_result <= {unit_clamped_i[item_lobe], unit_y_i[item_lobe*(O+1)+:O+1]};
end

wire [N-1:0] units_ok;
wire [SLOTS-1:0] mark_ok;
generate
    for (k = 0; k < N; k = k + 1) begin : units
        localparam [7:0] OWN = CLOCKS[8*k+:8];
        reg [OWN-1:0] started_q;  // what started so many clocks ago
        always @(posedge clk_i) started_q <= !rst_ni ? 0 : {started_q, start_o[k]};
        always @* if (MASK[k]) assume (unit_valid_i[k] == started_q[OWN-1]);
        // Where the item is, this unit was started for it or was not.
        wire [SLOTS-1:0] marked = mark_q & {{SLOTS{1'b0}}, {OWN{1'b1}}};
        assign units_ok[k] = marked == 0 || (marked & started_q) == (item_lobe == k && MASK[k] ? marked : 0);
    end
    for (k = 0; k < SLOTS; k = k + 1) begin : slots
        wire [7:0] after;
        if (k == SLOTS - 1) assign after = 0;
        else assign after = count(\stream.valid_q >> (k + 1));
        wire [PLACE_W-1:0] joined;
        if (k == 0) assign joined = 0;
        else assign joined = line_q[(k-1)*PLACE_W+:PLACE_W];
        assign mark_ok[k] = !mark_q[k] || (\stream.valid_q [k] && ahead == \fifo.held + after
            && \stream.delay_tag.contents [k*(TAG_W+1)+:TAG_W+1] == {item_above, item}
            && joined == (k < item_clocks || !item_built ? 0 : item_result));
    end
endgenerate
function [7:0] count(input [SLOTS-1:0] bits);
    integer slot;
    begin
        count = 0;
        for (slot = 0; slot < SLOTS; slot = slot + 1) count = count + bits[slot];
    end
endfunction

assign \fifo.place = ahead;
wire [PLACE_W-1:0] wanted = {item_result[O+1] | item_above, item_result[O:0]};

always @* begin
    if (rst_ni && watching && valid_o && ahead == 0) right: assert ({clamped_o, y_o} == wanted);
    if (!$initstate) begin
        inv_count: assert (held_q == in_flight && held_q == \fifo.held + count(\stream.valid_q ) && held_q <= DEPTH);
        inv_lobe: assert (!watching || (item_lobe < N && (item_built || item_result == 0)));
        inv_one: assert ((mark_q & (mark_q - 1)) == 0 && (watching || mark_q == 0));
        inv_units: assert (&units_ok);
        inv_mark: assert (&mark_ok);
        if (watching && mark_q == 0) inv_memory: assert (ahead < \fifo.held
            && \fifo.at_place == {wanted[O+1], item, wanted[O:0]});
    end
    cover_overtaken: cover (watching && item_lobe == 0 && rst_ni && valid_o && ahead == 0 && item_result != 0);
    cover_full:      cover (rst_ni && in_flight == DEPTH && !ready_o);
    cover_clamped:   cover (watching && item_above && rst_ni && valid_o && ahead == 0);
end
