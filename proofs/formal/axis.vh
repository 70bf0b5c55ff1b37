// Included at the end of a copy of a generated AXI4-Stream wrapper (glint_bps_axis_p12, ...): register slices, in glint_axis
// named axis, around a unit, named core. In the copy of a lobe's, F, O, the other word lengths and CORE_CLOCKS, the unit's
// latency, are parameters. axis.py puts before it what travels with an item (TAG_W, item_in, item_out), and what the words
// of tdata hold: offered, taken of OPERAND_W bits, given, result of RESULT_W bits, words.

localparam IN_W  = TAG_W + OPERAND_W;
localparam OUT_W = TAG_W + RESULT_W;

(* hierconn *) wire                         \axis.skid_in.valid_q ;
(* hierconn *) wire                         \axis.skid_in.ready_q ;
(* hierconn *) wire                         \axis.skid_in.spare_full_q ;
(* hierconn *) wire              [IN_W-1:0] \axis.skid_in.data_q ;
(* hierconn *) wire              [IN_W-1:0] \axis.skid_in.spare_q ;
(* hierconn *) wire                         \axis.skid_out.valid_q ;
(* hierconn *) wire                         \axis.skid_out.ready_q ;
(* hierconn *) wire                         \axis.skid_out.spare_full_q ;
(* hierconn *) wire             [OUT_W-1:0] \axis.skid_out.data_q ;
(* hierconn *) wire             [OUT_W-1:0] \axis.skid_out.spare_q ;
(* hierconn *) wire                         \core.ports.advance ;
(* hierconn *) wire           [CORE_CLOCKS-1:0] \core.ports.valid_q ;
(* hierconn *) wire         [6*CORE_CLOCKS-1:0] \core.ports.after_q ;
(* hierconn *) wire                   [5:0] \core.ports.inside ;
(* hierconn *) wire [(TAG_W+1)*CORE_CLOCKS-1:0] \core.ports.all.delay_tag.contents ;

wire             watch_now, watching;
wire [TAG_W-1:0] item;
wire       [7:0] in_flight, ahead, patience, drought, ready_run;

glint_scoreboard #(
    .WIDTH     (TAG_W),
    .RESULT_W  (WORDS_W),
    .CAPACITY  (CORE_CLOCKS + 4),
    .PATIENCE  (CORE_CLOCKS + 4),
    .DROUGHT   (CORE_CLOCKS + 2),
    .RATE      (2),
    .REGISTERED(1)
) scoreboard (
    .clk       (aclk),
    .rst_n     (aresetn),
    .in_valid  (s_axis_tvalid),
    .in_ready  (s_axis_tready),
    .in_data   (item_in),
    .out_valid (m_axis_tvalid),
    .out_ready (m_axis_tready),
    .out_data  (item_out),
    .out_result(m_axis_tdata),
    .watch_now (watch_now),
    .watching  (watching),
    .item      (item),
    .in_flight (in_flight),
    .ahead     (ahead),
    .patience  (patience),
    .drought   (drought),
    .ready_run (ready_run)
);

// Where the watched item is follows from how many are ahead of it: in skid_out, in the core, or in skid_in.
wire [7:0] count_out  = \axis.skid_out.valid_q + \axis.skid_out.spare_full_q ;
wire [7:0] count_core = \core.ports.inside ;
wire [7:0] count_in   = \axis.skid_in.valid_q + \axis.skid_in.spare_full_q ;
wire       at_out     = watching && ahead < count_out;
wire       at_in      = watching && ahead >= count_out + count_core;
wire       at_core    = watching && !at_out && !at_in;
wire       second     = at_out ? ahead == 1 : ahead == count_out + count_core + 1;  // in the spare register

reg    [CORE_CLOCKS-1:0] mark_q;  // the slot of the core that holds the watched item
reg  [OPERAND_W-1:0] operands;  // what came in with it
wire                 enters = at_in && !second && in_valid && in_ready;
wire                 leaves = mark_q[CORE_CLOCKS-1] && out_valid && out_ready;
always @(posedge aclk) begin
    if (!aresetn) mark_q <= 0;
    else if (\core.ports.advance ) mark_q <= {mark_q, enters};
    if (watch_now) operands <= offered;
    if (leaves) result <= given;
end

wire [CORE_CLOCKS-1:0] mark_ok, drought_ok;
genvar slot;
generate
    for (slot = 0; slot < CORE_CLOCKS; slot = slot + 1) begin : marks
        assign mark_ok[slot] = !mark_q[slot] || (\core.ports.valid_q [slot]
            && ahead == count_out + \core.ports.after_q [6*slot+:6]
            && patience + CORE_CLOCKS - slot + \axis.skid_out.spare_full_q <= CORE_CLOCKS + 3
            && item == \core.ports.all.delay_tag.contents [slot*(TAG_W+1)+:TAG_W]);
        assign drought_ok[slot] = \core.ports.valid_q [slot] && drought <= slot + 1;
    end
endgenerate

always @* begin
    // The core computes from what came in with the item, and its answer leaves with the item.
    if (aresetn && enters) operands_kept: assert (taken == operands);
    if (aresetn && watching && ahead == 0 && m_axis_tvalid) begin
        result_kept: assert (m_axis_tdata == words);
    end

    if (!$initstate) begin
        inv_count: assert (in_flight == count_out + count_core + count_in);
        inv_spare_in: assert (!(\axis.skid_in.spare_full_q && (\axis.skid_in.ready_q || !\axis.skid_in.valid_q )));
        inv_spare_out: assert (!(\axis.skid_out.spare_full_q && (\axis.skid_out.ready_q || !\axis.skid_out.valid_q )));
        // Not ready with room to spare: only in the clock after reset.
        if (!\axis.skid_in.ready_q && !\axis.skid_in.spare_full_q ) begin
            inv_ready_in: assert (in_flight == 0 && ready_run == 0);
        end
        if (!\axis.skid_out.ready_q && !\axis.skid_out.spare_full_q ) begin
            inv_ready_out: assert (in_flight == 0 && ready_run == 0);
        end
        if (ready_run != 0) inv_rate: assert (\axis.skid_out.ready_q );
        if (ready_run == 2) inv_rate_in: assert (\axis.skid_in.ready_q );
        inv_run: assert (ready_run <= 2);
        if (in_flight != 0 && !m_axis_tvalid) inv_drought: assert (count_core == 0 ? drought == 0 : |drought_ok);
        if (watching) inv_inside: assert (ahead < in_flight);
        inv_mark: assert (at_core == |mark_q && (mark_q & (mark_q - 1)) == 0 && &mark_ok);
        if (at_in) inv_in: assert ((second ? \axis.skid_in.spare_q : \axis.skid_in.data_q ) == {item, operands}
            && patience + CORE_CLOCKS + 1 + second + \axis.skid_out.spare_full_q <= CORE_CLOCKS + 3);
        if (at_out) inv_out: assert ((second ? \axis.skid_out.spare_q : \axis.skid_out.data_q ) == {item, result}
            && patience + second <= CORE_CLOCKS + 3);
    end

    cover_operands: cover (enters && second == 0 && operands != 0);
    cover_result:   cover (watching && ahead == 0 && m_axis_tvalid && m_axis_tdata[31] && m_axis_tdata[1:0] == 1);
end
