// glint_effect_cook_torrance_modified: the specular term of Cook and Torrance with a cubic for the distribution and a
// constant for the reflectance, one result a clock.
//
// Contract, ports, latency: docs/effects/cook_torrance_modified.md; a value here carries the name that it has there.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_cook_torrance_modified #(
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
    input  wire     [O+9:0] level_i,   // signed, code / 2^(O+4)
    input  wire      [17:0] stretch_i, // code / 2^8
    input  wire     [O+8:0] c0_i,      // signed, code / 2^(O+5)
    input  wire     [O+8:0] c1_i,
    input  wire     [O+8:0] c2_i,
    input  wire     [O+8:0] c3_i,
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
    output wire     [E-1:0] exp2_address_o,
    input  wire [3*(O+4)-3*E+5:0] exp2_entry_i
);

    localparam L = O + 9;  // fraction bits of logarithms
    localparam S = O + 4;  // fraction bits of exponents
    localparam K = O + 5;  // fraction bits of x, the coefficients and the factor

    // Clocks from the input to a value.
    localparam AT_ATTENUATION = 11;                  // 1 correct, 10
    localparam AT_FACTOR      = 10;                  // 1 correct, 1 distance, 1 x, 6 Horner, 1 cut
    localparam AT_Z           = AT_ATTENUATION + 2;  // 1 sum, 1 round
    localparam LATENCY        = AT_Z + 8;

    wire         advance, dark_1;
    wire   [1:0] clamped;
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
        .dark_i   (1'b0),
        .clamped_o(clamped[0]),
        .nl_o     (nl_1),
        .nv_o     (nv_1),
        .nh_o     (nh_1),
        .vh_o     (vh_1),
        .level_o  (level_1),
        .dark_o   (dark_1)
    );

    // stretch is at least 1.
    assign clamped[1] = ~|stretch_i[17:8];

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

    reg [17:0] stretch_q;  // 1 .. 2^10
    always @(posedge clk_i) begin
        if (advance) stretch_q <= {stretch_i[17:9], stretch_i[8] | clamped[1], stretch_i[7:0] & {8{~clamped[1]}}};
    end

    // ---- The cubic ----------------------------------------------------------------------------------------------------
    // x = (1 - nh) stretch, cut to K bits; past its end, 1, the result is 0 whatever x is.
    localparam [F:0] ONE_F = {1'b1, {F{1'b0}}};

    reg    [F:0] distance_q;
    reg   [17:0] stretch_late_q;
    reg [F+18:0] product_x_q;
    /* verilator lint_off UNUSED */  // the bits below x
    wire [F+18:0] product_x = product_x_q;
    /* verilator lint_on UNUSED */
    wire  [K-1:0] x_1 = product_x[F+7:F+8-K];
    wire          past = |product_x[F+18:F+8];

    // The coefficients wait for their steps: c3 for x, the others for the sum that they enter.
    wire [K+3:0] c0, c1, c2, c3;
    glint_delay #(
        .WIDTH (K + 4),
        .STAGES(3)
    ) delay_c3 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (c3_i),
        .data_o  (c3)
    );
    glint_delay #(
        .WIDTH (K + 4),
        .STAGES(4)
    ) delay_c2 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (c2_i),
        .data_o  (c2)
    );
    glint_delay #(
        .WIDTH (K + 4),
        .STAGES(6)
    ) delay_c1 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (c1_i),
        .data_o  (c1)
    );
    glint_delay #(
        .WIDTH (K + 4),
        .STAGES(8)
    ) delay_c0 (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (c0_i),
        .data_o  (c0)
    );

    // x < 1 and -8 <= c < 8: -16 <= h1 < 16, -24 <= h2 < 24, -32 <= h3 < 32, so K + 5, K + 6 and K + 6 bits. A product has K
    // bits more than its signed operand; the half that rounds it does not change its sign bit.
    reg  signed [2*K+3:0] product_3_q;
    reg  signed [2*K+4:0] product_2_q;
    reg  signed [2*K+5:0] product_1_q;
    reg    signed [K+4:0] h1_q;
    reg    signed [K+5:0] h2_q, h3_q;
    reg           [K-1:0] x_2_q, x_3_q, x_4_q, x_5_q;
    reg           [K+1:0] factor_q;

    /* verilator lint_off UNUSED */  // the bits that rounding cuts
    wire signed [2*K+3:0] sum_3 = product_3_q + {{(K + 4) {1'b0}}, 1'b1, {(K - 1) {1'b0}}};
    wire signed [2*K+4:0] sum_2 = product_2_q + {{(K + 5) {1'b0}}, 1'b1, {(K - 1) {1'b0}}};
    wire signed [2*K+5:0] sum_1 = product_1_q + {{(K + 6) {1'b0}}, 1'b1, {(K - 1) {1'b0}}};
    /* verilator lint_on UNUSED */

    // Operands at the width of their product, signed.
    wire signed [2*K+3:0] c3_wide = {{K{c3[K+3]}}, c3};
    wire signed [2*K+3:0] x3_wide = {{(K + 4) {1'b0}}, x_1};
    wire signed [2*K+4:0] h1_wide = {{K{h1_q[K+4]}}, h1_q};
    wire signed [2*K+4:0] x2_wide = {{(K + 5) {1'b0}}, x_3_q};
    wire signed [2*K+5:0] h2_wide = {{K{h2_q[K+5]}}, h2_q};
    wire signed [2*K+5:0] x1_wide = {{(K + 6) {1'b0}}, x_5_q};

    // The factor is the cubic, cut to 0 .. 2.
    wire above = ~h3_q[K+5] & (|h3_q[K+4:K+1]);
    always @(posedge clk_i) begin
        if (advance) begin
            distance_q     <= ONE_F - nh_1;
            stretch_late_q <= stretch_q;
            product_x_q    <= {18'd0, distance_q} * {{(F + 1) {1'b0}}, stretch_late_q};

            product_3_q <= c3_wide * x3_wide;
            x_2_q       <= x_1;
            h1_q        <= {c2[K+3], c2} + {sum_3[2*K+3], sum_3[2*K+3:K]};
            x_3_q       <= x_2_q;
            product_2_q <= h1_wide * x2_wide;
            x_4_q       <= x_3_q;
            h2_q        <= {{2{c1[K+3]}}, c1} + {sum_2[2*K+4], sum_2[2*K+4:K]};
            x_5_q       <= x_4_q;
            product_1_q <= h2_wide * x1_wide;
            h3_q        <= {{2{c0[K+3]}}, c0} + sum_1[2*K+5:K];
            factor_q    <= h3_q[K+5] ? {(K + 2) {1'b0}} : above ? {1'b1, {(K + 1) {1'b0}}} : h3_q[K+1:0];
        end
    end

    wire [K+1:0] factor;
    glint_delay #(
        .WIDTH (K + 2),
        .STAGES(AT_Z + 5 - AT_FACTOR)
    ) delay_factor (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (factor_q),
        .data_o  (factor)
    );

    // ---- z: all powers of two together --------------------------------------------------------------------------------
    wire [L+6:0] gain;
    /* verilator lint_off PINCONNECTEMPTY */
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
        .uh_o     (),
        .gain_o   (gain)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    wire [S+5:0] level;
    glint_delay #(
        .WIDTH (S + 6),
        .STAGES(AT_ATTENUATION - 1)
    ) delay_level (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (level_1),
        .data_o  (level)
    );

    // -64 < gain <= 31 and -32 <= level <= 16: the sum is within -96 .. 47, 8 bits before the point. level is exact at S
    // bits, so that it may be added before the sum is rounded to S bits.
    reg [L+7:0] sum_q;
    reg [S+7:0] z_q;
    /* verilator lint_off UNUSED */  // the bits that rounding cuts
    wire [L+7:0] sum_half = sum_q + {{(S + 8) {1'b0}}, 1'b1, {(L - S - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    always @(posedge clk_i) begin
        if (advance) begin
            sum_q <= {gain[L+6], gain} + {{2{level[S+5]}}, level, {(L - S) {1'b0}}};
            z_q   <= {(S + 8) {1'b0}} - sum_half[L+7:L-S];
        end
    end

    wire dark_at_x, dark;
    glint_delay #(
        .WIDTH (1),
        .STAGES(2)
    ) delay_dark_x (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (dark_1),
        .data_o  (dark_at_x)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(AT_Z - 3)
    ) delay_dark (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (dark_at_x | past),
        .data_o  (dark)
    );

    glint_scaled_power #(
        .I_W  (8),
        .E    (E),
        .S    (S),
        .K    (K),
        .BELOW(K),
        .O    (O)
    ) power (
        .clk_i    (clk_i),
        .enable_i (advance),
        .z_i      (z_q),
        .dark_i   (dark),
        .factor_i (factor),
        .address_o(exp2_address_o),
        .entry_i  (exp2_entry_i),
        .y_o      (y_o)
    );

endmodule

`default_nettype wire
