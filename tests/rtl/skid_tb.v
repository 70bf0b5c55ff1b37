// glint_skid against what docs/rtl.md says of it, clock by clock: a queue of two items, which offers while it holds
// one, accepts while it does not hold two, and hands out the oldest; whose outputs do not move with the inputs within a
// clock; which a reset empties. Verilog-2005, for any simulator. Without an offer, data_i is x.
//
// The last line is `10000 items, 0 mismatches`: so many left the queue; ten mismatches end the run.

`default_nettype none

module skid_tb;

    parameter WIDTH = 1;
    parameter ITEMS = 10000;

    reg              clk;
    reg              reset_n;
    reg              valid_in;
    wire             ready_in;
    reg  [WIDTH-1:0] data_in;
    wire             valid_out;
    reg              ready_out;
    wire [WIDTH-1:0] data_out;

    glint_skid #(
        .WIDTH(WIDTH)
    ) skid (
        .clk_i  (clk),
        .rst_ni (reset_n),
        .valid_i(valid_in),
        .ready_o(ready_in),
        .data_i (data_in),
        .valid_o(valid_out),
        .ready_i(ready_out),
        .data_o (data_out)
    );

    // ---- what it must be ------------------------------------------------------------------------------------------
    reg [WIDTH-1:0] queue[0:1];  // the oldest first
    integer         held;        // items in it
    reg             open;        // out of reset since an edge: offers and accepts at all

    integer items, longest_run, run;  // items that left; most in consecutive clocks
    integer full, empty, resets;      // clocks
    integer mismatches;
    integer clock;
    integer seed;
    integer offer_chance, take_chance;  // in sixteenths
    reg     accept, leave;

    task check;
        if (valid_out !== (open && held > 0) || ready_in !== (open && held < 2)
                || (valid_out && data_out !== queue[0])) begin
            mismatches = mismatches + 1;
            $display("FAILED: clock %0d, %0d items: valid %b, ready %b, data %h instead of %h", clock, held, valid_out,
                     ready_in, data_out, queue[0]);
        end
    endtask

    task edge_passes;  // what the edge does to the queue, by the inputs before it
        begin
            accept = open && valid_in && held < 2;
            leave  = open && ready_out && held > 0;
            if (leave) begin
                queue[0] = queue[1];
                held     = held - 1;
                items    = items + 1;
            end
            run = leave ? run + 1 : 0;
            if (run > longest_run) longest_run = run;
            if (accept) begin
                queue[held] = data_in;
                held        = held + 1;
            end
            if (!reset_n) held = 0;
            open = reset_n;
            if (held == 2) full = full + 1;
            if (held == 0) empty = empty + 1;
        end
    endtask

    function integer chance;
        input [1:0] draw;
        case (draw)
            2'd0: chance = 16;
            2'd1: chance = 12;
            2'd2: chance = 4;
            2'd3: chance = 1;
        endcase
    endfunction

    task drive;
        begin
            if (clock % 64 == 0) begin
                offer_chance = chance($random(seed));
                take_chance  = chance($random(seed));
            end
            reset_n   = clock > 3 && $random(seed) % 256 != 0;
            valid_in  = ($random(seed) & 15) < offer_chance;
            data_in   = valid_in ? {$random(seed), $random(seed)} : {WIDTH{1'bx}};
            ready_out = ($random(seed) & 15) < take_chance;
            if (!reset_n) resets = resets + 1;
        end
    endtask

    initial begin
        clk         = 1'b0;
        open        = 1'b0;
        held        = 0;
        items       = 0;
        run         = 0;
        longest_run = 0;
        full        = 0;
        empty       = 0;
        resets      = 0;
        mismatches  = 0;
        clock       = 0;
        seed        = 1;
        drive;
        while (items < ITEMS && mismatches < 10) begin
            #1 clk = 1'b1;
            edge_passes;
            clock = clock + 1;
            // Other inputs, and others again before the next edge: the outputs are what the edge made them.
            #1 check;
            reset_n   = ~reset_n;
            valid_in  = ~valid_in;
            data_in   = ~data_in;
            ready_out = ~ready_out;
            #1 check;
            clk = 1'b0;
            drive;
            #1 check;
        end
        if (mismatches == 0 && (longest_run < 32 || full == 0 || empty == 0 || resets < 8)) begin
            mismatches = 1;
            $display("FAILED: %0d items in a row, %0d clocks full, %0d empty, %0d in reset: too few", longest_run, full,
                     empty, resets);
        end
        $display("%0d items, %0d mismatches", items, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
