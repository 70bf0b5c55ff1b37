// glint_multiplier_sliced: product = a * b in STAGES clocks, of multiplier blocks of W x W bits with registers inside.
//
// The glint_multiplier of a device with such blocks (rtl/blocks/ecp5, rtl/blocks/up5k): bits and clocks are those of
// rtl/blocks/glint_multiplier.v, registers are where its blocks have them. A slice of each operand makes a piece, which is
// the product where there is one piece. Of several the last clock is their sum, so the blocks have one clock less; with one
// clock in all the registers are those in the blocks, and the sum follows. No valid bits and no reset: its owner counts clocks.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_multiplier_sliced #(
    parameter W      = 18,  // bits of a block's operands
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

    localparam A_SLICES = (A_W + W - 1) / W;
    localparam B_SLICES = (B_W + W - 1) / W;
    localparam PIECES   = A_SLICES * B_SLICES;
    localparam P_W      = A_W + B_W;
    localparam CLOCKS   = PIECES == 1 || STAGES == 1 ? STAGES : STAGES - 1;  // of a piece

    wire sign = SIGNED != 0 & a_i[A_W-1];
    /* verilator lint_off UNUSED */  // a bit above the last slice
    wire [A_SLICES*W:0] a = {{(A_SLICES * W + 1 - A_W) {sign}}, a_i};
    wire [B_SLICES*W:0] b = {{(B_SLICES * W + 1 - B_W) {1'b0}}, b_i};
    /* verilator lint_on UNUSED */

    // The pieces, each where it belongs in the product. The last slice of a has its sign; all other slices have none.
    wire [PIECES*P_W-1:0] pieces;
    genvar i, j;
    generate
        for (j = 0; j < B_SLICES; j = j + 1) begin : row
            for (i = 0; i < A_SLICES; i = i + 1) begin : piece
                localparam LAST = SIGNED != 0 && i == A_SLICES - 1;
                wire [2*W-1:0] product;
                if (B_W - W * j == 1) begin : gates  // a slice of one bit needs no block
                    wire [W-1:0] slice = b[W*j] ? a[W*i+:W] : {W{1'b0}};
                    glint_delay #(
                        .WIDTH (2 * W),
                        .STAGES(CLOCKS)
                    ) delay (
                        .clk_i   (clk_i),
                        .enable_i(enable_i),
                        .data_i  ({{W{LAST & slice[W-1]}}, slice}),
                        .data_o  (product)
                    );
                end else begin : block
                    glint_multiplier_block #(
                        .SIGNED(LAST),
                        .STAGES(CLOCKS)
                    ) multiplier (
                        .clk_i    (clk_i),
                        .enable_i (enable_i),
                        .a_i      (a[W*i+:W]),
                        .b_i      (b[W*j+:W]),
                        .product_o(product)
                    );
                end
                /* verilator lint_off UNUSED */  // what the product has no bits for: copies of the sign, or 0
                wire [P_W+2*W-1:0] placed = {{P_W{LAST & product[2*W-1]}}, product} << (W * (i + j));
                /* verilator lint_on UNUSED */
                assign pieces[P_W*(j*A_SLICES+i)+:P_W] = placed[P_W-1:0];
            end
        end

        if (PIECES == 1) begin : one
            assign product_o = pieces;
        end else begin : several
            reg [P_W-1:0] sum;
            integer       k;
            always @* begin
                sum = {P_W{1'b0}};
                for (k = 0; k < PIECES; k = k + 1) sum = sum + pieces[P_W*k+:P_W];
            end
            glint_delay #(
                .WIDTH (P_W),
                .STAGES(STAGES - CLOCKS)
            ) delay_sum (
                .clk_i   (clk_i),
                .enable_i(enable_i),
                .data_i  (sum),
                .data_o  (product_o)
            );
        end
    endgenerate

endmodule

`default_nettype wire
