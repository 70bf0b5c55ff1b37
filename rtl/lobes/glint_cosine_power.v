// glint_cosine_power: the specular highlight max(0, (n/a)(c - 1) + 1)^a in fixed point, one result a clock.
//
// The arithmetic is docs/lobes/cosine_power.md; a value here carries the name that it has there. Table of ports,
// handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_cosine_power #(
    parameter F      = 18,  // fraction bits of the cosine
    parameter LOG2_A = 3,   // a = 2^LOG2_A, so many squarings: 1 .. 6
    parameter S      = 16,  // fraction bits of the powers; O <= S <= F + LOG2_A
    parameter O      = 12,  // fraction bits of the output
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter LATENCY           = 2,  // clocks without those of the divider, and products: what the blocks on the way
    parameter PRODUCTS          = 0,  // add up to, from `glint emit`
    parameter TAG_W  = 16   // width of the tag, at least 1
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

    // Clocks: 1 correct, 1 product n d, 1 base, 2 a squaring. Products: n d, the squarings.
    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] distance;
    /* verilator lint_off PINCONNECTEMPTY */  // the cosine itself is not needed
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
        .cosine_o  (),
        .distance_o(distance),
        .negative_o(negative)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // ---- p1 = rnd(base, F + LOG2_A - S), base = max(0, a 2^F - n d) -----------------------------------------------
    // n d <= 1023 2^F: F + 10 bits. a 2^F <= 2^(F+6) and the half that rounds is below it, so offset - n d is between
    // -1023 2^F and 2^(F+7): F + 11 bits with the sign. Rounded before it is cut: rnd is monotone and keeps 0.
    localparam ND_W   = F + 10;
    localparam BASE_W = F + 11;
    localparam CUT    = F + LOG2_A - S;  // bits dropped, at least 0

    localparam [BASE_W-1:0] UNIT   = {{(BASE_W - 1) {1'b0}}, 1'b1};
    localparam [BASE_W-1:0] OFFSET = (UNIT << (F + LOG2_A)) + ((UNIT << CUT) >> 1);

    wire   [ND_W:0] product;  // its top bit is 0
    glint_multiplier #(
        .A_W   (F + 1),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (distance),
        .b_i      (n),
        .product_o(product)
    );
    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts; the high ones repeat the sign
    wire [BASE_W-1:0] base = OFFSET - product;
    /* verilator lint_on UNUSED */
    reg         [S:0] p1_q;  // 0 .. 2^S, since base is at most a 2^F
    always @(posedge clk_i) begin
        if (advance) begin
            p1_q <= base[BASE_W-1] ? {(S + 1) {1'b0}} : base[CUT+S:CUT];
        end
    end

    // ---- p2 = rnd(p1^2, S), p4 = rnd(p2^2, S), ..., y = rnd(p^2, 2 S - O): LOG2_A squarings --------------------------
    glint_power #(
        .S                (S),
        .O                (O),
        .SQUARES          (LOG2_A - 1),
        .CHOICE           (0),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) power_of_base (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .r_i       (p1_q),
        .power_i   (3'd0),
        .negative_i(negative),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
