// Streams a vector file of `glint vectors --format hex` through a unit and compares every result, in order.
// Verilog-2005, for any simulator; replay.py compiles and runs it with Icarus.
//
//   macros      UNIT: the module, such as glint_bps_p12; AXIS: it is an AXI4-Stream unit; NETLIST: it has no parameters
//               any more, and a tag (tuser) of the default width
//   parameters  F, O: fraction bits of its cosine and output; COUNT: how many vectors the file must hold
//   arguments   +vectors=FILE; +stalls: bubbles at the input and stalls at the output, else full speed
//
// What the unit must not look at is x: the inputs of a bubble, the ignored bits of s_axis_tdata. Before the first
// vector the unit is filled with inputs that a reset must discard. The last line is `10000 vectors, 0 mismatches`: how
// many results were compared, and how many complaints there were, each on a line of its own before; ten end the run.

`default_nettype none

module replay_tb;

    parameter F     = 0;
    parameter O     = 0;
    parameter COUNT = 0;

`ifndef NETLIST
    localparam TAG_W    = 24;    // not the default of the units
`elsif AXIS
    localparam TAG_W    = 16;
`else
    localparam TAG_W    = 15;    // and one bit for last_in
`endif
    localparam FILLING  = 64;    // clocks that fill any unit
    localparam PATIENCE = 2000;  // clocks without a result after which none is expected any more

    integer compared;
    integer mismatches;

    task finish;
        begin
            $display("%0d vectors, %0d mismatches", compared, mismatches);
            $finish(0);
        end
    endtask

    task complain;  // begins a line; the caller ends it
        begin
            mismatches = mismatches + 1;
            $write("FAILED: ");
        end
    endtask

    // ---- the vectors ----------------------------------------------------------------------------------------------
    reg        [95:0] vectors[0:COUNT-1];
    reg [8*1024-1:0] file;
    reg   [8*64-1:0] line;
    reg              stalls;
    reg       [95:0] word;
    integer          handle;
    integer          lines;
    integer          i;

    initial begin
        compared   = 0;
        mismatches = 0;
        stalls     = $test$plusargs("stalls");
        handle     = 0;
        lines      = 0;
        if ($value$plusargs("vectors=%s", file)) handle = $fopen(file, "r");
        if (handle == 0) begin
            complain;
            $display("vector file '%0s' cannot be read", file);
            finish;
        end else begin
            while ($fgets(line, handle) != 0) lines = lines + 1;
            $fclose(handle);
            if (lines == 0 || lines != COUNT) begin
                complain;
                $display("vector file '%0s' holds %0d lines, not %0d", file, lines, COUNT);
                finish;
            end else begin
                $readmemh(file, vectors);
                for (i = 0; i < COUNT && mismatches < 10; i = i + 1) begin
                    word = vectors[i];
                    if ((^word) === 1'bx || word[63:58] != 0 || word[47:33] != 0 || word[31:0] >> (O + 1) != 0
                            || (word[95:64] + (32'd2 << F)) >> (F + 2) != 0) begin
                        complain;
                        $display("word %0d of the file, %h, is no vector for F = %0d, O = %0d", i + 1, word, F, O);
                    end
                end
                if (mismatches > 0) finish;
            end
        end
    end

    // ---- the unit -------------------------------------------------------------------------------------------------
    reg              clk;
    reg              reset_n;
    reg              valid_in;
    wire             ready_in;
    reg       [95:0] offered;  // the vector at the input
    reg  [TAG_W-1:0] tag_in;
    reg              last_in;
    wire             valid_out;
    reg              ready_out;
    wire      [31:0] result;   // as m_axis_tdata: [31] clamped, [O:0] y
    wire [TAG_W-1:0] tag_out;
    wire             last_out;

`ifdef AXIS
    localparam AXI = 1;  // an offer stands until it is taken; outputs answer a reset after the edge

    `UNIT
`ifndef NETLIST
    #(
        .USER_W(TAG_W)
    )
