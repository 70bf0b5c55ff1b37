// glint_polynomial: the specular highlight as a polynomial of degree 2 .. 6 in fixed point.
//
// The arithmetic is docs/lobes/polynomial.md; a value here carries the name that it has there. Do not instantiate this
// module by hand: I and COEFFICIENTS come from the model (`glint emit`), which writes one wrapper per profile
// (rtl/generated/). Table of ports, handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_polynomial #(
    parameter F        = 18,  // fraction bits of the cosine
    parameter S        = 15,  // fraction bits of the quotient; O <= S
    parameter K        = 15,  // fraction bits of the coefficients; O <= K
    parameter O        = 12,  // fraction bits of the output
    parameter I        = 2,   // integer bits of a Horner value, at least 1
    parameter VARIABLE = 1,   // 0: s = c / (n - n c + c), 1: t = (1 + c) / ((1 + c) + 2 n (1 - c))
    parameter DEGREE   = 3,   // 2 .. 6
    parameter TAG_W    = 16,  // width of the tag, at least 1
    parameter DIVIDER           = 0,  // 0 restoring, 1 radix4, 2 iterative, 3 reciprocal
    parameter REGISTER_EVERY    = 1,  // rows of the divider in a clock
    parameter MULTIPLIER_STAGES = 1,  // clocks of a product
    parameter LATENCY           = 2,  // clocks without those of the divider, and products: what the blocks on the way
    parameter PRODUCTS          = 0,  // add up to, from `glint emit`
    // The coefficients at K fraction bits, signed, K + I + 1 bits each, that of the power i in field i.
    parameter [(DEGREE+1)*(K+I+1)-1:0] COEFFICIENTS = 0
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
        if (COEFFICIENTS == 0) begin  // the default: without coefficients the unit would answer 0 to everything
            $display("glint_polynomial: parameter COEFFICIENTS not set; use a wrapper from `glint emit`");
            $finish;
        end
    end
`endif

    // Clocks: 1 correct, 2 divisor, the division, 2 a Horner step. Products: n d, one a Horner step.
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
        .SYMMETRIC        (VARIABLE),
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

    // I is such that each Horner value, and the last sum with the half that rounds it, is below 2^I in magnitude: the
    // model shows it for these coefficients.
    glint_horner #(
        .S                (S),
        .K                (K),
        .O                (O),
        .I                (I),
        .DEGREE           (DEGREE),
        .CLAMP            (1),
        .ITERATIVE        (DIVIDER == 2),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .COEFFICIENTS     (COEFFICIENTS)
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
