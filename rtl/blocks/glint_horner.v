// glint_horner: y = min(2^O, max(0, rnd(h q + k0 2^S, S + K - O))), h by Horner's rule at a quotient q of S bits:
// h<j> = k<DEGREE-j> + rnd(h<j-1> q, S), h0 = k<DEGREE>, and h the last of these before k0.
//
// Used by the lobes that are polynomials of a quotient. DEGREE (MULTIPLIER_STAGES + 1) clocks; either a pipeline, or one
// multiplier that takes the steps in turn. No valid bits and no reset: its owner counts clocks. Ports and parameters:
// docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_horner #(
    parameter S                 = 15,  // fraction bits of the quotient; O <= S
    parameter K                 = 15,  // fraction bits of the coefficients; O <= K
    parameter O                 = 12,  // fraction bits of the output
    parameter I                 = 2,   // integer bits of a Horner value, at least 1
    parameter DEGREE            = 3,   // at least 2
    parameter CLAMP             = 0,   // 1: y is cut to 2^O; 0: it is never above
    parameter ITERATIVE         = 0,   // 1: one multiplier, one value at a time
    parameter MULTIPLIER_STAGES = 1,
    // The coefficients at K fraction bits, signed, K + I + 1 bits each, that of the power i in field i.
    parameter [(DEGREE+1)*(K+I+1)-1:0] COEFFICIENTS = 0
) (
    input  wire       clk_i,
    input  wire       enable_i,
    /* verilator lint_off UNUSED */
    input  wire       start_i,     // iterative: the quotient is there, and stays until y is
    /* verilator lint_on UNUSED */
    input  wire [S:0] quotient_i,  // 0 .. 2^S
    input  wire       negative_i,  // y is 0: beside the last step
    output wire [O:0] y_o          // 0 .. 2^O
);

    // I is such that each h, and the last sum with the half that rounds it, is below 2^I in magnitude as a real number.
    // With 0 <= q <= 1 the products are too: K + I + 1 bits with the sign, S more before the cut. A step is a product
    // and a sum: k + rnd(x, S) = floor((x + k 2^S + 2^(S-1)) / 2^S).
    localparam H_W   = K + I + 1;
    localparam SUM_W = H_W + S;
    localparam CUT   = S + K - O;  // bits dropped at the end; at least O, since O <= S and O <= K
    localparam R_W   = I + O + 1;  // what is left of SUM_W bits

    localparam [SUM_W-1:0] OFFSET_Y = {COEFFICIENTS[H_W-1:0], {S{1'b0}}} + {{(SUM_W - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};

    wire [SUM_W-1:0] last_product;
    /* verilator lint_off UNUSED */  // the low bits of a sum are those that rounding cuts; the top bit of a product repeats
    wire [SUM_W-1:0] last_sum = last_product + OFFSET_Y;
    wire   [R_W-1:0] r = last_sum[SUM_W-1:CUT];
    wire             below = r[R_W-1];
    wire             above = CLAMP != 0 & ~below & (|r[R_W-2:O]);  // r >= 2^O, where y is 2^O
    reg        [O:0] y_q;
    always @(posedge clk_i) begin
        if (enable_i) y_q <= negative_i | below ? {(O + 1) {1'b0}} : above ? {1'b1, {O{1'b0}}} : r[O:0];
    end
    assign y_o = y_q;

    genvar j;
    generate
        if (ITERATIVE == 0) begin : pipeline
            // Fields j: h<j>, and the quotient that travels beside it.
            wire   [DEGREE*H_W-1:0] h;
            wire [DEGREE*(S+1)-1:0] q;
            assign h[H_W-1:0] = COEFFICIENTS[DEGREE*H_W+:H_W];
            assign q[S:0]     = quotient_i;

            for (j = 1; j <= DEGREE; j = j + 1) begin : step
                wire [H_W+S:0] product;
                glint_multiplier #(
                    .A_W   (H_W),
                    .B_W   (S + 1),
                    .SIGNED(1),
                    .STAGES(MULTIPLIER_STAGES)
                ) multiplier (
                    .clk_i    (clk_i),
                    .enable_i (enable_i),
                    .a_i      (h[(j-1)*H_W+:H_W]),
                    .b_i      (q[(j-1)*(S+1)+:S+1]),
                    .product_o(product)
                );
                if (j < DEGREE) begin : next
                    wire [SUM_W-1:0] sum = product[SUM_W-1:0] + {COEFFICIENTS[(DEGREE-j)*H_W+:H_W], 1'b1, {(S - 1) {1'b0}}};
                    reg    [H_W-1:0] h_q;
                    always @(posedge clk_i) if (enable_i) h_q <= sum[SUM_W-1:S];
                    assign h[j*H_W+:H_W] = h_q;
                    glint_delay #(
                        .WIDTH (S + 1),
                        .STAGES(MULTIPLIER_STAGES + 1)
                    ) delay_q (
                        .clk_i   (clk_i),
                        .enable_i(enable_i),
                        .data_i  (q[(j-1)*(S+1)+:S+1]),
                        .data_o  (q[j*(S+1)+:S+1])
                    );
                end else begin : result
                    assign last_product = product[SUM_W-1:0];
                end
            end
        end else begin : shared
            // A mark goes through the clocks of all steps; a start takes the place of any other, so that none has to be
            // reset. In the clock of a start the first step begins, with h0; the others begin with the last sum.
            localparam MARKS = (DEGREE - 1) * (MULTIPLIER_STAGES + 1);

            reg  [MARKS-1:0] mark_q;
            reg    [H_W-1:0] h_q;
            wire   [H_W+S:0] product;
            wire [DEGREE-2:0] sum_now;  // the product of step j is there
            for (j = 1; j < DEGREE; j = j + 1) begin : step
                assign sum_now[j-1] = mark_q[j*(MULTIPLIER_STAGES+1)-2];
            end
            reg [H_W-1:0] chosen;  // the coefficient of the sum that is now
            integer       k;
            always @* begin
                chosen = {H_W{1'b0}};
                for (k = 1; k < DEGREE; k = k + 1) begin
                    if (sum_now[k-1]) chosen = COEFFICIENTS[(DEGREE-k)*H_W+:H_W];
                end
            end
            wire [SUM_W-1:0] sum = product[SUM_W-1:0] + {chosen, 1'b1, {(S - 1) {1'b0}}};
            always @(posedge clk_i) begin
                if (enable_i) begin
                    mark_q <= start_i ? {{(MARKS - 1) {1'b0}}, 1'b1} : {mark_q[MARKS-2:0], 1'b0};
                    if (|sum_now) h_q <= sum[SUM_W-1:S];
                end
            end
            glint_multiplier #(
                .A_W   (H_W),
                .B_W   (S + 1),
                .SIGNED(1),
                .STAGES(MULTIPLIER_STAGES)
            ) multiplier (
                .clk_i    (clk_i),
                .enable_i (enable_i),
                .a_i      (start_i ? COEFFICIENTS[DEGREE*H_W+:H_W] : h_q),
                .b_i      (quotient_i),
                .product_o(product)
            );
            assign last_product = product[SUM_W-1:0];
        end
    endgenerate
    /* verilator lint_on UNUSED */

endmodule

`default_nettype wire
