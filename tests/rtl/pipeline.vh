// The bench of a block whose results come LATENCY enabled edges after their inputs, and stay while enable_i is 0. The module
// that includes this has
//   LATENCY, IN_W (bits of all inputs), THINGS ("roots"), COUNT: so many random inputs; 0: all, from FIRST on
//   the block, from `given`; `right`: its outputs are those of `past`; complain: prints what is wrong
//   draw_next: random inputs in `next`; following: those after `next`, or more = 0
// enable_i is 1 for 16 clocks, random for the next 16, and so on; while it is 0 the inputs are x. The last line is
// `15872 roots, 0 mismatches`; ten mismatches end the run. Verilog-2005, for any simulator.

    reg             clk, enable;
    reg  [IN_W-1:0] given;
    reg  [IN_W-1:0] past;  // inputs of LATENCY enabled edges ago
    reg  [IN_W-1:0] next;
    reg             more;  // these have not been used yet
    wire            right;
    integer         seed;

    reg  [IN_W-1:0] history[0:LATENCY-1];
    reg             wrong;                     // the result at the outputs was complained about
    integer         used, entered, items;      // inputs, enabled edges, results
    integer         mismatches, clock, stalled;

    initial clk = 1'b0;
    always #1 clk = ~clk;

    initial begin
        enable     = 1'b0;
        clock      = 0;
        stalled    = 0;
        entered    = 0;
        items      = 0;
        mismatches = 0;
        wrong      = 1'b0;
        used       = 0;
        seed       = 1;
        more       = 1'b1;
        next       = FIRST;
        if (COUNT > 0) draw_next;
        while ((more || items < used) && mismatches < 10) begin
            @(posedge clk);
            clock = clock + 1;
            if (entered >= LATENCY && !wrong && right !== 1'b1) begin  // whether this edge is enabled or not
                wrong      = 1'b1;
                mismatches = mismatches + 1;
                complain;
            end
            if (enable) begin
                if (entered >= LATENCY) items = items + 1;
                wrong                    = 1'b0;
                history[entered%LATENCY] = given;
                entered                  = entered + 1;
                if (more) begin
                    used = used + 1;
                    if (COUNT > 0) begin
                        more = used < COUNT;
                        draw_next;
                    end else following;
                end
            end else begin
                stalled = stalled + 1;
            end
            past = history[entered%LATENCY];
            if (clock % 32 < 16 || $random(seed) % 2 == 0) begin
                enable <= 1'b1;
                given  <= next;
            end else begin
                enable <= 1'b0;
                given  <= {IN_W{1'bx}};
            end
        end
        if (mismatches == 0 && clock > 100 && stalled == 0) begin
            mismatches = 1;
            $display("FAILED: enable_i was never 0");
        end
        $display("%0d %0s, %0d mismatches", items, THINGS, mismatches);
        $finish(0);
    end
