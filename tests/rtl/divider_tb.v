// glint_divider by its contract: for divisor > 0 and dividend < divisor * 2^Q_W,
//   dividend = divisor * quotient + remainder, remainder < divisor, and beside_o is what was beside these operands,
// LATENCY enabled edges after them, and for as long as enable_i is 0 then. Verilog-2005, for any simulator. All dividers
// but the iterative one: divider_iterative_tb.v.
//
//   parameters  X_W, Y_W, Q_W (Y_W and Q_W up to 64), DIVIDER, REGISTER_EVERY, MULTIPLIER_STAGES as in glint_divider
//               LATENCY: what docs/rtl.md says for them
//               DIVISIONS: so many, of random operands and corners; 0: all that there are
//
// enable_i is 1 for 16 clocks, random for the next 16, and so on; while it is 0 the operands are x. The last line is
// `15872 divisions, 0 mismatches`; ten mismatches end the run.

`default_nettype none

module divider_tb;

    parameter X_W       = 34;
    parameter Y_W       = 28;
    parameter Q_W       = 16;
    parameter DIVISIONS = 0;
    parameter DIVIDER   = 0;
    parameter LATENCY   = 16;
    parameter REGISTER_EVERY    = 1;
    parameter MULTIPLIER_STAGES = 1;

    localparam W = Y_W + Q_W;  // of every legal dividend, and of divisor * quotient + remainder

    reg            clk;
    reg            enable;
    reg  [X_W-1:0] dividend;
    reg  [Y_W-1:0] divisor;
    wire [Q_W-1:0] quotient;
    wire [Y_W-1:0] remainder;
    wire [Y_W-1:0] beside;

    glint_divider #(
        .X_W              (X_W),
        .Y_W              (Y_W),
        .Q_W              (Q_W),
        .DIVIDER          (DIVIDER),
        .REGISTER_EVERY   (REGISTER_EVERY),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .BESIDE_W         (Y_W)
    ) divider (
        .clk_i      (clk),
        .enable_i   (enable),
        .start_i    (1'b0),
        .dividend_i (dividend),
        .divisor_i  (divisor),
        .beside_i   (~divisor),
        .done_o     (),
        .quotient_o (quotient),
        .remainder_o(remainder),
        .beside_o   (beside)
    );

    initial clk = 1'b0;
    always #1 clk = ~clk;

    // ---- operands -------------------------------------------------------------------------------------------------
    reg     [W:0] next_dividend;  // a bit more than needed, to see a count run over
    reg [Y_W-1:0] next_divisor;
    reg           more;           // they have not been used yet
    integer       used;           // operands used
    integer       seed;

    // 1, a power of two, all ones, or a random number: of up to so many bits, as often of few as of many.
    function [63:0] draw;
        input integer most;
        integer bits;
        begin
            bits = 1 + {$random(seed)} % most;
            case ({$random(seed)} % 8)
                0: draw = 1;
                1: draw = 64'd1 << (bits - 1);
                2: draw = ~64'd0 >> (64 - bits);
                3: draw = ~64'd0 >> (64 - most);
                default: draw = {$random(seed), $random(seed)} >> (64 - bits);
            endcase
        end
    endfunction

    reg [W-1:0] drawn;

    task draw_operands;
        begin
            next_divisor = draw(Y_W);
            if (next_divisor == 0) next_divisor = 1;
            case ({$random(seed)} % 4)
                0: drawn = 0;
                1: drawn = next_divisor - 1;
                default: drawn = draw(Y_W) % next_divisor;
            endcase
            drawn         = drawn + next_divisor * draw(Q_W);
            next_dividend = drawn[X_W-1:0];  // what is cut off makes it smaller: still legal
        end
    endtask

    task next_operands;
        begin
            used = used + 1;
            if (DIVISIONS > 0) begin
                more = used < DIVISIONS;
                draw_operands;
            end else begin
                next_dividend = next_dividend + 1;
                if (next_dividend >> X_W != 0 || next_dividend >> Q_W == next_divisor) begin
                    next_dividend = 0;
                    more          = ~&next_divisor;
                    next_divisor  = next_divisor + 1;
                end
            end
        end
    endtask

    // ---- results --------------------------------------------------------------------------------------------------
    reg [X_W-1:0] dividends[0:LATENCY-1];  // the operands at the last LATENCY enabled edges
    reg [Y_W-1:0] divisors[0:LATENCY-1];
    integer       entered;             // enabled edges
    integer       oldest;
    integer       divisions;
    integer       mismatches;
    reg           wrong;               // the result at the outputs was complained about
    integer       clock, stalled;

    task compare;
        if (!wrong && ((divisors[oldest] * {{Y_W{1'b0}}, quotient} + remainder === dividends[oldest]) !== 1'b1
                       || (remainder < divisors[oldest]) !== 1'b1 || beside !== ~divisors[oldest])) begin
            wrong      = 1'b1;
            mismatches = mismatches + 1;
            $display("FAILED: %0d / %0d: quotient %0d, remainder %0d, beside %0d", dividends[oldest],
                     divisors[oldest], quotient, remainder, ~beside);
        end
    endtask

    initial begin
        enable        = 1'b0;
        clock         = 0;
        stalled       = 0;
        entered       = 0;
        divisions     = 0;
        mismatches    = 0;
        wrong         = 1'b0;
        used          = 0;
        seed          = 1;
        more          = 1'b1;
        next_divisor  = 1;
        next_dividend = 0;
        if (DIVISIONS > 0) draw_operands;
        while ((more || divisions < used) && mismatches < 10) begin
            @(posedge clk);
            clock  = clock + 1;
            oldest = entered % LATENCY;
            if (entered >= LATENCY) compare;  // whether this edge is enabled or not
            if (enable) begin
                if (entered >= LATENCY) begin
                    divisions = divisions + 1;
                    wrong     = 1'b0;
                end
                dividends[oldest] = dividend;
                divisors[oldest]  = divisor;
                entered           = entered + 1;
                if (more) next_operands;
            end else begin
                stalled = stalled + 1;
            end
            if (clock % 32 < 16 || $random(seed) % 2 == 0) begin
                enable   <= 1'b1;
                dividend <= next_dividend[X_W-1:0];
                divisor  <= next_divisor;
            end else begin
                enable   <= 1'b0;
                dividend <= {X_W{1'bx}};
                divisor  <= {Y_W{1'bx}};
            end
        end
        if (mismatches == 0 && clock > 100 && stalled == 0) begin
            mismatches = 1;
            $display("FAILED: enable_i was never 0");
        end
        $display("%0d divisions, %0d mismatches", divisions, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
