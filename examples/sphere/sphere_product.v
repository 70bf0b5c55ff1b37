// sphere_product: the product of two signed numbers by glint_multiplier, whose second one has no sign. 2 clocks.
//
// a b = a (b + 2^(B_W-1)) - a 2^(B_W-1). a stays as it is while its products are on the way.

`default_nettype none

module sphere_product #(
    parameter A_W = 10,  // at least 2
    parameter B_W = 10   // at least 2
) (
    input  wire                      clk_i,
    input  wire signed     [A_W-1:0] a_i,
    input  wire            [B_W-1:0] b_i,       // signed
    output wire signed [A_W+B_W-1:0] product_o
);

    wire signed [A_W+B_W-1:0] shifted;
    glint_multiplier #(
        .A_W   (A_W),
        .B_W   (B_W),
        .SIGNED(1)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (1'b1),
        .a_i      (a_i),
        .b_i      ({~b_i[B_W-1], b_i[B_W-2:0]}),
        .product_o(shifted)
    );
    reg signed [A_W+B_W-1:0] product_q;
    always @(posedge clk_i) product_q <= shifted - $signed({a_i[A_W-1], a_i, {B_W - 1{1'b0}}});
    assign product_o = product_q;

endmodule

`default_nettype wire
