// glint_schlick: Schlick's rational approximation of the specular highlight in fixed point.
//
// The arithmetic is that of docs/lobes/schlick.md; a value here carries the name that it has there. Table of
// ports and parameters, latency, handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_schlick #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter O     = 12,  // fraction bits of the output
    parameter DIVIDER           = 0,  // 0 restoring, 1 radix4, 2 iterative, 3 reciprocal
    parameter REGISTER_EVERY    = 1,  // rows of the divider in a clock
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter LATENCY           = 2,  // clocks without those of the divider, and products: what the blocks on the way
    parameter PRODUCTS          = 0,  // add up to, from `glint emit`
    parameter TAG_W = 16   // width of the tag, at least 1
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

    // Clocks: 1 correct, 2 divisor, the division at O + 1 bits, 1 rounding. Products: n d.
    wire       advance, start, negative;
    wire [9:0] n;
    wire [F:0] cosine, distance;
    glint_ports #(
        .F                (F),
        .LATENCY          (LATENCY),
        .PRODUCTS         (PRODUCTS),
        .QUOTIENT_W       (O + 2),
        .DIVIDER          (DIVIDER),
        .REGISTER_EVERY   (REGISTER_EVERY),
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
        .start_o   (start),
        .n_o       (n),
        .cosine_o  (cosine),
        .distance_o(distance),
        .negative_o(negative)
    );

    wire [O+1:0] quotient;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_ratio #(
        .F                (F),
        .S                (O + 1),
        .DIVIDER          (DIVIDER),
        .REGISTER_EVERY   (REGISTER_EVERY),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) ratio (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .start_i   (start),
        .n_i       (n),
        .cosine_i  (cosine),
        .distance_i(distance),
        .done_o    (),
        .quotient_o(quotient)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // y = rnd(quotient, 1), at most 2^O since the quotient is at most 2^(O+1).
    reg [O:0] y_q;
    always @(posedge clk_i) begin
        if (advance) y_q <= negative ? {(O + 1) {1'b0}} : quotient[O+1:1] + {{O{1'b0}}, quotient[0]};
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
