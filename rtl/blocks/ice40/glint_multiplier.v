// glint_multiplier for Lattice iCE40: product = a * b in STAGES clocks, one product a clock, by look-up tables.
//
// It takes the place of rtl/blocks/glint_multiplier.v in a list of files: same ports, parameters, bits and clocks. Where a slice
// of b has two bits its product is a choice of 0, a, 2 a and 3 a. The last is one adder for all slices, in the place of one in
// each. Table of ports and parameters: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_multiplier #(
    parameter A_W    = 18,  // bits of a
    parameter B_W    = 16,  // bits of b, the narrower one where there is a choice
    parameter SIGNED = 0,   // 1: a is signed; b is unsigned in any case
    parameter STAGES = 1    // 1 .. 4
) (
    input  wire               clk_i,
    input  wire               enable_i,
    input  wire     [A_W-1:0] a_i,
    input  wire     [B_W-1:0] b_i,
    output wire [A_W+B_W-1:0] product_o  // signed where a is
);

    localparam SLICES  = 1 << (STAGES - 1);
    localparam SLICE_W = (B_W + SLICES - 1) / SLICES;
    localparam LAST    = STAGES - 1;

    /* verilator lint_off UNUSED */  // bits of the padding above b
    wire [SLICES*SLICE_W-1:0] b = {{(SLICES * SLICE_W - B_W) {1'b0}}, b_i};
    /* verilator lint_on UNUSED */

    // A node of level j is the product with 2^j slices: A_W + 2^j SLICE_W bits, whether signed or not.
    genvar j, k;
    generate
        for (j = 0; j < STAGES; j = j + 1) begin : level
            localparam NODE_W = A_W + (SLICE_W << j);
            for (k = 0; k < SLICES >> j; k = k + 1) begin : node
                /* verilator lint_off UNUSED */  // of the last node, bits above those of the product
                reg [NODE_W-1:0] product_q;
                /* verilator lint_on UNUSED */
                if (j == 0 && SLICE_W == 2 && SLICES > 1) begin : choice
                    wire sign = SIGNED != 0 & a_i[A_W-1];
                    wire [NODE_W-1:0] single = {{2{sign}}, a_i};
                    wire [NODE_W-1:0] twice = {sign, a_i, 1'b0};
                    wire [NODE_W-1:0] triple = single + twice;  // one for all nodes, once synthesis has seen that
                    wire        [1:0] slice = b[k*SLICE_W+:SLICE_W];
                    always @(posedge clk_i) begin
                        if (enable_i) product_q <= slice[1] ? (slice[0] ? triple : twice) : slice[0] ? single : {NODE_W{1'b0}};
                    end
                end else if (j == 0 && SIGNED != 0) begin : signed_slice
                    wire signed [NODE_W-1:0] a = {{SLICE_W{a_i[A_W-1]}}, a_i};
                    wire signed [NODE_W-1:0] slice = {{A_W{1'b0}}, b[k*SLICE_W+:SLICE_W]};
                    always @(posedge clk_i) if (enable_i) product_q <= a * slice;
                end else if (j == 0) begin : unsigned_slice
                    wire [NODE_W-1:0] a = {{SLICE_W{1'b0}}, a_i};
                    wire [NODE_W-1:0] slice = {{A_W{1'b0}}, b[k*SLICE_W+:SLICE_W]};
                    always @(posedge clk_i) if (enable_i) product_q <= a * slice;
                end else begin : sum
                    // The low bits of the lower node need no adder.
                    localparam LOW_W = SLICE_W << (j - 1);
                    wire [A_W+LOW_W-1:0] low  = level[j-1].node[2*k].product_q;
                    wire [A_W+LOW_W-1:0] high = level[j-1].node[2*k+1].product_q;
                    wire                 sign = SIGNED != 0 ? low[A_W+LOW_W-1] : 1'b0;
                    always @(posedge clk_i) begin
                        if (enable_i) product_q <= {high + {{LOW_W{sign}}, low[A_W+LOW_W-1:LOW_W]}, low[LOW_W-1:0]};
                    end
                end
            end
        end
    endgenerate

    assign product_o = level[LAST].node[0].product_q[A_W+B_W-1:0];

endmodule

`default_nettype wire
