// glint_sqrt by its contract: radicand = root^2 + remainder, remainder <= 2 root, Y_W enabled edges after the radicand,
// and for as long as enable_i is 0 then. Verilog-2005, for any simulator.
//
//   parameters  Y_W as in glint_sqrt (up to 32)
//               ROOTS: so many, of random radicands and corners; 0: all that there are
//
// enable_i is 1 for 16 clocks, random for the next 16, and so on; while it is 0 the radicand is x. The last line is
// `1024 roots, 0 mismatches`; ten mismatches end the run.

`default_nettype none

module sqrt_tb;

    parameter Y_W   = 19;
    parameter ROOTS = 0;

    localparam X_W = 2 * Y_W;

    reg            clk;
    reg            enable;
    reg  [X_W-1:0] radicand;
    wire [Y_W-1:0] root;
    wire   [Y_W:0] remainder;

    glint_sqrt #(
        .Y_W(Y_W)
    ) sqrt (
        .clk_i      (clk),
        .enable_i   (enable),
        .radicand_i (radicand),
        .root_o     (root),
        .remainder_o(remainder)
    );

    initial clk = 1'b0;
    always #1 clk = ~clk;

    // ---- radicands ------------------------------------------------------------------------------------------------
    reg [X_W-1:0] next_radicand;
    reg           more;  // it has not been used yet
    integer       used;
    integer       seed;
    integer       bits;
    reg [X_W-1:0] drawn;

    // A square, one less or one more, all ones, or a random number: of up to X_W bits, as often of few as of many.
    task draw_radicand;
        begin
            bits  = 1 + {$random(seed)} % X_W;
            drawn = {X_W{1'b1}} & ({$random(seed), $random(seed)} >> (64 - bits));
            case ({$random(seed)} % 8)
                0: next_radicand = drawn[Y_W-1:0] * drawn[Y_W-1:0];
                1: next_radicand = drawn[Y_W-1:0] * drawn[Y_W-1:0] - 1;
                2: next_radicand = drawn[Y_W-1:0] * drawn[Y_W-1:0] + 1;
                3: next_radicand = {X_W{1'b1}} >> (X_W - bits);
                default: next_radicand = drawn;
            endcase
        end
    endtask

    task next;
        begin
            used = used + 1;
            if (ROOTS > 0) begin
                more = used < ROOTS;
                draw_radicand;
            end else begin
                more          = ~&next_radicand;
                next_radicand = next_radicand + 1;
            end
        end
    endtask

    // ---- results --------------------------------------------------------------------------------------------------
    reg [X_W-1:0] radicands[0:Y_W-1];  // those of the last Y_W enabled edges
    integer       entered;             // enabled edges
    integer       oldest;
    integer       roots;
    integer       mismatches;
    reg           wrong;               // the result at the outputs was complained about
    integer       clock, stalled;

    task compare;
        if (!wrong && (({2'b0, root} * {2'b0, root} + remainder === {2'b0, radicands[oldest]}) !== 1'b1
                       || (remainder <= {root, 1'b0}) !== 1'b1)) begin
            wrong      = 1'b1;
            mismatches = mismatches + 1;
            $display("FAILED: %0d: root %0d, remainder %0d", radicands[oldest], root, remainder);
        end
    endtask

    initial begin
        enable        = 1'b0;
        clock         = 0;
        stalled       = 0;
        entered       = 0;
        roots         = 0;
        mismatches    = 0;
        wrong         = 1'b0;
        used          = 0;
        seed          = 1;
        more          = 1'b1;
        next_radicand = 0;
        if (ROOTS > 0) draw_radicand;
        while ((more || roots < used) && mismatches < 10) begin
            @(posedge clk);
            clock  = clock + 1;
            oldest = entered % Y_W;
            if (entered >= Y_W) compare;  // whether this edge is enabled or not
            if (enable) begin
                if (entered >= Y_W) begin
                    roots = roots + 1;
                    wrong = 1'b0;
                end
                radicands[oldest] = radicand;
                entered           = entered + 1;
                if (more) next;
            end else begin
                stalled = stalled + 1;
            end
            if (clock % 32 < 16 || $random(seed) % 2 == 0) begin
                enable   <= 1'b1;
                radicand <= next_radicand;
            end else begin
                enable   <= 1'b0;
                radicand <= {X_W{1'bx}};
            end
        end
        if (mismatches == 0 && clock > 100 && stalled == 0) begin
            mismatches = 1;
            $display("FAILED: enable_i was never 0");
        end
        $display("%0d roots, %0d mismatches", roots, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
