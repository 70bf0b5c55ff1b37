// glint_cayley for Lattice ECP5: the lobe `cayley` of the specular highlight in fixed point.
//
// It takes the place of rtl/lobes/glint_cayley.v in a list of files: same ports, parameters, bits and clocks. No clock adds three
// numbers, and none chooses after a sum: where num is cut the quotient is made 0. Contract: docs/lobes/cayley.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_cayley #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter A     = 0,   // 0: the lobe; 2, 4, 8, 16, 32: the plain formula with that power, for study
    parameter S     = 17,  // fraction bits of the base and its powers, O .. 30
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

    localparam POWER = A == 0 ? 8 : A;
    localparam SQUARES = POWER == 2 ? 0 : POWER == 4 ? 1 : POWER == 8 ? 2 : POWER == 16 ? 3 : 4;

    // Clocks: 1 correct, 1 m, 1 x, 1 num and den, the division, 2 each square, 1 the last product, 1 rounding. Products:
    // x, each square, the last.
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

    // m = n - POWER is -31 .. 1021 for every A: 11 bits with the sign. POWER is 2^LOW, so the lower bits stay. The lobe has m = 0
    // where it takes a power of C: n <= 6, and n = 8, where it is 0 already. With 0 in place of the distance x is the same.
    localparam         LOW        = SQUARES + 1;
    wire               is_power   = A == 0 && n <= 10'd6;
    wire    [10-LOW:0] high       = {1'b0, n[9:LOW]} - {{(10 - LOW) {1'b0}}, 1'b1};
    wire signed [10:0] difference = {high, n[LOW-1:0]};

    reg signed [10:0] m_q;
    reg         [F:0] distance_q;
    reg         [F:0] cosine_m_q;
    always @(posedge clk_i) begin
        if (advance) begin
            m_q        <= difference;
            distance_q <= is_power ? {(F + 1) {1'b0}} : distance;
            cosine_m_q <= cosine;
        end
    end

    // x = m (2^F - C), -31 2^F .. 1021 2^F: F + 11 bits with the sign. The distance has F bits where C is not 0: the product of a
    // multiplier block at p12. Where C = 0, x is m 2^F, or 0 with A = 0, where y is 0 in either case: n = 7 alone has a num above
    // 0 there, and then r^8 is below 2^-31. Of several clocks of the product the last one is left to sums.
    localparam X_W   = F + 11;
    localparam EARLY = MULTIPLIER_STAGES > 1 ? 1 : 0;

    wire signed [X_W-1:0] product;
    wire           [10:0] m_top;
    glint_multiplier #(
        .A_W   (11),
        .B_W   (F),
        .SIGNED(1),
        .STAGES(MULTIPLIER_STAGES - EARLY)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (m_q),
        .b_i      (distance_q[F-1:0]),
        .product_o(product)
    );
    glint_delay #(
        .WIDTH (11),
        .STAGES(MULTIPLIER_STAGES - EARLY)
    ) delay_top (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (A != 0 && distance_q[F] ? m_q : 11'd0),
        .data_o  (m_top)
    );
    wire signed [X_W-1:0] x = {product[X_W-1:F] | m_top, product[F-1:0]};

    wire [F:0] cosine_x;
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_cosine (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (cosine_m_q),
        .data_o  (cosine_x)
    );

    // num before its cut to 0 is -1021 2^F .. 2 POWER 2^F, and POWER <= 32: the width of x. num <= den. Where num is
    // cut the answer is 0 whatever the divider makes of it. Elsewhere x <= 2 POWER C, with A = 0 a little more, 17.1 2^F,
    // and den is below 4 POWER 2^F, with A = 0 at most 34.3 2^F. Since m >= 1 - POWER, den is above POWER 2^F: at most one
    // leading zero, with A = 0 two.
    localparam SHIFT = SQUARES + 2;  // 2 POWER = 2^SHIFT
    localparam N_W   = F + SHIFT + 1;
    localparam D_W   = A == 0 ? N_W + 1 : N_W;

    localparam signed [X_W-1:0] TWICE_POWER = {{(X_W - N_W) {1'b0}}, 1'b1, {(N_W - 1) {1'b0}}};

    // Both arms signed: with one that is not, >>> would shift zeros in.
    wire signed [X_W-1:0] sixteenth = A == 0 ? x >>> 4 : $signed({X_W{1'b0}});
    wire signed [X_W-1:0] little    = sixteenth >>> 4;
    wire signed [X_W-1:0] upper     = TWICE_POWER + little;
    wire signed [X_W-1:0] lower     = x + sixteenth;
    wire        [X_W-1:0] less;
    wire        [D_W-1:0] den_lower, den_upper;
    glint_delay #(
        .WIDTH (X_W + 2 * D_W),
        .STAGES(EARLY)
    ) delay_sums (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({x - sixteenth, lower[D_W-1:0], upper[D_W-1:0]}),
        .data_o  ({less, den_lower, den_upper})
    );
    /* verilator lint_off UNUSED */  // where num is not cut the upper bits are 0
    wire        [X_W-1:0] uncut = {{(X_W - N_W) {1'b0}}, cosine_x, {SHIFT{1'b0}}} - less;
    wire                  unused = &{1'b0, lower, upper};
    /* verilator lint_on UNUSED */

    reg [N_W-1:0] num_q;
    reg [D_W-1:0] complement_q;  // of den: what the rows of a divider add
    reg           cut_q;
    always @(posedge clk_i) begin
        if (advance) begin
            num_q        <= uncut[N_W-1:0];
            complement_q <= ~(den_lower + den_upper);
            cut_q        <= uncut[X_W-1];
        end
    end

    // Beside num and den: where the answer is a power of C, which one. With the iterative divider n stays where it is.
    wire [2:0] power_n = A == 0 && n <= 10'd6 ? n[2:0] : 3'd0;
    wire [2:0] power_den;
    wire       start_den;
    generate
        if (DIVIDER == 2) begin : held
            assign power_den = power_n;
            glint_delay #(
                .WIDTH (1),
                .STAGES(MULTIPLIER_STAGES + 2)
            ) delay_start (
                .clk_i   (clk_i),
                .enable_i(advance),
                .data_i  (start),
                .data_o  (start_den)
            );
        end else begin : moved
            assign start_den = start;  // and not used
            glint_delay #(
                .WIDTH (3),
                .STAGES(MULTIPLIER_STAGES + 2)
            ) delay_power (
                .clk_i   (clk_i),
                .enable_i(advance),
                .data_i  (power_n),
                .data_o  (power_den)
            );
        end
    endgenerate

    // num <= den, so r is at most 2^S: S + 1 bits, and num 2^S < den 2^(S+1) as the divider asks.
    wire [S:0] quotient;
    wire [2:0] power;
    wire       cut;
    wire [S:0] r = quotient & {(S + 1) {~cut}};
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W           (N_W + S),
        .Y_W           (D_W),
        .Q_W           (S + 1),
        .DIVIDER       (DIVIDER),
        .REGISTER_EVERY(REGISTER_EVERY),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES),
        .ZEROS(A == 0 ? 2 : 1),
        .BESIDE_W      (4)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .start_i    (start_den),
        .dividend_i ({num_q, {S{1'b0}}}),
        .divisor_i  (~complement_q),
        .beside_i   ({cut_q, power_den}),
        .done_o     (),
        .quotient_o (quotient),
        .remainder_o(),
        .beside_o   ({cut, power})
    );
    /* verilator lint_on PINCONNECTEMPTY */

    glint_power #(
        .S                (S),
        .O                (O),
        .SQUARES          (SQUARES),
        .CHOICE           (A == 0),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
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
