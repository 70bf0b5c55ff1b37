// glint_multiplier for Lattice ECP5: product = a * b in STAGES clocks, one product a clock, by MULT18X18D.
//
// It takes the place of rtl/blocks/glint_multiplier.v in a list of files: same ports, parameters, bits and clocks.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_multiplier #(
    parameter A_W    = 18,  // bits of a
    parameter B_W    = 16,  // bits of b
    parameter SIGNED = 0,   // 1: a is signed; b is unsigned in any case
    parameter STAGES = 1    // 1 .. 4
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire     [A_W-1:0] a_i,
    input  wire     [B_W-1:0] b_i,
    output wire [A_W+B_W-1:0] product_o  // signed where a is
);

    glint_multiplier_sliced #(
        .W     (18),
        .A_W   (A_W),
        .B_W   (B_W),
        .SIGNED(SIGNED),
        .STAGES(STAGES)
    ) sliced (
        .clk_i    (clk_i),
        .enable_i (enable_i),
        .a_i      (a_i),
        .b_i      (b_i),
        .product_o(product_o)
    );

endmodule

`default_nettype wire
