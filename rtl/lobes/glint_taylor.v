// glint_taylor: the lobe `taylor` of the specular highlight in fixed point, one result a clock, without a division.
//
// The arithmetic is that of docs/lobes/taylor.md; a value here carries the name that it has there. Table of ports and
// parameters, latency: there; handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_taylor #(
    parameter F     = 18,  // fraction bits of the cosine, 8 .. 29
    parameter A     = 16,  // the power: 16 is the lobe, 8 and 32 are for study
    parameter E     = 24,  // fraction bits of e, max(F, S) .. 2 F
    parameter S     = 18,  // fraction bits of the base and its powers, O .. 30
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
    output wire             clamped_o // an input was out of range and was corrected
);

    localparam LOG_A   = A == 8 ? 3 : A == 16 ? 4 : 5;
    localparam SQUARES = LOG_A - 1;

    // Clocks: 1 correct, 1 d^2, 1 e, 1 x, 1 v, 2 square of v, 1 base, 2 each squaring, 1 last product, 1 rounding.
    // Products: d^2, x, v^2, each squaring, the last.
    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] cosine, distance;
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
        .cosine_o  (cosine),
        .distance_o(distance),
        .negative_o(negative)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    // e = rnd(8 d 2^F + 5 d^2, 2 F + 3 - E) for d = 2^F - C. The sum is at most 13 2^(2F), with the half that rounds it
    // below 2^(2F+4); e is at most 1.625 2^E.
    localparam E_CUT = 2 * F + 3 - E;

    wire       [F:0] distance_d;  // beside d^2
    wire       [9:0] n_e;         // beside e
    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts; the top bits are 0
    wire [2*F+1:0] square_d;
    wire [2*F+3:0] square_wide = {2'd0, square_d};
    wire [2*F+3:0] sum_e = {distance_d, {(F + 3) {1'b0}}} + (square_wide << 2) + square_wide +
                           {{(2 * F + 4 - E_CUT) {1'b0}}, 1'b1, {(E_CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */

    glint_multiplier #(
        .A_W   (F + 1),
        .B_W   (F + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_d (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (distance),
        .b_i      (distance),
        .product_o(square_d)
    );
    glint_delay #(
        .WIDTH (F + 1),
        .STAGES(MULTIPLIER_STAGES)
    ) delay_distance (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (distance),
        .data_o  (distance_d)
    );
    glint_delay #(
        .WIDTH (10),
        .STAGES(MULTIPLIER_STAGES + 1)
    ) delay_n (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (n),
        .data_o  (n_e)
    );

    reg [E:0] e_q;
    always @(posedge clk_i) if (advance) e_q <= sum_e[E_CUT+:E+1];

    // x = n e is at most 1023 * 1.625 2^E: E + 11 bits. From A 2^E on the result is 0.
    localparam X_W = E + 11;
    localparam V_CUT = E + LOG_A - S;

    wire [X_W-1:0] x;
    wire           cut = |x[X_W-1:E+LOG_A];
    glint_multiplier #(
        .A_W   (E + 1),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier_x (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (e_q),
        .b_i      (n_e),
        .product_o(x)
    );

    // v = rnd(A 2^E - x, E + LOG_A - S), 0 .. 2^S; the difference is at most A 2^E, with the half that rounds it below
    // twice that.
    /* verilator lint_off UNUSED */  // the low bits are those that rounding cuts
    wire [E+LOG_A:0] sum_v = {1'b1, {(E + LOG_A) {1'b0}}} - {1'b0, x[E+LOG_A-1:0]} +
                             {{(E + LOG_A + 1 - V_CUT) {1'b0}}, 1'b1, {(V_CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */

    reg [S:0] v_q;
    reg       cut_q;
    always @(posedge clk_i) begin
        if (advance) begin
            v_q   <= sum_v[E+LOG_A:V_CUT];
            cut_q <= cut;
        end
    end

    // rnd(v^2, S + 1): 0 .. 2^(S-1).
    wire [S-1:0] half_square;
    glint_square #(
        .S                (S),
        .R                (S - 1),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) square_v (
        .clk_i   (clk_i),
        .enable_i(advance),
        .x_i     (v_q),
        .y_o     (half_square)
    );

    // What goes with it: whether x is cut, C at S bits, the power of C.
    wire         cut_late;
    wire   [F:0] cosine_late;
    wire   [2:0] power_late;
    glint_delay #(
        .WIDTH (1),
        .STAGES(MULTIPLIER_STAGES + 1)
    ) delay_cut (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (cut_q),
        .data_o  (cut_late)
    );
    glint_delay #(
        .WIDTH (F + 4),
        .STAGES(3 * MULTIPLIER_STAGES + 3)
    ) delay_cosine (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  ({cosine, n <= 10'd6 ? n[2:0] : n == 10'd8 ? 3'd7 : 3'd0}),
        .data_o  ({cosine_late, power_late})
    );

    wire [S:0] whole;  // rnd(C, F - S), or C 2^(S-F)
    generate
        if (S >= F) begin : wider
            assign whole = {{S{1'b0}}, cosine_late[F]} << S | {1'b0, cosine_late[F-1:0], {(S - F) {1'b0}}};
        end else begin : narrower
            assign whole = cosine_late[F:F-S] + {{S{1'b0}}, cosine_late[F-S-1]};
        end
    endgenerate

    // r = 2^(S-1) + half_square: its two upper bits are 01, and 10 where half_square is 2^(S-1).
    reg [S:0] r_q;
    reg [2:0] power_q;
    always @(posedge clk_i) begin
        if (advance) begin
            r_q     <= power_late != 3'd0 ? whole :
                       cut_late ? {(S + 1) {1'b0}} : {half_square[S-1], ~half_square[S-1], half_square[S-2:0]};
            power_q <= power_late;
        end
    end

    glint_power #(
        .S                (S),
        .O                (O),
        .SQUARES          (SQUARES),
        .CHOICE           (1),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) power_of_r (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .r_i       (r_q),
        .power_i   (power_q),
        .negative_i(negative),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
