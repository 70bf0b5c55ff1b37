// glint_divider with the iterative divider by its contract: Q_W + 1 enabled edges after a start with operands that stay,
// done_o is 1 for one of them, dividend = divisor * quotient + remainder and remainder < divisor, and these stay until the
// next start. A start in the middle of a division begins anew. Verilog-2005, for any simulator.
//
//   parameters  X_W, Y_W, Q_W as in glint_divider (Y_W and Q_W up to 64); DIVISIONS: so many
//
// enable_i is 0 at random; then nothing may move. The last line is `1000 divisions, 0 mismatches`.

`default_nettype none

module divider_iterative_tb;

    parameter X_W       = 34;
    parameter Y_W       = 28;
    parameter Q_W       = 16;
    parameter DIVISIONS = 1000;

    reg            clk, enable, start;
    reg  [X_W-1:0] dividend;
    reg  [Y_W-1:0] divisor;
    wire           done;
    wire [Q_W-1:0] quotient;
    wire [Y_W-1:0] remainder;
    wire           beside;

    glint_divider #(
        .X_W    (X_W),
        .Y_W    (Y_W),
        .Q_W    (Q_W),
        .DIVIDER(2)
    ) divider (
        .clk_i      (clk),
        .enable_i   (enable),
        .start_i    (start),
        .dividend_i (dividend),
        .divisor_i  (divisor),
        .beside_i   (1'b1),
        .done_o     (done),
        .quotient_o (quotient),
        .remainder_o(remainder),
        .beside_o   (beside)
    );

    initial clk = 1'b0;
    always #1 clk = ~clk;

    integer seed, divisions, mismatches, age, wait_more, broken_off;
`include "division.vh"

    task begin_anew;
        begin
            draw_division;
            divisor  = drawn_divisor;
            dividend = drawn[X_W-1:0];
            start    = 1'b1;
            age      = 0;
        end
    endtask

    task fail;
        begin
            mismatches = mismatches + 1;
            $display("FAILED: %0d / %0d, %0d enabled edges after the start: done %b, quotient %0d, remainder %0d", dividend,
                     divisor, age, done, quotient, remainder);
        end
    endtask

    initial begin
        seed       = 1;
        enable     = 1'b1;
        divisions  = 0;
        mismatches = 0;
        broken_off = 0;
        wait_more  = 3;
        begin_anew;
        while (divisions < DIVISIONS && mismatches < 10) begin
            @(posedge clk);
            // What stands here now was made by the edges before.
            if (age > 0 && (done !== (age == Q_W + 1))) fail;
            if (age > Q_W && (((divisor * {{Y_W{1'b0}}, quotient} + remainder === dividend) !== 1'b1)
                              || (remainder < divisor) !== 1'b1 || beside !== 1'b1)) fail;
            #1;
            if (enable) begin
                age   = age + 1;
                start = 1'b0;
                if (age > Q_W + wait_more) begin
                    divisions = divisions + 1;
                    wait_more = 2 + {$random(seed)} % 4;
                    begin_anew;
                end else if ({$random(seed)} % 97 == 0) begin
                    broken_off = broken_off + 1;
                    begin_anew;
                end
            end
            enable = {$random(seed)} % 4 != 0;
        end
        if (mismatches == 0 && DIVISIONS > 500 && broken_off == 0) begin
            mismatches = 1;
            $display("FAILED: no division was broken off");
        end
        $display("%0d divisions, %0d mismatches", divisions, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
