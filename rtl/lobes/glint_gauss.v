// glint_gauss: exp(-n theta^2 / 2) in fixed point, theta the angle of the cosine, one result a clock.
//
// The arithmetic is docs/lobes/gauss.md; a value here carries the name that it has there.
// Ports and parameters: there too; handshake: docs/rtl.md.

`default_nettype none
// verilator lint_off TIMESCALEMOD

module glint_gauss #(
    parameter F     = 18,  // fraction bits of the cosine
    parameter T     = 5,   // address bits of v
    parameter L     = 25,  // fraction bits of v
    parameter E     = 3,   // address bits of exp2
    parameter S     = 16,  // fraction bits of t and p
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
    output wire     [T-1:0] angle_address_o,
    input  wire [3*L-3*T+4:0] angle_entry_i,
    output wire     [E-1:0] exp2_address_o,
    input  wire [3*S-3*E+5:0] exp2_entry_i
);

    // Clocks: 1 correct, 5 v, 2 product with n, 7 exp2. Products: two in each parabola, n v.
    wire       advance, negative;
    wire [9:0] n;
    wire [F:0] d;
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
        .distance_o(d),
        .negative_o(negative)
    );
    /* verilator lint_on PINCONNECTEMPTY */
    assign table_enable_o = advance;

    // d = 2^F, which is c = 0, is the end of the last piece.
    localparam R    = F - T;
    localparam C1_W = L - T + 3;      // 0 < h < 2.28 2^(L-T), signed
    localparam C2_W = L - 2 * T + 1;  // 0 < c2 < 0.73 2^(L-2T), signed

    reg [R:0] r_q;
    always @(posedge clk_i) begin
        if (advance) r_q <= {d[F], d[R-1:0]};
    end
    assign angle_address_o = d[F] ? {T{1'b1}} : d[F-1:R];

    // v = theta^2 / (2 ln 2) <= 1.7799 2^L.
    wire [L:0] v;
    glint_parabola #(
        .R   (R),
        .G   (0),
        .V_W (L + 1),
        .C1_W(C1_W),
        .C2_W(C2_W),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) parabola (
        .clk_i   (clk_i),
        .enable_i(advance),
        .r_i     (r_q),
        .c0_i    (angle_entry_i[C1_W+C2_W+L:C1_W+C2_W]),
        .c1_i    (angle_entry_i[C1_W+C2_W-1:C2_W]),
        .c2_i    (angle_entry_i[C2_W-1:0]),
        .value_o (v)
    );

    wire [9:0] n_late;
    glint_delay #(
        .WIDTH (10),
        .STAGES(2 * MULTIPLIER_STAGES + 3)
    ) delay_n (
        .clk_i   (clk_i),
        .enable_i(advance),
        .data_i  (n),
        .data_o  (n_late)
    );

    // n v <= 1023 * 1.78 * 2^L < 1822 2^L, also with the half that rounds it: 11 integer bits. t = rnd(n v, L - S).
    localparam CUT = L - S;

    wire [L+10:0] product;
    reg  [S+10:0] t_q;
    glint_multiplier #(
        .A_W   (L + 1),
        .B_W   (10),
        .STAGES(MULTIPLIER_STAGES)
    ) multiplier (
        .clk_i    (clk_i),
        .enable_i (advance),
        .a_i      (v),
        .b_i      (n_late),
        .product_o(product)
    );
    /* verilator lint_off UNUSED */  // the low bits of the sum are those that rounding cuts
    wire [L+10:0] sum = product + {{(L + 11 - CUT) {1'b0}}, 1'b1, {(CUT - 1) {1'b0}}};
    /* verilator lint_on UNUSED */
    always @(posedge clk_i) begin
        if (advance) begin
            t_q <= sum[L+10:CUT];
        end
    end

    glint_exp2 #(
        .I_W(11),
        .E  (E),
        .S  (S),
        .O  (O),
        .MULTIPLIER_STAGES(MULTIPLIER_STAGES)
    ) exp2 (
        .clk_i     (clk_i),
        .enable_i  (advance),
        .t_i       (t_q),
        .negative_i(negative),
        .address_o (exp2_address_o),
        .entry_i   (exp2_entry_i),
        .y_o       (y_o)
    );

endmodule

`default_nettype wire
