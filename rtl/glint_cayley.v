// glint_cayley: the lobe `cayley` of the specular highlight in fixed point, one result a clock.
//
// The arithmetic is that of docs/lobes/cayley.md; a value here carries the name that it has there. Table of ports and
// parameters, latency: there; handshake: docs/rtl.md.

`default_nettype none

module glint_cayley #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter A     = 0,   // 0: the lobe; 2, 4, 8, 16, 32: the plain formula with that power, for study
    parameter S     = 17,  // fraction bits of the base and its powers, O .. 30
    parameter O     = 12,  // fraction bits of the output
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

    localparam POWER = A == 0 ? 8 : A;
    localparam SQUARES = POWER == 2 ? 0 : POWER == 4 ? 1 : POWER == 8 ? 2 : POWER == 16 ? 3 : 4;

    // 1 correct, 1 m, 1 x, 1 num and den, S + 1 division, 2 each square, 1 the last product, 1 rounding.
    localparam LATENCY = S + 7 + 2 * SQUARES;

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

    // m = n - POWER is -31 .. 1021 for every A: 11 bits with the sign. The lobe has m = 0 where it takes a power of C.
    wire               is_power = A == 0 && (n <= 10'd6 || n == 10'd8);
    localparam  [10:0] POWER_CODE = POWER;
    wire signed [10:0] difference = {1'b0, n} - POWER_CODE;

    reg signed [10:0] m_q;
    reg         [F:0] distance_q;
    reg         [F:0] cosine_m_q;
    always @(posedge clk_i) begin
        if (advance) begin
            m_q        <= is_power ? 11'sd0 : difference;
            distance_q <= distance;
            cosine_m_q <= cosine;
        end
    end

    // x = m (2^F - C), -31 2^F .. 1021 2^F: F + 11 bits with the sign.
    localparam X_W = F + 11;

    wire signed [X_W-1:0] m_wide = {{F{m_q[10]}}, m_q};
    wire signed [X_W-1:0] distance_wide = {10'd0, distance_q};

    reg signed [X_W-1:0] x_q;
    reg            [F:0] cosine_x_q;
    always @(posedge clk_i) begin
        if (advance) begin
            x_q        <= m_wide * distance_wide;
            cosine_x_q <= cosine_m_q;
        end
    end

    // num before its cut to 0 is -1021 2^F .. 2 POWER 2^F, and POWER <= 32: the width of x. num <= den. Where num is
    // cut the answer is 0 whatever den is; it is 1 there. Elsewhere x <= 2 POWER C, with A = 0 a little more, 17.1 2^F,
    // and den is below 4 POWER 2^F, with A = 0 at most 34.3 2^F.
    localparam SHIFT = SQUARES + 2;  // 2 POWER = 2^SHIFT
    localparam N_W   = F + SHIFT + 1;
    localparam D_W   = A == 0 ? N_W + 1 : N_W;

    localparam signed [X_W-1:0] TWICE_POWER = {{(X_W - N_W) {1'b0}}, 1'b1, {(N_W - 1) {1'b0}}};

    // Both arms signed: with one that is not, >>> would shift zeros in.
    wire signed [X_W-1:0] sixteenth = A == 0 ? x_q >>> 4 : $signed({X_W{1'b0}});
    wire signed [X_W-1:0] scaled_cosine = {{(X_W - N_W) {1'b0}}, cosine_x_q, {SHIFT{1'b0}}};
    /* verilator lint_off UNUSED */  // where num is not cut the upper bits are 0
    wire signed [X_W-1:0] uncut = scaled_cosine - x_q + sixteenth;
    wire signed [X_W-1:0] sum_den = TWICE_POWER + x_q + sixteenth + (sixteenth >>> 4);
    /* verilator lint_on UNUSED */
    wire cut = uncut[X_W-1];

    reg [N_W-1:0] num_q;
    reg [D_W-1:0] den_q;
    always @(posedge clk_i) begin
        if (advance) begin
            num_q <= cut ? {N_W{1'b0}} : uncut[N_W-1:0];
            den_q <= cut ? {{(D_W - 1) {1'b0}}, 1'b1} : sum_den[D_W-1:0];
        end
    end

    // num <= den, so r is at most 2^S: S + 1 bits, and num 2^S < den 2^(S+1) as the divider asks.
    wire [S:0] r;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(N_W + S),
        .Y_W(D_W),
        .Q_W(S + 1)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .dividend_i ({num_q, {S{1'b0}}}),
        .divisor_i  (den_q),
        .quotient_o (r),
        .remainder_o(),
        .divisor_o  ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // The power stands beside n, one clock after a transfer; r is there S + 5 clocks after it.
    wire [2:0] power;
    generate
        if (A == 0) begin : chosen
            glint_delay #(
                .WIDTH (3),
                .STAGES(S + 4)
            ) delay_power (
                .clk_i   (clk_i),
                .enable_i(advance),
                .data_i  (n <= 10'd6 ? n[2:0] : 3'd0),
                .data_o  (power)
            );
        end else begin : plain
            assign power = 3'd0;
        end
    endgenerate

    glint_power #(
        .S      (S),
        .O      (O),
        .SQUARES(SQUARES),
        .CHOICE (A == 0)
    ) power_of_r (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .r_i       (r),
        .power_i   (power),
        .negative_i(negative),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
