// glint_multiplier by its contract: product_o is a * b of STAGES enabled edges ago, and stays while enable_i is 0.
// Verilog-2005, for any simulator.
//
//   parameters  A_W, B_W (A_W + B_W up to 64), SIGNED, STAGES as in glint_multiplier; PRODUCTS: so many
//
// The last line is `10000 products, 0 mismatches`.

`default_nettype none

module multiplier_tb;

    parameter A_W      = 18;
    parameter B_W      = 16;
    parameter SIGNED   = 0;
    parameter STAGES   = 1;
    parameter PRODUCTS = 10000;

    reg                clk, enable;
    reg      [A_W-1:0] a;
    reg      [B_W-1:0] b;
    wire [A_W+B_W-1:0] product;

    glint_multiplier #(
        .A_W   (A_W),
        .B_W   (B_W),
        .SIGNED(SIGNED),
        .STAGES(STAGES)
    ) multiplier (
        .clk_i    (clk),
        .enable_i (enable),
        .a_i      (a),
        .b_i      (b),
        .product_o(product)
    );

    initial clk = 1'b0;
    always #1 clk = ~clk;

    reg [A_W+B_W-1:0] expected[0:STAGES-1];
    integer           seed, entered, products, mismatches;
    reg  signed [127:0] wide_a, wide_b;
    reg         [127:0] wide;

    function [63:0] draw;
        input integer most;
        case ({$random(seed)} % 6)
            0: draw = 0;
            1: draw = 64'd1 << (most - 1);
            2: draw = ~64'd0 >> (65 - most);
            3: draw = ~64'd0;
            default: draw = {$random(seed), $random(seed)};
        endcase
    endfunction

    initial begin
        seed       = 1;
        entered    = 0;
        products   = 0;
        mismatches = 0;
        enable     = 1'b0;
        a          = 0;
        b          = 0;
        while (products < PRODUCTS && mismatches < 10) begin
            @(posedge clk);
            if (entered >= STAGES && product !== expected[entered%STAGES]) begin
                mismatches = mismatches + 1;
                $display("FAILED: product %h, not %h", product, expected[entered%STAGES]);
            end
            if (enable) begin
                if (entered >= STAGES) products = products + 1;
                wide_a = SIGNED != 0 && a[A_W-1] ? {{(128 - A_W) {1'b1}}, a} : {{(128 - A_W) {1'b0}}, a};
                wide_b = {{(128 - B_W) {1'b0}}, b};
                wide   = wide_a * wide_b;
                expected[entered%STAGES] = wide[A_W+B_W-1:0];
                entered = entered + 1;
            end
            #1;
            enable = {$random(seed)} % 4 != 0;
            a      = draw(A_W);
            b      = draw(B_W);
        end
        $display("%0d products, %0d mismatches", products, mismatches);
        $finish(0);
    end

endmodule

`default_nettype wire
