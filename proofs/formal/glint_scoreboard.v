// glint_scoreboard: the properties that every stream unit shares, in terms of its ports alone.
//
// It counts the items in flight and watches one of them, which the solver picks freely, from its acceptance to its
// departure. Since any item may be the watched one, what holds for it holds for all: the k-th item accepted since the
// reset is the k-th that leaves. A transfer is a clock edge with valid = ready = 1 outside reset.
// The internals that the invariants of a unit need leave through the outputs at the end of the port list.

`default_nettype none

module glint_scoreboard #(
    parameter WIDTH      = 1,  // bits that travel with an item unchanged
    parameter RESULT_W   = 1,  // bits of all other outputs that valid vouches for
    parameter CAPACITY   = 1,  // most items in flight
    parameter PATIENCE   = 1,  // an item leaves at the PATIENCE-th clock with out_ready = 1, or before; 0: not claimed
    parameter DROUGHT    = 1,  // with an item in flight, out_valid is 0 for less than DROUGHT clocks in a row; 0: not claimed
    parameter RATE       = 0,  // in_ready is 1 after RATE clocks in a row with out_ready = 1; 0: in the same clock
    parameter FULL_RATE  = 1,  // 0: the item a clock is not claimed
    parameter REGISTERED = 0   // 1: valid and ready are 0 in the clock after one with reset; 2: valid alone; 0: in the same clock
) (
    input  wire                clk,
    input  wire                rst_n,
    input  wire                in_valid,
    input  wire                in_ready,
    input  wire    [WIDTH-1:0] in_data,
    input  wire                out_valid,
    input  wire                out_ready,
    input  wire    [WIDTH-1:0] out_data,
    input  wire [RESULT_W-1:0] out_result,
    output wire                watch_now,  // the item accepted at this edge becomes the watched one
    output reg                 watching,
    output reg     [WIDTH-1:0] item,
    output reg           [7:0] in_flight,
    output reg           [7:0] ahead,      // items in flight that were accepted before the watched one
    output reg           [7:0] patience,   // clocks with out_ready = 1 since the watched item was accepted
    output reg           [7:0] drought,    // clocks in a row with an item in flight and out_valid = 0
    output reg           [7:0] ready_run   // clocks in a row with out_ready = 1, up to RATE
);

    (* anyseq *) wire watch;

    wire accept = rst_n & in_valid & in_ready;
    wire emit   = rst_n & out_valid & out_ready;

    // The books start empty; the unit starts in any state at all, and in reset.
    initial {watching, in_flight, drought, ready_run, reset_q, stall_q, was_two, was_cut, burst} = 0;

    assign watch_now = accept & watch & ~watching;

    always @* if ($initstate) assume (!rst_n);

    always @(posedge clk) begin
        if (!rst_n) begin
            in_flight <= 0;
            watching  <= 0;
            drought   <= 0;
            ready_run <= 0;
        end else begin
            in_flight <= in_flight + accept - emit;
            drought   <= (in_flight != 0 && !out_valid) ? drought + 1 : 0;
            ready_run <= !out_ready ? 0 : ready_run == RATE ? ready_run : ready_run + 1;
            if (watch_now) begin
                watching <= 1;
                item     <= in_data;
                ahead    <= in_flight - emit;
                patience <= 0;
            end else if (watching) begin
                if (emit) ahead <= ahead - 1;
                if (emit && ahead == 0) watching <= 0;
                patience <= patience + out_ready;
            end
        end
    end

    reg                      reset_q;  // the last clock had rst_n = 0
    reg                      stall_q;  // the last clock had an item at the output that could not leave
    reg [WIDTH+RESULT_W-1:0] held_q;   // what it offered
    always @(posedge clk) begin
        reset_q <= !rst_n;
        stall_q <= rst_n & out_valid & ~out_ready;
        held_q  <= {out_data, out_result};
    end

    always @* begin
        // Nothing comes out that did not go in since the reset, and nothing twice.
        if (rst_n && out_valid) nothing_invented: assert (in_flight != 0);
        // Nothing is lost, repeated or overtaken on the way, and what travels with an item is kept.
        if (rst_n && out_valid && watching && ahead == 0) in_turn: assert (out_data == item);
        // Nothing stays inside for ever: both bounds hold whatever the neighbours do.
        if (watching && PATIENCE != 0) delivered: assert (patience < PATIENCE);
        capacity: assert (in_flight <= CAPACITY);
        // valid never waits for ready.
        if (rst_n && in_flight != 0 && !out_valid && DROUGHT != 0) valid_does_not_wait: assert (drought + 1 < DROUGHT);
        // An item a clock, for as long as the receiver takes one a clock.
        if (FULL_RATE != 0 && rst_n && ready_run == RATE && (out_ready || RATE != 0)) full_rate: assert (in_ready);
        // A stalled output does not change and does not go away, except by reset.
        if (rst_n && stall_q) stable: assert (out_valid && {out_data, out_result} == held_q);
        // Reset closes both sides.
        if (REGISTERED != 0 ? reset_q : !rst_n) silent_in_reset: assert (!out_valid && (!in_ready || REGISTERED == 2));
    end

    // What is not shown to happen would make the properties empty. The bounds above are reached: they are exact.
    reg       was_two;   // two items were in flight since the reset
    reg       was_cut;   // a reset hit an item in flight
    reg       was_last;  // the watched item took the last room
    reg [2:0] burst;     // clocks in a row with a transfer on both sides
    always @(posedge clk) begin
        was_two <= rst_n && (was_two || in_flight >= 2);
        was_cut <= was_cut || (!rst_n && in_flight != 0);
        if (watch_now) was_last <= in_flight - emit == CAPACITY - 1;
        burst <= !(accept && emit) ? 0 : burst == 4 ? 4 : burst + 1;
    end

    wire watched_leaves = emit && watching && ahead == 0;

`ifndef DEEP_COVER
    always @* begin
        cover_leaves:  cover (watched_leaves);
        cover_stalled: cover (watched_leaves && stall_q);
        cover_reset:   cover (emit && was_cut);
    end
    generate
        if (CAPACITY > 1) begin : many
            always @* cover_drained: cover (rst_n && was_two && in_flight == 0);
        end
        if (FULL_RATE != 0) begin : fast
            always @* cover_burst: cover (rst_n && burst == 4);
        end else begin : slow
            always @* cover_exchange: cover (accept && emit);
        end
        if (DROUGHT > 1) begin : dry
            always @* cover_drought: cover (rst_n && in_flight != 0 && !out_valid && drought + 2 == DROUGHT);
        end
    endgenerate
`else
    // The full unit lies deep. To get there fast the solver is held to one way: fill without a pause, then empty.
    reg [7:0] clock;
    initial clock = 0;
    always @(posedge clk) clock <= clock + 1;
    always @* begin
        assume (rst_n == (clock != 0));
        assume (in_valid);
        assume (out_ready == (clock >= CAPACITY + 4));

        cover_full:     cover (in_flight == CAPACITY && out_valid && !out_ready && !in_ready);
        cover_last:     cover (watched_leaves && was_last);
        cover_patience: cover (watched_leaves && patience == PATIENCE - 1);
    end
`endif

endmodule

`default_nettype wire
