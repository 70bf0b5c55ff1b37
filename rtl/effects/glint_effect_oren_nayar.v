// glint_effect_oren_nayar: the diffuse term of Oren and Nayar, one result a clock.
//
// Contract, ports, latency: docs/effects/oren_nayar.md; a value here carries the name that it has there.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_effect_oren_nayar #(
    parameter F     = 18,  // fraction bits of the dot products, at least O + 3
    parameter O     = 12,  // fraction bits of the output, at least 1
    parameter TAG_W = 16   // width of the tag, at least 1
) (
    input  wire             clk_i,
    input  wire             rst_ni,   // synchronous, active low
    input  wire             valid_i,
    output wire             ready_o,
    input  wire     [F+1:0] nl_i,     // N.L, signed, code / 2^F
    input  wire     [F+1:0] nv_i,     // N.V
    input  wire     [F+1:0] lv_i,     // L.V
    input  wire     [O+2:0] a_i,      // A, code / 2^(O+2)
    input  wire     [O+2:0] b_i,      // B, code / 2^(O+2)
    input  wire [TAG_W-1:0] tag_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire       [O:0] y_o,      // code / 2^O, 0 .. 1.5 2^O
    output wire [TAG_W-1:0] tag_o,
    output wire             clamped_o // an input was out of range and was corrected
);

    localparam S       = O + 2;  // fraction bits of a, b, q, ratio and p
    localparam LATENCY = S + 5;  // 1 correct, S ratio, 1 product, 1 p, 1 b p, 1 sum

    wire         advance;
    wire   [4:0] clamped;
    wire [F+1:0] nl_cut, nv_cut, lv_cut;
    glint_dot #(
        .F(F)
    ) nl_dot (
        .dot_i    (nl_i),
        .dot_o    (nl_cut),
        .clamped_o(clamped[0])
    );
    glint_dot #(
        .F(F)
    ) nv_dot (
        .dot_i    (nv_i),
        .dot_o    (nv_cut),
        .clamped_o(clamped[1])
    );
    glint_dot #(
        .F(F)
    ) lv_dot (
        .dot_i    (lv_i),
        .dot_o    (lv_cut),
        .clamped_o(clamped[2])
    );

    // a <= 1; b <= 1/2: above it, one of the two top bits is 1 and it is not the lower alone.
    assign clamped[3] = a_i[S] & (|a_i[S-1:0]);
    assign clamped[4] = b_i[S] | (b_i[S-1] & (|b_i[S-2:0]));

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

    // Dark where nl or nv is not above 0; from here on they are taken as unsigned, which is then without meaning.
    wire dark = nl_cut[F+1] | ~|nl_cut[F:0] | nv_cut[F+1] | ~|nv_cut[F:0];

    reg   [F:0] nl_q, nv_q;  // 0 .. 2^F where they count
    reg [F+1:0] lv_q;
    reg   [S:0] a_q;         // 0 .. 2^S
    reg [S-1:0] b_q;         // 0 .. 2^(S-1)
    reg         dark_q;
    always @(posedge clk_i) begin
        if (advance) begin
            nl_q   <= nl_cut[F:0];
            nv_q   <= nv_cut[F:0];
            lv_q   <= lv_cut;
            a_q    <= {a_i[S], a_i[S-1:0] & {S{~a_i[S]}}};
            b_q    <= clamped[4] ? {1'b1, {(S - 1) {1'b0}}} : b_i[S-1:0];
            dark_q <= dark;
        end
    end

    // ratio = nl / nv, cut to 1; only where nl < nv the quotient counts, and there nl < 2^F and the quotient < 2^S.
    wire         reaches = nl_q >= nv_q;
    wire         ratio_is_1;
    wire [S-1:0] quotient;
    /* verilator lint_off PINCONNECTEMPTY */
    glint_divider #(
        .X_W(F + S),
        .Y_W(F + 1),
        .Q_W(S)
    ) divider (
        .clk_i      (clk_i),
        .enable_i   (advance),
        .start_i    (1'b0),
        .dividend_i ({nl_q[F-1:0], {S{1'b0}}}),
        .divisor_i  (nv_q),
        .beside_i   (1'b0),
        .done_o     (),
        .quotient_o (quotient),
        .remainder_o(),
        .beside_o   ()
    );
    /* verilator lint_on PINCONNECTEMPTY */
    glint_delay #(
        .WIDTH (1),
        .STAGES(S)
    ) delay_reaches (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (reaches),
        .data_o  (ratio_is_1)
    );

    // q = max(0, rnd(lv 2^F - nl nv, 2 F - S)). The half that rounds is 2^(F-S-1) in units of lv, which stays below
    // 2^(F+1) with it. nl nv is 0 .. 2^(2F), so the difference is above -2^(2F+1): 2 F + 2 bits with the sign; and q is at
    // most 2^S.
    localparam [F+1:0] HALF_Q = {{(S + 2) {1'b0}}, 1'b1, {(F - S - 1) {1'b0}}};
    reg   [F+1:0] lv_half_q;
    reg [2*F+1:0] nlv_q;
    reg     [S:0] q_q;
    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts
    wire [2*F+1:0] difference = {lv_half_q, {F{1'b0}}} - nlv_q;
    /* verilator lint_on UNUSED */

    // a nl <= 2^(S+F); HALF_Y, which rounds y, is below 2^(S+F) as well.
    localparam [S+F+1:0] HALF_Y = {{(O + 2) {1'b0}}, 1'b1, {(S + F - O - 1) {1'b0}}};
    reg   [S+F:0] anl_q;
    reg [S+F+1:0] anl_half_q;
    always @(posedge clk_i) begin
        if (advance) begin
            lv_half_q  <= lv_q + HALF_Q;
            nlv_q      <= {{(F + 1) {1'b0}}, nl_q} * {{(F + 1) {1'b0}}, nv_q};
            q_q        <= difference[2*F:2*F-S] & {(S + 1) {~difference[2*F+1]}};

            anl_q      <= {{F{1'b0}}, a_q} * {{S{1'b0}}, nl_q};
            anl_half_q <= {1'b0, anl_q} + HALF_Y;
        end
    end

    wire     [S:0] q;
    wire [S+F+1:0] anl_half;
    wire   [S-1:0] b;
    wire           dark_late;
    glint_delay #(
        .WIDTH (S + 1),
        .STAGES(S - 2)
    ) delay_q (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (q_q),
        .data_o  (q)
    );
    glint_delay #(
        .WIDTH (S + F + 2),
        .STAGES(S + 1)
    ) delay_anl (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (anl_half_q),
        .data_o  (anl_half)
    );
    glint_delay #(
        .WIDTH (S),
        .STAGES(S + 2)
    ) delay_b (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (b_q),
        .data_o  (b)
    );
    glint_delay #(
        .WIDTH (1),
        .STAGES(S + 3)
    ) delay_dark (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (dark_q),
        .data_o  (dark_late)
    );

    // p = rnd(q ratio, S), 0 .. 2^S; b p <= 2^(2S-1); the sum is at most 1.5 2^(S+F) and the half: S + F + 2 bits with y
    // at most 1.5 2^O.
    reg   [2*S:0] product_q;
    reg     [S:0] p_q;
    reg [2*S-1:0] bp_q;
    reg     [O:0] y_q;
    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts, the top one is 0
    wire [S+F+1:0] sum = anl_half + {2'b00, bp_q, {(F - S) {1'b0}}};
    /* verilator lint_on UNUSED */
    always @(posedge clk_i) begin
        if (advance) begin
            product_q <= {{S{1'b0}}, q} * {{S{1'b0}}, ratio_is_1, quotient & {S{~ratio_is_1}}};
            p_q       <= product_q[2*S:S] + {{S{1'b0}}, product_q[S-1]};
            bp_q      <= {{S{1'b0}}, b} * {{(S - 1) {1'b0}}, p_q};
            y_q       <= sum[S+F:S+F-O] & {(O + 1) {~dark_late}};
        end
    end
    wire unused = &{1'b0, product_q[S-2:0]};

    assign y_o = y_q;

endmodule

`default_nettype wire
