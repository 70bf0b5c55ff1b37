// Included at the end of a copy of glint_effect_shade. The units of the terms are outside: each answers what was started in
// turn, after any number of clocks, with any number. The blocks `unit`, `lit`, ... continue those of the module, where the
// memories are.

localparam       DEPTH  = 1 << LOG_DEPTH;
localparam       SLOTS  = 6;  // from the join to the last memory: sum, four of the tail, total

(* hierconn *) wire [LOG_DEPTH:0] \fifo_tag.write_q ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_tag.written_q ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_tag.read_q ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_tag.held ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_tag.fresh ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_tag.place ;
(* hierconn *) wire [TAG_W+BUILT-1:0] \fifo_tag.at_place ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_total.held ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_total.fresh ;
(* hierconn *) wire [LOG_DEPTH:0] \fifo_total.place ;
(* hierconn *) wire [TOTAL_W-1:0] \fifo_total.at_place ;
(* hierconn *) wire         [3:0] \tail.valid_q ;
(* hierconn *) wire [4*(TAG_W+1)-1:0] \tail.delay_tag.contents ;

wire             watch_now, watching;
wire [TAG_W-1:0] item;
wire       [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (TAG_W),
    .RESULT_W  (3 * O + 25),
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
    .out_result({clamped_o, b_o, g_o, r_o}),
    .watch_now (watch_now),
    .watching  (watching),
    .item      (item),
    .in_flight (in_flight),
    .ahead     (ahead),
    .patience  (patience),
    .drought   (drought),
    .ready_run (ready_run)
);

// What came in with the watched item, and what the units answered to it.
reg [TAG_W+BUILT-1:0] item_waiting;
reg       [3*O+2:0] item_ka, item_kd, item_ks;
reg      [3*O+11:0] item_ia, item_i;
always @(posedge clk_i) begin
    if (watch_now) begin
        item_waiting <= waiting_in;
        {item_ka, item_kd, item_ks, item_ia, item_i} <= {ka_i, kd_i, ks_i, ia_i, i_i};
    end
end
wire           [N:0] item_asked;
wire [N*(O+9)-1:0] item_terms;  // {clamped, y} each, 0 where it was not asked for

// What has to become of it: the sums, and whether anything that was asked for was corrected, part by part.
localparam [O:0] ONE = 1 << O;
function above_one(input [3*O+2:0] colour);
    above_one = colour[O:0] > ONE || colour[2*O+1:O+1] > ONE || colour[3*O+2:2*O+2] > ONE;
