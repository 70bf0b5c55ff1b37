// glint_bps: the specular highlight f_bps (cubic of Schlick's rational form) in fixed point.
//
// The arithmetic is that of docs/lobes/bps.md; a value here carries the name that it has there.
// Do not instantiate this module by hand: the constants A, B, C1, D0 come from the model (`glint emit`), which
// writes one wrapper per profile (rtl/generated/). Table of ports and parameters, latency, handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_bps #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter S     = 15,  // fraction bits of the quotient
    parameter K     = 15,  // fraction bits of the constants
    parameter O     = 12,  // fraction bits of the output; O <= S and O <= K
    parameter TAG_W = 16,  // width of the tag, at least 1
    parameter DIVIDER           = 0,  // 0 restoring, 1 radix4, 2 iterative, 3 reciprocal
    parameter REGISTER_EVERY    = 1,  // rows of the divider in a clock
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter LATENCY           = 2,  // clocks without those of the divider, and products: what the blocks on the way
    parameter PRODUCTS          = 0,  // add up to, from `glint emit`
    // The constants of f_bps at K fraction bits. The widths below rest on their values, so no others are legal.
    parameter signed [K+2:0] A  = 0,
    parameter signed [K+2:0] B  = 0,
    parameter signed [K+2:0] C1 = 0,
    parameter signed [K+2:0] D0 = 0
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
        if (B == 0) begin  // the defaults: without its constants the unit would answer 0 to everything
            $display("glint_bps: parameters A, B, C1, D0 not set; use a wrapper from `glint emit`");
            $finish;
        end
    end
`endif

    // Clocks: 1 correct, 2 divisor, the division, 6 Horner. Products: n d, three of Horner.
    wire       advance, start, negative;
    wire [9:0] n;
    wire [F:0] cosine, distance;
    glint_ports #(
        .F                (F),
        .LATENCY          (LATENCY),
        .PRODUCTS         (PRODUCTS),
        .QUOTIENT_W       (S + 1),
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

    wire       done;
    wire [S:0] quotient;
    glint_ratio #(
        .F                (F),
        .S                (S),
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
        .done_o    (done),
        .quotient_o(quotient)
    );

    // h1 = b + rnd(a q, S), h2 = c1 + rnd(h1 q, S), y = max(0, rnd(h2 q + d0 2^S, S + K - O)). With 0 <= q <= 1 and the
    // constants of f_bps (proof: docs/lobes/bps.md), as real numbers:
    //   -1.64 < a q  <= 0         h1 from  1.36 to 3.00
    //       0 <= h1 q < 3.00      h2 from -0.38 to 1.01
    //   -0.02 < h2 q < 1.01       y  from -0.02 to 1.00
    // so two integer bits are enough, and y is never above 1.
    glint_horner #(
        .S                (S),
        .K                (K),
        .O                (O),
        .I                (2),
        .DEGREE           (3),
        .CLAMP            (0),
        .ITERATIVE        (DIVIDER == 2),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .COEFFICIENTS     ({A, B, C1, D0})
    ) horner (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .start_i   (done),
        .quotient_i(quotient),
        .negative_i(negative),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
