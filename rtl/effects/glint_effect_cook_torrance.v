// glint_effect_cook_torrance: the specular term of Cook and Torrance, one result a clock.
//
// Contract, ports, latency: docs/effects/cook_torrance.md; a value here carries the name that it has there.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_cook_torrance #(
    parameter F     = 18,  // fraction bits of the dot products, (O + 14) / 2 .. O + 9
    parameter T     = 5,   // address bits of log2
    parameter E     = 3,   // address bits of exp2
    parameter O     = 12,  // fraction bits of the output, 8 .. 16
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,    // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire     [F+1:0] nl_i,      // N.L, signed, code / 2^F
    input  wire     [F+1:0] nv_i,      // N.V
    input  wire     [F+1:0] nh_i,      // N.H
    input  wire     [F+1:0] vh_i,      // V.H
    input  wire     [O+9:0] falloff_i, // code / 2^O
    input  wire     [O+9:0] level_i,   // signed, code / 2^(O+4)
    input  wire      [15:0] excess_i,  // code / 2^12
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire     [O+7:0] y_o,       // code / 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o, // an input was out of range and was corrected
    output wire             table_enable_o,
    output wire     [T-1:0] log2_nl_address_o,
    input  wire [3*(O+9)-3*T+2:0] log2_nl_entry_i,
    output wire     [T-1:0] log2_nv_address_o,
    input  wire [3*(O+9)-3*T+2:0] log2_nv_entry_i,
    output wire     [T-1:0] log2_nh_address_o,
    input  wire [3*(O+9)-3*T+2:0] log2_nh_entry_i,
    output wire     [T-1:0] log2_vh_address_o,
    input  wire [3*(O+9)-3*T+2:0] log2_vh_entry_i,
    output wire     [T-1:0] log2_q_address_o,
    input  wire [3*(O+9)-3*T+2:0] log2_q_entry_i,
    output wire     [E-1:0] exp2_address_o,
    input  wire [3*(O+4)-3*E+5:0] exp2_entry_i
);

    localparam L = O + 9;   // fraction bits of logarithms
    localparam S = O + 4;   // fraction bits of exponents, of t, ratio and factor
    localparam R = O + 10;  // fraction bits of root and q
    localparam W = O + 14;  // fraction bits of s and e

    // Clocks from the input to a value.
    localparam AT_ATTENUATION = 11;           // 1 correct, 10
    localparam AT_T       = S + 11;           // 1 correct, 1 square, 1 s and e, 1 product, S + 7 quotient
    localparam AT_ROOT    = R + 6;            // 1 correct, 1 square, 1 radicand, R + 3 root
    localparam AT_Q       = AT_ROOT + 1;
    localparam AT_UQ      = AT_Q + 8;
    localparam AT_FACTOR  = AT_ROOT + S + 6;  // 1 product, 1 sums, 1 operands, S + 1 ratio, 2 square
    localparam AT_Z       = AT_FACTOR - 5;    // z waits for the factor
    localparam LATENCY    = AT_Z + 8;

    wire         advance, dark_1;
    wire   [2:0] clamped;
    wire   [F:0] nl_1, nv_1, nh_1, vh_1;  // in the clock after that of the ports
    wire [S+5:0] level_1;
    glint_microfacets #(
        .F(F),
        .S(S)
    ) microfacets (
        .clk_i    (clk_i),
        .enable_i (advance),
        .nl_i     (nl_i),
        .nv_i     (nv_i),
        .nh_i     (nh_i),
        .vh_i     (vh_i),
        .level_i  (level_i),
        .dark_i   (~|excess_i),
        .clamped_o(clamped[0]),
        .nl_o     (nl_1),
        .nv_o     (nv_1),
        .nh_o     (nh_1),
        .vh_o     (vh_1),
        .level_o  (level_1),
        .dark_o   (dark_1)
    );

    // falloff is at least 1, excess at most 15.
    assign clamped[1] = ~|falloff_i[O+9:O];
    assign clamped[2] = &excess_i[15:12] & (|excess_i[11:0]);

    glint_stream #(
        .LATENCY(LATENCY),
        .TAG_W  (TAG_W)
    ) stream (
        .clk_i    (clk_i),
        .rst_ni   (rst_ni),
        .valid_i  (valid_i),
        .ready_o  (ready_o),
        .clamped_i(|clamped),
        .tag_i    (tag_i),
        .valid_o  (valid_o),
        .ready_i  (ready_i),
        .tag_o    (tag_o),
        .clamped_o(clamped_o),
        .advance_o(advance)
    );
    assign table_enable_o = advance;

    reg [O+9:0] falloff_q;  // 1 .. 2^10
    reg  [15:0] excess_q;   // 0 .. 15; with 0 nothing reflects
    always @(posedge clk_i) begin
        if (advance) begin
            falloff_q <= {falloff_i[O+9:O+1], falloff_i[O] | clamped[1], falloff_i[O-1:0] & {O{~clamped[1]}}};
            excess_q  <= {excess_i[15:12], excess_i[11:0] & {12{~clamped[2]}}};
        end
    end

    // ---- t = falloff (1 - nh^2) / nh^2, at most 2^7 ---------------------------------------------------------------------
    // s is 2^W where nh is 0, else less; e = 2^W - s. falloff s < 2^(O+10+W).
    localparam [2*F:0] ONE_SQUARE = {1'b1, {(2 * F) {1'b0}}};
    localparam   [W:0] ONE_W = {1'b1, {W{1'b0}}};

    reg   [2*F:0] nh_square_q;
    reg     [W:0] s_q, e_q, e_late_q;
    reg   [O+9:0] falloff_1_q, falloff_0_q;
    reg [O+W+9:0] product_t_q;
    /* verilator lint_off UNUSED */  // the bits of 1 - nh^2 below s
    wire  [2*F:0] nh_rest = ONE_SQUARE - nh_square_q;
    /* verilator lint_on UNUSED */
    wire    [W:0] s = nh_rest[2*F:2*F-W];
    always @(posedge clk_i) begin
        if (advance) begin
            nh_square_q <= {{F{1'b0}}, nh_1} * {{F{1'b0}}, nh_1};
            falloff_1_q <= falloff_q;

            s_q         <= s;
            e_q         <= ONE_W - s;
            falloff_0_q <= falloff_1_q;

            product_t_q <= {{W{1'b0}}, falloff_0_q} * {{(O + 9) {1'b0}}, s_q};
            e_late_q    <= e_q;
        end
    end

    // The dividend has S fraction bits more than e: those of the product, O, and zeros. Where t is below 2^7, the dividend
    // is below e 2^(S+7), which is at most 2^(W+S+7).
    wire         beyond = product_t_q[O+W+9:O+7] >= {2'b00, e_late_q};
    wire [S+6:0] t;
    /* verilator lint_off UNUSED */  // its top bits, which are 0 where it is not beyond
    wire [W+S+9:0] dividend_t = {product_t_q, {(S - O) {1'b0}}};
    /* verilator lint_on UNUSED */
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(W + S + 8),
        .Y_W(W + 1),
        .Q_W(S + 7)
    ) divider_t (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .start_i    (1'b0),
        .dividend_i (dividend_t[W+S+7:0]),
        .divisor_i  (e_late_q),
        .beside_i   (1'b0),
        .done_o     (),
        .quotient_o (t),
        .remainder_o(),
        .beside_o   ()
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // ---- Fresnel's reflectance: q, and factor = 1 + ratio^2 -----------------------------------------------------------
    // root^2 <= excess + vh^2 <= 16, so root is at most 4: R + 3 bits; q at most 5.
    reg   [2*F:0] vh_square_q;
    reg    [15:0] excess_late_q;
    reg [2*R+5:0] radicand_q;
    wire  [R+2:0] root;
    always @(posedge clk_i) begin
        if (advance) begin
            vh_square_q   <= {{F{1'b0}}, vh_1} * {{F{1'b0}}, vh_1};
            excess_late_q <= excess_q;
            radicand_q    <= {2'b00, excess_late_q, {(2 * R - 12) {1'b0}}} +
                             {5'd0, vh_square_q, {(2 * R - 2 * F) {1'b0}}};
        end
    end
    /* verilator lint_off PINCONNECTEMPTY */
    glint_sqrt #(
        .Y_W(R + 3)
    ) sqrt (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .radicand_i (radicand_q),
        .root_o     (root),
        .remainder_o()
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // square = rnd(vh^2, 2 F - S) beside the square; 0 .. 2^S.
    /* verilator lint_off UNUSED */  // the bits that rounding cuts
    wire [2*F:0] square_sum = vh_square_q + {{(S + 1) {1'b0}}, 1'b1, {(2 * F - S - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    reg    [S:0] square_q;
    always @(posedge clk_i) begin
        if (advance) square_q <= square_sum[2*F:2*F-S];
    end
    wire [S:0] square;
    wire [F:0] vh;
    glint_delay #(
        .WIDTH (S + 1),
        .STAGES(AT_Q - 3)
    ) delay_square (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (square_q),
        .data_o  (square)
    );
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(AT_ROOT - 1)
    ) delay_vh (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (vh_1),
        .data_o  (vh)
    );

    // across = rnd(vh root, F + R - S), at most 4. numerator = across + square - 1 is -1 .. 4, its magnitude at most the
    // denominator = across - square + 1, which is 1 .. 4: across is at least square.
    localparam [S+2:0] ONE_S = {3'b001, {S{1'b0}}};
    reg   [R+2:0] q_q;
    reg [F+R+3:0] across_product_q;
    /* verilator lint_off UNUSED */  // the bits that rounding cuts
    wire [F+R+3:0] across_sum = across_product_q + {{(S + 4) {1'b0}}, 1'b1, {(F + R - S - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    wire  [S+2:0] across = across_sum[F+R+2:F+R-S];
    reg   [S+3:0] numerator_q;
    reg   [S+2:0] denominator_1_q, denominator_q, magnitude_q;
    always @(posedge clk_i) begin
        if (advance) begin
            q_q              <= root + {2'b00, vh, {(R - F) {1'b0}}};
            across_product_q <= {{(R + 3) {1'b0}}, vh} * {{(F + 1) {1'b0}}, root};

            numerator_q      <= {1'b0, across} + {3'd0, square} - {1'b0, ONE_S};
            denominator_1_q  <= across - {2'd0, square} + ONE_S;

            magnitude_q      <= numerator_q[S+3] ? {(S + 3) {1'b0}} - numerator_q[S+2:0] : numerator_q[S+2:0];
            denominator_q    <= denominator_1_q;
        end
    end

    wire [S:0] ratio, ratio_square;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(2 * S + 3),
        .Y_W(S + 3),
        .Q_W(S + 1)
    ) divider_ratio (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .start_i    (1'b0),
        .dividend_i ({magnitude_q, {S{1'b0}}}),
        .divisor_i  (denominator_q),
        .beside_i   (1'b0),
        .done_o     (),
        .quotient_o (ratio),
        .remainder_o(),
        .beside_o   ()
    );
    /* verilator lint_on PINCONNECTEMPTY */
    glint_square #(
        .S(S),
        .R(S)
    ) ratio_squared (
        .clk_i   (clk_i),
        .enable_i(advance),
        .x_i     (ratio),
        .y_o     (ratio_square)
    );
    wire [S+1:0] factor = {2'b01, {S{1'b0}}} + {1'b0, ratio_square};  // 1 .. 2

    // q / 8 has R + 3 fraction bits; the logarithm takes L - 1 of them, from the leading one on.
    wire [L+4:0] uq;
    glint_log2 #(
        .F  (R + 3),
        .T  (T),
        .L  (L),
        .CUT(R + 4 - L)
    ) log2_q (
        .clk_i    (clk_i),
        .enable_i (advance),
        .cosine_i ({1'b0, q_q}),
        .address_o(log2_q_address_o),
        .entry_i  (log2_q_entry_i),
        .u_o      (uq)
    );

    // ---- z: all powers of two together --------------------------------------------------------------------------------
    wire [L+4:0] uh;
    wire [L+6:0] gain;
    glint_attenuation #(
        .F(F),
        .T(T),
        .L(L)
    ) attenuation (
        .clk_i    (clk_i),
        .enable_i (advance),
        .nl_i     (nl_1),
        .nv_i     (nv_1),
        .nh_i     (nh_1),
        .vh_i     (vh_1),
        .address_o({log2_vh_address_o, log2_nh_address_o, log2_nv_address_o, log2_nl_address_o}),
        .entry_i  ({log2_vh_entry_i, log2_nh_entry_i, log2_nv_entry_i, log2_nl_entry_i}),
        .uh_o     (uh),
        .gain_o   (gain)
    );

    wire [S+5:0] level;
    glint_delay #(
        .WIDTH (S + 6),
        .STAGES(AT_ATTENUATION)
    ) delay_level (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (level_1),
        .data_o  (level)
    );

    // -64 < gain <= 31, 4 uh <= 124, -32 <= level <= 16, 4 uq <= 124: the sums are within -96 .. 295, 10 bits before the
    // point. level is exact at S bits, so that it may be added before the sum is rounded to S bits.
    reg  [L+9:0] known_1_q;
    reg  [L+9:0] known_q;
    wire [L+9:0] known;
    always @(posedge clk_i) begin
        if (advance) begin
            known_1_q <= {{3{gain[L+6]}}, gain} + {3'd0, uh, 2'b00};
            known_q   <= known_1_q + {{4{level[S+5]}}, level, {(L - S) {1'b0}}};
        end
    end
    glint_delay #(
        .WIDTH (L + 10),
        .STAGES(AT_UQ - AT_ATTENUATION - 2)
    ) delay_known (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (known_q),
        .data_o  (known)
    );

    wire [S+6:0] t_late;
    glint_delay #(
        .WIDTH (S + 7),
        .STAGES(AT_UQ + 1 - AT_T)
    ) delay_t (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (t),
        .data_o  (t_late)
    );

    reg  [L+9:0] sum_q;
    reg  [S+9:0] z_q;
    wire [S+9:0] z;
    /* verilator lint_off UNUSED */  // the bits that rounding cuts
    wire [L+9:0] sum_half = sum_q + {{(S + 10) {1'b0}}, 1'b1, {(L - S - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    always @(posedge clk_i) begin
        if (advance) begin
            sum_q <= known + {3'd0, uq, 2'b00};
            z_q   <= {10'd12, {S{1'b0}}} + {3'd0, t_late} - sum_half[L+9:L-S];
        end
    end
    glint_delay #(
        .WIDTH (S + 10),
        .STAGES(AT_Z - AT_UQ - 2)
    ) delay_z (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (z_q),
        .data_o  (z)
    );

    wire dark_at_product, dark;
    glint_delay #(
        .WIDTH (1),
        .STAGES(3)
    ) delay_dark_product (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (dark_1),
        .data_o  (dark_at_product)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(AT_Z - 4)
    ) delay_dark (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (dark_at_product | beyond),
        .data_o  (dark)
    );

    glint_scaled_power #(
        .I_W  (10),
        .E    (E),
        .S    (S),
        .K    (S),
        .BELOW(0),
        .O    (O)
    ) power (
        .clk_i    (clk_i),
        .enable_i (advance),
        .z_i      (z),
        .dark_i   (dark),
        .factor_i (factor),
        .address_o(exp2_address_o),
        .entry_i  (exp2_entry_i),
        .y_o      (y_o)
    );

endmodule

`default_nettype wire
