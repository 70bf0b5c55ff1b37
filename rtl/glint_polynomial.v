// glint_polynomial: the specular highlight as a polynomial of degree 2 .. 6 in fixed point, one result a clock.
//
// The arithmetic is docs/lobes/polynomial.md; a value here carries the name that it has there. Do not instantiate this
// module by hand: I and COEFFICIENTS come from the model (`glint emit`), which writes one wrapper per profile
// (rtl/generated/). Table of ports, handshake: docs/rtl.md.

`default_nettype none

module glint_polynomial #(
    parameter F        = 18,  // fraction bits of the cosine
    parameter S        = 15,  // fraction bits of the quotient; O <= S
    parameter K        = 15,  // fraction bits of the coefficients; O <= K
    parameter O        = 12,  // fraction bits of the output
    parameter I        = 2,   // integer bits of a Horner value, at least 1
    parameter VARIABLE = 1,   // 0: s = c / (n - n c + c), 1: t = (1 + c) / ((1 + c) + 2 n (1 - c))
    parameter DEGREE   = 3,   // 2 .. 6
    parameter TAG_W    = 16,  // width of the tag, at least 1
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

    localparam LATENCY = S + 4 + 2 * DEGREE;  // 1 correct, S + 3 quotient, 2 a Horner step

    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] cosine, distance;
    glint_ports #(
        .F      (F),
        .LATENCY(LATENCY),
        .TAG_W  (TAG_W)
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
        .n_o       (n),
        .cosine_o  (cosine),
        .distance_o(distance),
        .negative_o(negative)
    );

    // ---- Horner: h<j> = k<DEGREE-j> + rnd(h<j-1> q, S), h0 = k<DEGREE> --------------------------------------------
    // I is such that each h, and the last sum with the half that rounds it, is below 2^I in magnitude as a real number:
    // the model shows it for these coefficients. With 0 <= q <= 1 the products are too: K + I + 1 bits with the sign, S
    // more before the cut. A step is a product, a register, and a sum:
    // k + rnd(x, S) = floor((x + k 2^S + 2^(S-1)) / 2^S).
    localparam H_W   = K + I + 1;
    localparam SUM_W = H_W + S;

    // Fields j: h<j>, and the quotient that travels beside it.
    wire   [DEGREE*H_W-1:0] h;
    wire [DEGREE*(S+1)-1:0] q;
    assign h[H_W-1:0] = COEFFICIENTS[DEGREE*H_W+:H_W];

    genvar j;
    generate
        if (VARIABLE == 0) begin : schlick
            glint_ratio #(
                .F(F),
                .S(S)
            ) ratio (
                .clk_i     (clk_i),
                .enable_i  (advance),
                .n_i       (n),
                .cosine_i  (cosine),
                .distance_i(distance),
                .quotient_o(q[S:0])
            );
        end else begin : symmetric
            glint_ratio_symmetric #(
                .F(F),
                .S(S)
            ) ratio (
                .clk_i     (clk_i),
                .enable_i  (advance),
                .n_i       (n),
                .cosine_i  (cosine),
                .distance_i(distance),
                .quotient_o(q[S:0])
            );
        end

        for (j = 1; j < DEGREE; j = j + 1) begin : step
            wire [H_W-1:0] operand = h[(j-1)*H_W+:H_W];
            wire     [S:0] factor = q[(j-1)*(S+1)+:S+1];

            reg [SUM_W-1:0] product_q;
            reg   [H_W-1:0] h_q;
            reg       [S:0] factor_q, q_q;  // beside the product, beside h
            /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts
            wire [SUM_W-1:0] sum = product_q + {COEFFICIENTS[(DEGREE-j)*H_W+:H_W], 1'b1, {(S - 1) {1'b0}}};
            /* verilator lint_on UNUSED */
            always @(posedge clk_i) begin
                if (advance) begin
                    product_q <= {{S{operand[H_W-1]}}, operand} * {{(SUM_W - S - 1) {1'b0}}, factor};
                    factor_q  <= factor;
                    h_q       <= sum[SUM_W-1:S];
                    q_q       <= factor_q;
                end
            end
            assign h[j*H_W+:H_W]     = h_q;
            assign q[j*(S+1)+:S+1] = q_q;
        end
    endgenerate

    // ---- r = rnd(h q + k0 2^S, S + K - O), y = min(2^O, max(0, r)) ------------------------------------------------
    localparam CUT = S + K - O;  // bits dropped, at least O, since O <= S and O <= K
    localparam R_W = I + O + 1;  // what is left of SUM_W bits

    wire [H_W-1:0] last   = h[(DEGREE-1)*H_W+:H_W];
    wire     [S:0] factor = q[(DEGREE-1)*(S+1)+:S+1];

    reg  [SUM_W-1:0] product_q;
    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts
    wire [SUM_W-1:0] sum = product_q + {COEFFICIENTS[H_W-1:0], {S{1'b0}}}
                         + {{(SUM_W - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    wire   [R_W-1:0] r = sum[SUM_W-1:CUT];
    wire             below = r[R_W-1];
    wire             above = ~below & (|r[R_W-2:O]);  // r >= 2^O, where y is 2^O
    reg        [O:0] y_q;
    always @(posedge clk_i) begin
        if (advance) begin
            product_q <= {{S{last[H_W-1]}}, last} * {{(SUM_W - S - 1) {1'b0}}, factor};
            y_q       <= negative | below ? {(O + 1) {1'b0}} : above ? {1'b1, {O{1'b0}}} : {1'b0, r[O-1:0]};
        end
    end
    assign y_o = y_q;

endmodule

`default_nettype wire
