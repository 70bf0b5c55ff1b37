// glint_quadratic: the specular highlight max(0, 0.786 n c^2 + (1 - 0.786 n) c) in fixed point, one result a clock.
//
// The arithmetic is docs/lobes/quadratic.md; a value here carries the name that it has there. Do not instantiate this
// module by hand: the constant SLOPE comes from the model (`glint emit`), which writes one wrapper per profile
// (rtl/generated/). Table of ports, handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_quadratic #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter S     = 13,  // fraction bits of w; O <= S
    parameter K     = 14,  // fraction bits of the constant; S <= F + K
    parameter O     = 12,  // fraction bits of the output
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter LATENCY           = 2,  // clocks without those of the divider, and products: what the blocks on the way
    parameter PRODUCTS          = 0,  // add up to, from `glint emit`
    parameter TAG_W = 16,  // width of the tag, at least 1
    // 0.786 at K fraction bits. The widths below rest on its being below 1, so no other is legal.
    parameter [K-1:0] SLOPE = 0
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire       [9:0] n_i,      // specular exponent
    input  wire     [F+1:0] cos_i,    // cosine, signed, code / 2^F
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire       [O:0] y_o,      // result, code / 2^O, 0 .. 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o // an input was out of range and was corrected
);

`ifndef SYNTHESIS
    initial begin
        if (SLOPE == 0) begin  // the default: without its constant the unit would answer c to everything
            $display("glint_quadratic: parameter SLOPE not set; use a wrapper from `glint emit`");
            $finish;
        end
    end
`endif

    // Clocks: 1 correct, 1 slope n, 1 times d, 1 w, 1 times C, 1 rounding. Products: slope n, times d, times C.
    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] cosine, distance;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_ports #(
        .F                (F),
        .LATENCY          (LATENCY),
        .PRODUCTS         (PRODUCTS),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .TAG_W            (TAG_W)
    ) ports (
        .clk_i     (clk_i),
        .rst_ni    (rst_ni),
        .valid_i   (valid_i),
        .ready_o   (ready_o),
        .n_i       (n_i),
        .cos_i     (cos_i),
        .tag_i     (tag_i),
        .valid_o   (valid_o),
        .ready_i   (ready_i),
        .tag_o     (tag_o),
        .clamped_o (clamped_o),
        .advance_o (advance),
        .start_o   (),
        .n_o       (n),
        .cosine_o  (cosine),
        .distance_o(distance),
        .negative_o(negative)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // ---- scaled = slope n, and its product with d = 2^F - C -------------------------------------------------------
    // slope < 2^K and n < 2^10: K + 10 bits; times d <= 2^F: below 2^(F+K+10).
    localparam N_W = K + 10;
    localparam P_W = F + K + 10;

    wire [N_W-1:0] scaled;
    wire [P_W:0] product;  // its top bit is 0
    wire     [F:0] distance_1;  // beside scaled
    wire     [F:0] cosine_3;    // beside w
    glint_multiplier #(
        .A_W   (K),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_1 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (SLOPE),
        .b_i      (n),
        .product_o(scaled)
    );
    glint_multiplier #(
        .A_W   (N_W),
        .B_W   (F + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_2 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (scaled),
        .b_i      (distance_1),
        .product_o(product)
    );
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_distance (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (distance),
        .data_o  (distance_1)
    );
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(2 * MULTIPLIER_STAGES + 1)
    ) delay_cosine (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (cosine),
        .data_o  (cosine_3)
    );

    // ---- w = rnd(line, F + K - S), line = max(0, 2^(F+K) - scaled d) ----------------------------------------------
    // Between -2^(F+K+10) and 2^(F+K), with the half that rounds it below 2^(F+K+1): one bit more for the sign. Rounded
    // before it is cut: rnd is monotone and keeps 0.
    localparam LINE_W = F + K + 11;
    localparam CUT    = F + K - S;  // bits dropped, at least 0

    localparam [LINE_W-1:0] UNIT   = {{(LINE_W - 1) {1'b0}}, 1'b1};
    localparam [LINE_W-1:0] OFFSET = (UNIT << (F + K)) + ((UNIT << CUT) >> 1);

    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts; the high ones repeat the sign
    wire [LINE_W-1:0] line = OFFSET - product;
    /* verilator lint_on UNUSED */
    reg         [S:0] w_q;  // 0 .. 2^S, since line is at most 2^(F+K)

    // ---- y = rnd(C w, F + S - O) ----------------------------------------------------------------------------------
    // C w <= 2^(F+S); with the half that rounds it still fits F + S + 1 bits.
    localparam Y_W   = F + S + 1;
    localparam CUT_Y = F + S - O;  // at least F, since O <= S

    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts; the product's top bit is 0
    wire   [Y_W:0] product_y;
    wire [Y_W-1:0] sum = product_y[Y_W-1:0] + {{(Y_W - CUT_Y) {1'b0}}, 1'b1, {(CUT_Y - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    reg      [O:0] y_q;

    glint_multiplier #(
        .A_W   (F + 1),
        .B_W   (S + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_3 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (cosine_3),
        .b_i      (w_q),
        .product_o(product_y)
    );

    always @(posedge clk_i) begin
        if (advance) begin
            w_q <= line[LINE_W-1] ? {(S + 1) {1'b0}} : line[CUT+S:CUT];
            y_q <= negative ? {(O + 1) {1'b0}} : sum[F+S:CUT_Y];
        end
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
