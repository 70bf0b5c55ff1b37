// glint_signed_multiplier: product = a * b of two signed numbers, in STAGES clocks, one product a clock.
//
// A register of the product; with more stages registers of the operands, too, as multiplier blocks have them. No valid bits
// and no reset: its owner counts clocks. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_signed_multiplier #(
    parameter WIDTH  = 16,  // bits of a and of b, 2 .. 18
    parameter STAGES = 1    // 1 .. 4
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire   [WIDTH-1:0] a_i,
    input  wire   [WIDTH-1:0] b_i,
    output wire [2*WIDTH-1:0] product_o
);

    wire [WIDTH-1:0] a, b;
    glint_delay #(
        .WIDTH (2 * WIDTH),
        .STAGES(STAGES > 1 ? 1 : 0)
    ) delay_operands (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  ({a_i, b_i}),
        .data_o  ({a, b})
    );

    wire signed [2*WIDTH-1:0] a_wide = {{WIDTH{a[WIDTH-1]}}, a};
    wire signed [2*WIDTH-1:0] b_wide = {{WIDTH{b[WIDTH-1]}}, b};
    reg         [2*WIDTH-1:0] product_q;
    always @(posedge clk_i) if (enable_i) product_q <= a_wide * b_wide;

    glint_delay #(
        .WIDTH (2 * WIDTH),
        .STAGES(STAGES > 2 ? STAGES - 2 : 0)
    ) delay_product (
        .clk_i   (clk_i),
        .enable_i(enable_i),
        .data_i  (product_q),
        .data_o  (product_o)
    );

endmodule

`default_nettype wire
