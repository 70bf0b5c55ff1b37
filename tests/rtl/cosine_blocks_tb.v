// Products, root and quotient of glint_cosine by their contracts, one after the other: x = a b of signed numbers,
// root = floor(sqrt(radicand)), quotient = floor((x + root) / (2 root + 1)). Verilog-2005, for any simulator.
//
//   parameters  WIDTH of the factors; ROOT_W of the root; Q_W of the quotient; STAGES of the product
//               TRIALS: so many random inputs, corners among them, of each
//
// enable_i is 1 for 16 clocks, random for the next 16, and so on. The last line is `1000 results, 0 mismatches`.

`default_nettype none

module cosine_blocks_tb;

    parameter WIDTH  = 16;
    parameter ROOT_W = 22;
    parameter Q_W    = 21;
    parameter STAGES = 1;
    parameter TRIALS = 1000;

    localparam X_W  = ROOT_W + Q_W + 1;
    localparam DEEP = 64;  // more than the clocks of any

    reg                      clk, enable;
    reg          [WIDTH-1:0] a, b;
    reg       [2*ROOT_W-1:0] radicand;
    reg            [X_W-1:0] x;
    reg         [ROOT_W-1:0] root;
    wire       [2*WIDTH-1:0] product;
    wire        [ROOT_W-1:0] root_found;
    wire          [ROOT_W:0] remainder;
    wire             [Q_W:0] quotient;

    glint_signed_multiplier #(.WIDTH(WIDTH), .STAGES(STAGES)) multiplier (
        .clk_i(clk), .enable_i(enable), .a_i(a), .b_i(b), .product_o(product));
    glint_sqrt #(.Y_W(ROOT_W)) sqrt (
        .clk_i(clk), .enable_i(enable), .radicand_i(radicand), .root_o(root_found), .remainder_o(remainder));
    glint_nearest #(.ROOT_W(ROOT_W), .Q_W(Q_W)) nearest (
        .clk_i(clk), .enable_i(enable), .x_i(x), .root_i(root), .quotient_o(quotient));

    initial clk = 1'b0;
    always #1 clk = ~clk;

    integer seed, bits;
    function [63:0] drawn(input integer ignored);  // of up to 64 bits, as often of few as of many, with ones at the ends
        begin
            bits  = {$random(seed)} % 64;
            drawn = {$random(seed), $random(seed)} >> bits;
            case ({$random(seed)} % 8)
                0: drawn = 64'd1 << bits;
                1: drawn = ~64'd0 >> bits;
                2: drawn = ~(~64'd0 >> bits);
            endcase
        end
    endfunction

    // Of the quotient q and the rest of a division with a divisor 2 root + 1: x + root = q (2 root + 1) + rest.
    reg signed       [Q_W:0] q;
    reg signed       [X_W:0] made;
    reg         [ROOT_W-1:0] half;
    reg             [63:0]   number;
    reg signed [2*WIDTH-1:0] products[0:DEEP-1];
    reg         [2*ROOT_W-1:0] radicands[0:DEEP-1];
    reg signed         [Q_W:0] quotients[0:DEEP-1];

    task draw;
        begin
            a = drawn(0);
            b = drawn(0);
            radicand = drawn(0);
            root = drawn(0);
            number = drawn(0);
            q = number[Q_W:0];
            if (q > $signed({2'b01, {(Q_W - 1) {1'b0}}})) q = {2'b01, {(Q_W - 1) {1'b0}}};
            if (q < -$signed({2'b01, {(Q_W - 1) {1'b0}}})) q = -$signed({2'b01, {(Q_W - 1) {1'b0}}});
            // rest - root in -root .. root, the ends among them
            half = drawn(0);
            if (half > root) half = root;
            made = q * $signed({1'b0, root, 1'b1});
            made = number[40] ? made + $signed({1'b0, half}) : made - $signed({1'b0, half});
            if (made[X_W] != made[X_W-1]) made = q * $signed({1'b0, root, 1'b1});  // beyond the port
            x = made[X_W-1:0];
        end
    endtask

    integer entered, results, mismatches, clock;
    task compare(input right, input [127:0] what);
        begin
            results = results + 1;
            if (right !== 1'b1) begin
                mismatches = mismatches + 1;
                $display("FAILED: %0s", what);
            end
        end
    endtask

    reg [2*ROOT_W-1:0] squared;
    initial begin
        enable = 1'b0;
        seed = 1;
        entered = 0;
        results = 0;
        mismatches = 0;
        clock = 0;
        draw;
        while (entered < TRIALS + DEEP && mismatches < 10) begin
            @(posedge clk);
            clock = clock + 1;
            if (enable) begin
                products[entered % DEEP] = $signed(a) * $signed(b);
                radicands[entered % DEEP] = radicand;
                quotients[entered % DEEP] = q;
                if (entered >= DEEP) begin
                    compare(product === products[(entered - STAGES) % DEEP], "product");
                    squared = radicands[(entered - ROOT_W) % DEEP];
                    compare({{ROOT_W{1'b0}}, root_found} * {{ROOT_W{1'b0}}, root_found} + remainder === squared
                            && remainder <= {root_found, 1'b0}, "root");
                    compare(quotient === quotients[(entered - Q_W - 1) % DEEP], "quotient");
                end
                entered = entered + 1;
            end
            #0.5 enable = clock % 32 < 16 || $random(seed) % 2 == 0;
            draw;
        end
        $display("%0d results, %0d mismatches", results, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
