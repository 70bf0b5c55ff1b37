// glint_cubic: the cubic approximation of the specular highlight, its coefficients from a memory, one result a clock.
//
// The arithmetic is docs/lobes/cubic.md; a value here carries the name that it has there. The memory of coefficients is
// in the generated wrapper. Table of ports and parameters, latency: docs/lobes/cubic.md; handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_cubic #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter S     = 16,  // fraction bits of T; O <= S <= F
    parameter K     = 18,  // fraction bits of the coefficients; O <= K
    parameter O     = 12,  // fraction bits of the output
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
    output wire             clamped_o, // an input was out of range and was corrected
    output wire             table_enable_o,
    output wire       [9:0] row_address_o, // n
    input  wire [F+3*K-2:0] row_entry_i    // one enabled clock later: cut (F + 1), g1 (K + 1), g2 (K), g3 (K - 3 bits)
);

    // Clocks: 1 correct, 1 product and memory, 1 rounding and cut, 6 Horner. Products: n X, three of Horner.
    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] distance;
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
        .cosine_o  (),
        .distance_o(distance),
        .negative_o(negative)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    assign table_enable_o = advance;
    // The entry comes beside the product.
    glint_delay #(
        .WIDTH (10),
        .STAGES(MULTIPLIER_STAGES - 1)
    ) delay_address (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (n),
        .data_o  (row_address_o)
    );

    wire          [F:0] cut = row_entry_i[F+3*K-2:3*K-2];
    wire signed   [K:0] g1  = row_entry_i[3*K-3:2*K-3];
    wire signed [K-1:0] g2  = row_entry_i[2*K-4:K-3];
    wire signed [K-4:0] g3  = row_entry_i[K-4:0];

    // ---- T = rnd(n X, F - S), 0 where X >= cut; else n X <= 3 2^F: S + 2 bits -----------------------------------------
    localparam N_W = F + 11;  // n X <= 1023 2^F, with the half that rounds it

    wire [F:0] distance_late;
    wire       beyond = distance_late >= cut;
    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts; the high ones are 0 where it counts
    wire [N_W-1:0] half;
    wire [N_W-1:0] scaled;
    wire [N_W-1:0] sum_0 = scaled + half;
    /* verilator lint_on UNUSED */
    glint_multiplier #(
        .A_W   (F + 1),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_0 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (distance),
        .b_i      (n),
        .product_o(scaled)
    );
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_distance (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (distance),
        .data_o  (distance_late)
    );
    generate
        if (F == S) begin : exact
            assign half = {N_W{1'b0}};
        end else begin : rounded
            assign half = {{(N_W - F + S) {1'b0}}, 1'b1, {(F - S - 1) {1'b0}}};
        end
    endgenerate

    // ---- Horner: h2 = g2 + rnd(g3 T, S), h1 = g1 + rnd(h2 T, S), y = max(0, rnd(2^(K+S) + h1 T, K + S - O)) -----------
    // With 0 <= T <= 3 as a real number, from the table of ranges of the document:
    //   -0.12 <= g3 T <= 0     h2 from  0    to 0.34: below 1/2 in magnitude, K bits
    //    0 <= h2 T <= 1.01     h1 from -1    to 0.17: below 2, K + 2 bits
    //   -3 <= h1 T <= 0.5      sum from -2   to 1.5: below 4, K + S + 3 bits
    localparam T_W   = S + 2;
    localparam SUM_W = K + S + 3;
    localparam CUT   = K + S - O;  // bits dropped at the end

    localparam signed [SUM_W-1:0] HALF_S = {{(SUM_W - S) {1'b0}}, 1'b1, {(S - 1) {1'b0}}};
    localparam signed [SUM_W-1:0] OFFSET_Y =
        {3'b001, {(K + S) {1'b0}}} + {{(SUM_W - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};

    reg         [T_W-1:0] t_0_q;
    wire        [T_W-1:0] t_2, t_4;  // beside h2, h1
    reg             [K:0] g1_0_q;
    reg           [K-1:0] g2_0_q;
    reg           [K-4:0] g3_0_q;
    wire            [K:0] g1_late;   // beside h2 T
    wire          [K-1:0] g2_late;   // beside g3 T
    reg signed    [K-1:0] h2_q;
    reg signed    [K+1:0] h1_q;
    reg             [O:0] y_q;

    wire signed   [K+S-2:0] product_1;
    wire signed   [K+S+1:0] product_2;
    /* verilator lint_off UNUSED */  // the top bit of a product repeats; the low bits of a sum are those that rounding cuts; the high ones repeat the sign
    wire signed   [K+S+3:0] product_3;
    wire signed [SUM_W-1:0] sum_1 = {{4{product_1[K+S-2]}}, product_1} + HALF_S;
    wire signed [SUM_W-1:0] sum_2 = {product_2[K+S+1], product_2} + HALF_S;
    wire signed [SUM_W-1:0] sum_3 = product_3[SUM_W-1:0] + OFFSET_Y;
    /* verilator lint_on UNUSED */
    glint_multiplier #(
        .A_W   (K - 3),
        .B_W   (T_W),
        .SIGNED(1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_1 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (g3_0_q),
        .b_i      (t_0_q),
        .product_o(product_1)
    );
    glint_multiplier #(
        .A_W   (K),
        .B_W   (T_W),
        .SIGNED(1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_2 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (h2_q),
        .b_i      (t_2),
        .product_o(product_2)
    );
    glint_multiplier #(
        .A_W   (K + 2),
        .B_W   (T_W),
        .SIGNED(1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_3 (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (h1_q),
        .b_i      (t_4),
        .product_o(product_3)
    );
    glint_delay #(
        .WIDTH (K),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_g2 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (g2_0_q),
        .data_o  (g2_late)
    );
    glint_delay #(
        .WIDTH (K + 1),
        .STAGES(2 * MULTIPLIER_STAGES + 1)
    ) delay_g1 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (g1_0_q),
        .data_o  (g1_late)
    );
    glint_delay #(
        .WIDTH (T_W),
        .STAGES(MULTIPLIER_STAGES + 1)
    ) delay_t2 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (t_0_q),
        .data_o  (t_2)
    );
    glint_delay #(
        .WIDTH (T_W),
        .STAGES(MULTIPLIER_STAGES + 1)
    ) delay_t4 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (t_2),
        .data_o  (t_4)
    );
    wire beyond_y;  // X >= cut, beside sum_3

    always @(posedge clk_i) begin
        if (advance) begin
            t_0_q  <= beyond ? {T_W{1'b0}} : sum_0[F-S+T_W-1:F-S];
            g1_0_q <= g1;
            g2_0_q <= g2;
            g3_0_q <= g3;

            h2_q <= g2_late + sum_1[S+K-1:S];
            h1_q <= {g1_late[K], g1_late} + sum_2[S+K+1:S];

            // max(0, .): the sign bit says below 0; else the integer part is at most 1 and y has O + 1 bits.
            y_q <= (negative | beyond_y | sum_3[SUM_W-1]) ? {(O + 1) {1'b0}} : sum_3[CUT+O:CUT];
        end
    end

    assign y_o = y_q;

    glint_delay #(
        .WIDTH (1),
        .STAGES(3 * MULTIPLIER_STAGES + 3)
    ) delay_beyond (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (beyond),
        .data_o  (beyond_y)
    );

endmodule

`default_nettype wire