endfunction
localparam SUM_W = O + 12;
wire [SUM_W*(N+1)-1:0] sums_d, sums_s;  // of the first terms, without saturation
assign sums_d[SUM_W-1:0] = 0;
assign sums_s[SUM_W-1:0] = 0;
wire      [SUM_W-1:0] sum_d = sums_d[N*SUM_W+:SUM_W];
wire      [SUM_W-1:0] sum_s = sums_s[N*SUM_W+:SUM_W];
wire      [N-1:0] clamped_terms;
wire      [O+7:0] diffuse_sum    = sum_d >> (O + 8) == 0 ? sum_d : {(O + 8) {1'b1}};
wire      [O+7:0] specular_sum   = sum_s >> (O + 8) == 0 ? sum_s : {(O + 8) {1'b1}};
wire              diffuse_asked  = |(item_asked & BUILT_DIFFUSE);
wire              specular_asked = |(item_asked & BUILT_SPECULAR);
wire              kd_clamped     = above_one(item_kd);
wire              ks_clamped     = above_one(item_ks);
wire              ka_clamped     = above_one(item_ka);
wire              item_clamped   = |clamped_terms || (item_asked[0] && ka_clamped) || (diffuse_asked && kd_clamped)
    || (specular_asked && ks_clamped);

// Where it is follows from how many are ahead of it: in the last memory, between the memories, or in the first ones.
wire [LOG_DEPTH+1:0] count_last = \fifo_total.held ;
wire     [SLOTS-1:0] full = {total_valid_q, \tail.valid_q , sum_valid_q};
wire           [3:0] count_between = full[0] + full[1] + full[2] + full[3] + full[4] + full[5];
wire                 at_last = watching && ahead < count_last;
wire                 waiting = watching && ahead >= count_last + count_between;
wire                 between = watching && !at_last && !waiting;
wire   [LOG_DEPTH:0] place   = ahead - count_last - count_between;
wire                 joins   = waiting && place == 0 && join_valid;
assign \fifo_tag.place   = place;
assign \fifo_total.place = ahead;

reg [SLOTS-1:0] mark_q;  // the slot between the memories that holds it
initial mark_q = 0;
always @(posedge clk_i) mark_q <= !rst_ni ? 0 : {mark_q, joins};

wire [TAG_W*SLOTS-1:0] slots_tag;
wire       [SLOTS-1:0] mark_ok;
wire             [3:0] tail_ok, diffuse_ok, specular_ok, ambient_ok;  // `clamped` and what was asked for, on the way
wire                   same_i, same_kd, same_ks, same_a;              // a memory holds what fifo_tag holds
wire                   at_place_i, at_place_kd, at_place_ks, at_place_a;
wire                   kept_i, kept_kd, kept_ks, kept_a;              // and gives the item's
wire                   light_ok, sum_d_ok, sum_s_ok;                  // beside sum_valid_q
wire [3*(LOG_DEPTH+1)-1:0] pointers = {\fifo_tag.write_q , \fifo_tag.written_q , \fifo_tag.read_q };
assign slots_tag[TAG_W-1:0] = sum_tag_q;
assign slots_tag[5*TAG_W+:TAG_W] = total_tag_q;
generate
    for (k = 0; k < 4; k = k + 1) begin : of_tail
        assign slots_tag[(k+1)*TAG_W+:TAG_W] = \tail.delay_tag.contents [k*(TAG_W+1)+:TAG_W];
        assign tail_ok[k] = !mark_q[k+1] || \tail.delay_tag.contents [k*(TAG_W+1)+TAG_W] == |clamped_terms;
    end
    for (k = 0; k < SLOTS; k = k + 1) begin : marks
        wire [3:0] after;
        if (k == SLOTS - 1) assign after = 0;
        else assign after = full[SLOTS-1-:SLOTS-1-k] == 0 ? 0 : count(full >> (k + 1));
        assign mark_ok[k] = !mark_q[k] || (full[k] && ahead == count_last + after && slots_tag[k*TAG_W+:TAG_W] == item);
    end
endgenerate
function [3:0] count(input [SLOTS-1:0] bits);
    count = bits[0] + bits[1] + bits[2] + bits[3] + bits[4] + bits[5];
endfunction

wire [N:0] late, unseen;  // of each unit, and of what came with the input: not yet answered, not yet to be read
assign late[0]   = 0;
assign unseen[0] = \fifo_tag.fresh != 0;

wire [N-1:0] term_ok, outstanding_ok, at_place_ok;

always @* begin
    // The terms that join are those of one item. Each of the first memories gives up what came with the item that joins, and the last one its tag.
    if (joins) asked_kept: assert (waiting_out == item_waiting);
    if (joins) terms_kept: assert (&term_ok);
    if (joins) colours_kept: assert (kept_i && kept_kd && kept_ks && kept_a);
    // The sums saturate as a whole, and stand beside their colours.
    if (mark_q[0]) sums_right: assert (sum_d_ok && sum_s_ok && light_ok);
    // `clamped` is said of the item, and of what was asked for alone.
    if (watching && ahead == 0 && rst_ni && valid_o) clamped_right: assert (clamped_o == item_clamped);
    // Nothing waits without a reason: here for a unit, or for the clock in which a memory is written.
    if (rst_ni && \fifo_tag.held != 0 && late == 0 && unseen == 0) joined: assert (join_valid);
    if (rst_ni && \fifo_total.held != 0 && \fifo_total.fresh == 0) shown: assert (valid_o);

    if (!$initstate) begin
        inv_count: assert (in_flight == held_q && in_flight == \fifo_tag.held + count_between + count_last);
        if (watching) inv_inside: assert (ahead < in_flight && item_waiting[TAG_W-1:0] == item);
        inv_mark: assert (between == |mark_q && (mark_q & (mark_q - 1)) == 0 && &mark_ok);
        inv_outstanding: assert (&outstanding_ok);
        if (waiting) inv_waiting: assert (\fifo_tag.at_place == item_waiting && &at_place_ok);
        inv_same: assert (same_i && same_kd && same_ks && same_a);
        if (waiting) inv_colours: assert (at_place_i && at_place_kd && at_place_ks && at_place_a);
        if (mark_q[0]) inv_clamped: assert (sum_clamped_q == |clamped_terms);
        inv_between: assert (&tail_ok && &diffuse_ok && &specular_ok && &ambient_ok);
        if (mark_q[5]) inv_total: assert (total_clamped_q == item_clamped);
        if (at_last) inv_last: assert (\fifo_total.at_place [3*(O+8)+:TAG_W] == item);
        if (at_last) inv_last_clamped: assert (\fifo_total.at_place [TOTAL_W-1] == item_clamped);
    end

    cover_joins:   cover (joins && late != 0 && place == 0 && \fifo_tag.held == 2);
    cover_full:    cover (rst_ni && in_flight == DEPTH && !ready_o && valid_o);
    cover_all_out: cover (watching && ahead == 0 && rst_ni && valid_o && ready_i && in_flight == DEPTH);
end

generate
    for (k = 0; k <= N; k = k + 1) begin : choice
        if (MASK[k]) begin : built
            localparam [N:0] UNDER = MASK & ~({(N + 1) {1'b1}} << k);
            assign item_asked[k] = item_waiting[TAG_W+ones(UNDER)];
        end else begin : absent
            assign item_asked[k] = 0;
        end
    end
    for (k = 0; k < N; k = k + 1) begin : unit
        if (MASK[k+1]) begin : built
            (* hierconn *) wire [LOG_DEPTH:0] \fifo.held ;
            (* hierconn *) wire [LOG_DEPTH:0] \fifo.fresh ;
            (* hierconn *) wire [LOG_DEPTH:0] \fifo.place ;
            (* hierconn *) wire [O+8:0]       \fifo.at_place ;
            (* hierconn *) wire [O+8:0]       \fifo.data_o ;
            assign \fifo.place = place;

            // What is proven of every unit: it answers only what was started.
            reg [LOG_DEPTH:0] outstanding;
            reg         [O+8:0] term;  // answered to the watched item
            wire answers = rst_ni && unit_valid_i[k];
            always @* assume (!(answers && outstanding == 0));
            always @(posedge clk_i) begin
                outstanding <= !rst_ni ? 0 : outstanding + start_o - answers;
                if (answers && waiting && place == \fifo.held ) term <= {unit_clamped_i[k], unit_y_i[(O+8)*k+:O+8]};
            end
            assign late[k+1]   = outstanding != 0;
            assign unseen[k+1] = \fifo.fresh != 0;
            assign item_terms[k*(O+9)+:O+9] = item_asked[k+1] ? term : 0;
            assign term_ok[k]        = \fifo.data_o == term;
            assign outstanding_ok[k] = outstanding + \fifo.held == \fifo_tag.held && outstanding <= \fifo_tag.held ;
            assign at_place_ok[k]    = place >= \fifo.held || \fifo.at_place == term;
        end else begin : absent
            assign late[k+1]   = 0;
            assign unseen[k+1] = 0;
            assign {term_ok[k], outstanding_ok[k], at_place_ok[k]} = 3'b111;
            assign item_terms[k*(O+9)+:O+9] = 0;
        end
    end
    for (k = 0; k < N; k = k + 1) begin : add
        assign clamped_terms[k] = item_terms[k*(O+9)+O+8];
        wire [O+7:0] y = item_terms[k*(O+9)+:O+8];
        assign sums_d[(k+1)*SUM_W+:SUM_W] = sums_d[k*SUM_W+:SUM_W] + (BUILT_DIFFUSE[k+1] ? y : 0);
        assign sums_s[(k+1)*SUM_W+:SUM_W] = sums_s[k*SUM_W+:SUM_W] + (BUILT_SPECULAR[k+1] ? y : 0);
    end

    if (|MASK[N:1]) begin : lit
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.write_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.written_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.read_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.place ;
        (* hierconn *) wire [3*O+11:0] \fifo.at_place ;
        (* hierconn *) wire [3*O+11:0] \fifo.data_o ;
        assign \fifo.place = place;
        assign same_i     = {\fifo.write_q , \fifo.written_q , \fifo.read_q } == pointers;
        assign at_place_i = \fifo.at_place == item_i;
        assign kept_i     = \fifo.data_o == item_i;
        assign light_ok   = light == item_i;
    end else begin : unlit
        assign {same_i, at_place_i, kept_i, light_ok} = 4'hf;
    end

    if (|BUILT_DIFFUSE) begin : with_diffuse
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.write_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.written_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.read_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.place ;
        (* hierconn *) wire [3*O+2:0] \part.fifo.at_place ;
        (* hierconn *) wire [3*O+2:0] \part.fifo.data_o ;
        (* hierconn *) wire [3*O+2:0] \part.k_q ;
        (* hierconn *) wire   [O+7:0] \part.sum_q ;
        (* hierconn *) wire           \part.asked_q ;
        (* hierconn *) wire     [7:0] \part.unit.stream.delay_tag.contents ;
        assign \part.fifo.place = place;
        assign same_kd     = {\part.fifo.write_q , \part.fifo.written_q , \part.fifo.read_q } == pointers;
        assign at_place_kd = \part.fifo.at_place == item_kd;
        assign kept_kd     = \part.fifo.data_o == item_kd;
        assign sum_d_ok    = \part.sum_q == diffuse_sum && \part.k_q == item_kd && \part.asked_q == diffuse_asked;
        for (k = 0; k < 4; k = k + 1) begin : slot
            assign diffuse_ok[k] = !mark_q[k+1] || \part.unit.stream.delay_tag.contents [2*k+:2] == {kd_clamped, diffuse_asked};
        end
    end else begin : without_diffuse
        assign {same_kd, at_place_kd, kept_kd, sum_d_ok, diffuse_ok} = 8'hff;
    end

    if (|BUILT_SPECULAR) begin : with_specular
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.write_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.written_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.read_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \part.fifo.place ;
        (* hierconn *) wire [3*O+2:0] \part.fifo.at_place ;
        (* hierconn *) wire [3*O+2:0] \part.fifo.data_o ;
        (* hierconn *) wire [3*O+2:0] \part.k_q ;
        (* hierconn *) wire   [O+7:0] \part.sum_q ;
        (* hierconn *) wire           \part.asked_q ;
        (* hierconn *) wire     [7:0] \part.unit.stream.delay_tag.contents ;
        assign \part.fifo.place = place;
        assign same_ks     = {\part.fifo.write_q , \part.fifo.written_q , \part.fifo.read_q } == pointers;
        assign at_place_ks = \part.fifo.at_place == item_ks;
        assign kept_ks     = \part.fifo.data_o == item_ks;
        assign sum_s_ok    = \part.sum_q == specular_sum && \part.k_q == item_ks && \part.asked_q == specular_asked;
        for (k = 0; k < 4; k = k + 1) begin : slot
            assign specular_ok[k] = !mark_q[k+1] || \part.unit.stream.delay_tag.contents [2*k+:2] == {ks_clamped, specular_asked};
        end
    end else begin : without_specular
        assign {same_ks, at_place_ks, kept_ks, sum_s_ok, specular_ok} = 8'hff;
    end

    if (MASK[0]) begin : with_ambient
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.write_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.written_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.read_q ;
        (* hierconn *) wire [LOG_DEPTH:0] \fifo.place ;
        (* hierconn *) wire [6*O+14:0] \fifo.at_place ;
        (* hierconn *) wire [6*O+14:0] \fifo.data_o ;
        (* hierconn *) wire      [5:0] \unit.stream.delay_tag.contents ;
        (* hierconn *) wire [2*(3*O+13)-1:0] \delay.contents ;
        assign \fifo.place = place;
        assign same_a     = {\fifo.write_q , \fifo.written_q , \fifo.read_q } == pointers;
        assign at_place_a = \fifo.at_place == {item_ka, item_ia};
        assign kept_a     = \fifo.data_o == {item_ka, item_ia};
        wire [2:0] unit_ok;
        for (k = 0; k < 3; k = k + 1) begin : slot
            assign unit_ok[k] = !mark_q[k] || \unit.stream.delay_tag.contents [2*k+:2] == {ka_clamped, item_asked[0]};
        end
        assign ambient_ok[0] = &unit_ok;
        assign ambient_ok[1] = !mark_q[3] || (\delay.contents [0] == (ka_clamped && item_asked[0])
            && (item_asked[0] || \delay.contents [3*O+12:1] == 0));
        assign ambient_ok[2] = !mark_q[4] || \delay.contents [3*O+13] == (ka_clamped && item_asked[0]);
        assign ambient_ok[3] = !mark_q[4] || item_asked[0] || ambient == 0;
    end else begin : without_ambient
        assign {same_a, at_place_a, kept_a, ambient_ok} = 7'h7f;
    end
endgenerate
