// glint_effect_lobe_select: one lobe of several, chosen for each input.
//
// The lobes' units stand beside it in the generated wrapper, each only where MASK has its bit. Each input goes to the one that
// it asks for; all share one line of registers, which a result joins where its unit is done. They and the line never stand
// still: as many inputs are accepted as the memory behind the line can hold. Contract: docs/effects/lobe_select.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_lobe_select #(
    parameter           O         = 12,  // fraction bits of the results
    parameter           N         = 2,   // lobes, at most 16
    parameter   [N-1:0] MASK      = {N{1'b1}},  // what is built: a bit a lobe
    parameter [8*N-1:0] CLOCKS    = {N{8'd2}},  // the latency of each lobe's unit, 8 bits each, 1 to 255
    parameter           LOG_DEPTH = 6,   // inputs in flight: 2^LOG_DEPTH; one a clock where that is no less than the latency
    parameter           TAG_W     = 16   // width of the tag, at least 1
) (
    input  wire               clk_i,
    input  wire               rst_ni,         // synchronous, active low
    input  wire               valid_i,
    output wire               ready_o,
    input  wire         [3:0] select_i,       // the number of a lobe, 0 .. N - 1
    input  wire   [TAG_W-1:0] tag_i,
    output wire               valid_o,
    input  wire               ready_i,
    output wire         [O:0] y_o,            // code / 2^O, 0 .. 2^O; 0 of a lobe that is not built
    output wire   [TAG_W-1:0] tag_o,
    output wire               clamped_o,
    output wire       [N-1:0] start_o,        // valid_i of each unit
    input  wire       [N-1:0] unit_valid_i,
    input  wire       [N-1:0] unit_clamped_i,
    input  wire [N*(O+1)-1:0] unit_y_i
);

    localparam LATENCY = slowest(MASK, CLOCKS);
    localparam PLACE_W = O + 2;  // of a place in the line: clamped, y

    function integer slowest(input [N-1:0] built, input [8*N-1:0] clocks);
        integer lobe;
        begin
            slowest = 1;
            for (lobe = 0; lobe < N; lobe = lobe + 1) begin
                if (built[lobe] && {24'd0, clocks[8*lobe+:8]} > slowest) slowest = {24'd0, clocks[8*lobe+:8]};
            end
        end
    endfunction

    // ---- what was accepted and not yet delivered -----------------------------------------------------------------------
    reg  [LOG_DEPTH:0] held_q;
    wire               deliver = valid_o & ready_i;
    assign             ready_o = rst_ni & ~held_q[LOG_DEPTH];
    wire               start   = valid_i & ready_o;
    always @(posedge clk_i) begin
        if (!rst_ni) held_q <= {(LOG_DEPTH + 1) {1'b0}};
        else held_q <= held_q + {{LOG_DEPTH{1'b0}}, start} - {{LOG_DEPTH{1'b0}}, deliver};
    end

    // ---- the lobe that is asked for; above the last one, the last ----------------------------------------------------------
    localparam [3:0] LAST  = N - 1;
    wire             above = select_i > LAST;
    wire       [3:0] lobe  = above ? LAST : select_i;
    genvar k;
    generate
        for (k = 0; k < N; k = k + 1) begin : unit
            localparam [3:0] NUMBER = k;
            if (MASK[k]) begin : built
                assign start_o[k] = start & lobe == NUMBER;
            end else begin : absent
                assign start_o[k] = 1'b0;
                wire unused = &{1'b0, lobe == NUMBER, unit_valid_i[k], unit_clamped_i[k], unit_y_i[(O+1)*k+:O+1]};
            end
        end
    endgenerate

    // ---- the line: place p - 1 holds what entered p clocks ago, 0 until its unit is done -------------------------------
    reg [LATENCY*PLACE_W-1:0] line_q, joining;
    integer i;
    always @* begin
        joining = {(LATENCY * PLACE_W) {1'b0}};
        for (i = 0; i < N; i = i + 1) begin
            if (MASK[i]) begin
                joining[(CLOCKS[8*i+:8]-1)*PLACE_W+:PLACE_W] = joining[(CLOCKS[8*i+:8]-1)*PLACE_W+:PLACE_W]
                    | ({unit_clamped_i[i], unit_y_i[(O+1)*i+:O+1]} & {PLACE_W{unit_valid_i[i]}});
            end
        end
    end
    always @(posedge clk_i) line_q <= line_q << PLACE_W | joining;
    wire         clamped;
    wire   [O:0] y;
    assign {clamped, y} = line_q[(LATENCY-1)*PLACE_W+:PLACE_W];

    wire             done, done_above, stream_ready, stream_advance;
    wire [TAG_W-1:0] done_tag;
    glint_stream #(
        .LATENCY(LATENCY + 1),
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (start),
        .ready_o  (stream_ready),
        .clamped_i(above),
        .tag_i    (tag_i),
        .valid_o  (done),
        .ready_i  (1'b1),
        .tag_o    (done_tag),
        .clamped_o(done_above),
        .advance_o(stream_advance)
    );
    wire unused_stream = &{1'b0, stream_ready, stream_advance};

    wire shown;
    glint_fifo #(
        .WIDTH    (TAG_W + PLACE_W),
        .LOG_DEPTH(LOG_DEPTH)
    ) fifo (
        .clk_i  (clk_i),
        .rst_ni (rst_ni),
        .push_i (done),
        .data_i ({done_above | clamped, done_tag, y}),
        .valid_o(shown),
        .pop_i  (deliver),
        .data_o ({clamped_o, tag_o, y_o})
    );
    assign valid_o = rst_ni & shown;

endmodule

`default_nettype wire
