// The glint_multiplier of a family against that for any device, here glint_multiplier_generic, for many widths at a time, each
// with both signs and 1 to 4 stages. For Verilator; tests/rtl/products_test.py writes the macros.
//
//   macros      WIDTHS: how many; TABLE: {A_W, B_W} of each, 8 bits a number, the first one lowest
//               CLOCKS: so many; SEED
//               COUNT: operands count through all pairs, for widths up to 6; else they are random, corners among them
//
// Every stall holds enable_i at 0 for a clock. The last line is `1440 products, 0 mismatches`: those of each multiplier, and
// the multipliers that were ever wrong.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module products_tb;

    localparam [16*`WIDTHS-1:0] TABLE = `TABLE;

    reg         clk      = 1'b0;
    reg         enable   = 1'b0;
    reg  [63:0] state    = 64'd`SEED * 64'd2 + 64'd1;
    reg  [63:0] entered  = 64'd0;
    reg  [63:0] clocks   = 64'd0;
    always #1 clk = ~clk;

    // xorshift, two steps a clock: one for each operand. Three bits of an operand say whether it is a corner.
    function [63:0] next(input [63:0] x);
        reg [63:0] y, z;
        begin
            y    = x ^ (x << 13);
            z    = y ^ (y >> 7);
            next = z ^ (z << 17);
        end
    endfunction

    wire [63:0] state_a = next(state);
    wire [63:0] state_b = next(state_a);

    wire [8*`WIDTHS-1:0] wrong;
    genvar w, s, g;
    generate
        for (w = 0; w < `WIDTHS; w = w + 1) begin : width
            localparam A_W = {24'd0, TABLE[16*w+8+:8]};
            localparam B_W = {24'd0, TABLE[16*w+:8]};
`ifdef COUNT
            wire [A_W-1:0] a = entered[A_W-1:0];
            wire [B_W-1:0] b = entered[A_W+:B_W];
`else
            wire [A_W-1:0] top_a = {1'b1, {(A_W - 1) {1'b0}}};
            wire [B_W-1:0] top_b = {1'b1, {(B_W - 1) {1'b0}}};
            wire [A_W-1:0] a = state_a[63:61] != 3'd0 ? state_a[A_W-1:0]
                : state_a[60] ? {A_W{state_a[59]}} : state_a[59] ? top_a : ~top_a;
            wire [B_W-1:0] b = state_b[63:61] != 3'd0 ? state_b[B_W-1:0]
                : state_b[60] ? {B_W{state_b[59]}} : state_b[59] ? top_b : ~top_b;
`endif
            for (g = 0; g < 2; g = g + 1) begin : sign
                for (s = 1; s <= 4; s = s + 1) begin : stages
                    wire [A_W+B_W-1:0] product, expected;
                    glint_multiplier #(
                        .A_W   (A_W),
                        .B_W   (B_W),
                        .SIGNED(g),
                        .STAGES(s)
                    ) of_family (
                        .clk_i    (clk),
                        .enable_i (enable),
                        .a_i      (a),
                        .b_i      (b),
                        .product_o(product)
                    );
                    glint_multiplier_generic #(
                        .A_W   (A_W),
                        .B_W   (B_W),
                        .SIGNED(g),
                        .STAGES(s)
                    ) of_any (
                        .clk_i    (clk),
                        .enable_i (enable),
                        .a_i      (a),
                        .b_i      (b),
                        .product_o(expected)
                    );
                    reg wrong_q = 1'b0;
                    always @(posedge clk) begin
                        if (entered > 64'd8 && product != expected) wrong_q <= 1'b1;
                    end
                    assign wrong[8*w+4*g+s-1] = wrong_q;
                end
            end
        end
    endgenerate

    always @(posedge clk) begin
        clocks <= clocks + 64'd1;
        state  <= state_b;
        enable <= state_a[47:45] != 3'd0;
        if (enable) entered <= entered + 64'd1;
        if (entered == 64'd`CLOCKS) begin
            $display("%0d products, %0d mismatches", entered - 64'd8, $countones(wrong));
            $finish;
        end
    end

endmodule

`default_nettype wire
