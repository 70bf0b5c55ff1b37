// Operands of a division, of Y_W and Q_W bits, for the benches of dividers; they have `seed`.
    reg [Y_W+Q_W-1:0] drawn;          // a legal dividend, cut to the port it is smaller: still legal
    reg     [Y_W-1:0] drawn_divisor;

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

    task draw_division;
        begin
            drawn_divisor = draw(Y_W);
            if (drawn_divisor == 0) drawn_divisor = 1;
            case ({$random(seed)} % 4)
                0: drawn = 0;
                1: drawn = drawn_divisor - 1;
                default: drawn = draw(Y_W) % drawn_divisor;
            endcase
            drawn = drawn + drawn_divisor * draw(Q_W);
        end
    endtask