`endif
    unit (
        .aclk         (clk),
        .aresetn      (reset_n),
        .s_axis_tdata ({{(30 - F) {1'bx}}, offered[64+F+1:64], 22'bx, offered[57:48]}),
        .s_axis_tuser (tag_in),
        .s_axis_tlast (last_in),
        .s_axis_tvalid(valid_in),
        .s_axis_tready(ready_in),
        .m_axis_tdata (result),
        .m_axis_tuser (tag_out),
        .m_axis_tlast (last_out),
        .m_axis_tvalid(valid_out),
        .m_axis_tready(ready_out)
    );
`else
    localparam AXI = 0;

    wire [O:0] y;
    wire       clamped;

    `UNIT
`ifndef NETLIST
    #(
        .TAG_W(TAG_W + 1)
    )
`endif
    unit (
        .clk_i    (clk),
        .rst_ni   (reset_n),
        .valid_i  (valid_in),
        .ready_o  (ready_in),
        .n_i      (offered[57:48]),
        .cos_i    (offered[64+F+1:64]),
        .tag_i    ({last_in, tag_in}),
        .valid_o  (valid_out),
        .ready_i  (ready_out),
        .y_o      (y),
        .tag_o    ({last_out, tag_out}),
        .clamped_o(clamped)
    );

    assign result = {clamped, {(30 - O) {1'b0}}, y};
`endif

    // `settled` rises while everything stands still, before the edge of the clock, and falls after it: what is read at the
    // one and changed at the other meets no edge, in any simulator.
    reg settled;

    initial begin
        clk    = 1'b0;
        settled = 1'b0;
    end
    always begin
        #1 settled = 1'b1;
        #1 clk = 1'b1;
        #1 settled = 1'b0;
        #1 clk = 1'b0;
    end

    // ---- what is offered and what is taken ------------------------------------------------------------------------
    integer clock;           // edges since the first vector was offered
    integer progress_clock;  // the last one at which a result was taken
    integer sent_clock;      // of the first vector
    integer first_clock;     // of the first result
    integer sent;            // vectors accepted
    integer held;            // inputs that the unit accepts while nothing leaves it
    integer bubbles, stall_clocks, refusals;
    reg     refused;         // an input was not taken at the last edge
    reg     waiting;         // a result was not taken at the last edge
    reg     wrong;           // and it was complained about

    integer seed;
    integer offer_chance, take_chance;  // in sixteenths

    function integer chance;
        input [1:0] draw;
        case (draw)
            2'd0: chance = 16;
            2'd1: chance = 12;
            2'd2: chance = 4;
            2'd3: chance = 1;
        endcase
    endfunction

    // What the unit sees at the next edge.
    task drive;
        begin
            if (stalls && clock % 64 == 0) begin
                offer_chance = chance($random(seed));
                take_chance  = chance($random(seed));
            end
            if (sent < COUNT && ((AXI && refused) || ($random(seed) & 15) < offer_chance)) begin
                valid_in = 1'b1;
                offered  = vectors[sent];
                tag_in   = ~sent;
                last_in  = ^sent;
            end else begin
                if (sent < COUNT) bubbles = bubbles + 1;
                valid_in = 1'b0;
                offered  = 96'bx;
                tag_in   = {TAG_W{1'bx}};
                last_in  = 1'bx;
            end
            ready_out = ($random(seed) & 15) < take_chance;
        end
    endtask

    // Whatever is offered must be right, at every clock that it has to wait.
    reg      [95:0] expected;
    reg      [31:0] expected_result;
    reg [TAG_W-1:0] expected_tag;

    task compare;
        begin
            expected        = vectors[compared];
            expected_result = expected[31:0] | {expected[32], 31'b0};
            expected_tag    = ~compared;
            if (!wrong && (result !== expected_result || tag_out !== expected_tag || last_out !== ^compared)) begin
                wrong = 1'b1;
                complain;
                $display("vector %0d, n = %0d, cos_code = %0d: y %0d, clamped %b, tag %h %b; expected %0d, %b, %h %b",
                         compared + 1, expected[57:48], $signed(expected[95:64]), result[30:0], result[31], tag_out,
                         last_out, expected[30:0], expected[32], expected_tag, ^compared);
            end
        end
    endtask

    task observe;
        begin
            if ((valid_out ^ ready_in) === 1'bx) begin
                complain;
                $display("clock %0d: valid is %b, ready is %b", clock, valid_out, ready_in);
            end
            if (waiting && !valid_out) begin
                complain;
                $display("clock %0d: result %0d was withdrawn", clock, compared + 1);
            end
            waiting = valid_out && !ready_out;
            if (waiting) stall_clocks = stall_clocks + 1;
            if (valid_out && compared >= sent) begin
                complain;
                $display("clock %0d: a result that no input had asked for", clock);
            end else if (valid_out) begin
                compare;
                if (ready_out) begin
                    wrong = 1'b0;
                    if (compared == 0) first_clock = clock;
                    compared       = compared + 1;
                    progress_clock = clock;
                end
            end
            refused = valid_in && !ready_in;
            if (refused) refusals = refusals + 1;
            if (valid_in && ready_in) begin
                if (sent == 0) sent_clock = clock;
                sent = sent + 1;
            end
        end
    endtask

    task in_reset;
        input first;  // its first edge
        begin
            @(posedge settled);
            if (!(AXI && first) && (valid_out !== 1'b0 || ready_in !== 1'b0)) begin
                complain;
                $display("in reset: valid is %b, ready is %b", valid_out, ready_in);
            end
            @(negedge settled);
        end
    endtask

    initial begin
        reset_n   = 1'b0;
        valid_in  = 1'b0;
        ready_out = 1'b0;
        in_reset(1);
        in_reset(0);
        in_reset(0);

        // Fill the unit and let nothing leave it; then one edge in reset must discard everything.
        reset_n  = 1'b1;
        valid_in = 1'b1;
        offered  = vectors[0];
        tag_in   = {TAG_W{1'b0}};  // the tags of the vectors begin at the other end
        last_in  = 1'b1;
        held     = 0;
        repeat (FILLING) begin
            @(posedge settled);
            if (ready_in === 1'b1) held = held + 1;
            @(negedge settled);
        end
        if (valid_out !== 1'b1 || ready_in !== 1'b0) begin
            complain;
            $display("after %0d inputs, of which none could leave: valid is %b, ready is %b", held, valid_out,
                     ready_in);
        end
        reset_n = 1'b0;
        in_reset(1);
        reset_n = 1'b1;

        seed           = 1;
        offer_chance   = 16;
        take_chance    = 16;
        clock          = 0;
        progress_clock = 0;
        sent           = 0;
        bubbles        = 0;
        stall_clocks   = 0;
        refusals       = 0;
        refused        = 1'b0;
        waiting        = 1'b0;
        wrong          = 1'b0;
        drive;
        // After the last result the unit is watched for one more.
        while (clock - progress_clock < (compared == COUNT ? 2 * FILLING : PATIENCE) && mismatches < 10) begin
            @(posedge settled);
            clock = clock + 1;
            observe;
            @(negedge settled);
            drive;
        end

        if (mismatches >= 10) begin
            $display("ended after ten mismatches");
        end else if (sent < COUNT || compared < COUNT) begin
            complain;
            $display("%0d of %0d vectors were accepted, %0d results came", sent, COUNT, compared);
        end else if (stalls) begin
            $display("%0d clocks, %0d bubbles, %0d stalls, %0d refusals", clock, bubbles, stall_clocks, refusals);
            if (COUNT >= 100 && (bubbles == 0 || stall_clocks == 0 || refusals == 0)) begin
                complain;
                $display("each must occur");
            end
        end else begin
            $display("latency %0d, holds %0d", first_clock - sent_clock, held);
            if (progress_clock - first_clock != COUNT - 1) begin
                complain;
                $display("%0d clocks from the first result to the last", progress_clock - first_clock + 1);
            end
        end
        finish;
    end

endmodule

`default_nettype wire
