// glint_bps: the specular highlight f_bps (cubic of Schlick's rational form) in fixed point, one result a clock.
//
// The arithmetic is the section `bps` of docs/contract.md; a value here carries the name that it has there.
// Do not instantiate this module by hand: the constants A, B, C1, D0 come from the model (`glint emit`), which
// writes one wrapper per profile (rtl/generated/). Table of ports and parameters, latency, handshake: docs/rtl.md.

`default_nettype none

module glint_bps #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter S     = 15,  // fraction bits of the quotient
    parameter K     = 15,  // fraction bits of the constants
    parameter O     = 12,  // fraction bits of the output; O <= S and O <= K
    parameter TAG_W = 16,  // width of the tag, at least 1
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

    localparam LATENCY = S + 10;  // 1 correct, S + 3 quotient, 6 Horner

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

    wire [S:0] quotient;
    glint_ratio #(
        .F(F),
        .S(S)
    ) ratio (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .n_i       (n),
        .cosine_i  (cosine),
        .distance_i(distance),
        .quotient_o(quotient)
    );

    // ---- Horner: h1 = b + rnd(a q, S), h2 = c1 + rnd(h1 q, S), y = max(0, rnd(h2 q + d0 2^S, S + K - O)) ----------
    // Each step is a product, a register, and a sum: b + rnd(x, S) = floor((x + b 2^S + 2^(S-1)) / 2^S), where the floor
    // is a cut of the low bits. With 0 <= q <= 1 and the constants of f_bps (proof: docs/contract.md), as real numbers:
    //   -1.64 < a q  <= 0         h1 from  1.36 to 3.00    both below 4 in magnitude: 3 + K bits, + S before the cut
    //       0 <= h1 q < 3.00      h2 from -0.38 to 1.01    the same
    //   -0.02 < h2 q < 1.01       y  from -0.02 to 1.00    both below 2 in magnitude: 2 + K + S bits
    localparam H_W   = K + 3;
    localparam SUM_W = H_W + S;
    localparam Y_W   = K + S + 2;
    localparam CUT   = S + K - O;  // bits dropped at the end; at least O, since O <= S and O <= K

    localparam signed [SUM_W-1:0] OFFSET_1 = {B, 1'b1, {(S - 1) {1'b0}}};   // b 2^S + 2^(S-1)
    localparam signed [SUM_W-1:0] OFFSET_2 = {C1, 1'b1, {(S - 1) {1'b0}}};  // c1 2^S + 2^(S-1)
    localparam signed [SUM_W-1:0] OFFSET_Y = {D0, {S{1'b0}}} + {{(SUM_W - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};

    // The quotient travels with the Horner steps: q_1_q beside the product a q, q_2_q beside h1, ...
    reg [S:0] q_1_q, q_2_q, q_3_q, q_4_q;

    reg signed [SUM_W-1:0] product_1_q;  // a q
    reg signed [SUM_W-1:0] product_2_q;  // h1 q
    reg signed   [Y_W-1:0] product_3_q;  // h2 q
    reg signed   [H_W-1:0] h1_q;
    reg signed   [H_W-1:0] h2_q;
    reg              [O:0] y_q;

    /* verilator lint_off UNUSED */  // the low bits of a sum are those that rounding cuts
    wire signed [SUM_W-1:0] sum_1 = product_1_q + OFFSET_1;
    wire signed [SUM_W-1:0] sum_2 = product_2_q + OFFSET_2;
    wire signed   [Y_W-1:0] sum_3 = product_3_q + OFFSET_Y[Y_W-1:0];
    /* verilator lint_on UNUSED */

    // Operands at the width of their product.
    wire signed [SUM_W-1:0] a_x   = {{(SUM_W - H_W) {A[K+2]}}, A};
    wire signed [SUM_W-1:0] h1_x  = {{(SUM_W - H_W) {h1_q[H_W-1]}}, h1_q};
    wire signed   [Y_W-1:0] h2_x  = {{(Y_W - H_W) {h2_q[H_W-1]}}, h2_q};
    wire signed [SUM_W-1:0] q_0_x = {{(SUM_W - S - 1) {1'b0}}, quotient};
    wire signed [SUM_W-1:0] q_2_x = {{(SUM_W - S - 1) {1'b0}}, q_2_q};
    wire signed   [Y_W-1:0] q_4_x = {{(Y_W - S - 1) {1'b0}}, q_4_q};

    always @(posedge clk_i) begin
        if (advance) begin
            product_1_q <= a_x * q_0_x;
            q_1_q       <= quotient;

            h1_q  <= sum_1[SUM_W-1:S];
            q_2_q <= q_1_q;

            product_2_q <= h1_x * q_2_x;
            q_3_q       <= q_2_q;

            h2_q  <= sum_2[SUM_W-1:S];
            q_4_q <= q_3_q;

            product_3_q <= h2_x * q_4_x;

            // max(0, .): the sign bit says below 0; else the integer part is at most 1 and y has O + 1 bits.
            y_q <= (negative | sum_3[Y_W-1]) ? {(O + 1) {1'b0}} : sum_3[CUT+O:CUT];
        end
    end

    assign y_o = y_q;

endmodule

`default_nettype wire
