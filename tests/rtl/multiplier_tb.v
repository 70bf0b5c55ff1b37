// glint_multiplier by its contract: product_o is a * b of STAGES enabled edges ago.
//
//   parameters  A_W, B_W (A_W + B_W up to 64), SIGNED, STAGES as in glint_multiplier; PRODUCTS: so many

`default_nettype none

module multiplier_tb;

    parameter A_W      = 18;
    parameter B_W      = 16;
    parameter SIGNED   = 0;
    parameter STAGES   = 1;
    parameter PRODUCTS = 10000;

    localparam LATENCY = STAGES;
    localparam THINGS  = "products";
    localparam COUNT   = PRODUCTS;
    localparam IN_W    = A_W + B_W;  // a, b
    localparam FIRST   = {IN_W{1'b0}};
`include "pipeline.vh"

    wire [A_W+B_W-1:0] product;

    glint_multiplier #(
        .A_W   (A_W),
        .B_W   (B_W),
        .SIGNED(SIGNED),
        .STAGES(STAGES)
    ) multiplier (
        .clk_i    (clk),
        .enable_i (enable),
        .a_i      (given[IN_W-1:B_W]),
        .b_i      (given[B_W-1:0]),
        .product_o(product)
    );

    wire         sign     = SIGNED != 0 && past[IN_W-1];
    wire [127:0] expected = {{(128 - A_W) {sign}}, past[IN_W-1:B_W]} * {{(128 - B_W) {1'b0}}, past[B_W-1:0]};
    assign right = product === expected[A_W+B_W-1:0];

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

    reg [A_W-1:0] a;
    reg [B_W-1:0] b;

    task draw_next;
        begin
            a    = draw(A_W);
            b    = draw(B_W);
            next = {a, b};
        end
    endtask

    task following;
        more = 1'b0;
    endtask

    task complain;
        $display("FAILED: product %h, not %h", product, expected[A_W+B_W-1:0]);
    endtask

endmodule

`default_nettype wire
